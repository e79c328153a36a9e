// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_PARAMETERIZE_ONTO_SQUARE_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_PARAMETERIZE_ONTO_SQUARE_H

#include <CGAL_ext/Square_parameterization/Balanced_minimization.h>
#include <CGAL_ext/Square_parameterization/Bracketing_corner_search.h>
#include <CGAL_ext/Square_parameterization/Stretch_minimization.h>
#include <CGAL_ext/Square_parameterization/error_message.h>
#include <CGAL_ext/Square_parameterization/internal/Face_graph_patch.h>
#include <CGAL_ext/Square_parameterization/internal/square_search.h>
#include <CGAL_ext/Square_parameterization/measure_stretch.h>
#include <CGAL_ext/Square_parameterization/split_chords.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/property_map.h>

#include <array>
#include <chrono>
#include <optional>
#include <string>
#include <vector>

namespace CGAL_ext {

/// \ingroup PkgSquareParameterizationFunctions
///
/// what `parameterize_onto_square()` is to do. Every member has a default.
struct Square_map_options
{
  /// chooses the corners: any model of `CornerSearch`
  Corner_search search = Bracketing_corner_search();
  /// how each candidate is mapped: by the minimizer of the balanced energy, or, when this is empty, by the iteration
  std::optional<Balanced_minimization> balanced = Balanced_minimization();
  Stretch_minimization minimization;    ///< the iteration; `Hybrid_corner_search` suits it
  Square_search_options search_options; ///< corner rule, walk, threads, visitor and callback
  Chords chords = Chords::ALL;          ///< which chords are split

  /// four border vertices for (0, 0), (1, 0), (1, 1) and (0, 1), counter-clockwise, as indices in the order of
  /// `vertices(mesh)`; none: the corners are searched
  std::optional<std::array<std::size_t, 4>> corners;
};

/// \ingroup PkgSquareParameterizationResults
///
/// what `parameterize_onto_square()` did
template <class TriangleMesh>
struct Square_map_result
{
  typedef typename boost::graph_traits<TriangleMesh>::vertex_descriptor vertex_descriptor;

