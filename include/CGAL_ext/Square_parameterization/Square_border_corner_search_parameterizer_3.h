// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_SQUARE_BORDER_CORNER_SEARCH_PARAMETERIZER_3_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_SQUARE_BORDER_CORNER_SEARCH_PARAMETERIZER_3_H

#include <CGAL_ext/Square_parameterization/Hybrid_corner_search.h>
#include <CGAL_ext/Square_parameterization/Stretch_minimization.h>
#include <CGAL_ext/Square_parameterization/internal/common/Thread_team.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/make_iteration_minimizer.h>
#include <CGAL_ext/Square_parameterization/internal/patch/write_uv.h>
#include <CGAL_ext/Square_parameterization/internal/search/square_search.h>
#include <CGAL_ext/Square_parameterization/internal/surface/Face_graph_patch.h>

#include <CGAL/Default.h>

#include <utility>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {

/// \ingroup PkgSquareParameterizationBorderParameterizers
///
/// parameterizes the border of a disk onto the unit square by arc length, with the corners that a search finds: those
/// with which the map of the surface stretches least, among the candidates that the search asks for.
///
/// Used with a parameterizer of this package, the search minimises what that parameterizer minimises, and its best map
/// is the result. Used with another fixed border parameterizer it minimises the objective given here, and only the
/// border is taken from the best map.
///
/// Candidates are counted from the source of the border halfedge given to `parameterize()`; they are mapped
/// concurrently, and the result does not depend on the number of threads. The mesh is not changed: a candidate that
/// puts both ends of an interior edge on one side of the square has no map (see `split_chords()`).
///
/// Complexity: as many maps as the search asks for, side by side on as many threads as there are; one map and the
/// memory of one minimization per thread.
///
/// Thread safety: one object may be used by several threads at a time, if its search, its visitor and its callback may.
///
/// \cgalModels `Parameterizer_3`
///
/// \tparam TriangleMesh_ must be a model of `FaceGraph`. Coordinates are read as `double`.
/// \tparam CornerSearch_ must be a model of `CornerSearch`. <b>%Default:</b> `Hybrid_corner_search`
///
/// \sa `CGAL_ext::Stretch_minimizing_parameterizer_3`
/// \sa `CGAL_ext::Stretch_optimal_parameterizer_3`
template <class TriangleMesh_, class CornerSearch_ = CGAL::Default>
class Square_border_corner_search_parameterizer_3
{
public:
  typedef TriangleMesh_ Triangle_mesh;
  typedef TriangleMesh_ TriangleMesh;
  typedef typename CGAL::Default::Get<CornerSearch_, Hybrid_corner_search>::type Corner_search;
  typedef typename boost::graph_traits<Triangle_mesh>::vertex_descriptor vertex_descriptor;
  typedef typename boost::graph_traits<Triangle_mesh>::halfedge_descriptor halfedge_descriptor;
  typedef CGAL::Surface_mesh_parameterization::Error_code Error_code;

  /// constructs the parameterizer.
  /// \param search chooses the candidates
  /// \param options corner rule, walk, number of threads, visitor and callback
  /// \param objective what is minimised when a parameterizer that is not of this package uses this border
  explicit Square_border_corner_search_parameterizer_3(Corner_search search = Corner_search(),
                                                       Square_search_options options = {},
                                                       Stretch_minimization objective = {})
    : m_search(std::move(search)), m_options(std::move(options)), m_objective(std::move(objective))
  {}

  /// searches the corners for the connected component at the border halfedge \p bhd, assigns to the vertices of its
  /// border their position on the square, and marks them as parameterized. Nothing is written but on `OK`.
  /// \return
  /// - `OK`,
  /// - `ERROR_NO_1_TO_1_MAPPING` when no evaluated candidate has a one-to-one map, or no face has an area,
  /// - `ERROR_BORDER_TOO_SHORT` when the border has fewer than four vertices,
  /// - `ERROR_NON_TRIANGULAR_MESH`, `ERROR_NO_TOPOLOGICAL_DISC` when the connected component at the border halfedge is
  ///   not a triangulated disk,
  /// - `ERROR_WRONG_PARAMETER` when a coordinate is not finite, when a number of the search or of the objective is out
  ///   of range, or when the search asks for a candidate that does not exist, or for none.
  ///
  /// What a user's search, visitor or callback throws comes out, and nothing is written then.
  template <class VertexUVMap, class VertexIndexMap, class VertexParameterizedMap>
  Error_code parameterize(const Triangle_mesh& mesh, halfedge_descriptor bhd, VertexUVMap uvmap,
                          VertexIndexMap /* vimap */, VertexParameterizedMap vpmap) const
  {
    namespace SMP = CGAL::Surface_mesh_parameterization;
    try {
      if(!m_objective.is_valid())
        return SMP::ERROR_WRONG_PARAMETER;
      internal::check_corner_search(m_search);
      internal::Thread_team team(m_options.number_of_threads);
      const internal::Thread_team::Scope scope(team);
      const auto [patch, vertices] = internal::make_face_graph_patch(mesh, bhd, get(CGAL::vertex_point, mesh));
      const internal::Search_outcome outcome = search(patch, *internal::make_minimizer(patch, m_objective, deadline()));
      if(outcome.map.uv.rows() == 0)
        return SMP::ERROR_NO_1_TO_1_MAPPING;
      internal::write_uv(internal::select(vertices, patch.border), internal::border_coordinates(patch, outcome.map.uv),
                         uvmap, vpmap);
      return SMP::OK;
    } catch(const internal::Unmappable& error) {
      return error.code();
    }
  }

  /// indicates if the border's shape is convex.
  bool is_border_convex() const { return true; }

  /// \cond SKIP_IN_MANUAL
  /// searches the corners for maps made by \p minimizer, with the threads of the current team, and tells the visitor all of it
  internal::Search_outcome search(const internal::Patch& patch, const internal::Map_minimizer& minimizer) const
  {
    internal::Search_outcome outcome = internal::search_corners(patch, minimizer, m_search, m_options);
    internal::finish_map(minimizer, m_options.visitor, outcome);
    if(m_options.visitor != nullptr && outcome.map.uv.rows() > 0)
      m_options.visitor->end_minimization(outcome.map.report);
    return outcome;
  }

  /// when the search, and the minimization of its maps, is to end
  const internal::Deadline& deadline() const { return m_options.deadline; }

  /// that map; 0 for all cores
  unsigned int number_of_threads() const { return m_options.number_of_threads; }
  /// \endcond

private:
  Corner_search m_search;
  Square_search_options m_options;
  Stretch_minimization m_objective;
};

} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_SQUARE_BORDER_CORNER_SEARCH_PARAMETERIZER_3_H
