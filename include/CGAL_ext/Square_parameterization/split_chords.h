// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_SPLIT_CHORDS_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_SPLIT_CHORDS_H

#include <CGAL_ext/Square_parameterization/Chords.h>
#include <CGAL_ext/Square_parameterization/internal/common/named_parameters.h>
#include <CGAL_ext/Square_parameterization/internal/surface/Mesh_edges.h>
#include <CGAL_ext/Square_parameterization/internal/surface/apply_edits.h>
#include <CGAL_ext/Square_parameterization/internal/surface/split_edges.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <cstddef>
#include <utility>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {

namespace parameters {

/// \ingroup PkgSquareParameterizationConditioning
///
/// the named parameter that says which chords `split_chords()` splits. It must come first in a chain of named parameters:
/// `parameters::chords(c).vertex_point_map(vpm)`.
inline CGAL::Named_function_parameters<Chords, internal::chords_t> chords(Chords chords)
{
  return {chords};
}

} // namespace parameters

/// \ingroup PkgSquareParameterizationConditioning
///
/// splits the chords of a triangulated surface with border at their midpoints, and returns how many there were. A chord
/// is an interior edge with both ends on the border. When both ends come to lie on one side of the square the faces
/// beside the chord have no area: no one-to-one map exists. After the split each choice of corners has one.
///
/// The new vertices and faces come after the existing ones, unless the mesh has places of removed ones for them.
/// Complexity: all but linear.
///
/// \tparam TriangleMesh must be a model of `MutableFaceGraph`.
/// \tparam NamedParameters a sequence of named parameters
///
/// \param mesh the surface
/// \param np optional named parameters among those below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{chords}
///     \cgalParamDescription{which chords are split}
///     \cgalParamType{`CGAL_ext::Chords`}
///     \cgalParamDefault{`CGAL_ext::Chords::ALL`}
///     \cgalParamExtra{It is made by `CGAL_ext::parameters::chords()` and must come first.}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{the positions of the vertices}
///     \cgalParamType{a model of `ReadWritePropertyMap` with the vertex descriptor as key type and a 3D point as value
///                    type}
///     \cgalParamDefault{the internal vertex point map of `mesh`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \pre all faces are triangles, and no two edges join the same two vertices
template <class TriangleMesh, class NamedParameters = CGAL::parameters::Default_named_parameters>
std::size_t split_chords(TriangleMesh& mesh, const NamedParameters& np = NamedParameters())
{
  namespace CP = CGAL::parameters;
  CGAL_precondition(CGAL::is_triangle_mesh(mesh));
  const Chords which = CP::choose_parameter(CP::get_parameter(np, internal::chords), Chords::ALL);
  const auto vpm =
      CP::choose_parameter(CP::get_parameter(np, CGAL::internal_np::vertex_point), get(CGAL::vertex_point, mesh));
  const TriangleMesh& const_mesh = mesh;
  auto [arrays, vertex_list] = internal::read_faces(const_mesh, faces(const_mesh), vpm);
  const internal::Numbered_triangles surface(static_cast<int>(arrays.points.size()), std::move(arrays.triangles));
  internal::Surface_edits edits;
  for(int e : internal::chords_of(surface, which))
    edits.splits.push_back(surface.numbering.edges[e]);
  internal::apply_edits(edits, mesh, vpm, vertex_list);
  return edits.splits.size();
}

/// \ingroup PkgSquareParameterizationConditioning
///
/// splits the chords that \p mesh has as a `CGAL::Seam_mesh`: edges that are not seams between two vertices on seams or
/// borders. Returns how many there were. New edges and vertices are on no seam.
///
/// \tparam TriangleMesh must be a model of `MutableFaceGraph`.
/// \tparam SeamEdgeMap must be a model of `ReadWritePropertyMap` with the edge descriptor as key type and `bool` as
///         value type.
/// \tparam SeamVertexMap must be a model of `ReadWritePropertyMap` with the vertex descriptor as key type and `bool` as
///         value type.
/// \tparam NamedParameters a sequence of named parameters
///
/// \param mesh the surface
/// \param seam_edges,seam_vertices tell the seams
/// \param np optional named parameters among those below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{the positions of the vertices}
///     \cgalParamType{a model of `ReadWritePropertyMap` with the vertex descriptor as key type and a 3D point as value
///                    type}
///     \cgalParamDefault{the internal vertex point map of `mesh`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \pre all faces are triangles, no two edges join the same two vertices, and no `CGAL::Seam_mesh` of `mesh` has been
///      made yet
template <class TriangleMesh, class SeamEdgeMap, class SeamVertexMap,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
std::size_t split_seam_chords(TriangleMesh& mesh, SeamEdgeMap seam_edges, SeamVertexMap seam_vertices,
                              const NamedParameters& np = NamedParameters())
{
  namespace CP = CGAL::parameters;
  CGAL_precondition(CGAL::is_triangle_mesh(mesh));
  const auto vpm =
      CP::choose_parameter(CP::get_parameter(np, CGAL::internal_np::vertex_point), get(CGAL::vertex_point, mesh));
  const TriangleMesh& const_mesh = mesh;
  auto [arrays, vertex_list] = internal::read_faces(const_mesh, faces(const_mesh), vpm);
  const internal::Numbered_triangles surface(static_cast<int>(arrays.points.size()), std::move(arrays.triangles));
  const internal::Mesh_edges<TriangleMesh> mesh_edges(const_mesh, vertex_list, surface.numbering.edges);
  const std::size_t uncut = vertex_list.size();
  std::vector<bool> is_seam_vertex;
  for(auto v : vertex_list)
    is_seam_vertex.push_back(get(seam_vertices, v));
  const std::vector<bool> is_border_vertex = internal::border_vertices(surface);
  const std::vector<int> chords = internal::chords_of(
      surface, Chords::ALL, [&](int v) { return is_seam_vertex[v] || is_border_vertex[v]; },
      [&](int e) { return get(seam_edges, mesh_edges[e]) || surface.is_border_edge(e); });
  internal::Surface_edits edits;
  for(int e : chords)
    edits.splits.push_back(surface.numbering.edges[e]);
  internal::apply_edits(edits, mesh, vpm, vertex_list);
  for(std::size_t k = uncut; k < vertex_list.size(); ++k) {
    put(seam_vertices, vertex_list[k], false);
    for(auto h : CGAL::halfedges_around_target(vertex_list[k], mesh))
      put(seam_edges, edge(h, mesh), false);
  }
  return edits.splits.size();
}

} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_SPLIT_CHORDS_H
