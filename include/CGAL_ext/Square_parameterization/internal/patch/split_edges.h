// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PATCH_SPLIT_EDGES_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PATCH_SPLIT_EDGES_H

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <cmath>
#include <cstddef>

namespace CGAL_ext {
namespace internal {

/// splits the edge of \p h at its midpoint, and the triangles beside it; returns the midpoint
template <class TriangleMesh, class VertexPointMap>
typename boost::graph_traits<TriangleMesh>::vertex_descriptor
split_edge_at_midpoint(typename boost::graph_traits<TriangleMesh>::halfedge_descriptor h, TriangleMesh& mesh,
                       VertexPointMap vpm)
{
  typedef typename boost::property_traits<VertexPointMap>::reference Reference;
  typedef typename boost::property_traits<VertexPointMap>::value_type Point;
  Reference p = get(vpm, source(h, mesh)), q = get(vpm, target(h, mesh));
  const auto middle = [](const auto& a, const auto& b) { return a / 2 + b / 2; };
  const Point midpoint(middle(p.x(), q.x()), middle(p.y(), q.y()), middle(p.z(), q.z()));
  const auto first = CGAL::Euler::split_edge(h, mesh); // ends at the new vertex; h begins there
  put(vpm, target(first, mesh), midpoint);
  if(!CGAL::is_border(first, mesh))
    CGAL::Euler::split_face(first, next(h, mesh), mesh);
  const auto second = opposite(h, mesh); // ends at the new vertex, on the other side
  if(!CGAL::is_border(second, mesh))
    CGAL::Euler::split_face(second, next(next(second, mesh), mesh), mesh);
  return target(first, mesh);
}

/// splits the longest edge of the border of \p bhd, again and again, until it has four edges: one for each side of the
/// square. Ties go to the edge met first. Returns how many were split.
template <class TriangleMesh, class VertexPointMap>
std::size_t lengthen_border(typename boost::graph_traits<TriangleMesh>::halfedge_descriptor bhd, TriangleMesh& mesh,
                            VertexPointMap vpm)
{
  const auto length = [&](auto h) {
    const auto& p = get(vpm, source(h, mesh));
    const auto& q = get(vpm, target(h, mesh));
    return std::hypot(CGAL::to_double(p.x()) - CGAL::to_double(q.x()), CGAL::to_double(p.y()) - CGAL::to_double(q.y()),
                      CGAL::to_double(p.z()) - CGAL::to_double(q.z()));
  };
  for(std::size_t splits = 0;; ++splits) {
    std::size_t edges = 0;
    auto longest = bhd;
    for(auto h : CGAL::halfedges_around_face(bhd, mesh)) {
      ++edges;
      if(length(h) > length(longest))
        longest = h;
    }
    if(edges >= 4)
      return splits;
    split_edge_at_midpoint(longest, mesh, vpm);
  }
}

} // namespace internal
} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PATCH_SPLIT_EDGES_H
