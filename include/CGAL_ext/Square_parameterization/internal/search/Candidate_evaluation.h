// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SEARCH_CANDIDATE_EVALUATION_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SEARCH_CANDIDATE_EVALUATION_H

#include <CGAL_ext/Square_parameterization/Search_visitor.h>
#include <CGAL_ext/Square_parameterization/internal/common/Thread_team.h>
#include <CGAL_ext/Square_parameterization/internal/common/Unmappable.h>
#include <CGAL_ext/Square_parameterization/internal/iteration/Minimized_map.h>
#include <CGAL_ext/Square_parameterization/internal/search/Worker_pool.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// the number of maps of a surface of \p number_of_vertices that are under way at a time, at most: as many as have room
/// in about 2 GB. Threads beyond help with these.
inline std::size_t most_maps_at_once(int number_of_vertices)
{
  constexpr int MOST_VERTICES = 1000000; // of all maps under way: each takes 1 to 3 kB
  return static_cast<std::size_t>((std::max)(1, MOST_VERTICES / (std::max)(1, number_of_vertices)));
}

/// thrown out of a strategy by the evaluation when the callback asks to stop. No `std::exception`: a strategy that
/// handles errors of its own lets it through.
struct Search_cancelled
{
};

/// refuses a candidate that does not exist
inline void check_candidate(int candidate, int number_of_candidates)
{
  if(candidate < 0 || candidate >= number_of_candidates)
    throw Unmappable(CGAL::Surface_mesh_parameterization::ERROR_WRONG_PARAMETER,
                     "the corner search asked for candidate " + std::to_string(candidate) +
                         "; the candidates are 0 to " + std::to_string(number_of_candidates - 1));
}

/// maps candidates concurrently, by the threads of the current team, each at most once, and keeps their objectives and the
/// best map.
///
/// The result does not depend on the number of threads: what the maps of a call start from is chosen before the call
/// begins, among the maps of earlier calls, and among equal objectives the lowest candidate wins. Memory: one map, one
/// workspace per thread, one number per evaluation and one warm start per evaluation that kept it.
///
/// The operator is called by one thread at a time.
class Candidate_evaluation
{
public:
  /// maps one candidate, from the warm start of a neighbor if that is not null; called by one thread at a time
  using Worker = std::function<Minimized_map(int candidate, const Uv_coordinates* warm_start)>;

  /// \param make_worker makes a worker, of which each thread that maps has one; called by several threads at a time
  /// \param visitor told of each evaluation, by one thread at a time; may be null
  /// \param callback asked before each evaluation, by one thread at a time, with the share of the candidates evaluated
  ///        so far; `false` stops. May be empty.
  /// \param most_at_once candidates under way at a time, each with the memory of a worker
  Candidate_evaluation(int number_of_candidates, std::function<Worker()> make_worker, Search_visitor* visitor,
                       std::function<bool(double)> callback, std::size_t most_at_once = Thread_team::ANY_NUMBER)
    : m_number_of_candidates(number_of_candidates),
      m_workers(std::move(make_worker)),
      m_most_at_once(most_at_once),
      m_visitor(visitor),
      m_callback(std::move(callback))
  {}

  /// the objective of \p candidates, in their order. Throws `Unmappable` before anything is mapped when one of them
  /// does not exist, and `Search_cancelled` as soon as the candidates that are under way are finished when the callback
  /// asks to stop.
  /// \param start_from_neighbors maps start from the nearest candidate of an earlier call (ties: the lower index) of
  ///        which the warm start was kept, as those of these calls are
  std::vector<double> operator()(const std::vector<int>& candidates, bool start_from_neighbors = false)
  {
    for(int candidate : candidates)
      check_candidate(candidate, m_number_of_candidates);
    std::vector<int> missing;
    std::vector<const Uv_coordinates*> warm_starts;
    for(int candidate : candidates)
      if(m_samples.emplace(candidate, Search_report::Sample{candidate, INFEASIBLE, INFEASIBLE}).second) {
        missing.push_back(candidate);
        warm_starts.push_back(start_from_neighbors ? nearest_warm_start(candidate) : nullptr);
      }
    std::vector<char> is_done(missing.size(), false);
    Thread_team::current()(
        missing.size(),
        [&](std::size_t i) {
          if(!may_continue())
            return;
          evaluate(missing[i], warm_starts[i], start_from_neighbors);
          is_done[i] = true;
        },
        m_most_at_once);
    for(std::size_t i = 0; i < missing.size(); ++i)
      if(!is_done[i])
        m_samples.erase(missing[i]);
    if(m_is_cancelled)
      throw Search_cancelled();
    std::vector<double> result;
    for(int candidate : candidates)
      result.push_back(m_samples.at(candidate).objective);
    return result;
  }

