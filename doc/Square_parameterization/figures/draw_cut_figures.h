// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FIGURES_DRAW_CUT_FIGURES_H
#define FIGURES_DRAW_CUT_FIGURES_H

#include "Folders.h"

#include <CGAL_ext/Square_parameterization/internal/sampling/locate_samples.h>

#include <Eigen/Geometry>

#include <cmath>
#include <cstdio>
#include <numeric>
#include <utility>
#include <vector>

// Figures of what is done to a surface before and after it is mapped: chords, cuts, samples.

namespace figures {

/// a corner of the surface that a chord cuts off, before and after the chord is split
inline void draw_chord(const Folders& folders)
{
  Mesh mesh;
  std::vector<Mesh::Vertex_index> v;
  for(int j = 0; j <= 3; ++j)
    for(int i = 0; i <= 3; ++i)
      v.push_back(mesh.add_vertex(Kernel::Point_3(i, j, 0)));
  for(int j = 0; j < 3; ++j)
    for(int i = 0; i < 3; ++i) {
      const auto a = v[4 * j + i], b = v[4 * j + i + 1], c = v[4 * j + i + 5], d = v[4 * j + i + 4];
      // only the diagonal of the first cell joins two border vertices that are not neighbors along the border
      const bool falls = (i == 0 && j == 0) || (i == 0 && j == 2) || (i == 2 && j == 0);
      mesh.add_face(a, b, falls ? d : c);
      falls ? mesh.add_face(b, c, d) : mesh.add_face(a, c, d);
    }
  Style style;
  style.has_edges = true;
  style.has_checkerboard = style.has_corners = false;
  style.size = 240;
  const Map after = make_map(mesh);
  Map before = after;
  auto [arrays, vertices] = CGAL_ext::internal::read_faces(mesh, mesh.faces(), mesh.points());
  before.points = std::move(arrays.points);
  before.triangles = std::move(arrays.triangles);
  before.uv.setZero(static_cast<Eigen::Index>(before.points.size()), 2);
  before.normals.assign(before.points.size(), Eigen::Vector3d::UnitZ());
  before.border = border_edges(before.triangles);
  folders.write("chord.png", {draw_surface(before, style), draw_surface(after, style)});
  std::printf("chords: %zu split\n", after.result.chords_split);
}

inline Style hand_style()
{
  Style style;
  style.front = {0.3, -1, 0.2};
  style.up = {0, 0, 1};
  return style;
}

inline void draw_cut(const Folders& folders)
{
  const Map map = make_map(folders.mesh("hand.off"));
  const Style style = hand_style();
  folders.write("cut.png", {draw_surface(map, style), draw_domain(map, faces_style())});
  std::printf("cut: length %.3f, L2 %.3f\n", map.result.cut.cut_length, map.result.measures.l2);
}

/// samples as a picture, and the surface rebuilt from them
inline void draw_geometry_image(const Folders& folders)
{
  constexpr int SAMPLES = 65;
  Options options;
  options.seam_grid = CGAL_ext::Grid_size{SAMPLES, SAMPLES};
  const Map map = make_map(folders.mesh("hand.off"), options);
  Map rebuilt;
  rebuilt.uv.resize(SAMPLES * SAMPLES, 2);
  Eigen::AlignedBox3d box;
  for(const auto& [f, weights] : CGAL_ext::internal::locate_samples(map.triangles, map.uv, *options.seam_grid)) {
    const int s = static_cast<int>(rebuilt.points.size()), i = s % SAMPLES, j = s / SAMPLES;
    rebuilt.points.push_back(CGAL_ext::internal::interpolated(map.points, map.triangles[f], weights));
    box.extend(rebuilt.points.back());
    rebuilt.uv.row(s) << i / (SAMPLES - 1.), j / (SAMPLES - 1.);
    if(i > 0 && j > 0) {
      rebuilt.triangles.push_back({s - SAMPLES - 1, s - SAMPLES, s});
      rebuilt.triangles.push_back({s - SAMPLES - 1, s, s - 1});
    }
  }
  std::vector<int> itself(rebuilt.points.size());
  std::iota(itself.begin(), itself.end(), 0);
  rebuilt.normals = CGAL_ext::internal::vertex_normals(rebuilt.points, rebuilt.triangles, itself);
  Style style = hand_style();
  Picture image{style.size, style.size, {}};
  for(int y = 0; y < style.size; ++y)
    for(int x = 0; x < style.size; ++x) {
      const int i = x * SAMPLES / style.size, j = (style.size - 1 - y) * SAMPLES / style.size;
      const Eigen::Vector3d share =
          (rebuilt.points[static_cast<std::size_t>(j * SAMPLES + i)] - box.min()).cwiseQuotient(box.sizes());
      Color color{};
      for(int c = 0; c < 3; ++c)
        color[c] = static_cast<std::uint8_t>(std::lround(255 * share[c]));
      image.pixels.push_back(color);
    }
  style.has_corners = style.has_checkerboard = false;
  style.has_edges = true;
  folders.write("geometry_image.png", {image, draw_surface(rebuilt, style)});
  std::printf("geometry image: %zu pairs of samples along the seams\n", map.result.seam_samples.size());
}

} // namespace figures

#endif // FIGURES_DRAW_CUT_FIGURES_H
