// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SURFACE_CHECK_SURFACE_IMPL_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SURFACE_CHECK_SURFACE_IMPL_H

#include <CGAL_ext/Square_parameterization/internal/common/Complaint.h>
#include <CGAL_ext/Square_parameterization/internal/common/Thread_team.h>
#include <CGAL_ext/Square_parameterization/internal/common/compiled_core.h>
#include <CGAL_ext/Square_parameterization/internal/patch/Patch.h>
#include <CGAL_ext/Square_parameterization/internal/surface/check_surface.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

CGAL_EXT_INLINE_FUNCTION void check_faces(const Surface_arrays& mesh)
{
  namespace SMP = CGAL::Surface_mesh_parameterization;
  if(mesh.triangles.empty())
    throw Unmappable(SMP::ERROR_EMPTY_MESH, "the surface has no faces");
  std::vector<std::string> places;
  std::size_t repeating = 0;
  for(std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    const auto& [a, b, c] = mesh.triangles[f];
    if((a == b || b == c || c == a) && ++repeating <= NAMED_PLACES)
      places.push_back("face " + std::to_string(f));
  }
  Complaint complaint;
  complaint.add(repeating, "face that repeats a vertex", "faces that repeat a vertex", places);
  complaint.throw_if_any(SMP::ERROR_NON_TRIANGULAR_MESH);
}

CGAL_EXT_INLINE_FUNCTION void check_edges(const Surface_arrays& mesh, const Edge_numbering& numbering)
{
  std::vector<std::string> places;
  std::size_t many = 0, border_edges = 0;
  for(std::size_t e = 0; e < numbering.edges.size(); ++e) {
    border_edges += numbering.number_of_triangles[e] == 1 ? 1 : 0;
    if(numbering.number_of_triangles[e] > 2 && ++many <= NAMED_PLACES)
      places.push_back("vertices " + std::to_string(mesh.place(numbering.edges[e][0])) + " and " +
                       std::to_string(mesh.place(numbering.edges[e][1])));
  }
  Complaint complaint;
  complaint.add(many, "non-manifold edge", "non-manifold edges", places);
  if(many == 0 && border_edges != mesh.border_sides)
    complaint.say("two of its border edges join the same two vertices");
  complaint.throw_if_any(CGAL::Surface_mesh_parameterization::ERROR_NO_TOPOLOGICAL_DISC);
}

/// indicates whether the surface is one component
inline bool is_connected(const Triangle_surface& surface)
{
  std::vector<bool> is_met(surface.triangles.size(), false);
  std::vector<int> front{0};
  is_met[0] = true;
  int met = 0;
  while(!front.empty()) {
    const int f = front.back();
    front.pop_back();
    ++met;
    for(int h = 3 * f; h < 3 * f + 3; ++h) {
      const int neighbor = surface.opposites[h] < 0 ? f : surface.opposites[h] / 3;
      if(!is_met[neighbor])
        front.push_back(neighbor);
      is_met[neighbor] = true;
    }
  }
  return met == surface.number_of_faces();
}

/// tells of vertices at which several fans of faces meet
inline Complaint complaint_about_vertices(const Surface_arrays& mesh, const Triangle_surface& surface)
{
  std::vector<bool> is_met(3 * surface.triangles.size(), false), has_fan(surface.points.size(), false);
  std::vector<std::string> places;
  std::size_t pinched = 0;
  for(int corner = 0; corner < 3 * surface.number_of_faces(); ++corner) {
    if(is_met[corner])
      continue;
    const int v = surface.origin(corner);
    if(has_fan[v] && ++pinched <= NAMED_PLACES)
      places.push_back("vertex " + std::to_string(mesh.place(v)));
    has_fan[v] = true;
    int h = corner;
    do // clockwise, round or to the border
      is_met[h] = true;
    while(surface.opposites[h] >= 0 && (h = Triangle_surface::next(surface.opposites[h])) != corner);
    if(surface.opposites[h] < 0) // the rest, counter-clockwise
      for(int before = surface.opposites[Triangle_surface::previous(corner)]; before >= 0;
          before = surface.opposites[Triangle_surface::previous(before)])
        is_met[before] = true;
  }
  Complaint complaint;
  complaint.add(pinched, "non-manifold vertex", "non-manifold vertices", places);
  return complaint;
}

/// refuses a surface that is not connected, or not manifold at its vertices, with the threads of the current team
inline void check_faces_joined(const Surface_arrays& mesh, const Triangle_surface& surface)
{
  namespace SMP = CGAL::Surface_mesh_parameterization;
  bool is_one_component = false;
  Complaint about_vertices;
  Thread_team::current()(2, [&](std::size_t i) {
    if(i == 0)
      is_one_component = is_connected(surface);
    else
      about_vertices = complaint_about_vertices(mesh, surface);
  });
  if(!is_one_component)
    throw Unmappable(SMP::ERROR_NO_TOPOLOGICAL_DISC, "the surface has more than one connected component");
  about_vertices.throw_if_any(SMP::ERROR_NO_TOPOLOGICAL_DISC);
}

CGAL_EXT_INLINE_FUNCTION Triangle_surface make_checked_surface(const Surface_arrays& mesh)
{
  check_faces(mesh);
  Edge_numbering numbering = number_edges(mesh.points.size(), mesh.triangles);
  check_edges(mesh, numbering);
  std::vector<Eigen::Vector3d> points = mesh.points;
  check_finite(points, [&mesh](std::size_t v) { return mesh.place(static_cast<int>(v)); });
  const double rounding = normalise_coordinates(points);
  const bool has_extent = std::any_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const auto& t) {
    return flatten(points[t[0]], points[t[1]], points[t[2]], rounding).y2 > 0;
  });
  if(!has_extent)
    refuse_without_extent();
  Triangle_surface surface = make_triangle_surface(std::move(points), mesh.triangles, std::move(numbering));
  check_faces_joined(mesh, surface);
  return surface;
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SURFACE_CHECK_SURFACE_IMPL_H
