// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SEARCH_CANDIDATE_RING_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SEARCH_CANDIDATE_RING_H

#include <CGAL_ext/Square_parameterization/Corner_search_problem.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// the ring of candidates as a strategy explores it: what is known so far, and the best of it (ties: lowest index)
class Candidate_ring
{
public:
  typedef std::function<std::vector<double>(const std::vector<int>&)> Objective_of;

  explicit Candidate_ring(const Corner_search_problem& problem) : Candidate_ring(problem, problem.objective_of) {}

  /// \param objective_of by which candidates are compared, one of the problem
  Candidate_ring(const Corner_search_problem& problem, Objective_of objective_of)
    : m_problem(problem), m_objective_of(std::move(objective_of))
  {}

  /// from now on maps start from their neighbors where that is possible
  void start_from_neighbors()
  {
    if(m_problem.objective_from_neighbors)
      m_objective_of = m_problem.objective_from_neighbors;
  }

  int size() const { return m_problem.number_of_candidates; }

  /// the candidate at any integer position of the ring
  int at(long position) const { return static_cast<int>(((position % size()) + size()) % size()); }

  /// up to \p count candidates spread evenly over the ring, ascending, the first among them
  std::vector<int> even_candidates(int count) const
  {
    const int n = (std::min)(count, size());
    std::vector<int> candidates;
    for(int i = 0; i < n; ++i)
      candidates.push_back(static_cast<int>(static_cast<long>(i) * size() / n));
    return candidates;
  }

  /// the candidates evaluated so far, ascending
  std::vector<int> known() const
  {
    std::vector<int> candidates;
    for(const auto& entry : m_objective)
      candidates.push_back(entry.first);
    return candidates;
  }

  int number_of_known() const { return static_cast<int>(m_objective.size()); }
  bool is_known(int candidate) const { return m_objective.count(candidate) != 0; }
  double objective(int candidate) const { return m_objective.at(candidate); }
  int best() const { return m_best; }

  /// evaluates those of a batch of candidates that are unknown, together
  void evaluate(std::vector<int> candidates)
  {
    candidates.erase(std::remove_if(candidates.begin(), candidates.end(), [this](int c) { return is_known(c); }),
                     candidates.end());
    const std::vector<double> objective = m_objective_of(candidates);
    for(std::size_t i = 0; i < candidates.size(); ++i) {
      m_objective[candidates[i]] = objective[i];
      if(m_best < 0 || objective[i] < m_objective[m_best] ||
         (objective[i] == m_objective[m_best] && candidates[i] < m_best))
        m_best = candidates[i];
    }
  }

  /// how far the nearest known candidate is from the best one in direction 1 or -1; the size of the ring when there is
  /// no other
  int distance_to_known(int direction) const
  {
    int distance = 1;
    while(distance < size() && !is_known(at(m_best + direction * distance)))
      ++distance;
    return distance;
  }

  /// evaluates every unknown candidate between the best one and its nearest known neighbors on both sides: what the
  /// paper calls deep checking. When no known candidate has a map, evaluates all that are left.
  void evaluate_around_best()
  {
    const bool has_map = std::isfinite(objective(m_best));
    std::set<int> candidates;
    for(const int direction : {-1, 1}) {
      const int end = has_map ? distance_to_known(direction) : size();
      for(int distance = 1; distance < end; ++distance)
        candidates.insert(at(m_best + direction * distance));
    }
    evaluate({candidates.begin(), candidates.end()});
  }

private:
  const Corner_search_problem& m_problem;
  Objective_of m_objective_of;
  std::map<int, double> m_objective;
  int m_best = -1;
};

/// the step of the paper: sqrt(V m / F), at least 2
inline int sampling_step(const Corner_search_problem& problem)
{
  const double squared_step =
      double(problem.number_of_vertices) * problem.number_of_candidates / problem.number_of_faces;
  return (std::max)(2, static_cast<int>(std::sqrt(squared_step)));
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SEARCH_CANDIDATE_RING_H
