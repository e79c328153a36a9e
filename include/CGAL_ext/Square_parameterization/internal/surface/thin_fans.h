// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SURFACE_THIN_FANS_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SURFACE_THIN_FANS_H

#include <CGAL_ext/Square_parameterization/internal/common/Deadline.h>

#include <CGAL/Kernel/global_functions.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// simplifies the surface round vertices of very many triangles, such as the middles of the lids of a cylinder: edges
/// opposite to them are collapsed, the shortest first. It prepares for CGAL's collapse of edges by their costs, whose
/// time grows with the cube of that number.
/// \tparam Mesh a `CGAL::Surface_mesh` of triangles
template <class Mesh>
class Fan_thinning
{
public:
  /// \param most triangles that a vertex may have
  Fan_thinning(Mesh& mesh, std::size_t most) : m_mesh(mesh), m_most(most), m_pass_of(mesh.number_of_vertices(), 0) {}

  /// thins each fan until it is small enough, its topology and shape allow no more, or the deadline has passed. A fan
  /// of n triangles takes O(n log n).
  void operator()(const Deadline& deadline)
  {
    const std::vector<Vertex> vertices(m_mesh.vertices().begin(), m_mesh.vertices().end());
    for(Vertex hub : vertices)
      while(!m_mesh.is_removed(hub) && m_mesh.degree(hub) > m_most && !has_passed(deadline) && thin(hub)) {
      }
  }

private:
  typedef typename Mesh::Vertex_index Vertex;
  typedef typename Mesh::Halfedge_index Halfedge;

  /// collapses edges opposite to \p hub that have no vertex in common, so that what is left is as even as before.
  /// Returns whether there was one.
  bool thin(Vertex hub)
  {
    std::vector<std::pair<double, Halfedge>> sides;
    for(Halfedge h : CGAL::halfedges_around_target(m_mesh.halfedge(hub), m_mesh))
      if(!m_mesh.is_border(h))
        sides.emplace_back(squared_length(m_mesh.prev(h)), m_mesh.prev(h));
    std::sort(sides.begin(), sides.end());
    ++m_pass;
    const std::size_t before = m_mesh.degree(hub);
    std::size_t left = before - m_most;
    for(auto side = sides.begin(); side != sides.end() && left > 0; ++side)
      if(is_new(m_mesh.source(side->second)) && is_new(m_mesh.target(side->second)) && collapse(side->second))
        --left;
    return m_mesh.degree(hub) < before;
  }

  double squared_length(Halfedge h) const
  {
    return (m_mesh.point(m_mesh.target(h)) - m_mesh.point(m_mesh.source(h))).squared_length();
  }

  /// indicates whether a vertex is no end of an edge that was collapsed in this pass
  bool is_new(Vertex v) const { return m_pass_of[v.idx()] != m_pass; }

  /// collapses an edge into one of its ends, a border vertex if there is one, unless that changes the topology or turns
  /// a triangle over; returns whether it did
  bool collapse(Halfedge h)
  {
    if(m_mesh.is_border(m_mesh.source(h)) && !m_mesh.is_border(m_mesh.target(h)))
      h = m_mesh.opposite(h);
    if(!CGAL::Euler::does_satisfy_link_condition(m_mesh.edge(h), m_mesh) || turns_triangle_over(h))
      return false;
    // of an edge the mesh collapses the source of its first halfedge
    const auto point = m_mesh.point(m_mesh.target(h));
    const Vertex kept = CGAL::Euler::collapse_edge(m_mesh.edge(h), m_mesh);
    m_mesh.point(kept) = point;
    m_pass_of[kept.idx()] = m_pass;
    return true;
  }

  /// indicates whether a triangle is turned over when the source of \p h moves to its target
  bool turns_triangle_over(Halfedge h) const
  {
    const auto &from = m_mesh.point(m_mesh.source(h)), &to = m_mesh.point(m_mesh.target(h));
    for(Halfedge spoke : CGAL::halfedges_around_source(h, m_mesh)) {
      if(m_mesh.is_border(spoke) || m_mesh.target(spoke) == m_mesh.target(h) ||
         m_mesh.target(m_mesh.next(spoke)) == m_mesh.target(h))
        continue;
      const auto &p = m_mesh.point(m_mesh.target(spoke)), &q = m_mesh.point(m_mesh.target(m_mesh.next(spoke)));
      if(CGAL::cross_product(p - from, q - from) * CGAL::cross_product(p - to, q - to) < 0)
        return true;
    }
    return false;
  }

  Mesh& m_mesh;
  std::size_t m_most;
  int m_pass = 0;
  std::vector<int> m_pass_of; // per vertex, the last pass that collapsed an edge into it
};

/// see `Fan_thinning`
template <class Mesh>
void thin_fans(Mesh& mesh, std::size_t most, const Deadline& deadline)
{
  Fan_thinning<Mesh>(mesh, most)(deadline);
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SURFACE_THIN_FANS_H
