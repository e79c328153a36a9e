// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ITERATION_STRETCH_ITERATION_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ITERATION_STRETCH_ITERATION_H

#include <CGAL_ext/Square_parameterization/Stretch_minimization.h>
#include <CGAL_ext/Square_parameterization/internal/common/Deadline.h>
#include <CGAL_ext/Square_parameterization/internal/common/Minimizer_numbers.h>
#include <CGAL_ext/Square_parameterization/internal/iteration/Convex_combination_system.h>
#include <CGAL_ext/Square_parameterization/internal/iteration/Minimized_map.h>
#include <CGAL_ext/Square_parameterization/internal/iteration/repair_flips.h>

#include <limits>
#include <memory>
#include <utility>
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
                    const Linear_solver_factory& make_solver = make_direct_solver, const Deadline& deadline = {})
    : m_patch(patch),
      m_system(patch, checked(options.weights(patch), patch)),
      m_options(options),
      m_deadline(deadline),
      m_first_solver(make_solver(m_system.is_symmetric()))
  {
    Convex_combination_system::Equations equations;
    const Uv_coordinates any_border = Uv_coordinates::Zero(patch.border.size(), 2);
    m_system.assemble(std::vector<double>(patch.points.size(), 1.), any_border, equations);
    m_is_first_system_solvable = factorize(*m_first_solver, equations);
  }

  /// maps the interior for the border \p border_uv (#B by 2, convex, counter-clockwise).
  ///
  /// Solves with the base weights; then divides the weight of neighbor j by sigma_j^eta, sigma from the current map,
  /// and solves again (see `exponent()`). Keeps the iterate of least stretch; stops after `patience` + 1 iterates in a
  /// row that are not lower than it (Yoshizawa et al. stop at the first). Triangles that rounding has left flat or
  /// flipped in the first map are repaired.
  /// \param uv_area area inside the border: the stretch is normalised by it
  Minimized_map minimize(const Uv_coordinates& border_uv, double uv_area, Workspace& workspace) const
  {
    Minimized_map best;
    Minimization_report& report = best.report;
    if(!m_is_first_system_solvable) {
      report.stop_reason = Stop_reason::CANNOT_SOLVE;
      return best;
    }
    workspace.factors.assign(m_patch.points.size(), 1.);
    m_system.assemble(workspace.factors, border_uv, workspace.equations);
    bool is_solved = solve(*m_first_solver, workspace);
    unsigned int failures = 0;
    while(true) {
      if(!is_solved) {
        report.stop_reason = Stop_reason::CANNOT_SOLVE;
        return best;
      }
      m_system.compose(workspace.solution, border_uv, workspace.uv);
      double l2 = std::sqrt(stretch_energy(m_patch, workspace.uv, workspace.sigma) * uv_area);
      if(report.history.empty() && !std::isfinite(l2) && repair_flips(m_patch, workspace.uv, best.work))
        l2 = std::sqrt(stretch_energy(m_patch, workspace.uv, workspace.sigma) * uv_area);
      report.history.push_back(l2);
      if(l2 < report.l2) {
        report.l2 = report.objective = l2;
        report.best_iteration = report.iterations;
        best.uv = workspace.uv;
        failures = 0;
      } else
        ++failures;
      if(!(l2 < std::numeric_limits<double>::infinity()) || failures > m_options.patience) {
        report.stop_reason = Stop_reason::STRETCH_GROWS;
        return best;
      }
      if(report.iterations == m_options.maximum_iterations) {
        report.stop_reason = Stop_reason::MAXIMUM_ITERATIONS;
        return best;
      }
      if(has_passed(m_deadline)) {
        report.stop_reason = Stop_reason::DEADLINE;
        return best;
      }
      is_solved = solve_with_stretch_weights(border_uv, exponent(report.iterations), workspace);
      ++report.iterations;
    }
  }

private:
  /// the exponent of an iteration: eta, but 0.7, 0.49, 0.343, ... at first where these are larger. The first maps are
  /// far from their limit, and long steps save a quarter of the iterations without a higher limit. eta = 1 is the
  /// paper's iteration unchanged.
  double exponent(unsigned int iteration) const
  {
    return (std::max)(m_options.eta, std::pow(Minimizer_numbers::FIRST_EXPONENT, iteration + 1));
  }

  bool solve_with_stretch_weights(const Uv_coordinates& border_uv, double eta, Workspace& workspace) const
  {
    for(std::size_t v = 0; v < workspace.factors.size(); ++v)
      workspace.factors[v] /= std::pow(workspace.sigma[v], eta);
    m_system.assemble(workspace.factors, border_uv, workspace.equations);
    if(!workspace.solver)
      workspace.solver = m_first_solver->make_another();
    return factorize(*workspace.solver, workspace.equations) && solve(*workspace.solver, workspace);
  }

  // a patch without interior vertices has no equations: libraries do not expect that

  static bool factorize(Linear_solver& solver, const Convex_combination_system::Equations& equations)
  {
    return equations.matrix.rows() == 0 || solver.factorize(equations.matrix);
  }

  static bool solve(const Linear_solver& solver, Workspace& workspace)
  {
    workspace.solution.resize(workspace.equations.matrix.rows(), 2);
    return workspace.equations.matrix.rows() == 0 ||
           solver.solve(workspace.equations.right_hand_sides, workspace.solution);
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

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ITERATION_STRETCH_ITERATION_H
