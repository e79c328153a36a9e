// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_MULTILEVEL_MINIMIZER_IMPL_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_MULTILEVEL_MINIMIZER_IMPL_H

#include <CGAL_ext/Square_parameterization/internal/common/compiled_core.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/Coarse_to_fine_descent.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/Multilevel_minimizer.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

CGAL_EXT_INLINE_FUNCTION
Multilevel_minimizer::Multilevel_minimizer(const Patch& patch, const Balanced_minimization& options,
                                           bool may_coarsen_border, const Deadline& deadline, Coarsening coarsening)
  : Multilevel_minimizer(
        std::make_shared<const Minimizer_levels>(patch, options, may_coarsen_border, deadline, coarsening), options,
        deadline)
{}

CGAL_EXT_INLINE_FUNCTION Multilevel_minimizer::Multilevel_minimizer(std::shared_ptr<const Minimizer_levels> levels,
                                                                    const Balanced_minimization& options,
                                                                    const Deadline& deadline)
  : m_levels(std::move(levels)), m_options(options), m_deadline(deadline)
{
  for(const std::size_t level : m_levels->starts())
    m_first_maps.emplace_back(patches()[level], options.start, make_direct_solver, deadline);
}

CGAL_EXT_INLINE_FUNCTION Minimized_map Multilevel_minimizer::minimize(const Uv_coordinates& border_uv,
                                                                      Workspace& workspace,
                                                                      const Uv_coordinates* warm_start,
                                                                      long work_before) const
{
  m_levels->prepare(workspace);
  const Patch_sequence::Borders borders = patches().borders(border_uv);
  Coarse_to_fine_descent descent(*m_levels, m_first_maps, borders, workspace, work_before);
  Uv_coordinates uv;
  if(const std::optional<std::size_t> level = warm_start != nullptr ? level_of_warm_start(*warm_start) : std::nullopt;
     level && *level < borders.size())
    uv = descent.refine(*level, 0, transport(*level, *warm_start, borders[*level].uv, workspace));
  if(uv.rows() == 0)
    uv = descent.start(0);
  if(uv.rows() == 0 && !descent.is_abandoned() && patches().size() > 1 &&
     !has_passed(m_deadline)) { // some coarse triangle was lost in rounding
    Stretch_iteration::Workspace iteration_workspace;
    uv = descent.first_map(Stretch_iteration(patches()[0], m_options.start), border_uv, iteration_workspace);
  }
  if(uv.rows() == 0)
    return without_map(descent);
  Minimized_map map = map_to_compare(0, std::move(uv), workspace, descent);
  map.warm_start = m_levels->warm() == 0 ? map.uv : descent.take_warm_start();
  return map;
}

CGAL_EXT_INLINE_FUNCTION Minimized_map Multilevel_minimizer::compare(Coarse_maps kind, const Uv_coordinates& border_uv,
                                                                     Workspace& workspace,
                                                                     const Uv_coordinates* warm_start,
                                                                     double limit) const
{
  const std::size_t level = level_of(kind);
  m_levels->prepare(workspace);
  const Patch_sequence::Borders borders = patches().borders(border_uv);
  Minimized_map map;
  if(warm_start != nullptr && level < borders.size())
    map = compare_from(level, *warm_start, limit, borders[level].uv, workspace);
  if(map.uv.rows() == 0) {
    Coarse_to_fine_descent descent(*m_levels, m_first_maps, borders, workspace);
    Uv_coordinates uv = descent.start(level);
    if(uv.rows() == 0)
      return without_map(descent);
    map = map_to_compare(level, std::move(uv), workspace, descent);
  }
  map.warm_start = std::move(map.uv);
  map.uv.resize(0, 2);
  return map;
}

CGAL_EXT_INLINE_FUNCTION Minimized_map Multilevel_minimizer::finish(Minimized_map map, double limit) const
{
  if(!is_large()) {
    Balanced_minimizer::Workspace workspace;
    const long work = (std::max)(m_levels->most_final_work() - map.work_of_starts, m_levels->least_final_work());
    map = m_levels->minimizer(0).minimize(std::move(map), m_options.tolerance,
                                          {m_options.maximum_iterations, work, limit}, workspace);
  }
  if(map.report.objective < limit)
    m_levels->minimizer(0).settle(map);
  return map;
}

CGAL_EXT_INLINE_FUNCTION Minimized_map Multilevel_minimizer::compare_from(std::size_t level,
                                                                          const Uv_coordinates& warm_start,
                                                                          double limit, const Uv_coordinates& border_uv,
                                                                          Workspace& workspace) const
{
  Uv_coordinates uv = transport(level, warm_start, border_uv, workspace);
  if(uv.rows() == 0)
    return Minimized_map();
  const Balanced_minimizer& minimizer = m_levels->minimizer(level);
  const long relaxation = minimizer.relax(uv, Minimizer_numbers::SWEEPS_OF_TRANSPORTED);
  const Balanced_minimizer::Limits limits{Minimizer_numbers::SEARCH_ITERATIONS, (std::numeric_limits<long>::max)(),
                                          limit};
  Minimized_map map =
      minimizer.minimize({std::move(uv), {}, {}}, m_options.search_tolerance, limits, workspace.levels[level]);
  map.work += relaxation;
  return map;
}

CGAL_EXT_INLINE_FUNCTION Minimized_map Multilevel_minimizer::without_map(const Coarse_to_fine_descent& descent)
{
  Minimized_map map;
  map.work = descent.work();
  return map;
}

CGAL_EXT_INLINE_FUNCTION Minimized_map Multilevel_minimizer::map_to_compare(std::size_t level, Uv_coordinates uv,
                                                                            Workspace& workspace,
                                                                            const Coarse_to_fine_descent& descent) const
{
  const Balanced_minimizer& minimizer = m_levels->minimizer(level);
  const long relaxation = minimizer.relax(uv);
  const bool is_last = level == 0 && is_large(), is_lost = descent.is_lost();
  const unsigned int most_of_search =
      is_lost ? Minimizer_numbers::ITERATIONS_OF_LOST_MAP : Minimizer_numbers::SEARCH_ITERATIONS;
  const unsigned int most =
      is_last ? m_options.maximum_iterations : (std::min)(m_options.maximum_iterations, most_of_search);
  const double tolerance = is_last ? m_options.tolerance : m_options.search_tolerance;
  const auto minimize = [&](Minimized_map map, long most_work) {
    return minimizer.minimize(std::move(map), tolerance, {most, most_work}, workspace.levels[level]);
  };
  Minimized_map map = minimize({std::move(uv), {}, {}},
                               is_last && is_lost ? m_levels->least_final_work() : m_levels->usual_final_work());
  if(is_large() && !is_lost && map.report.objective > Minimizer_numbers::HOPELESS_RESULT)
    map = minimize(std::move(map), m_levels->most_final_work());
  map.work += relaxation + descent.work();
  return map;
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_MULTILEVEL_MINIMIZER_IMPL_H
