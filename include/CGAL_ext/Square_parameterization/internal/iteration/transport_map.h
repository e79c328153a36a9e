// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ITERATION_TRANSPORT_MAP_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ITERATION_TRANSPORT_MAP_H

#include <CGAL_ext/Square_parameterization/internal/energy/stretch_kernel.h>
#include <CGAL_ext/Square_parameterization/internal/iteration/Convex_combination_system.h>

#include <algorithm>
#include <utility>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// carries a map over to another border: solves the mean value equations that the map itself satisfies, with the new
/// border. The weights are positive, so the result has no flips (Floater 2003); it is the map itself when the border
/// is.
///
/// \param uv a map of the patch without flips
/// \param border_uv #B by 2, convex, counter-clockwise, without chords along a side
/// \return empty when the equations cannot be solved, or when rounding flips a triangle
inline Uv_coordinates transport_map(const Patch& patch, const Uv_coordinates& uv, const Uv_coordinates& border_uv)
{
  Patch plane = patch; // with the shapes that its triangles have in the map
  for(int f = 0; f < patch.number_of_faces(); ++f) {
    const auto& t = patch.triangles[f];
    const Eigen::RowVector2d a = uv.row(t[1]) - uv.row(t[0]), b = uv.row(t[2]) - uv.row(t[0]);
    const double length = a.norm(), height = twice_uv_area(uv, t) / length;
    if(!(height > 0))
      return {};
    plane.shapes[f] = {length, a.dot(b) / length, height};
  }
  const Convex_combination_system system(plane, mean_value_weights(plane));
  Convex_combination_system::Equations equations;
  system.assemble(std::vector<double>(patch.points.size(), 1.), border_uv, equations);
  Right_hand_sides solution(equations.matrix.rows(), 2);
  if(equations.matrix.rows() > 0) {
    const auto solver = make_direct_solver(system.is_symmetric());
    if(!solver->factorize(equations.matrix) || !solver->solve(equations.right_hand_sides, solution))
      return {};
  }
  Uv_coordinates result;
  system.compose(solution, border_uv, result);
  const bool has_flips = std::any_of(patch.triangles.begin(), patch.triangles.end(),
                                     [&result](const auto& t) { return !(twice_uv_area(result, t) > 0); });
  return has_flips ? Uv_coordinates() : result;
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ITERATION_TRANSPORT_MAP_H
