// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SEARCH_SQUARE_SEARCH_IMPL_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SEARCH_SQUARE_SEARCH_IMPL_H

#include <CGAL_ext/Square_parameterization/internal/common/Thread_team.h>
#include <CGAL_ext/Square_parameterization/internal/common/compiled_core.h>
#include <CGAL_ext/Square_parameterization/internal/search/Search_for_corners.h>
#include <CGAL_ext/Square_parameterization/internal/search/square_search.h>

#include <utility>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

CGAL_EXT_INLINE_FUNCTION Search_outcome search_corners(const Patch& patch, const Map_minimizer& minimizer,
                                                       const Corner_search& search,
                                                       const Square_search_options& options, double work_factor)
{
  check_corner_search(search);
  return Search_for_corners(patch, minimizer, search, options, work_factor)();
}

CGAL_EXT_INLINE_FUNCTION Search_outcome search_square_map(const Patch& patch, const Map_minimizer& minimizer,
                                                          const Corner_search& search,
                                                          const Square_search_options& options)
{
  Thread_team team(options.number_of_threads);
  const Thread_team::Scope scope(team);
  Search_outcome outcome = search_corners(patch, minimizer, search, options);
  finish_map(minimizer, options.visitor, outcome);
  return outcome;
}

CGAL_EXT_INLINE_FUNCTION void finish_map(const Map_minimizer& minimizer, Search_visitor* visitor,
                                         Search_outcome& outcome, double limit)
{
  if(visitor != nullptr)
    visitor->start_minimization();
  outcome.map = minimizer.finish(std::move(outcome.map), limit);
  outcome.report.is_cancelled |= outcome.map.report.stop_reason == Stop_reason::DEADLINE;
  if(outcome.map.uv.rows() > 0)
    outcome.report.best_objective = outcome.map.report.objective;
  if(visitor != nullptr)
    visitor->end_search(outcome.report);
}

CGAL_EXT_INLINE_FUNCTION Search_outcome map_with_corners(const Patch& patch, const Map_minimizer& minimizer,
                                                         const Corners& corners)
{
  const Square_border border = square_border(Border_walk(patch.border_lengths, Walk::COUNTER_CLOCKWISE), corners);
  Search_outcome outcome{minimizer.make_worker()(border.uv, nullptr), {}};
  outcome.work = double(outcome.map.work);
  outcome.report.is_cancelled = outcome.map.report.stop_reason == Stop_reason::DEADLINE;
  outcome.report.candidates = 1;
  outcome.report.evaluations = 1;
  outcome.report.best_objective = outcome.map.report.objective;
  if(outcome.map.uv.rows() > 0)
    outcome.report.best_candidate = corners[0];
  outcome.report.corners = border.corners;
  outcome.report.curve.push_back({corners[0], outcome.map.report.objective, outcome.map.report.l2});
  return outcome;
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SEARCH_SQUARE_SEARCH_IMPL_H
