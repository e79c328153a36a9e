// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ITERATION_TRANSPORT_MAP_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ITERATION_TRANSPORT_MAP_H

#include <CGAL_ext/Square_parameterization/internal/energy/stretch_kernel.h>
#include <CGAL_ext/Square_parameterization/internal/iteration/Convex_combination_system.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// carries maps of one patch over to other borders: solves the mean value equations that a map itself satisfies, with
/// the new border. The weights are positive, so the result has no flips (Floater 2003); it is the map itself when the
/// border is.
///
/// Constant after construction: several threads may use it, each with a workspace of its own. The order of the equations
/// is found once.
class Map_transport
{
public:
  /// the memory of one thread
  struct Workspace
  {
    std::optional<Patch> plane; // with the shapes that the triangles have in the map
    Convex_combination_system::Equations equations;
    std::unique_ptr<Linear_solver> solver;
    Right_hand_sides solution;
  };

  explicit Map_transport(const Patch& patch)
    : m_patch(patch), m_system(patch, Edge_weights(patch)), m_ones(patch.points.size(), 1.)
  {}

  /// \param uv a map of the patch without flips
  /// \param border_uv #B by 2, convex, counter-clockwise, without chords along a side
  /// \return empty when the equations cannot be solved, or when rounding flips a triangle
  Uv_coordinates operator()(const Uv_coordinates& uv, const Uv_coordinates& border_uv, Workspace& workspace) const
  {
    if(!flatten(uv, workspace))
      return {};
    m_system.assemble(mean_value_weights(*workspace.plane), m_ones, border_uv, workspace.equations);
    const Sparse_matrix& matrix = workspace.equations.matrix;
    workspace.solution.resize(matrix.rows(), 2);
    if(matrix.rows() > 0) {
      if(!workspace.solver)
        workspace.solver = make_direct_solver(m_system.is_symmetric());
      if(!workspace.solver->factorize(matrix) ||
         !workspace.solver->solve(workspace.equations.right_hand_sides, workspace.solution))
        return {};
    }
    Uv_coordinates result;
    m_system.compose(workspace.solution, border_uv, result);
    const bool has_flips = std::any_of(m_patch.triangles.begin(), m_patch.triangles.end(),
                                       [&result](const auto& t) { return !(twice_uv_area(result, t) > 0); });
    return has_flips ? Uv_coordinates() : result;
  }

private:
  /// gives the triangles of the plane the shapes that they have in the map; false when one has no area
  bool flatten(const Uv_coordinates& uv, Workspace& workspace) const
  {
    if(!workspace.plane)
      workspace.plane = m_patch;
    for(int f = 0; f < m_patch.number_of_faces(); ++f) {
      const auto& t = m_patch.triangles[f];
      const Eigen::RowVector2d a = uv.row(t[1]) - uv.row(t[0]), b = uv.row(t[2]) - uv.row(t[0]);
      const double length = a.norm(), height = twice_uv_area(uv, t) / length;
      if(!(height > 0))
        return false;
      workspace.plane->shapes[f] = {length, a.dot(b) / length, height};
    }
    return true;
  }

  const Patch& m_patch;
  Convex_combination_system m_system;
  std::vector<double> m_ones; // #V
};

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ITERATION_TRANSPORT_MAP_H
