// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_FUZZ_CHECK_MAP_H
#define CGAL_EXT_FUZZ_CHECK_MAP_H

#include "reference_stretch.h"

#include <CGAL_ext/Square_parameterization/internal/soup/Surface_soup.h>
#include <CGAL_ext/Square_parameterization/parameterize_onto_square.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// What must hold for every surface that is mapped: else these throw.

typedef CGAL::Exact_predicates_inexact_constructions_kernel Fuzz_kernel;
typedef CGAL::Surface_mesh<Fuzz_kernel::Point_3> Fuzz_mesh;
typedef Fuzz_mesh::Property_map<Fuzz_mesh::Vertex_index, Fuzz_kernel::Point_2> Fuzz_uv_map;

/// throws a sentence unless the condition holds
inline void demand(bool condition, const std::string& sentence)
{
  if(!condition)
    throw std::logic_error(sentence);
}

/// the mesh of conditioned triangles
inline Fuzz_mesh mesh_of(const CGAL_ext::internal::Surface_soup& soup)
{
  const auto vertex = [](std::size_t v) { return Fuzz_mesh::Vertex_index(static_cast<Fuzz_mesh::size_type>(v)); };
  Fuzz_mesh mesh;
  for(const Eigen::Vector3d& p : soup.points)
    mesh.add_vertex(Fuzz_kernel::Point_3(p.x(), p.y(), p.z()));
  for(const auto& face : soup.faces)
    demand(mesh.add_face(vertex(face[0]), vertex(face[1]), vertex(face[2])) != Fuzz_mesh::null_face(),
           "a conditioned soup is no mesh");
  return mesh;
}

/// throws unless the mesh has one border and Euler characteristic 1
inline void check_disk(const Fuzz_mesh& mesh)
{
  std::set<Fuzz_mesh::Halfedge_index> border;
  for(Fuzz_mesh::Halfedge_index h : mesh.halfedges())
    if(mesh.is_border(h))
      border.insert(h);
  demand(!border.empty(), "the cut surface has no border");
  const auto first = *border.begin();
  auto h = first;
  do
    border.erase(h);
  while((h = mesh.next(h)) != first);
  demand(border.empty(), "the cut surface has several borders");
  demand(mesh.number_of_vertices() + mesh.number_of_faces() == mesh.number_of_edges() + 1,
         "the cut surface is no disk");
}

/// throws unless the cut surface is the uncut one with vertices copied and edges split, as the report says, and no
/// given seam is left in one piece
inline void check_cut(const Fuzz_mesh& uncut, const std::vector<Fuzz_mesh::Edge_index>& seams, const Fuzz_mesh& cut,
                      const CGAL_ext::Square_map_result<Fuzz_mesh>& result)
{
  typedef Fuzz_mesh::Vertex_index Vertex;
  const std::size_t splits = result.border_edges_split + result.chords_split;
  demand(cut.number_of_vertices() == uncut.number_of_vertices() + result.copies.size() + splits,
         "the number of vertices does not fit the report");
  for(Vertex v : uncut.vertices())
    demand(cut.point(v) == uncut.point(v), "a vertex has moved");
  std::map<Vertex, Vertex> originals;
  for(const auto& [copy, original] : result.copies) {
    demand(cut.point(copy) == uncut.point(original), "a copied vertex is elsewhere");
    originals[copy] = original;
  }
  const auto original = [&](Vertex v) { return originals.count(v) != 0 ? originals[v] : v; };
  std::set<std::pair<Vertex, Vertex>> inside; // edges of the uncut surface that are still no border
  for(Fuzz_mesh::Edge_index e : cut.edges())
    if(!cut.is_border(e))
      inside.insert(std::minmax({original(cut.vertex(e, 0)), original(cut.vertex(e, 1))}));
  for(Fuzz_mesh::Edge_index seam : seams)
    demand(inside.count(std::minmax({uncut.vertex(seam, 0), uncut.vertex(seam, 1)})) == 0, "a seam is not cut");
}

/// throws unless the map is onto the unit square and without flips, by exact predicates, and the report fits it
inline void check_one_to_one(const Fuzz_mesh& mesh, Fuzz_uv_map uv,
                             const CGAL_ext::Square_map_result<Fuzz_mesh>& result)
{
  for(Fuzz_mesh::Face_index f : mesh.faces()) {
    const auto h = mesh.halfedge(f);
    demand(CGAL::orientation(uv[mesh.source(h)], uv[mesh.target(h)], uv[mesh.target(mesh.next(h))]) == CGAL::LEFT_TURN,
           "face " + std::to_string(f.idx()) + " is flipped or flat");
  }
  for(Fuzz_mesh::Vertex_index v : mesh.vertices()) {
    const double x = uv[v].x(), y = uv[v].y();
    demand(x >= 0 && x <= 1 && y >= 0 && y <= 1, "vertex " + std::to_string(v.idx()) + " is off the square");
    demand(!mesh.is_border(v) || x == 0 || x == 1 || y == 0 || y == 1,
           "vertex " + std::to_string(v.idx()) + " is off the border");
  }
  demand(result.corners.size() == 4, "there are not four corners");
  for(int k = 0; k < 4; ++k)
    demand(uv[result.corners[k]] == Fuzz_kernel::Point_2(k == 1 || k == 2, k >= 2), "a corner is not at a corner");
  demand(result.measures.flipped_faces == 0 && result.measures.l2 >= 1 - 1e-9 && std::isfinite(result.measures.l2) &&
             std::isfinite(result.search.best_objective),
         "the report does not fit the map");
}

