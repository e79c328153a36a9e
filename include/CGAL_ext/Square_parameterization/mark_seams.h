// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_MARK_SEAMS_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_MARK_SEAMS_H

#include <CGAL_ext/Square_parameterization/Cut_options.h>
#include <CGAL_ext/Square_parameterization/Cut_report.h>
#include <CGAL_ext/Square_parameterization/internal/common/named_parameters.h>
#include <CGAL_ext/Square_parameterization/internal/cut/cut_to_disk.h>
#include <CGAL_ext/Square_parameterization/internal/surface/Mesh_edges.h>
#include <CGAL_ext/Square_parameterization/internal/surface/check_surface.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>

#include <array>
#include <string>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {

/// \ingroup PkgSquareParameterizationResults
///
/// what `mark_seams()` did
struct Seam_result
{
  /// `OK`, or why there is no cut
  CGAL::Surface_mesh_parameterization::Error_code status = CGAL::Surface_mesh_parameterization::OK;
  std::string message; ///< one sentence that names the condition and the place; empty on `OK`
  Cut_report cut;      ///< length, score and history
};

namespace parameters {

/// \ingroup PkgSquareParameterizationConditioning
///
/// the named parameter that carries the options of `mark_seams()`. It must come first in a chain of named parameters:
/// `parameters::options(o).vertex_point_map(vpm)`.
inline CGAL::Named_function_parameters<Seam_options, internal::options_t> options(const Seam_options& options)
{
  return {options};
}

} // namespace parameters

/// \ingroup PkgSquareParameterizationConditioning
///
/// marks the edges along which a closed or holed surface, of any genus and with any number of borders, is cut to a disk
/// that stretches little on the square. Afterwards exactly the seams are marked, ready for `CGAL::Seam_mesh`. Seams end
/// at the border or at other seams; a disk needs none, and gets some only on demand (`Cut_options::cuts_disk`).
///
/// Edges that are marked before stay seams, and what they lack is added; then nothing is decided by stretch.
///
/// The cut is grown from one that the topology needs: terminals are added, dropped and moved while the stretch that is
/// left on the square, plus the weighted length, falls; after Gu, Gortler and Hoppe \cgalCite{ggh-gi-02}. Large surfaces
/// are decided on by a simplified copy. Deterministic.
///
/// \tparam TriangleMesh must be a model of `FaceListGraph`.
/// \tparam SeamEdgeMap must be a model of `ReadWritePropertyMap` with the edge descriptor as key type and `bool` as
///         value type.
/// \tparam SeamVertexMap must be a model of `WritablePropertyMap` with the vertex descriptor as key type and `bool` as
///         value type.
/// \tparam NamedParameters a sequence of named parameters
///
/// \param mesh one connected component of triangles
/// \param seam_edges holds the edges to be cut in any case, and receives the seams. It is written only when the status
///        is `OK`.
/// \param seam_vertices receives the ends of the seams, as `CGAL::Seam_mesh` wants them
/// \param np optional named parameters among those below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{options}
///     \cgalParamDescription{whether the cut is short or leaves little stretch, and the price of its length}
///     \cgalParamType{`CGAL_ext::Seam_options`}
///     \cgalParamDefault{`CGAL_ext::Seam_options()`}
///     \cgalParamExtra{It is made by `CGAL_ext::parameters::options()` and must come first.}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{the positions of the vertices}
///     \cgalParamType{a model of `ReadablePropertyMap` with the vertex descriptor as key type and a 3D point as value
///                    type}
///     \cgalParamDefault{the internal vertex point map of `mesh`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return the status, and on `OK` length, score and history of the cut. No exception is thrown for bad data.
template <class TriangleMesh, class SeamEdgeMap, class SeamVertexMap,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
Seam_result mark_seams(const TriangleMesh& mesh, SeamEdgeMap seam_edges, SeamVertexMap seam_vertices,
                       const NamedParameters& np = NamedParameters())
{
  namespace CP = CGAL::parameters;
  const auto options = CP::choose_parameter(CP::get_parameter(np, internal::options), Seam_options());
  const auto vpm =
      CP::choose_parameter(CP::get_parameter(np, CGAL::internal_np::vertex_point), get(CGAL::vertex_point, mesh));
  Seam_result result;
  try {
    const auto [arrays, vertex_list] = internal::read_faces(mesh, faces(mesh), vpm);
    const internal::Triangle_surface surface = internal::make_checked_surface(arrays);
    const internal::Mesh_edges<TriangleMesh> mesh_edges(mesh, vertex_list, surface.edges);
    std::vector<std::array<int, 2>> given;
    for(int e = 0; e < surface.number_of_edges(); ++e)
      if(get(seam_edges, mesh_edges[e]))
        given.push_back(surface.edges[e]);
    const internal::Cut cut = internal::cut_to_disk(surface, given, options, result.cut);
    for(int e = 0; e < surface.number_of_edges(); ++e)
      put(seam_edges, mesh_edges[e], cut.contains(e));
    for(int v = 0; v < surface.number_of_vertices(); ++v)
      put(seam_vertices, vertex_list[v], cut.degree(v) > 0);
  } catch(const internal::Unmappable& error) {
    result.status = error.code();
    result.message = error.what();
  }
  return result;
}

} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_MARK_SEAMS_H
