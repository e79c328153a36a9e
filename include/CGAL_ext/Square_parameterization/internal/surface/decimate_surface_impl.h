// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SURFACE_DECIMATE_SURFACE_IMPL_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SURFACE_DECIMATE_SURFACE_IMPL_H

#include <CGAL_ext/Square_parameterization/internal/common/compiled_core.h>
#include <CGAL_ext/Square_parameterization/internal/surface/decimate_surface.h>
#include <CGAL_ext/Square_parameterization/internal/surface/low_degree_collapses.h>
#include <CGAL_ext/Square_parameterization/internal/surface/thin_fans.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Bounded_normal_change_filter.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_cost.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_placement.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

// CGAL 6 renames this predicate and warns of the old name
#if __has_include(<CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Edge_count_stop_predicate.h>)
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Edge_count_stop_predicate.h>
#define CGAL_EXT_EDGE_COUNT_STOP_PREDICATE Edge_count_stop_predicate
#else
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Count_stop_predicate.h>
#define CGAL_EXT_EDGE_COUNT_STOP_PREDICATE Count_stop_predicate
#endif

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// stops when fewer edges are left than a number, or a deadline has passed
template <class Mesh>
class Edge_count_or_deadline_stop_predicate
{
public:
  Edge_count_or_deadline_stop_predicate(std::size_t edges, const Deadline& deadline)
    : m_has_few_edges(edges), m_deadline(deadline)
  {}

  template <class Cost, class Profile, class Count>
  bool operator()(const Cost& cost, const Profile& profile, Count initial_edges, Count edges) const
  {
    return has_passed(m_deadline) || m_has_few_edges(cost, profile, initial_edges, edges);
  }

private:
  CGAL::Surface_mesh_simplification::CGAL_EXT_EDGE_COUNT_STOP_PREDICATE<Mesh> m_has_few_edges;
  Deadline m_deadline;
};
#undef CGAL_EXT_EDGE_COUNT_STOP_PREDICATE

CGAL_EXT_INLINE_FUNCTION std::optional<Triangle_surface> decimate_surface(const Triangle_surface& surface, int faces,
                                                                          const Deadline& deadline)
{
  namespace SMS = CGAL::Surface_mesh_simplification;
  typedef CGAL::Simple_cartesian<double> Kernel;
  typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
  constexpr std::size_t MOST_TRIANGLES_OF_VERTEX = 64;
  constexpr int MOST_NEIGHBORS_OF_EDGE = 130; // fewer: parts with flat faces get another copy, and cut
  const Placement_of_low_degree placement(SMS::LindstromTurk_placement<Mesh>(), MOST_NEIGHBORS_OF_EDGE);
  const Cost_of_placement cost{SMS::LindstromTurk_cost<Mesh>()};
  Mesh mesh;
  for(const Eigen::Vector3d& p : surface.points)
    mesh.add_vertex(Kernel::Point_3(p.x(), p.y(), p.z()));
  for(const auto& [a, b, c] : surface.triangles)
    if(mesh.add_face(Mesh::Vertex_index(a), Mesh::Vertex_index(b), Mesh::Vertex_index(c)) == Mesh::null_face())
      return std::nullopt;
  thin_fans(mesh, MOST_TRIANGLES_OF_VERTEX, deadline);
  if(!has_passed(deadline)) // else even the costs of the edges are not computed
    SMS::edge_collapse(
        mesh, Edge_count_or_deadline_stop_predicate<Mesh>(3 * static_cast<std::size_t>(faces) / 2, deadline),
        CGAL::parameters::get_cost(cost).get_placement(placement).filter(SMS::Bounded_normal_change_filter<>()));
  if(has_passed(deadline))
    return std::nullopt;
  mesh.collect_garbage();

  std::vector<Eigen::Vector3d> points;
  for(Mesh::Vertex_index v : mesh.vertices())
    points.emplace_back(mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z());
  std::vector<std::array<int, 3>> triangles;
  for(Mesh::Face_index f : mesh.faces()) {
    const auto h = mesh.halfedge(f);
    const auto number = [](Mesh::Vertex_index v) { return static_cast<int>(v.idx()); };
    triangles.push_back({number(mesh.source(h)), number(mesh.target(h)), number(mesh.target(mesh.next(h)))});
  }
  const bool is_finite = std::all_of(points.begin(), points.end(), [](const auto& p) { return p.allFinite(); });
  Triangle_surface result = make_triangle_surface(std::move(points), std::move(triangles));
  if(!is_finite || result.border_loops.size() != surface.border_loops.size() || result.genus() != surface.genus())
    return std::nullopt;
  return result;
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SURFACE_DECIMATE_SURFACE_IMPL_H
