// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SURFACE_MESH_EDGES_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SURFACE_MESH_EDGES_H

#include <CGAL_ext/Square_parameterization/internal/surface/Face_graph_arrays.h>
#include <CGAL_ext/Square_parameterization/internal/surface/halfedge_between.h>

#include <algorithm>
#include <array>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// the edges of a mesh by their numbers in its arrays
template <class TriangleMesh>
class Mesh_edges
{
public:
  typedef typename boost::graph_traits<TriangleMesh>::vertex_descriptor vertex_descriptor;
  typedef typename boost::graph_traits<TriangleMesh>::edge_descriptor edge_descriptor;

  /// \param vertices those that the vertices of the arrays stand for
  /// \param edges of the arrays, #E: their ends
  Mesh_edges(const TriangleMesh& mesh, const std::vector<vertex_descriptor>& vertices,
             const std::vector<std::array<int, 2>>& edges)
  {
    for(const auto& [a, b] : edges)
      m_edges.push_back(edge(halfedge_between(vertices[a], vertices[b], mesh), mesh));
  }

  edge_descriptor operator[](int e) const { return m_edges[e]; }

private:
  std::vector<edge_descriptor> m_edges; // #E
};

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SURFACE_MESH_EDGES_H
