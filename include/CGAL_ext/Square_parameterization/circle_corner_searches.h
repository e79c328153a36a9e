// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_CIRCLE_CORNER_SEARCHES_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_CIRCLE_CORNER_SEARCHES_H

#include <CGAL_ext/Square_parameterization/Corner_search_problem.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {

/// \cond SKIP_IN_MANUAL
namespace internal {

/// the candidate of the largest value of `score(candidate)`; the lowest of several
template <class Score>
int best_candidate(const Corner_search_problem& problem, Score score)
{
  int best = 0;
  double best_score = score(0);
  for(int candidate = 1; candidate < problem.number_of_candidates; ++candidate) {
    const double value = score(candidate);
    if(value > best_score) {
      best_score = value;
      best = candidate;
    }
  }
  return best;
}

/// the candidate that puts the border vertex of highest stretch on the circle nearest to a corner
inline int single_highest_candidate(const Corner_search_problem& problem, const std::vector<double>& circle_stretch)
{
  if(circle_stretch.empty())
    return 0;
  const auto highest = std::max_element(circle_stretch.begin(), circle_stretch.end()) - circle_stretch.begin();
  return best_candidate(problem, [&](int candidate) { return -problem.corner_distances(candidate)[highest]; });
}

/// the candidate that gathers the border vertices of high stretch on the circle around the corners. The weight of a
/// vertex at the distance u (in half sides) from a corner is the gap between the circle and the square there, along the
/// diagonal: w = (2 - u - sqrt(2 - u^2)) / sqrt 2
inline int many_high_candidate(const Corner_search_problem& problem, const std::vector<double>& circle_stretch)
{
  if(circle_stretch.empty())
    return 0;
  return best_candidate(problem, [&](int candidate) {
    const std::vector<double> distances = problem.corner_distances(candidate);
    double cost = 0;
    for(std::size_t v = 0; v < distances.size(); ++v) {
      const double u = distances[v];
      cost += circle_stretch[v] * (2 - u - std::sqrt(2 - u * u)) / std::sqrt(2.);
    }
    return cost;
  });
}

} // namespace internal
/// \endcond

/// \ingroup PkgSquareParameterizationSearches
///
/// maps onto a circle, and evaluates the one candidate of the quarter that puts the border vertex of highest stretch
/// there nearest to a corner of the square (Dechvijankit et al., "highest stretch boundary vertex at corner"). One
/// evaluation and one circular map; a prediction, no optimum. When there is no circular map, the first candidate is
/// evaluated.
/// \cgalModels `CornerSearch`
struct Single_highest_corner_search
{
  Candidate_set candidate_set() const { return Candidate_set::QUARTER; }

  void operator()(const Corner_search_problem& problem) const
  {
    problem.objective_of({internal::single_highest_candidate(problem, problem.circle_stretch())});
  }
};

/// \ingroup PkgSquareParameterizationSearches
///
/// maps onto a circle, and evaluates the one candidate of the quarter that gathers the border vertices of high stretch
/// there around the corners of the square (Dechvijankit et al., "high stretch boundary vertices around corners"). One
/// evaluation and one circular map; a prediction, no optimum. When there is no circular map, the first candidate is
/// evaluated.
/// \cgalModels `CornerSearch`
struct Many_high_corner_search
{
  Candidate_set candidate_set() const { return Candidate_set::QUARTER; }

  void operator()(const Corner_search_problem& problem) const
  {
    problem.objective_of({internal::many_high_candidate(problem, problem.circle_stretch())});
  }
};

/// \ingroup PkgSquareParameterizationSearches
///
/// evaluates the candidates of `Single_highest_corner_search` and `Many_high_corner_search`, and keeps the better. Two
/// evaluations at most, and one circular map; a prediction, no optimum.
/// \cgalModels `CornerSearch`
struct Better_of_two_corner_search
{
  Candidate_set candidate_set() const { return Candidate_set::QUARTER; }

  void operator()(const Corner_search_problem& problem) const
  {
    const std::vector<double> circle_stretch = problem.circle_stretch();
    problem.objective_of({internal::single_highest_candidate(problem, circle_stretch),
                          internal::many_high_candidate(problem, circle_stretch)});
  }
};

} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_CIRCLE_CORNER_SEARCHES_H
