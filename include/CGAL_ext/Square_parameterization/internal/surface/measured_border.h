// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SURFACE_MEASURED_BORDER_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SURFACE_MEASURED_BORDER_H

#include <CGAL_ext/Square_parameterization/internal/patch/Patch.h>
#include <CGAL_ext/Square_parameterization/internal/surface/component_faces.h>

#include <unordered_map>
#include <utility>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// the lengths of the border edges along \p loop, which is the border of \p bhd, in units of the square root of the
/// area of the component; see `border_lengths()` for short ones. Polygons count as fans of triangles.
///
/// Throws `Unmappable` as `measured_patch()`. Complexity: linear.
template <class TriangleMesh, class VertexPointMap>
std::vector<double>
measured_border(const TriangleMesh& mesh, typename boost::graph_traits<TriangleMesh>::halfedge_descriptor bhd,
                const std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor>& loop,
                VertexPointMap vpm)
{
  typedef typename boost::graph_traits<TriangleMesh>::vertex_descriptor vertex_descriptor;
  std::unordered_map<vertex_descriptor, int> index;
  std::vector<Eigen::Vector3d> points;
  const auto index_of = [&](vertex_descriptor v) {
    const auto [found, is_new] = index.emplace(v, static_cast<int>(points.size()));
    if(is_new)
      points.push_back(point_of(vpm, v));
    return found->second;
  };
  std::vector<std::array<int, 3>> triangles;
  for(auto f : faces_of_component(face(opposite(bhd, mesh), mesh), mesh)) {
    const auto first = halfedge(f, mesh);
    for(auto h = next(first, mesh); next(h, mesh) != first; h = next(h, mesh))
      triangles.push_back({index_of(source(first, mesh)), index_of(source(h, mesh)), index_of(target(h, mesh))});
  }
  std::vector<int> border;
  for(vertex_descriptor v : loop)
    border.push_back(index_of(v));
  return measured_patch(std::move(points), std::move(triangles), std::move(border)).border_lengths;
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SURFACE_MEASURED_BORDER_H
