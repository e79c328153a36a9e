// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SURFACE_SPLIT_SURFACE_EDGES_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SURFACE_SPLIT_SURFACE_EDGES_H

#include <CGAL_ext/Square_parameterization/Chords.h>
#include <CGAL_ext/Square_parameterization/internal/surface/Triangle_surface.h>

#include <algorithm>
#include <array>
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

/// the chords of a surface: interior edges with both ends on the border. Ears are cut off by one that has a triangle with
/// two border edges.
/// \param is_border_vertex,is_border_edge tell of vertices and edges of the surface what counts as border
template <class Is_border_vertex, class Is_border_edge>
std::vector<int> chords_of(const Triangle_surface& surface, Chords which, Is_border_vertex is_border_vertex,
                           Is_border_edge is_border_edge)
{
  const auto cuts_off_a_face = [&](int h) {
    return h >= 0 && is_border_edge(surface.edge_of_halfedge[Triangle_surface::next(h)]) &&
           is_border_edge(surface.edge_of_halfedge[Triangle_surface::previous(h)]);
  };
  std::vector<int> chords;
  for(int e = 0; e < surface.number_of_edges(); ++e) {
    const auto& [a, b] = surface.edges[e];
    if(is_border_edge(e) || !is_border_vertex(a) || !is_border_vertex(b))
      continue;
    const int h = surface.edge_halfedges[e];
    if(which == Chords::ALL || cuts_off_a_face(h) || cuts_off_a_face(surface.opposites[h]))
      chords.push_back(e);
  }
  return chords;
}

/// as above, with the border of the surface
inline std::vector<int> chords_of(const Triangle_surface& surface, Chords which)
{
  return chords_of(
      surface, which, [&surface](int v) { return bool(surface.is_border_vertex[v]); },
      [&surface](int e) { return surface.is_border_edge(e); });
}

/// the longest edge of a border of three edges, which is too short for a square; none for a longer one. Ties go to the
/// lowest edge.
/// \pre there is one border at most
inline std::optional<int> border_edge_to_split(const Triangle_surface& surface)
{
  if(surface.border_loops.empty() || surface.border_loops.front().size() != 3)
    return {};
  std::vector<int> border;
  for(int e = 0; e < surface.number_of_edges(); ++e)
    if(surface.is_border_edge(e))
      border.push_back(e);
  const auto is_shorter = [&](int e, int f) { return surface.lengths[e] < surface.lengths[f]; };
  return *std::max_element(border.begin(), border.end(), is_shorter);
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SURFACE_SPLIT_SURFACE_EDGES_H
