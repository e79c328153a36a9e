// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SEARCH_SQUARE_SEARCH_IMPL_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SEARCH_SQUARE_SEARCH_IMPL_H

#include <CGAL_ext/Square_parameterization/internal/common/compiled_core.h>
#include <CGAL_ext/Square_parameterization/internal/search/run_corner_search.h>
#include <CGAL_ext/Square_parameterization/internal/search/square_search.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// the distance of every border vertex, in the order of the border loop, from the nearest corner, in half sides
inline std::vector<double> corner_distances(const Uv_coordinates& border_uv)
{
  std::vector<double> distances;
  // one coordinate is 0 or 1, the other tells the place on the side
  for(Eigen::Index k = 0; k < border_uv.rows(); ++k) {
    const double u = border_uv(k, 0), v = border_uv(k, 1);
    distances.push_back(2 * ((std::min)(u, 1 - u) + (std::min)(v, 1 - v)));
  }
  return distances;
}

CGAL_EXT_INLINE_FUNCTION Search_outcome search_square_map(const Patch& patch, const Map_minimizer& minimizer,
                                                          const Corner_search& search,
                                                          const Square_search_options& options)
{
  check_corner_search(search);
  const Border_walk walk(patch.border_lengths, options.walk);
  const auto border_of = [&](int candidate) {
    return square_border(walk, corners_of_candidate(walk, candidate, options.corner_rule));
  };
  const auto for_candidates = [&](Map_minimizer::Worker map_for) -> Candidate_evaluation::Worker {
    return [&, map_for = std::move(map_for)](int candidate, const Uv_coordinates* warm_start) {
      return map_for(border_of(candidate).uv, warm_start);
    };
  };
  Corner_search_problem problem;
  problem.number_of_candidates =
      search.candidate_set() == Candidate_set::FULL ? walk.size() : number_of_quarter_candidates(walk);
  const unsigned int threads = number_of_search_threads(options.number_of_threads, patch.number_of_vertices());
  const auto make_worker = [&] { return for_candidates(minimizer.make_worker()); };
  Candidate_evaluation evaluation(problem.number_of_candidates, make_worker, threads, options.visitor,
                                  options.callback);
  std::optional<Candidate_evaluation> sketches;
  if(minimizer.has_sketches()) {
    const auto make_sketching_worker = [&] { return for_candidates(minimizer.make_sketching_worker()); };
    const auto may_continue = [&options](double) { return !options.callback || options.callback(0); };
    sketches.emplace(problem.number_of_candidates, make_sketching_worker, threads, nullptr, may_continue);
    problem.sketched_objective_of = [&](const std::vector<int>& candidates) { return (*sketches)(candidates); };
  }
  problem.objective_of = [&](const std::vector<int>& candidates) { return evaluation(candidates); };
  problem.objective_from_neighbors = [&](const std::vector<int>& candidates) { return evaluation(candidates, true); };
  problem.number_of_vertices = patch.number_of_vertices();
  problem.number_of_faces = patch.number_of_faces();
  problem.circle_stretch = [&] { return minimizer.circle_stretch(); };
  problem.corner_distances = [&](int candidate) { return corner_distances(border_of(candidate).uv); };

  if(options.visitor != nullptr)
    options.visitor->start_search(problem.number_of_candidates);
  run_corner_search(search, std::move(problem), evaluation);
  evaluation.release_workers();
  Search_outcome outcome{minimizer.finish(evaluation.best_map()), evaluation.report()};
  if(sketches) {
    const Search_report sketching = sketches->report();
    outcome.report.sketches = sketching.evaluations;
    outcome.report.is_cancelled |= sketching.is_cancelled;
  }
  if(outcome.report.best_candidate >= 0) {
    outcome.report.best_objective = outcome.map.report.objective;
    outcome.report.corners = border_of(outcome.report.best_candidate).corners;
  }
  if(options.visitor != nullptr)
    options.visitor->end_search(outcome.report);
  return outcome;
}

CGAL_EXT_INLINE_FUNCTION Search_outcome map_with_corners(const Patch& patch, const Map_minimizer& minimizer,
                                                         const Corners& corners)
{
  const Square_border border = square_border(Border_walk(patch.border_lengths, Walk::COUNTER_CLOCKWISE), corners);
  Search_outcome outcome{minimizer.finish(minimizer.make_worker()(border.uv, nullptr)), {}};
  outcome.report.candidates = 1;
  outcome.report.evaluations = 1;
  outcome.report.best_objective = outcome.map.report.objective;
  outcome.report.best_candidate = outcome.map.uv.rows() > 0 ? corners[0] : -1;
  outcome.report.corners = border.corners;
  outcome.report.curve = {{corners[0], outcome.map.report.objective, outcome.map.report.l2}};
  return outcome;
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SEARCH_SQUARE_SEARCH_IMPL_H
