// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SURFACE_FACE_GRAPH_PATCH_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SURFACE_FACE_GRAPH_PATCH_H

#include <CGAL_ext/Square_parameterization/internal/surface/component_faces.h>
#include <CGAL_ext/Square_parameterization/internal/surface/make_disk_patch.h>

#include <algorithm>
#include <utility>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// a patch and the mesh vertices that its vertices stand for
template <class TriangleMesh>
struct Face_graph_patch
{
  typedef typename boost::graph_traits<TriangleMesh>::vertex_descriptor vertex_descriptor;

  Patch patch;
  std::vector<vertex_descriptor> vertices; ///< #V
};

/// makes a patch of the connected component of \p mesh at the border halfedge \p bhd; vertices and faces keep the order
/// of the mesh. The border starts at source(bhd). Coordinates are read as `double`.
///
/// Throws `Unmappable` when the component is not a triangulated disk, and as `make_patch()`.
template <class TriangleMesh, class VertexPointMap>
Face_graph_patch<TriangleMesh>
make_face_graph_patch(const TriangleMesh& mesh, typename boost::graph_traits<TriangleMesh>::halfedge_descriptor bhd,
                      VertexPointMap vpm)
{
  if(!is_on_border_of_face(bhd, mesh))
    throw Unmappable(CGAL::Surface_mesh_parameterization::ERROR_BORDER_TOO_SHORT,
                     "the given halfedge is not on the border of a face");
  auto [arrays, vertices] = read_faces(mesh, faces_of_component(face(opposite(bhd, mesh), mesh), mesh), vpm);
  const auto start = std::find(vertices.begin(), vertices.end(), source(bhd, mesh)) - vertices.begin();
  return {make_disk_patch(std::move(arrays), static_cast<int>(start)), std::move(vertices)};
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SURFACE_FACE_GRAPH_PATCH_H
