// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SOUP_PLANAR_TRIANGULATION_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SOUP_PLANAR_TRIANGULATION_H

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_face_base_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL_ext {
namespace internal {

/// the constrained Delaunay triangulation of a polygon in the plane, and of other points
class Planar_triangulation
{
public:
  typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
  typedef std::vector<Kernel::Point_2> Points;
  typedef std::array<std::size_t, 3> Triangle;

  /// \param corners of a simple polygon, counter-clockwise
  /// \param others that lie on none of its sides
  Planar_triangulation(const Points& corners, const Points& others)
  {
    std::vector<std::pair<Kernel::Point_2, std::size_t>> numbered;
    for(const Points* points : {&corners, &others})
      for(const Kernel::Point_2& p : *points)
        numbered.emplace_back(p, numbered.size());
    m_triangulation.insert(numbered.begin(), numbered.end());
    std::vector<Vertex_handle> vertices(numbered.size());
    for(const Vertex_handle v : m_triangulation.finite_vertex_handles())
      vertices[v->info()] = v;
    for(std::size_t k = 0; k < corners.size(); ++k)
      m_triangulation.insert_constraint(vertices[k], vertices[(k + 1) % corners.size()]);
    find_inside(vertices[0], vertices[1]);
  }

  /// the triangles inside the polygon: numbers of corners and, after these, of the other points
  const std::vector<Triangle>& triangles() const { return m_triangles; }

private:
  typedef CGAL::Triangulation_vertex_base_with_info_2<std::size_t, Kernel> Vertex_base; // with its number
  typedef CGAL::Constrained_triangulation_face_base_2<Kernel> Constrained_base;
  typedef CGAL::Triangulation_face_base_with_info_2<bool, Kernel, Constrained_base>
      Face_base; // is it known to be inside?
  typedef CGAL::Triangulation_data_structure_2<Vertex_base, Face_base> Data_structure;
  typedef CGAL::Constrained_Delaunay_triangulation_2<Kernel, Data_structure, CGAL::No_constraint_intersection_tag>
      Triangulation;
  typedef Triangulation::Vertex_handle Vertex_handle;
  typedef Triangulation::Face_handle Face_handle;

  /// goes from the triangle on the left of the first side to all that no side parts from it
  void find_inside(Vertex_handle first, Vertex_handle second)
  {
    for(const Face_handle face : m_triangulation.all_face_handles())
      face->info() = false;
    Face_handle left;
    int opposite = 0; // number of the corner that is not on the side
    m_triangulation.is_edge(first, second, left, opposite);
    if(left->vertex(Triangulation::ccw(opposite)) != first)
      left = left->neighbor(opposite);
    std::vector<Face_handle> waiting;
    const auto enter = [&waiting](Face_handle face) {
      face->info() = true;
      waiting.push_back(face);
    };
    enter(left);
    while(!waiting.empty()) {
      const Face_handle face = waiting.back();
      waiting.pop_back();
      m_triangles.push_back({face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
      for(int i = 0; i < 3; ++i)
        if(!face->is_constrained(i) && !face->neighbor(i)->info())
          enter(face->neighbor(i));
    }
  }

  Triangulation m_triangulation;
  std::vector<Triangle> m_triangles;
};

} // namespace internal
} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SOUP_PLANAR_TRIANGULATION_H