  /// what a map for this candidate, or one like it, may start from; null when it was not kept
  const Uv_coordinates* warm_start(int candidate) const
  {
    const auto known = m_warm_starts.find(candidate);
    return known == m_warm_starts.end() ? nullptr : &known->second;
  }

  /// keeps what a map for this candidate, or one like it, is to start from
  void set_warm_start(int candidate, Uv_coordinates warm_start) { m_warm_starts[candidate] = std::move(warm_start); }

  /// lets no map start from what was kept for this candidate
  void forget_warm_start(int candidate) { m_warm_starts.erase(candidate); }

  /// what all maps together have cost, in vertices visited
  long work() const { return m_work; }

  const Minimized_map& best_map() const { return m_best_map; }

  /// indicates whether no candidate was mapped, and no call was cancelled
  bool is_untouched() const { return m_samples.empty() && !m_is_cancelled; }

  /// frees the memory of the threads, which are given new memory where more candidates are evaluated
  void release_workers() { m_workers.clear(); }

  /// what has been found, but for the corners
  Search_report report() const
  {
    Search_report report;
    report.candidates = m_number_of_candidates;
    report.evaluations = m_samples.size();
    report.best_candidate = m_best_candidate;
    report.best_objective = m_best_map.report.objective;
    report.is_cancelled = m_is_cancelled;
    for(const auto& entry : m_samples)
      report.curve.push_back(entry.second);
    return report;
  }

private:
  static constexpr double INFEASIBLE = std::numeric_limits<double>::infinity();

  /// asks the callback, one thread at a time
  bool may_continue()
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    if(!m_is_cancelled && m_callback && !m_callback(double(m_finished) / m_number_of_candidates))
      m_is_cancelled = true;
    return !m_is_cancelled;
  }

  /// that of the nearest candidate on the ring; null when there is none
  const Uv_coordinates* nearest_warm_start(int candidate) const
  {
    const Uv_coordinates* nearest = nullptr;
    int least_distance = m_number_of_candidates;
    for(const auto& [other, warm_start] : m_warm_starts) {
      const int difference = std::abs(candidate - other);
      const int distance = (std::min)(difference, m_number_of_candidates - difference);
      if(distance < least_distance) {
        least_distance = distance;
        nearest = &warm_start;
      }
    }
    return nearest;
  }

  void evaluate(int candidate, const Uv_coordinates* warm_start, bool keeps_warm_start)
  {
    Minimized_map map = m_workers.lend([&](const Worker& worker) { return worker(candidate, warm_start); });
    const double objective = map.report.objective;
    const std::lock_guard<std::mutex> lock(m_mutex);
    if(keeps_warm_start && map.warm_start.rows() > 0)
      m_warm_starts[candidate] = map.warm_start;
    const Search_report::Sample sample{candidate, objective, map.report.l2};
    m_samples.at(candidate) = sample;
    ++m_finished;
    m_work += map.work;
    if(objective < m_best_map.report.objective ||
       (objective == m_best_map.report.objective && candidate < m_best_candidate)) {
      m_best_candidate = candidate;
      m_best_map = std::move(map);
    }
    if(m_visitor != nullptr)
      m_visitor->after_evaluation(sample);
  }

  const int m_number_of_candidates;
  Worker_pool<Worker> m_workers;
  std::size_t m_most_at_once;
  Search_visitor* m_visitor;
  std::function<bool(double)> m_callback;

  std::mutex m_mutex; // guards what follows while threads run
  std::map<int, Search_report::Sample> m_samples;
  std::map<int, Uv_coordinates> m_warm_starts; // by candidate
  std::size_t m_finished = 0;
  std::optional<int> m_best_candidate;
  Minimized_map m_best_map;
  long m_work = 0;
  bool m_is_cancelled = false;
};

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SEARCH_CANDIDATE_EVALUATION_H
