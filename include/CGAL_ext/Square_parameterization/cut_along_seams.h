// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_CUT_ALONG_SEAMS_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_CUT_ALONG_SEAMS_H

#include <CGAL_ext/Square_parameterization/internal/cut/open_seams.h>

#include <CGAL/Named_function_parameters.h>

#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL_ext {

/// \ingroup PkgSquareParameterizationConditioning
///
/// returns a copy of a surface that is cut open along seams, such as `mark_seams()` marks. Vertices and faces keep
/// their order; where seams part the faces round a vertex, copies of it come last, at the same point. Complexity:
/// linear.
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
template <class TriangleMesh, class SeamEdgeMap, class NamedParameters = CGAL::parameters::Default_named_parameters>
TriangleMesh cut_along_seams(const TriangleMesh& mesh, SeamEdgeMap seam_edges,
                             const NamedParameters& np = NamedParameters())
{
  namespace CP = CGAL::parameters;
  typedef typename boost::graph_traits<TriangleMesh>::vertex_descriptor vertex_descriptor;
  typedef typename boost::graph_traits<TriangleMesh>::edge_descriptor edge_descriptor;
  const auto vpm =
      CP::choose_parameter(CP::get_parameter(np, CGAL::internal_np::vertex_point), get(CGAL::vertex_point, mesh));
  auto originals = CP::choose_parameter(CP::get_parameter(np, CGAL::internal_np::vertex_to_vertex_output_iterator),
                                        CGAL::Emptyset_iterator());

  TriangleMesh result(mesh); // keeps the order, which CGAL::copy_face_graph() does not
  const auto result_points = get(CGAL::vertex_point, result);
  std::vector<edge_descriptor> seams;
  auto copied_edge = edges(result).begin();
  for(edge_descriptor e : edges(mesh)) {
    const auto h = halfedge(e, mesh);
    if(get(seam_edges, e) && !CGAL::is_border(h, mesh) && !CGAL::is_border(opposite(h, mesh), mesh))
      seams.push_back(*copied_edge);
    ++copied_edge;
  }
  std::unordered_map<vertex_descriptor, vertex_descriptor> original_of; // by vertex of the result
  auto copied_vertex = vertices(result).begin();
  for(vertex_descriptor v : vertices(mesh)) {
    original_of.emplace(*copied_vertex, v);
    *originals++ = std::make_pair(v, *copied_vertex);
    put(result_points, *copied_vertex++, get(vpm, v));
  }
  for(const auto& [copy, first] : internal::open_seams(result, seams, result_points))
    *originals++ = std::make_pair(original_of.at(first), copy);
  return result;
}

} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_CUT_ALONG_SEAMS_H
