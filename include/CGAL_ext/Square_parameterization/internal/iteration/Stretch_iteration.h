// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ITERATION_STRETCH_ITERATION_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ITERATION_STRETCH_ITERATION_H

#include <CGAL_ext/Square_parameterization/Stretch_minimization.h>
#include <CGAL_ext/Square_parameterization/internal/common/Deadline.h>
#include <CGAL_ext/Square_parameterization/internal/common/Minimizer_numbers.h>
#include <CGAL_ext/Square_parameterization/internal/iteration/Convex_combination_system.h>
#include <CGAL_ext/Square_parameterization/internal/iteration/Minimized_map.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// the stretch-minimizing parameterization of Yoshizawa, Belyaev and Seidel 2004 for any number of borders of one
/// patch.
///
/// Constant after construction: several threads may call `minimize()`, each with a workspace of its own. The first
/// system does not depend on the border, and is factored once, at construction.
class Stretch_iteration
{
public:
  /// the memory of one thread
  class Workspace
  {
    friend class Stretch_iteration;
    Convex_combination_system::Equations equations;
    Right_hand_sides solution;
    std::unique_ptr<Linear_solver> solver;
    std::vector<double> factors, sigma;
    Uv_coordinates uv;
  };

  /// \param make_solver makes the solver of the linear systems
  /// \param deadline when it has passed the first map, or the best so far, is taken
  Stretch_iteration(const Patch& patch, const Stretch_minimization& options,
                    const Linear_solver_factory& make_solver = make_direct_solver, const Deadline& deadline = {});

  /// maps the interior for the border \p border_uv (#B by 2, convex, counter-clockwise).
  ///
  /// Solves with the base weights; then divides the weight of neighbor j by sigma_j^eta, sigma from the current map,
  /// and solves again (see `exponent()`). Keeps the iterate of least stretch; stops after `patience` + 1 iterates in a
  /// row that are not lower than it (Yoshizawa et al. stop at the first). Triangles that rounding has left flat or
  /// flipped in the first map are repaired.
  /// \param uv_area area inside the border: the stretch is normalised by it
  Minimized_map minimize(const Uv_coordinates& border_uv, double uv_area, Workspace& workspace) const;

private:
  /// the exponent of an iteration: eta, but 0.7, 0.49, 0.343, ... at first where these are larger. The first maps are
  /// far from their limit, and long steps save a quarter of the iterations without a higher limit. eta = 1 is the
  /// paper's iteration unchanged.
  double exponent(unsigned int iteration) const
  {
    return (std::max)(m_options.eta, std::pow(Minimizer_numbers::FIRST_EXPONENT, iteration + 1));
  }

  bool solve_with_stretch_weights(const Uv_coordinates& border_uv, double eta, Workspace& workspace) const;

  // a patch without interior vertices has no equations: libraries do not expect that

  static bool factorize(Linear_solver& solver, const Convex_combination_system::Equations& equations)
  {
    return equations.matrix.rows() == 0 || solver.factorize(equations.matrix);
  }

  static bool solve(const Linear_solver& solver, Workspace& workspace)
  {
    const Right_hand_sides& b = workspace.equations.right_hand_sides;
    workspace.solution.resize(b.rows(), 2);
    return b.rows() == 0 || solver.solve(b, workspace.solution);
  }

  const Patch& m_patch;
  Convex_combination_system m_system;
  Stretch_minimization m_options;
  Deadline m_deadline;
  std::unique_ptr<Linear_solver> m_first_solver;
  bool m_is_first_system_solvable = false;
};

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#ifndef CGAL_EXT_COMPILED_CORE
#include <CGAL_ext/Square_parameterization/internal/iteration/Stretch_iteration_impl.h>
#endif

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ITERATION_STRETCH_ITERATION_H
