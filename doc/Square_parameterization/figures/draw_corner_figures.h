// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FIGURES_DRAW_CORNER_FIGURES_H
#define FIGURES_DRAW_CORNER_FIGURES_H

#include "Folders.h"
#include "draw_curve.h"

#include <CGAL_ext/Square_parameterization/Hybrid_corner_search.h>
#include <CGAL_ext/Square_parameterization/Step_sampling_corner_search.h>
#include <CGAL_ext/Square_parameterization/circle_corner_searches.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

// Figures of the choice of corners.

namespace figures {

inline const char* const SADDLE = "poly2x^2+y^2-0.062500.off";

/// all candidates of the quarter
inline Map map_all_candidates(const Mesh& mesh, Options options = {})
{
  options.search = CGAL_ext::Quarter_brute_force_corner_search();
  return make_map(mesh, options);
}

inline Map map_candidate(const Mesh& mesh, int candidate)
{
  Options options;
  options.search = Only_candidate{candidate};
  return make_map(mesh, options);
}

/// the worst and the best choice of corners: the reason why they are searched
inline void draw_corners(const Folders& folders)
{
  const Mesh mesh = folders.mesh(SADDLE);
  const Map best = map_all_candidates(mesh);
  const auto& curve = best.result.search.curve;
  const auto worst_sample = std::max_element(curve.begin(), curve.end(),
                                             [](const auto& a, const auto& b) { return a.objective < b.objective; });
  const Map worst = map_candidate(mesh, worst_sample->candidate);
  Style style;
  style.front = {0.4, -0.6, 1.3};
  style.up = {0, 0, 1};
  folders.write("corners.png", {draw_surface(worst, style), draw_surface(best, style)});
  std::printf("corners: L2 %.3f and %.3f\n", worst.result.measures.l2, best.result.measures.l2);
}

/// where the sides of the square end, with few border vertices
inline void draw_corner_rules(const Folders& folders)
{
  std::vector<Picture> pictures;
  Style style = faces_style();
  style.size = 230;
  for(const auto rule : {CGAL_ext::Corner_rule::NEAREST, CGAL_ext::Corner_rule::AUTHOR}) {
    Options options;
    options.search = CGAL_ext::First_candidate_corner_search();
    options.search_options.corner_rule = rule;
    options.minimization = with_border(CGAL_ext::Border_motion::FIXED);
    const Map map = make_map(folders.mesh("nefertiti.off"), options);
    pictures.push_back(draw_surface(map, style));
    pictures.push_back(draw_domain(map, style));
    std::printf("corner rules: L2 %.4f\n", map.result.measures.l2);
  }
  folders.write("corner_rules.png", pictures);
}

/// the curve of the objective, and where strategies look at it
inline void draw_strategies(const Folders& folders)
{
  const Mesh mesh = folders.mesh(SADDLE);
  Options options;
  options.minimization = CGAL_ext::Stretch_minimization();
  const CGAL_ext::Search_report all = map_all_candidates(mesh, options).result.search;
  std::vector<Strategy_samples> strategies;
  for(const auto& [name, search] : std::vector<std::pair<std::string, CGAL_ext::Corner_search>>{
          {"bracketing", CGAL_ext::Bracketing_corner_search()},
          {"hybrid", CGAL_ext::Hybrid_corner_search()},
          {"step sampling", CGAL_ext::Step_sampling_corner_search()},
          {"better of two", CGAL_ext::Better_of_two_corner_search()}}) {
    options.search = search;
    strategies.push_back({name, make_map(mesh, options).result.search});
    std::printf("%s: %zu of %d candidates, best %d\n", name.c_str(), strategies.back().report.evaluations,
                all.candidates, *strategies.back().report.best_candidate);
  }
  folders.write("strategies.svg", curve_svg(all, strategies));
}

} // namespace figures

#endif // FIGURES_DRAW_CORNER_FIGURES_H
