// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SURFACE_TRIANGLE_SURFACE_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SURFACE_TRIANGLE_SURFACE_H

#include <CGAL_ext/Square_parameterization/internal/common/Thread_team.h>
#include <CGAL_ext/Square_parameterization/internal/patch/number_edges.h>
#include <CGAL_ext/Square_parameterization/internal/surface/Incident_edges.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// a connected, oriented, manifold triangle surface of any genus with any number of border loops, as flat arrays with
/// the neighborhoods that cutting needs.
///
/// Halfedge 3 f + k runs from corner k of triangle f to the next corner, with the triangle on its left.
struct Triangle_surface
{
  std::vector<Eigen::Vector3d> points;        ///< #V
  std::vector<std::array<int, 3>> triangles;  ///< #F
  std::vector<std::array<int, 2>> edges;      ///< #E, first index lower, sorted
  std::vector<double> lengths;                ///< #E
  std::vector<int> edge_of_halfedge;          ///< 3 #F
  std::vector<int> opposites;                 ///< 3 #F, -1 where there is no triangle on the other side
  std::vector<int> edge_halfedges;            ///< #E, the lowest halfedge of the edge
  Incident_edges vertex_edges;                ///< per vertex
  std::vector<std::vector<int>> border_loops; ///< vertices of each loop, counter-clockwise
  std::vector<bool> is_border_vertex;         ///< #V
  double area = 0;

  int number_of_vertices() const { return static_cast<int>(points.size()); }
  int number_of_edges() const { return static_cast<int>(edges.size()); }
  int number_of_faces() const { return static_cast<int>(triangles.size()); }

  int origin(int h) const { return triangles[h / 3][h % 3]; }
  int target(int h) const { return triangles[h / 3][(h % 3 + 1) % 3]; }
  static int next(int h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static int previous(int h) { return h % 3 == 0 ? h + 2 : h - 1; }

  bool is_border_edge(int e) const { return opposites[edge_halfedges[e]] < 0; }

  /// the end of edge `e` that is not `v`
  int other_end(int e, int v) const { return edges[e][0] == v ? edges[e][1] : edges[e][0]; }

  int euler_characteristic() const { return number_of_vertices() - number_of_edges() + number_of_faces(); }
  int genus() const { return (2 - static_cast<int>(border_loops.size()) - euler_characteristic()) / 2; }
  bool is_disk() const { return border_loops.size() == 1 && euler_characteristic() == 1; }
  bool is_sphere() const { return border_loops.empty() && euler_characteristic() == 2; }
};

/// fills `opposites`, `edge_of_halfedge` and `edge_halfedges` of a surface whose triangles and edges are set
inline void join_halfedges(Triangle_surface& surface, const std::vector<std::array<int, 3>>& triangle_edges)
{
  surface.opposites.assign(3 * surface.triangles.size(), -1);
  surface.edge_of_halfedge.resize(3 * surface.triangles.size());
  surface.edge_halfedges.assign(surface.edges.size(), -1);
  for(int h = 0; h < 3 * surface.number_of_faces(); ++h) {
    const int e = triangle_edges[h / 3][(h % 3 + 2) % 3]; // opposite to the third corner
    surface.edge_of_halfedge[h] = e;
    int& first = surface.edge_halfedges[e];
    if(first < 0)
      first = h;
    else {
      surface.opposites[h] = first;
      surface.opposites[first] = h;
    }
  }
}

/// fills `border_loops` and `is_border_vertex` of a surface whose halfedges are joined
inline void find_border_loops(Triangle_surface& surface)
{
  std::vector<int> leaving(surface.points.size(), -1); // the border halfedge that begins at a vertex
  for(int h = 0; h < 3 * surface.number_of_faces(); ++h)
    if(surface.opposites[h] < 0)
      leaving[surface.origin(h)] = h;
  surface.is_border_vertex.assign(surface.points.size(), false);
  for(int first = 0; first < surface.number_of_vertices(); ++first) {
    if(leaving[first] < 0 || surface.is_border_vertex[first])
      continue;
    std::vector<int> loop;
    for(int v = first; !surface.is_border_vertex[v]; v = surface.target(leaving[v])) {
      surface.is_border_vertex[v] = true;
      loop.push_back(v);
    }
    surface.border_loops.push_back(std::move(loop));
  }
}

/// makes the surface, with the threads of the current team. Lengths are those of \p points as they are.
/// \param numbering of the edges of the triangles
/// \pre the triangles are oriented and manifold, and every vertex belongs to one
inline Triangle_surface make_triangle_surface(std::vector<Eigen::Vector3d> points,
                                              std::vector<std::array<int, 3>> triangles, Edge_numbering numbering)
{
  Triangle_surface surface;
  surface.points = std::move(points);
  surface.triangles = std::move(triangles);
  surface.edges = std::move(numbering.edges);
  const auto join = [&] {
    join_halfedges(surface, numbering.triangle_edges);
    find_border_loops(surface);
  };
  const auto measure = [&] {
    surface.lengths.reserve(surface.edges.size());
    for(const auto& [a, b] : surface.edges)
      surface.lengths.push_back((surface.points[b] - surface.points[a]).norm());
    for(const auto& [a, b, c] : surface.triangles)
      surface.area += (surface.points[b] - surface.points[a]).cross(surface.points[c] - surface.points[a]).norm() / 2;
  };
  Thread_team::current()(3, [&](std::size_t i) {
    if(i == 0)
      join();
    else if(i == 1)
      measure();
    else
      surface.vertex_edges = Incident_edges(surface.points.size(), surface.edges);
  });
  return surface;
}

/// as above, and numbers the edges
inline Triangle_surface make_triangle_surface(std::vector<Eigen::Vector3d> points,
                                              std::vector<std::array<int, 3>> triangles)
{
  Edge_numbering numbering = number_edges(points.size(), triangles);
  return make_triangle_surface(std::move(points), std::move(triangles), std::move(numbering));
}

/// the edges of a surface, numbered as they are
inline Edge_numbering numbering_of(const Triangle_surface& surface)
{
  Edge_numbering numbering;
  numbering.edges = surface.edges;
  numbering.triangle_edges.reserve(surface.triangles.size());
  numbering.number_of_triangles.reserve(surface.edges.size());
  for(int h = 0; h < 3 * surface.number_of_faces(); h += 3) // edge k is opposite to corner k
    numbering.triangle_edges.push_back(
        {surface.edge_of_halfedge[h + 1], surface.edge_of_halfedge[h + 2], surface.edge_of_halfedge[h]});
  for(int e = 0; e < surface.number_of_edges(); ++e)
    numbering.number_of_triangles.push_back(surface.is_border_edge(e) ? 1 : 2);
  return numbering;
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SURFACE_TRIANGLE_SURFACE_H
