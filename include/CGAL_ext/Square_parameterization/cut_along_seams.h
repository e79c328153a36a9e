// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_CUT_ALONG_SEAMS_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_CUT_ALONG_SEAMS_H

#include <CGAL_ext/Square_parameterization/internal/cut/open_disk.h>
#include <CGAL_ext/Square_parameterization/internal/surface/Mesh_edges.h>
#include <CGAL_ext/Square_parameterization/internal/surface/apply_edits.h>

#include <CGAL/Named_function_parameters.h>

#include <cstddef>
#include <utility>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {

/// \ingroup PkgSquareParameterizationConditioning
///
/// returns a copy of a surface that is cut open along seams, such as `mark_seams()` marks. Vertices and faces keep
/// their order; where seams part the faces round a vertex, copies of it come last, at the same point (or in the places of
/// removed vertices, if the mesh has some). Complexity: all but linear.
///
/// \tparam TriangleMesh must be a model of `MutableFaceGraph`, `FaceListGraph` and `CopyConstructible`.
/// \tparam SeamEdgeMap must be a model of `ReadablePropertyMap` with the edge descriptor as key type and `bool` as
///         value type.
/// \tparam NamedParameters a sequence of named parameters
///
/// \param mesh the surface
/// \param seam_edges tells the seams; on border edges it does not matter
/// \param np optional named parameters among those below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{the positions of the vertices of `mesh`}
///     \cgalParamType{a model of `ReadablePropertyMap` with the vertex descriptor as key type and a 3D point as value
///                    type}
///     \cgalParamDefault{the internal vertex point map of `mesh`}
///     \cgalParamExtra{The positions of the result are in its internal vertex point map.}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_to_vertex_output_iterator}
///     \cgalParamDescription{receives, for every vertex of the result, the pair of the vertex of `mesh` that it is a
///                           copy of and the vertex itself}
///     \cgalParamType{a model of `OutputIterator` that accepts `std::pair` of two vertex descriptors}
///     \cgalParamDefault{`CGAL::Emptyset_iterator`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \pre all faces are triangles; no two edges join the same two vertices, and no vertex joins several fans of faces
template <class TriangleMesh, class SeamEdgeMap, class NamedParameters = CGAL::parameters::Default_named_parameters>
TriangleMesh cut_along_seams(const TriangleMesh& mesh, SeamEdgeMap seam_edges,
                             const NamedParameters& np = NamedParameters())
{
  namespace CP = CGAL::parameters;
  typedef typename boost::graph_traits<TriangleMesh>::vertex_descriptor vertex_descriptor;
  const auto vpm =
      CP::choose_parameter(CP::get_parameter(np, CGAL::internal_np::vertex_point), get(CGAL::vertex_point, mesh));
  auto originals = CP::choose_parameter(CP::get_parameter(np, CGAL::internal_np::vertex_to_vertex_output_iterator),
                                        CGAL::Emptyset_iterator());

  TriangleMesh result(mesh); // keeps the order, which CGAL::copy_face_graph() does not
  const auto result_points = get(CGAL::vertex_point, result);
  auto copied_vertex = vertices(result).begin();
  for(vertex_descriptor v : vertices(mesh)) {
    *originals++ = std::make_pair(v, *copied_vertex);
    put(result_points, *copied_vertex++, get(vpm, v));
  }
  const auto [arrays, vertex_list] = internal::read_faces(mesh, faces(mesh), vpm);
  const internal::Triangle_surface surface = internal::make_triangle_surface(arrays.points, arrays.triangles);
  const internal::Mesh_edges<TriangleMesh> mesh_edges(mesh, vertex_list, surface.edges);
  internal::Cut cut(surface);
  for(int e = 0; e < surface.number_of_edges(); ++e)
    if(!surface.is_border_edge(e) && get(seam_edges, mesh_edges[e]))
      cut.insert(surface, e);
  const internal::Surface_edits edits = internal::cut_edits(surface, cut);
  auto result_vertices = internal::read_faces(result, faces(result), result_points).vertices;
  internal::apply_edits(edits, result, result_points, result_vertices);
  for(std::size_t k = 0; k < edits.copies.size(); ++k)
    *originals++ = std::make_pair(vertex_list[edits.copies[k]], result_vertices[vertex_list.size() + k]);
  return result;
}

} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_CUT_ALONG_SEAMS_H
