// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FIGURES_DRAW_MAP_FIGURES_H
#define FIGURES_DRAW_MAP_FIGURES_H

#include "Folders.h"

#include <cstdio>
#include <vector>

// Figures of what the minimizer is told: how the border moves, the balance, the rectangle.

namespace figures {

inline void draw_border_motion(const Folders& folders)
{
  std::vector<Picture> pictures;
  for(const auto motion : {CGAL_ext::Border_motion::FIXED, CGAL_ext::Border_motion::SLIDING}) {
    Options options;
    options.minimization = with_border(motion);
    const Map map = make_map(folders.mesh("nefertiti.off"), options);
    pictures.push_back(draw_domain(map, faces_style()));
    std::printf("border: L2 %.4f\n", map.result.measures.l2);
  }
  folders.write("border_motion.png", pictures);
}

inline void draw_balances(const Folders& folders)
{
  std::vector<Picture> pictures;
  Style style = faces_style();
  style.has_corners = false;
  for(const double balance : {0., 0.3, 1.}) {
    Options options;
    CGAL_ext::Balanced_minimization balanced;
    balanced.balance = balance;
    options.minimization = balanced;
    const Map map = make_map(folders.mesh("lion-head.off"), options);
    pictures.push_back(draw_domain(map, style));
    std::printf("balance %g: L2 %.3f, Linf %.1f\n", balance, map.result.measures.l2, map.result.measures.linf);
  }
  folders.write("balances.png", pictures);
}

/// a surface on the square, and on the rectangle that suits it
inline void draw_rectangle(const Folders& folders)
{
  std::vector<Picture> pictures;
  for(const bool is_square : {true, false}) {
    Options options;
    options.search_options.moves_corners = true;
    CGAL_ext::Balanced_minimization balanced;
    if(!is_square)
      balanced.aspect.reset();
    options.minimization = balanced;
    const Map map = make_map(folders.mesh("eight.off"), options);
    pictures.push_back(draw_surface(map));
    pictures.push_back(draw_domain(map, faces_style()));
    if(is_square)
      std::printf("square: L2 %.3f\n", map.result.measures.l2);
    else
      std::printf("rectangle: aspect %.3f, L2 %.3f\n", map.result.aspect, map.result.measures.l2);
  }
  folders.write("rectangle.png", pictures);
}

} // namespace figures

#endif // FIGURES_DRAW_MAP_FIGURES_H