/// the side of the unit square that a point lies on, and what grows along it, counter-clockwise; a corner begins a side
inline std::pair<int, double> place_on_square(const Fuzz_kernel::Point_2& p)
{
  const double x = p.x(), y = p.y();
  return y == 0 && x < 1   ? std::make_pair(0, x)
         : x == 1 && y < 1 ? std::make_pair(1, y)
         : y == 1 && x > 0 ? std::make_pair(2, -x)
                           : std::make_pair(3, -y);
}

/// throws unless the border, from the vertex at (0, 0), runs once round the square, counter-clockwise
inline void check_border_walk(const Fuzz_mesh& mesh, Fuzz_uv_map uv, Fuzz_mesh::Vertex_index first)
{
  auto h = mesh.halfedge(first);
  while(!mesh.is_border(h))
    h = mesh.next_around_target(h);
  // a border halfedge has the surface on its right: backward is counter-clockwise
  for(h = mesh.prev(h); mesh.target(h) != first; h = mesh.prev(h))
    demand(place_on_square(uv[mesh.target(mesh.next(h))]) < place_on_square(uv[mesh.target(h)]),
           "the border turns back at vertex " + std::to_string(mesh.target(h).idx()));
}

/// the relative error of the area of a triangle in the plane when it is computed in double precision
inline long double area_error(const std::array<Eigen::Vector2d, 3>& p)
{
  const Eigen::Vector2d a = p[1] - p[0], b = p[2] - p[0];
  const long double left = static_cast<long double>(a.x()) * b.y(), right = static_cast<long double>(b.x()) * a.y();
  return std::ldexp(1.L, -51) * (std::abs(left) + std::abs(right)) / std::abs(left - right);
}

/// throws unless the stretch is what its formulas give in extended precision, up to what rounding makes of the height of
/// each face, which may be lost in that of the coordinates, and of the area of its image
inline void check_stretch(const Fuzz_mesh& mesh, Fuzz_uv_map uv, const CGAL_ext::Stretch_measures& measures)
{
  double largest = 0;
  for(const Fuzz_kernel::Point_3& p : mesh.points())
    largest = (std::max)({largest, std::abs(p.x()), std::abs(p.y()), std::abs(p.z())});
  const long double rounding = std::ldexp(static_cast<long double>(largest), -50);
  long double least_energy = 0, greatest_energy = 0, area = 0;
  for(Fuzz_mesh::Face_index f : mesh.faces()) {
    std::array<Eigen::Vector3d, 3> q;
    std::array<Eigen::Vector2d, 3> p;
    auto h = mesh.halfedge(f);
    for(std::size_t k = 0; k < 3; ++k, h = mesh.next(h)) {
      const Fuzz_mesh::Vertex_index v = mesh.target(h);
      q[k] = {mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z()};
      p[k] = {uv[v].x(), uv[v].y()};
    }
    const Reference_triangle t = reference_triangle(q, p);
    const long double longest =
        (std::max)({(q[1] - q[0]).stableNorm(), (q[2] - q[1]).stableNorm(), (q[0] - q[2]).stableNorm()});
    const long double uv_error = (std::min)(0.5L, area_error(p)); // the energy has the square of the area in it
    least_energy += t.l2_squared * (1 - 2 * uv_error) * (std::max)(0.L, t.surface_area - rounding * longest);
    greatest_energy += t.l2_squared / ((1 - uv_error) * (1 - uv_error)) * (t.surface_area + rounding * longest);
    area += t.surface_area;
  }
  const long double least = 0.999999L * std::sqrt(least_energy) / area; // the square has area 1
  const long double greatest = 1.000001L * std::sqrt(greatest_energy) / area;
  demand(measures.l2 >= least && measures.l2 <= greatest, "the L2 stretch is " + std::to_string(measures.l2) + "; " +
                                                              std::to_string(least) + " to " +
                                                              std::to_string(greatest) + " was expected");
}

#endif // CGAL_EXT_FUZZ_CHECK_MAP_H
