// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_PARAMETERIZE_ONTO_SQUARE_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_PARAMETERIZE_ONTO_SQUARE_H

#include <CGAL_ext/Square_parameterization/Square_map_options.h>
#include <CGAL_ext/Square_parameterization/Square_map_result.h>
#include <CGAL_ext/Square_parameterization/error_message.h>
#include <CGAL_ext/Square_parameterization/internal/border/place_corners.h>
#include <CGAL_ext/Square_parameterization/internal/common/options_parameter.h>
#include <CGAL_ext/Square_parameterization/internal/cut/cut_face_graph.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/make_minimizer.h>
#include <CGAL_ext/Square_parameterization/internal/search/square_search.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/property_map.h>

#include <array>
#include <chrono>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace CGAL_ext {

/// \cond SKIP_IN_MANUAL
namespace internal {

/// refuses options that are out of range
inline void check_options(const Square_map_options& options)
{
  namespace SMP = CGAL::Surface_mesh_parameterization;
  if(!std::visit([](const auto& minimization) { return minimization.is_valid(); }, options.minimization))
    throw Unmappable(
        SMP::ERROR_WRONG_PARAMETER,
        std::holds_alternative<Balanced_minimization>(options.minimization)
            ? "the balance is not in [0, 1], a tolerance is negative, or the weights or eta of the start are wrong"
            : "the weights are missing, or eta is not in ]0, 1]");
  check_cut_options(options.cut);
  check_corner_search(options.search);
}

/// positions in the border loop of the vertex at place \p v in the order of the mesh, and of its copies
template <class TriangleMesh>
std::vector<int> border_places(const TriangleMesh& mesh, const Face_graph_patch<TriangleMesh>& disk,
                               const Square_map_result<TriangleMesh>& result, std::size_t v)
{
  typedef typename Square_map_result<TriangleMesh>::vertex_descriptor vertex_descriptor;
  std::vector<int> places;
  if(v >= vertices(mesh).size())
    return places;
  const vertex_descriptor original = *std::next(vertices(mesh).begin(), v);
  std::vector<vertex_descriptor> sought{original};
  for(const auto& [copy, copied] : result.copies)
    if(copied == original)
      sought.push_back(copy);
  const auto loop = select(disk.vertices, disk.patch.border);
  for(vertex_descriptor vertex : sought)
    if(const auto found = std::find(loop.begin(), loop.end(), vertex); found != loop.end())
      places.push_back(static_cast<int>(found - loop.begin()));
  return places;
}

/// positions in the border loop of four vertices, given by their places in the order of the mesh. Throws `Unmappable`
/// when one is not on the border, and when they are not distinct and in counter-clockwise order.
template <class TriangleMesh>
Corners border_positions(const TriangleMesh& mesh, const Face_graph_patch<TriangleMesh>& disk,
                         const Square_map_result<TriangleMesh>& result,
                         const std::array<std::size_t, 4>& corner_vertices)
{
  namespace SMP = CGAL::Surface_mesh_parameterization;
  std::array<std::vector<int>, 4> places;
  for(int k = 0; k < 4; ++k) {
    places[k] = border_places(mesh, disk, result, corner_vertices[k]);
    if(places[k].empty())
      throw Unmappable(SMP::ERROR_WRONG_PARAMETER,
                       "corner vertex " + std::to_string(corner_vertices[k]) + " is not on the border");
  }
  const std::optional<Corners> corners = place_corners(disk.patch.border_lengths, places);
  if(!corners)
    throw Unmappable(SMP::ERROR_WRONG_PARAMETER,
                     "the four corners are not distinct border vertices in counter-clockwise order");
  return *corners;
}

} // namespace internal
/// \endcond

