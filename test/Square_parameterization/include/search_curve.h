// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Runs a search strategy over a plain array of numbers: a strategy sees nothing of meshes and maps.

#ifndef CGAL_EXT_SEARCH_CURVE_H
#define CGAL_EXT_SEARCH_CURVE_H

#include "On_threads.h"

#include <CGAL_ext/Square_parameterization/internal/search/run_corner_search.h>
#include <CGAL_ext/Square_parameterization/internal/search/square_search.h>

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <limits>
#include <set>
#include <vector>

/// a stretch for every candidate
typedef std::vector<double> Stretch_curve;

const double INFEASIBLE = std::numeric_limits<double>::infinity();

/// one valley at `bottom` on the ring of n candidates, with strictly rising sides
inline Stretch_curve valley(int n, int bottom)
{
  Stretch_curve curve;
  for(int k = 0; k < n; ++k) {
    const int distance = std::abs(k - bottom);
    curve.push_back(1 + 0.01 * (std::min)(distance, n - distance));
  }
  return curve;
}

/// a worker for `Candidate_evaluation` that reads the stretch from the curve; the map it makes has the candidate as its
/// uv
inline CGAL_ext::internal::Candidate_evaluation::Worker worker_of(const Stretch_curve& curve)
{
  return [&curve](int candidate, const CGAL_ext::internal::Uv_coordinates*) {
    CGAL_ext::internal::Minimized_map map;
    map.report.l2 = map.report.objective = curve[candidate];
    if(curve[candidate] < INFEASIBLE)
      map.uv = CGAL_ext::internal::Uv_coordinates::Constant(1, 2, candidate);
    return map;
  };
}

/// what a search may be given besides the strategy
struct Search_conditions
{
  unsigned int number_of_threads = 1;
  CGAL_ext::Search_visitor* visitor = nullptr;
  std::function<bool(double)> callback = {};

  Stretch_curve sketched_stretch = {};             ///< one per candidate; empty: there are no sketches
  int number_of_vertices = 1, number_of_faces = 1; ///< of the mesh that the strategy believes it maps
  double work_per_map = 0;                         ///< in sweeps over the mesh, of a map or a sketch
  std::vector<double> circle_stretch = {};         ///< one per border vertex; empty: there is no map onto a circle
  std::function<std::vector<double>(int)> corner_distances = {};
};

/// runs a strategy over the curve through the evaluation that the library uses
inline CGAL_ext::Search_report search_curve(const Stretch_curve& curve, const CGAL_ext::Corner_search& search,
                                            const Search_conditions& conditions = {})
{
  const int candidates = static_cast<int>(curve.size());
  const On_threads threads(conditions.number_of_threads);
  CGAL_ext::internal::Candidate_evaluation evaluation(
      candidates, [&] { return worker_of(curve); }, conditions.visitor, conditions.callback);
  CGAL_ext::Corner_search_problem problem;
  problem.number_of_candidates = candidates;
  problem.objective_of = [&](const std::vector<int>& batch) { return evaluation(batch); };
  std::size_t sketches = 0;
  std::optional<int> settled_for;
  if(!conditions.sketched_stretch.empty()) {
    problem.settle_for = [&](int candidate) { settled_for = candidate; };
    problem.sketched_objective_of = [&](const std::vector<int>& batch) {
      sketches += batch.size();
      Stretch_curve stretch;
      for(int candidate : batch)
        stretch.push_back(conditions.sketched_stretch.at(candidate));
      return stretch;
    };
  }
  problem.work = [&] { return conditions.work_per_map * double(evaluation.report().evaluations + sketches); };
  problem.number_of_vertices = conditions.number_of_vertices;
  problem.number_of_faces = conditions.number_of_faces;
  problem.circle_stretch = [&] { return conditions.circle_stretch; };
  problem.corner_distances = conditions.corner_distances;
  CGAL_ext::internal::check_corner_search(search);
  CGAL_ext::internal::run_corner_search(search, problem, [&] { return settled_for || !evaluation.is_untouched(); });
  if(settled_for)
    evaluation({*settled_for});
  CGAL_ext::Search_report report = evaluation.report();
  report.sketches = sketches;
  return report;
}

/// the candidates that were mapped
inline std::set<int> evaluated(const CGAL_ext::Search_report& report)
{
  std::set<int> candidates;
  for(const auto& sample : report.curve)
    candidates.insert(sample.candidate);
  return candidates;
}

#endif // CGAL_EXT_SEARCH_CURVE_H
