// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SURFACE_SPLIT_EDGES_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SURFACE_SPLIT_EDGES_H

#include <CGAL_ext/Square_parameterization/Chords.h>
#include <CGAL_ext/Square_parameterization/internal/surface/Numbered_triangles.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

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

/// splits edges at their midpoints, which are the next vertices, in the order of the edges
inline Numbered_triangles split_edges(Numbered_triangles surface, const std::vector<int>& edges)
{
  if(edges.empty())
    return surface;
  std::vector<int> midpoints(surface.numbering.edges.size(), -1);
  int vertices = surface.number_of_vertices;
  for(int e : edges)
    midpoints[e] = vertices++;
  std::vector<std::array<int, 3>> triangles;
  triangles.reserve(surface.triangles.size() + 2 * edges.size());
  for(std::size_t f = 0; f < surface.triangles.size(); ++f) {
    const auto& [a, b, c] = surface.numbering.triangle_edges[f];
    split_triangle(surface.triangles[f], {midpoints[a], midpoints[b], midpoints[c]}, triangles);
  }
  return {vertices, std::move(triangles)};
}

/// the chords of a surface: interior edges with both ends on the border. Ears are cut off by one that has a triangle with
/// two border edges.
/// \param is_border_vertex,is_border_edge tell of vertices and edges of the surface what counts as border
template <class Is_border_vertex, class Is_border_edge>
std::vector<int> chords_of(const Numbered_triangles& surface, Chords which, Is_border_vertex is_border_vertex,
                           Is_border_edge is_border_edge)
{
  std::vector<bool> is_wanted(surface.numbering.edges.size(), which == Chords::ALL);
  if(which != Chords::ALL)
    for(const auto& edges : surface.numbering.triangle_edges)
      for(int k = 0; k < 3; ++k)
        if(is_border_edge(edges[(k + 1) % 3]) && is_border_edge(edges[(k + 2) % 3]))
          is_wanted[edges[k]] = true;
  std::vector<int> chords;
  for(int e = 0; e < surface.number_of_edges(); ++e) {
    const auto& [a, b] = surface.numbering.edges[e];
    if(is_wanted[e] && is_border_vertex(a) && is_border_vertex(b) && !is_border_edge(e))
      chords.push_back(e);
  }
  return chords;
}

/// per vertex, whether it is on the border
inline std::vector<bool> border_vertices(const Numbered_triangles& surface)
{
  std::vector<bool> is_border_vertex(surface.number_of_vertices, false);
  for(int e : surface.border_edges())
    for(int v : surface.numbering.edges[e])
      is_border_vertex[v] = true;
  return is_border_vertex;
}

/// as above, with the border of the surface
inline std::vector<int> chords_of(const Numbered_triangles& surface, Chords which)
{
  const std::vector<bool> is_border_vertex = border_vertices(surface);
  return chords_of(
      surface, which, [&](int v) { return bool(is_border_vertex[v]); },
      [&](int e) { return surface.is_border_edge(e); });
}

/// the longest edge of a border of three edges, which is too short for a square; none for a longer one. Ties go to the
/// lowest edge.
/// \param points_of_surface called for a border of three edges: makes the points of the vertices
/// \pre there is one border at most
template <class Make_points>
std::optional<int> border_edge_to_split(const Numbered_triangles& surface, const Make_points& points_of_surface)
{
  const std::vector<int> border = surface.border_edges();
  if(border.size() != 3)
    return {};
  const std::vector<Eigen::Vector3d> points = points_of_surface();
  const auto length = [&](int e) {
    const auto& [a, b] = surface.numbering.edges[e];
    return (points[b] - points[a]).norm();
  };
  return *std::max_element(border.begin(), border.end(), [&](int e, int f) { return length(e) < length(f); });
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SURFACE_SPLIT_EDGES_H
