// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_PARAMETERIZE_ONTO_SQUARE_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_PARAMETERIZE_ONTO_SQUARE_H

#include <CGAL_ext/Square_parameterization/Square_map_options.h>
#include <CGAL_ext/Square_parameterization/Square_map_result.h>
#include <CGAL_ext/Square_parameterization/error_message.h>
#include <CGAL_ext/Square_parameterization/internal/common/named_parameters.h>
#include <CGAL_ext/Square_parameterization/internal/patch/write_uv.h>
#include <CGAL_ext/Square_parameterization/internal/pipeline/map_surface.h>
#include <CGAL_ext/Square_parameterization/internal/surface/Face_graph_arrays.h>
#include <CGAL_ext/Square_parameterization/internal/surface/apply_edits.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {

/// \cond SKIP_IN_MANUAL
namespace internal {

/// the seams and corners of the options as vertices of the arrays. Throws `Unmappable` for one without a face.
template <class TriangleMesh>
Chosen_elements
chosen_elements(const Square_map_options<TriangleMesh>& options,
                const std::vector<typename Square_map_options<TriangleMesh>::vertex_descriptor>& vertices,
                const TriangleMesh& mesh, Square_map_report& report)
{
  namespace SMP = CGAL::Surface_mesh_parameterization;
  Chosen_elements chosen;
  if(options.seams.empty() && !options.corners)
    return chosen;
  std::map<typename Square_map_options<TriangleMesh>::vertex_descriptor, int> index;
  for(std::size_t v = 0; v < vertices.size(); ++v)
    index.emplace(vertices[v], static_cast<int>(v));
  for(auto e : options.seams) {
    const auto a = index.find(source(e, mesh)), b = index.find(target(e, mesh));
    if(a == index.end() || b == index.end())
      throw Unmappable(SMP::ERROR_WRONG_PARAMETER, "a seam is not an edge of a face of the mesh");
    chosen.seams.push_back({a->second, b->second});
  }
  if(!options.corners)
    return chosen;
  chosen.corners.emplace();
  for(int k = 0; k < 4; ++k) {
    const auto found = index.find((*options.corners)[k]);
    if(found == index.end()) {
      report.wrong_corner = k;
      throw Unmappable(SMP::ERROR_WRONG_PARAMETER, "a corner is not a vertex of a face of the mesh");
    }
    (*chosen.corners)[k] = found->second;
  }
  return chosen;
}

/// the values of triangles in the order in which a mesh has them after its edges were split
/// \param triangles those of the mesh, in another order, and with other first corners
/// \param vertices what they refer to
template <class TriangleMesh>
std::vector<double>
in_order_of_faces(const std::vector<double>& values, const std::vector<std::array<int, 3>>& triangles,
                  const std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor>& vertices,
                  const TriangleMesh& mesh)
{
  // the mesh may have new vertices in places of removed ones, before others: their numbers are not those of `read_faces()`
  auto index = get(CGAL::dynamic_vertex_property_t<int>(), mesh);
  for(std::size_t v = 0; v < vertices.size(); ++v)
    put(index, vertices[v], static_cast<int>(v));
  std::map<std::array<int, 3>, double> value_of;
  for(std::size_t f = 0; f < triangles.size(); ++f) {
    std::array<int, 3> corners = triangles[f];
    std::sort(corners.begin(), corners.end());
    value_of.emplace(corners, values[f]);
  }
  std::vector<double> result;
  for(auto f : faces(mesh)) {
    std::array<int, 3> corners{};
    auto corner = corners.begin();
    for(auto h : CGAL::halfedges_around_face(halfedge(f, mesh), mesh))
      *corner++ = get(index, source(h, mesh));
    std::sort(corners.begin(), corners.end());
    result.push_back(value_of.at(corners));
  }
  return result;
}

} // namespace internal
/// \endcond

namespace parameters {

/// \ingroup PkgSquareParameterizationFunctions
///
/// the named parameter that carries the options of `parameterize_onto_square()`. It must come first in a chain of named
/// parameters: `parameters::options(o).vertex_point_map(vpm)`.
template <class TriangleMesh>
CGAL::Named_function_parameters<Square_map_options<TriangleMesh>, internal::options_t>
options(const Square_map_options<TriangleMesh>& options)
{
  return {options};
}

} // namespace parameters

