// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SURFACE_HALFEDGE_BETWEEN_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SURFACE_HALFEDGE_BETWEEN_H

#include <boost/graph/graph_traits.hpp>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// the halfedge from vertex \p a to vertex \p b; null when there is none. Complexity: linear in the smaller of their
/// valences, for it walks round both at once; `halfedge(a, b, mesh)` of CGAL walks round one.
template <class TriangleMesh>
typename boost::graph_traits<TriangleMesh>::halfedge_descriptor
halfedge_between(typename boost::graph_traits<TriangleMesh>::vertex_descriptor a,
                 typename boost::graph_traits<TriangleMesh>::vertex_descriptor b, const TriangleMesh& mesh)
{
  const auto first_to_a = halfedge(a, mesh), first_to_b = halfedge(b, mesh);
  auto to_a = first_to_a, to_b = first_to_b;
  do {
    if(source(to_b, mesh) == a)
      return to_b;
    if(source(to_a, mesh) == b)
      return opposite(to_a, mesh);
    to_a = opposite(next(to_a, mesh), mesh);
    to_b = opposite(next(to_b, mesh), mesh);
  } while(to_a != first_to_a && to_b != first_to_b);
  return boost::graph_traits<TriangleMesh>::null_halfedge();
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SURFACE_HALFEDGE_BETWEEN_H
