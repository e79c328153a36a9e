// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SURFACE_SPLIT_SURFACE_CHORDS_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SURFACE_SPLIT_SURFACE_CHORDS_H

#include <CGAL_ext/Square_parameterization/internal/surface/Triangle_surface.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace CGAL_ext {
namespace internal {

/// splits a triangle at the given midpoints of its sides; -1 for a side that stays whole
inline void split_triangle(const std::array<int, 3>& t, const std::array<int, 3>& midpoints,
                           std::vector<std::array<int, 3>>& parts)
{
  for(int k = 0; k < 3; ++k) {
    const int middle = midpoints[k]; // on the side opposite to corner k
    if(middle < 0)
      continue;
    const int a = t[k], b = t[(k + 1) % 3], c = t[(k + 2) % 3];
    split_triangle({a, b, middle}, {-1, -1, midpoints[(k + 2) % 3]}, parts);
    split_triangle({a, middle, c}, {-1, midpoints[(k + 1) % 3], -1}, parts);
    return;
  }
  parts.push_back(t);
}

/// splits edges at their midpoints
inline Triangle_surface split_surface_edges(Triangle_surface surface, const std::vector<int>& edges)
{
  if(edges.empty())
    return surface;
  std::vector<int> midpoints(surface.edges.size(), -1);
  std::vector<Eigen::Vector3d> points = surface.points;
  for(int e : edges) {
    const auto& [a, b] = surface.edges[e];
    midpoints[e] = static_cast<int>(points.size());
    points.push_back(surface.points[a] / 2 + surface.points[b] / 2);
  }
  std::vector<std::array<int, 3>> triangles;
  for(int f = 0; f < surface.number_of_faces(); ++f) {
    const auto middle_of = [&](int k) { return midpoints[surface.edge_of_halfedge[3 * f + k]]; };
    split_triangle(surface.triangles[f], {middle_of(1), middle_of(2), middle_of(0)}, triangles);
  }
  return make_triangle_surface(std::move(points), std::move(triangles));
}

/// splits every interior edge between two border vertices at its midpoint: see `split_chords()`, which does the same to
/// a mesh
inline Triangle_surface split_surface_chords(Triangle_surface surface)
{
  std::vector<int> chords;
  for(int e = 0; e < surface.number_of_edges(); ++e) {
    const auto& [a, b] = surface.edges[e];
    if(!surface.is_border_edge(e) && surface.is_border_vertex[a] && surface.is_border_vertex[b])
      chords.push_back(e);
  }
  return split_surface_edges(std::move(surface), chords);
}

/// gives a border of three edges a fourth: see `lengthen_border()`, which does the same to a mesh
/// \pre there is one border at most
inline Triangle_surface lengthen_surface_border(Triangle_surface surface)
{
  if(surface.border_loops.empty() || surface.border_loops.front().size() != 3)
    return surface;
  std::vector<int> border;
  for(int e = 0; e < surface.number_of_edges(); ++e)
    if(surface.is_border_edge(e))
      border.push_back(e);
  const auto is_shorter = [&](int e, int f) { return surface.lengths[e] < surface.lengths[f]; };
  const int longest = *std::max_element(border.begin(), border.end(), is_shorter);
  return split_surface_edges(std::move(surface), {longest});
}

} // namespace internal
} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SURFACE_SPLIT_SURFACE_CHORDS_H
