// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_BALANCED_MINIMIZER_IMPL_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_BALANCED_MINIMIZER_IMPL_H

#include <CGAL_ext/Square_parameterization/internal/common/compiled_core.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/Balanced_minimizer.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/rows_by_ranges.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

CGAL_EXT_INLINE_FUNCTION
Balanced_minimizer::Balanced_minimizer(const Patch_division& division, bool has_coarser, const Patch& patch,
                                       const Balanced_minimization& options, const Deadline& deadline)
  : m_patch(division, patch),
    m_energy(*m_patch, options.balance, options.aspect, &m_patch.division()),
    m_preconditioner(has_coarser ? Multigrid_preconditioner::of_large(*m_patch, m_patch.division())
                                 : Multigrid_preconditioner(*m_patch, m_patch.division())),
    m_sweep(*m_patch, m_patch.division(), options.balance),
    m_options(options),
    m_deadline(deadline)
{
  m_patch.forget_edges(); // the matrices alone need them, while they are made
}

CGAL_EXT_INLINE_FUNCTION void Balanced_minimizer::set_coarser(const Coarse_patch& to_coarser,
                                                              const Balanced_minimizer& coarser)
{
  const std::vector<int>& order = m_patch.order();
  std::vector<int> rank(order.size());
  for(std::size_t i = 0; i < rank.size(); ++i)
    rank[order[i]] = static_cast<int>(i);
  m_preconditioner.set_coarser(Vertex_interpolation(m_patch.given(), to_coarser, rank, coarser.m_patch.order()),
                               coarser.m_preconditioner);
}

CGAL_EXT_INLINE_FUNCTION long Balanced_minimizer::relax(Uv_coordinates& given_uv, int most) const
{
  Uv_coordinates uv = m_patch.in_order(std::move(given_uv));
  const Free_coordinates is_free = free_coordinates(*m_patch, uv, is_border_sliding());
  double energy = m_energy(uv);
  int sweeps = 0;
  for(bool gains = true; gains && sweeps < most; ++sweeps) {
    m_sweep(is_free, m_energy.scale(uv), uv);
    const double reached = m_energy(uv);
    gains = energy - reached >= Minimizer_numbers::LEAST_SWEEP_GAIN * energy && !has_passed(m_deadline);
    energy = reached;
  }
  given_uv = m_patch.in_given_order(std::move(uv));
  return static_cast<long>(sweeps) * given_uv.rows();
}

CGAL_EXT_INLINE_FUNCTION Minimized_map Balanced_minimizer::minimize(Minimized_map map, double tolerance,
                                                                    const Limits& limits, Workspace& workspace) const
{
  map.uv = m_patch.in_order(std::move(map.uv));
  const Free_coordinates is_free = free_coordinates(*m_patch, map.uv, is_border_sliding());
  Minimization_report& report = map.report;
  Balanced_steps steps(*m_patch, m_energy, m_preconditioner, m_sweep, is_free, report.iterations, workspace);
  report.objective = steps.look_at(map.uv);
  if(report.history.empty())
    report.history.push_back(report.objective);
  const unsigned int first_iteration = report.iterations;
  while(true) {
    if(report.iterations >= limits.iterations ||
       has_cost_enough(work_of(report.iterations, steps.roundabouts(), Minimizer_numbers::ROUNDABOUT_WORK_OF_DELIVERED),
                       limits.work, report.history)) {
      report.stop_reason = Stop_reason::MAXIMUM_ITERATIONS;
      break;
    }
    if(has_passed(m_deadline)) {
      report.stop_reason = Stop_reason::DEADLINE;
      break;
    }
    if(!steps.refresh_factors(map.uv)) {
      report.stop_reason = Stop_reason::CANNOT_SOLVE;
      break;
    }
    const double slope = steps.find_direction();
    if(-slope / 2 <= tolerance * report.objective || gains_little(report.history, tolerance)) {
      report.stop_reason = Stop_reason::CONVERGED;
      break;
    }
    if(report.iterations > first_iteration && stays_above(limits.energy, report.history, slope)) {
      report.stop_reason = Stop_reason::CONVERGED;
      report.objective = (std::max)(report.objective + slope / 2, limits.energy);
      break;
    }
    if(steps.try_step(report.objective, slope, map.uv)) {
      report.best_iteration = ++report.iterations;
      report.objective = steps.take_step(map.uv);
      report.history.push_back(report.objective);
    } else if(!steps.start_afresh()) {
      report.stop_reason = Stop_reason::NO_LOWER_MAP;
      break;
    }
  }
  const bool is_lost = report.objective > Minimizer_numbers::LOST_RESULT;
  map.work += work_of(report.iterations - first_iteration, steps.roundabouts(), Minimizer_numbers::ROUNDABOUT_WORK,
                      is_lost ? Minimizer_numbers::ROUNDABOUT_WORK_OF_LOST : 0);
  report.gradient_norm = std::sqrt(dot(workspace.gradient, workspace.gradient));
  measure_stretch(map);
  map.uv = m_patch.in_given_order(std::move(map.uv));
  return map;
}

CGAL_EXT_INLINE_FUNCTION void Balanced_minimizer::settle(Minimized_map& map) const
{
  map.uv = m_patch.in_order(std::move(map.uv));
  const Free_coordinates is_free = free_coordinates(*m_patch, map.uv, is_border_sliding());
  for(int i = 0; i < Minimizer_numbers::SETTLING_SWEEPS; ++i)
    m_sweep(is_free, m_energy.scale(map.uv), map.uv);
  Workspace workspace;
  Balanced_steps steps(*m_patch, m_energy, m_preconditioner, m_sweep, is_free, map.report.iterations, workspace);
  map.report.objective = map.report.history.back() = steps.look_at(map.uv);
  map.report.gradient_norm = std::sqrt(dot(workspace.gradient, workspace.gradient));
  measure_stretch(map);
  map.uv = m_patch.in_given_order(std::move(map.uv));
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_BALANCED_MINIMIZER_IMPL_H
