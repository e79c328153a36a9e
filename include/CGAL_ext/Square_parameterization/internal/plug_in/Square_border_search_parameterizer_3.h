// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PLUG_IN_SQUARE_BORDER_SEARCH_PARAMETERIZER_3_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PLUG_IN_SQUARE_BORDER_SEARCH_PARAMETERIZER_3_H

#include <CGAL_ext/Square_parameterization/Stretch_minimization.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/make_iteration_minimizer.h>
#include <CGAL_ext/Square_parameterization/internal/patch/write_uv.h>
#include <CGAL_ext/Square_parameterization/internal/search/square_search.h>
#include <CGAL_ext/Square_parameterization/internal/surface/Face_graph_patch.h>

#include <utility>

namespace CGAL_ext {
namespace internal {

/// what the border parameterizers that search the corners share: they differ in the strategy alone.
///
/// Used with a parameterizer of this package, the search minimises what that parameterizer minimises, and its best map
/// is the result. Used with another fixed border parameterizer it minimises the objective given here, and only the
/// border is taken from the best map.
template <class TriangleMesh_, class Search_>
class Square_border_search_parameterizer_3
{
public:
  typedef TriangleMesh_ Triangle_mesh;
  typedef TriangleMesh_ TriangleMesh;
  typedef Search_ Search;
  typedef typename boost::graph_traits<Triangle_mesh>::vertex_descriptor vertex_descriptor;
  typedef typename boost::graph_traits<Triangle_mesh>::halfedge_descriptor halfedge_descriptor;

  explicit Square_border_search_parameterizer_3(Search search = Search(), Square_search_options options = {},
                                                Stretch_minimization objective = {})
    : m_search(std::move(search)), m_options(std::move(options)), m_objective(std::move(objective))
  {}

  template <class VertexUVMap, class VertexIndexMap, class VertexParameterizedMap>
  Error_code parameterize(const Triangle_mesh& mesh, halfedge_descriptor bhd, VertexUVMap uvmap,
                          VertexIndexMap /* vimap */, VertexParameterizedMap vpmap) const
  {
    namespace SMP = CGAL::Surface_mesh_parameterization;
    try {
      if(!m_objective.is_valid())
        return SMP::ERROR_WRONG_PARAMETER;
      const auto [patch, vertices] = make_face_graph_patch(mesh, bhd, get(CGAL::vertex_point, mesh));
      const Search_outcome outcome = search(patch, *make_minimizer(patch, m_objective));
      if(outcome.report.best_candidate < 0)
        return SMP::ERROR_NO_1_TO_1_MAPPING;
      write_uv(select(vertices, patch.border), border_coordinates(patch, outcome.map.uv), uvmap, vpmap);
      return SMP::OK;
    } catch(const Unmappable& error) {
      return error.code();
    }
  }

  /// indicates if the border's shape is convex.
  bool is_border_convex() const { return true; }

  /// \cond SKIP_IN_MANUAL
  /// searches the corners for maps made by \p minimizer
  Search_outcome search(const Patch& patch, const Map_minimizer& minimizer) const
  {
    return search_square_map(patch, minimizer, m_search, m_options);
  }
  /// \endcond

private:
  Search m_search;
  Square_search_options m_options;
  Stretch_minimization m_objective;
};

} // namespace internal
} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PLUG_IN_SQUARE_BORDER_SEARCH_PARAMETERIZER_3_H