namespace parameters {

/// \ingroup PkgSquareParameterizationFunctions
///
/// the named parameter that carries the options of `parameterize_onto_square()`. It must come first in a chain of named
/// parameters: `parameters::options(o).vertex_point_map(vpm)`.
inline CGAL::Named_function_parameters<Square_map_options, internal::options_t>
options(const Square_map_options& options)
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
/// \tparam TriangleMesh must be a model of `MutableFaceGraph` and `FaceListGraph`
/// \tparam VertexUVMap must be a model of `WritablePropertyMap` with the vertex descriptor as key type and a 2D point
///         as value type.
/// \tparam NamedParameters a sequence of named parameters
///
/// \param mesh the surface: one connected component of triangles. A surface that is not a disk (and one that is, if the
///        options say so) is cut in place, as `mark_seams()` marks and `cut_along_seams()` cuts; a border of three
///        edges gets a fourth, and chords are split; else it is not changed. New vertices and faces come last.
/// \param uvmap receives the position of every vertex, in [0, 1]^2; it is written only when the status is `OK`.
/// \param np optional named parameters among those below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{options}
///     \cgalParamDescription{the strategy, the minimization, the corner rule, the number of threads, the visitor}
///     \cgalParamType{`CGAL_ext::Square_map_options`}
///     \cgalParamDefault{`CGAL_ext::Square_map_options()`}
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
/// \return the status, and on `OK` the corners, the stretch, the curve and the timings. No exception is thrown for bad
///         data.
template <class TriangleMesh, class VertexUVMap, class NamedParameters = CGAL::parameters::Default_named_parameters>
Square_map_result<TriangleMesh> parameterize_onto_square(TriangleMesh& mesh, VertexUVMap uvmap,
                                                         const NamedParameters& np = NamedParameters())
{
  namespace SMP = CGAL::Surface_mesh_parameterization;
  namespace CP = CGAL::parameters;
  typedef std::chrono::steady_clock Clock;
  const auto options = CP::choose_parameter(CP::get_parameter(np, internal::options), Square_map_options());
  const auto vpm =
      CP::choose_parameter(CP::get_parameter(np, CGAL::internal_np::vertex_point), get(CGAL::vertex_point, mesh));
  Square_map_result<TriangleMesh> result;
  try {
    const auto start = Clock::now();
    internal::check_options(options);
    if(!options.seams.empty() || options.cut.may_cut_disk() ||
       (options.cut.mode != Cut_mode::NONE && !internal::is_disk(mesh)))
      result.copies = internal::cut_mesh(mesh, vpm, options, result.cut);
    else
      internal::check_connected_triangles(mesh); // what is cut is checked there
    const auto condition_start = Clock::now();
    result.cut_seconds = std::chrono::duration<double>(condition_start - start).count();
    const auto bhd = internal::first_border_halfedge(mesh);
    if(bhd == boost::graph_traits<TriangleMesh>::null_halfedge())
      throw internal::Unmappable(SMP::ERROR_NO_TOPOLOGICAL_DISC, "the surface is closed: it has no border");
    result.border_edges_split = internal::lengthen_border(bhd, mesh, vpm);
    result.chords_split = split_chords(mesh, vpm, options.chords);
    const auto disk = internal::make_face_graph_patch(mesh, internal::first_border_halfedge(mesh), vpm);
    const auto& [patch, vertex_list] = disk;
    const auto minimizer = internal::make_minimizer(patch, options.minimization);
    const auto search_start = Clock::now();
    const internal::Search_outcome outcome =
        options.corners ? internal::map_with_corners(patch, *minimizer,
                                                     internal::border_positions(mesh, disk, result, *options.corners))
                        : internal::search_square_map(patch, *minimizer, options.search, options.search_options);
    const auto end = Clock::now();

    result.condition_seconds = std::chrono::duration<double>(search_start - condition_start).count();
    result.search_seconds = std::chrono::duration<double>(end - search_start).count();
    result.search = outcome.report;
    result.minimization = outcome.map.report;
    result.border_edges = patch.border.size();
    result.degenerate_faces = patch.degenerate_faces.size();
    if(options.search_options.visitor != nullptr)
      options.search_options.visitor->end_minimization(outcome.map.report);
    if(outcome.report.best_candidate < 0)
      throw internal::Unmappable(SMP::ERROR_NO_1_TO_1_MAPPING, "none of " + std::to_string(outcome.report.evaluations) +
                                                                   " evaluated candidates has a one-to-one map");
    for(int k : outcome.report.corners)
      result.corners.push_back(vertex_list[patch.border[k]]);
    result.measures = internal::measure(internal::shapes_as_given(patch), patch.triangles, outcome.map.uv);
    internal::write_uv(
        vertex_list, outcome.map.uv, uvmap,
        CGAL::Constant_property_map<typename Square_map_result<TriangleMesh>::vertex_descriptor, bool>());
  } catch(const internal::Unmappable& error) {
    result.status = error.code();
    result.message = error.what();
  }
  return result;
}

} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_PARAMETERIZE_ONTO_SQUARE_H