/// \ingroup PkgSquareParameterizationFunctions
///
/// maps a triangulated surface onto the unit square, one-to-one and with little stretch. Cuts it to a disk where it is
/// none, splits the chords, searches the corners, and writes the best map.
///
/// The border starts at the border vertex that comes first in the order of the mesh. The map is not mirrored.
///
/// All is decided on arrays, and the mesh is changed last: unless the status is `OK`, \p mesh and \p uvmap are as they
/// were. Calls for different meshes may run at the same time, if they do not share a visitor or a callback that does not
/// allow it.
///
/// \tparam TriangleMesh must be a model of `MutableFaceGraph` and `FaceListGraph`
/// \tparam VertexUVMap must be a model of `WritablePropertyMap` with the vertex descriptor as key type and a 2D point
///         as value type.
/// \tparam NamedParameters a sequence of named parameters
///
/// \param mesh the surface: one connected component of triangles. A surface that is not a disk (and one that is, if the
///        options say so) is cut in place, as `mark_seams()` marks and `cut_along_seams()` cuts (of two cuts
///        that all but tie, or where a cut leaves no good map, along the one with the better map); a border of
///        three edges gets a fourth, and chords are split; else it is not changed. New vertices and faces come last,
///        unless the mesh has places of removed ones for them.
/// \param uvmap receives the position of every vertex of a face, in [0, 1]^2
/// \param np optional named parameters among those below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{options}
///     \cgalParamDescription{the strategy, the minimization, the corner rule, the number of threads, the visitor, seams
///                           and corners}
///     \cgalParamType{`CGAL_ext::Square_map_options<TriangleMesh>`}
///     \cgalParamDefault{`CGAL_ext::Square_map_options<TriangleMesh>()`}
///     \cgalParamExtra{It is made by `CGAL_ext::parameters::options()` and must come first.}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{the positions of the vertices}
///     \cgalParamType{a model of `ReadWritePropertyMap` with the vertex descriptor as key type and a 3D point as value
///                    type}
///     \cgalParamDefault{the internal vertex point map of `mesh`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return the status, and on `OK` the corners, the stretch, the curve and the timings:
/// - `ERROR_EMPTY_MESH`, `ERROR_NON_TRIANGULAR_MESH`,
/// - `ERROR_NO_TOPOLOGICAL_DISC` when the mesh is not one connected manifold surface, or not a disk and not to be cut,
/// - `ERROR_WRONG_PARAMETER` when a coordinate is not finite, an option is out of range, or the corners make no sense,
/// - `ERROR_NO_1_TO_1_MAPPING` when no map was found, no face has an area, or the numbers of \p uvmap, as `float`, round faces
///   of the map flat, or over.
///
/// No exception is thrown for bad data; `std::bad_alloc` and what a user's visitor, callback or search throws comes out,
/// and leaves the mesh as it was, too.
///
/// Complexity: about \f$ V^{1.5} \f$ operations for each candidate that is mapped, see `Balanced_minimization`.
template <class TriangleMesh, class VertexUVMap, class NamedParameters = CGAL::parameters::Default_named_parameters>
Square_map_result<TriangleMesh> parameterize_onto_square(TriangleMesh& mesh, VertexUVMap uvmap,
                                                         const NamedParameters& np = NamedParameters())
{
  namespace CP = CGAL::parameters;
  typedef Square_map_result<TriangleMesh> Result;
  const auto options =
      CP::choose_parameter(CP::get_parameter(np, internal::options), Square_map_options<TriangleMesh>());
  const auto vpm =
      CP::choose_parameter(CP::get_parameter(np, CGAL::internal_np::vertex_point), get(CGAL::vertex_point, mesh));
  Result result;
  try {
    const TriangleMesh& const_mesh = mesh;
    auto [arrays, vertex_list] = internal::read_faces(const_mesh, faces(const_mesh), vpm);
    const std::size_t uncut = vertex_list.size();
    const internal::Mapped_surface mapped = internal::map_surface(
        std::move(arrays), internal::chosen_elements(options, vertex_list, const_mesh, result), options, result);
    internal::check_rounding<VertexUVMap>(mapped.triangles, mapped.uv);

    internal::apply_edits(mapped.edits, mesh, vpm, vertex_list);
    for(std::size_t k = 0; k < mapped.edits.copies.size(); ++k)
      result.copies.emplace_back(vertex_list[uncut + k], vertex_list[mapped.edits.copies[k]]);
    for(int v : mapped.corners)
      result.corners.push_back(vertex_list[v]);
    if(!mapped.edits.splits.empty())
      result.measures.face_l2 =
          internal::in_order_of_faces(result.measures.face_l2, mapped.triangles, vertex_list, const_mesh);
    internal::write_uv(vertex_list, mapped.uv, uvmap,
                       CGAL::Constant_property_map<typename Result::vertex_descriptor, bool>());
  } catch(const internal::Unmappable& error) {
    result.status = error.code();
    result.message = error.what();
  }
  return result;
}

} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_PARAMETERIZE_ONTO_SQUARE_H