  /// `OK`, or why there is no map
  CGAL::Surface_mesh_parameterization::Error_code status = CGAL::Surface_mesh_parameterization::OK;
  std::string message;                    ///< one sentence that names the condition and the place; empty on `OK`
  std::size_t chords_split = 0;           ///< number of edges that were split at their midpoint
  std::vector<vertex_descriptor> corners; ///< the vertices at (0, 0), (1, 0), (1, 1) and (0, 1)
  Search_report search;                   ///< candidates, evaluations and the stretch curve
  Minimization_report minimization;       ///< iterations of the delivered map
  Stretch_measures measures;              ///< of the delivered map
  std::size_t border_edges = 0;           ///< number of edges of the border
  /// number of faces lower than 1e-8 sqrt(area) over their longest side. They are mapped as if they were as high as 1e-4
  /// sqrt(area); the measures take them as they are.
  std::size_t degenerate_faces = 0;
  double condition_seconds = 0;           ///< splitting chords, reading the mesh and the first factorization
  double search_seconds = 0;              ///< mapping all candidates
};

/// \cond SKIP_IN_MANUAL
namespace internal {

enum options_t
{
  options
};

/// the border halfedge whose source comes first among the border vertices, in the order of the mesh
template <class TriangleMesh>
typename boost::graph_traits<TriangleMesh>::halfedge_descriptor first_border_halfedge(const TriangleMesh& mesh)
{
  for(auto v : vertices(mesh)) {
    if(halfedge(v, mesh) == boost::graph_traits<TriangleMesh>::null_halfedge())
      continue; // isolated
    for(auto h : CGAL::halfedges_around_source(v, mesh))
      if(CGAL::is_border(h, mesh))
        return h;
  }
  return boost::graph_traits<TriangleMesh>::null_halfedge();
}

/// refuses what the splitting of chords cannot take, and options that are out of range
template <class TriangleMesh>
void check_input(const TriangleMesh& mesh, const Square_map_options& options)
{
  namespace SMP = CGAL::Surface_mesh_parameterization;
  if(options.balanced && !options.balanced->is_valid())
    throw Unmappable(
        SMP::ERROR_WRONG_PARAMETER,
        "the balance is not in [0, 1], a tolerance is negative, or the weights or eta of the start are wrong");
  if(!options.minimization.is_valid())
    throw Unmappable(SMP::ERROR_WRONG_PARAMETER, "the weights are missing, or eta is not in ]0, 1]");
  const std::size_t number_of_faces = std::distance(faces(mesh).begin(), faces(mesh).end());
  if(number_of_faces == 0)
    throw Unmappable(SMP::ERROR_EMPTY_MESH, "the surface has no faces");
  std::size_t polygons = 0;
  for(auto f : faces(mesh))
    if(!CGAL::is_triangle(halfedge(f, mesh), mesh))
      ++polygons;
  if(polygons > 0)
    throw Unmappable(SMP::ERROR_NON_TRIANGULAR_MESH, std::to_string(polygons) + " faces are not triangles");
  const auto bhd = first_border_halfedge(mesh);
  if(bhd == boost::graph_traits<TriangleMesh>::null_halfedge())
    throw Unmappable(SMP::ERROR_NO_TOPOLOGICAL_DISC, "the surface is closed: it has no border");
  if(faces_of_component(face(opposite(bhd, mesh), mesh), mesh).size() < number_of_faces)
    throw Unmappable(SMP::ERROR_NO_TOPOLOGICAL_DISC, "the surface has more than one connected component");
}

/// positions in the border loop of four vertices, given by their place in the order of the mesh
template <class TriangleMesh>
Corners border_positions(const TriangleMesh& mesh, const Face_graph_patch<TriangleMesh>& disk,
                         const std::array<std::size_t, 4>& corner_vertices)
{
  const auto loop = select(disk.vertices, disk.patch.border);
  Corners corners{};
  for(int k = 0; k < 4; ++k) {
    const std::size_t v = corner_vertices[k];
    const auto found = v < vertices(mesh).size()
                           ? std::find(loop.begin(), loop.end(), *std::next(vertices(mesh).begin(), v))
                           : loop.end();
    if(found == loop.end())
      throw Unmappable(CGAL::Surface_mesh_parameterization::ERROR_WRONG_PARAMETER,
                       "corner vertex " + std::to_string(v) + " is not on the border");
    corners[k] = static_cast<int>(found - loop.begin());
  }
  return corners;
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
/// maps a triangulated disk onto the unit square, one-to-one and with little stretch. Splits the chords of the mesh,
/// searches the corners, and writes the best map.
///
/// The border starts at the border vertex that comes first in the order of the mesh. The map is not mirrored.
///
/// \tparam TriangleMesh must be a model of `MutableFaceGraph`; it must be one connected component with one border.
/// \tparam VertexUVMap must be a model of `WritablePropertyMap` with the vertex descriptor as key type and a 2D point
///         as value type.
/// \tparam NamedParameters a sequence of named parameters
///
/// \param mesh the surface. It is changed only where a chord is split; new vertices and faces come last.
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
    internal::check_input(mesh, options);
    result.chords_split = split_chords(mesh, vpm, options.chords);
    const auto disk = internal::make_face_graph_patch(mesh, internal::first_border_halfedge(mesh), vpm);
    const auto& [patch, vertex_list] = disk;
    const internal::Map_minimizer minimizer =
        options.balanced ? options.balanced->make_minimizer(patch) : options.minimization.make_minimizer(patch);
    const auto search_start = Clock::now();
    const internal::Search_outcome outcome =
        options.corners
            ? internal::map_with_corners(patch, minimizer, internal::border_positions(mesh, disk, *options.corners))
            : internal::search_square_map(patch, minimizer, options.search, options.search_options);
    const auto end = Clock::now();

    result.condition_seconds = std::chrono::duration<double>(search_start - start).count();
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
