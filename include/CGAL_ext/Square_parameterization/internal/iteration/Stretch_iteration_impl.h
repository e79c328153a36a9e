// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ITERATION_STRETCH_ITERATION_IMPL_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ITERATION_STRETCH_ITERATION_IMPL_H

#include <CGAL_ext/Square_parameterization/internal/common/compiled_core.h>
#include <CGAL_ext/Square_parameterization/internal/iteration/Stretch_iteration.h>
#include <CGAL_ext/Square_parameterization/internal/iteration/repair_flips.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

CGAL_EXT_INLINE_FUNCTION Stretch_iteration::Stretch_iteration(const Patch& patch, const Stretch_minimization& options,
                                                              const Linear_solver_factory& make_solver,
                                                              const Deadline& deadline)
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

CGAL_EXT_INLINE_FUNCTION Minimized_map Stretch_iteration::minimize(const Uv_coordinates& border_uv, double uv_area,
                                                                   Workspace& workspace) const
{
  Minimized_map best;
  Minimization_report& report = best.report;
  if(!m_is_first_system_solvable) {
    report.stop_reason = Stop_reason::CANNOT_SOLVE;
    return best;
  }
  workspace.factors.assign(m_patch.points.size(), 1.);
  m_system.assemble(border_uv, workspace.equations.right_hand_sides);
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

CGAL_EXT_INLINE_FUNCTION bool Stretch_iteration::solve_with_stretch_weights(const Uv_coordinates& border_uv, double eta,
                                                                            Workspace& workspace) const
{
  for(std::size_t v = 0; v < workspace.factors.size(); ++v)
    workspace.factors[v] /= std::pow(workspace.sigma[v], eta);
  m_system.assemble(workspace.factors, border_uv, workspace.equations);
  if(!workspace.solver)
    workspace.solver = m_first_solver->make_another();
  return factorize(*workspace.solver, workspace.equations) && solve(*workspace.solver, workspace);
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ITERATION_STRETCH_ITERATION_IMPL_H
