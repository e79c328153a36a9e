// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PLUG_IN_PARAMETERIZE_WITH_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PLUG_IN_PARAMETERIZE_WITH_H

#include <CGAL_ext/Square_parameterization/internal/common/Thread_team.h>
#include <CGAL_ext/Square_parameterization/internal/patch/write_uv.h>
#include <CGAL_ext/Square_parameterization/internal/search/square_search.h>
#include <CGAL_ext/Square_parameterization/internal/surface/Face_graph_patch.h>

#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// indicates whether a border parameterizer is one of this package that searches the corners
template <class Border, class = void>
struct Searches_corners : std::false_type
{
};

template <class Border>
struct Searches_corners<Border, std::void_t<decltype(std::declval<const Border&>().search(
                                    std::declval<const Patch&>(), std::declval<const Map_minimizer&>()))>>
  : std::true_type
{
};

/// what the parameterizers of this package do in `parameterize()`: they differ in the minimizer that
/// \p make_minimizer makes for a patch and a deadline.
///
/// With a border parameterizer that searches, the best map of the search is the result, and is not computed twice; the
/// visitor of the search is told of it. Any other is taken as it is, mirrored or not, and then all cores are used.
template <class TriangleMesh, class Border, class MakeMinimizer, class VertexUVmap, class VertexIndexMap,
          class VertexParameterizedMap>
Error_code parameterize_with(const MakeMinimizer& make_minimizer, Border& border, TriangleMesh& mesh,
                             typename boost::graph_traits<TriangleMesh>::halfedge_descriptor bhd, VertexUVmap uvmap,
                             VertexIndexMap vimap, VertexParameterizedMap vpmap)
{
  namespace SMP = CGAL::Surface_mesh_parameterization;
  if(!border.is_border_convex())
    return SMP::ERROR_NON_CONVEX_BORDER;
  try {
    const TriangleMesh& const_mesh = mesh;
    const auto [patch, vertices] = make_face_graph_patch(const_mesh, bhd, get(CGAL::vertex_point, const_mesh));
    Deadline deadline;
    unsigned int number_of_threads = 0;
    if constexpr(Searches_corners<Border>::value) {
      deadline = border.deadline();
      number_of_threads = border.number_of_threads();
    }
    Thread_team team(number_of_threads);
    const Thread_team::Scope scope(team);
    const std::shared_ptr<const Map_minimizer> minimizer = make_minimizer(patch, deadline);
    Minimized_map map;
    if constexpr(Searches_corners<Border>::value) {
      map = border.search(patch, *minimizer).map;
    } else {
      const Error_code status = border.parameterize(mesh, bhd, uvmap, vimap, vpmap);
      if(status != SMP::OK)
        return status;
      map = minimizer->map_border(read_uv(select(vertices, patch.border), uvmap));
    }
    if(map.uv.rows() == 0)
      return map.report.stop_reason == Stop_reason::CANNOT_SOLVE ? SMP::ERROR_CANNOT_SOLVE_LINEAR_SYSTEM
                                                                 : SMP::ERROR_NO_1_TO_1_MAPPING;
    check_rounding<VertexUVmap>(patch.triangles, map.uv);
    write_uv(vertices, map.uv, uvmap, vpmap);
    return SMP::OK;
  } catch(const Unmappable& error) {
    return error.code();
  }
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PLUG_IN_PARAMETERIZE_WITH_H
