// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SEARCH_CORNER_EVALUATION_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SEARCH_CORNER_EVALUATION_H

#include <CGAL_ext/Square_parameterization/internal/border/border_curves.h>
#include <CGAL_ext/Square_parameterization/internal/common/Thread_team.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/Map_minimizer.h>
#include <CGAL_ext/Square_parameterization/internal/search/Candidate_evaluation.h>
#include <CGAL_ext/Square_parameterization/internal/search/Worker_pool.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <mutex>
#include <tuple>
#include <utility>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// four corners and what they are worth
struct Corner_choice
{
  Corners corners;
  double objective;

  bool operator<(const Corner_choice& other) const
  {
    return std::tie(objective, corners) < std::tie(other.objective, other.corners);
  }
};

/// maps a patch for choices of four corners, concurrently, by the threads of the current team, and keeps the best map; the
/// result is the same for any number of them
class Corner_evaluation
{
public:
  /// of the patch itself
  /// \param visitor told of each map, by one thread at a time; may be null
  /// \param may_continue asked before each map, by one thread at a time; `false` stops
  /// \param most_at_once maps under way at a time, each with the memory of a worker
  Corner_evaluation(std::function<Map_minimizer::Comparing_worker()> make_worker, const Patch& patch,
                    Search_visitor* visitor, std::function<bool()> may_continue,
                    std::size_t most_at_once = Thread_team::ANY_NUMBER)
    : m_workers(std::move(make_worker)),
      m_loop(patch.border_lengths, Walk::COUNTER_CLOCKWISE),
      m_most_at_once(most_at_once),
      m_visitor(visitor),
      m_may_continue(std::move(may_continue))
  {}

  /// of a coarse patch. \pre `minimizer.has_coarse_maps()`
  Corner_evaluation(const Map_minimizer& minimizer, Coarse_maps kind, const Patch& patch, Search_visitor* visitor,
                    std::function<bool()> may_continue)
    : Corner_evaluation([&minimizer, kind] { return minimizer.make_comparing_worker(kind); }, patch, visitor,
                        std::move(may_continue))
  {
    const std::size_t coarse_border = minimizer.coarse_patch(kind).border.size();
    m_least_step = (std::max)(1, static_cast<int>(patch.border.size() / coarse_border));
  }

  /// the number of border edges that an edge of the coarse border stands for, in the mean, rounded down; 1 on the patch
  /// itself. Corners that are nearer mostly have the same coarse map.
  int least_step() const { return m_least_step; }

  /// the objectives of choices, which are positions in the border loop, in their order; infinite for one without a map.
  /// Throws `Unmappable` for one that is out of order, and `Search_cancelled` when it is not to continue.
  /// \param warm_starts what the maps start from, if they can: one for each choice, which may be null, or none at all
  /// \param limit objectives above it need only be near
  std::vector<double> operator()(const std::vector<Corners>& choices,
                                 const std::vector<const Uv_coordinates*>& warm_starts = {},
                                 double limit = std::numeric_limits<double>::infinity())
  {
    for(const Corners& corners : choices)
      if(!are_border_positions(corners))
        throw Unmappable(CGAL::Surface_mesh_parameterization::ERROR_WRONG_PARAMETER,
                         "the corner search asked for corners that are not four border vertices in counter-clockwise "
                         "order");
    m_number_of_choices += choices.size();
    std::vector<Minimized_map> maps(choices.size());
    Thread_team::current()(
        choices.size(),
        [&](std::size_t i) {
          if(may_continue())
            maps[i] = map_for(choices[i], warm_starts.empty() ? nullptr : warm_starts[i], limit);
        },
        m_most_at_once);
    if(m_is_cancelled)
      throw Search_cancelled();
    std::vector<double> objectives;
    for(std::size_t i = 0; i < choices.size(); ++i) {
      m_work += maps[i].work;
      objectives.push_back(maps[i].report.objective);
      Warm_start& known = m_warm_starts[choices[i]];
      if(objectives.back() < known.objective) // a choice that was mapped before may end in another local minimum
        known = {std::move(maps[i].warm_start), objectives.back()};
      if(objectives.back() < m_best_map.report.objective) {
        m_best_map = std::move(maps[i]);
        m_best_corners = choices[i];
      }
    }
    return objectives;
  }

  /// frees the memory of the threads, which are given new memory where more corners are mapped
  void release_workers() { m_workers.clear(); }

  /// forgets what maps may start from, but for corners like these
  void keep_warm_starts(const std::vector<Corners>& choices)
  {
    std::map<Corners, Warm_start> kept;
    for(const Corners& corners : choices)
      kept.insert(m_warm_starts.extract(corners)); // which stay where they are
    m_warm_starts.swap(kept);
  }

  /// the number of choices evaluated
  std::size_t number_of_choices() const { return m_number_of_choices; }

  /// what all maps together have cost, in vertices visited
  long work() const { return m_work; }

  /// what maps for corners like these may start from; null when these were not mapped
  const Uv_coordinates* warm_start(const Corners& corners) const
  {
    const auto known = m_warm_starts.find(corners);
    return known == m_warm_starts.end() || known->second.uv.rows() == 0 ? nullptr : &known->second.uv;
  }

  const Minimized_map& best_map() const { return m_best_map; }
  const Corners& best_corners() const { return m_best_corners; }

private:
  /// what maps may start from, and the objective of the map that it is of
  struct Warm_start
  {
    Uv_coordinates uv;
    double objective = std::numeric_limits<double>::infinity();
  };

  bool are_border_positions(const Corners& corners) const
  {
    const auto [least, largest] = std::minmax_element(corners.begin(), corners.end());
    return *least >= 0 && *largest < m_loop.size() && are_corners_in_order(corners, m_loop.size());
  }

  bool may_continue()
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    m_is_cancelled = m_is_cancelled || !m_may_continue();
    return !m_is_cancelled;
  }

  Minimized_map map_for(const Corners& corners, const Uv_coordinates* warm_start, double limit)
  {
    const Square_border border = square_border(m_loop, corners);
    Minimized_map map = m_workers.lend(
        [&](const Map_minimizer::Comparing_worker& worker) { return worker(border.uv, warm_start, limit); });
    const std::lock_guard<std::mutex> lock(m_mutex);
    if(m_visitor != nullptr)
      m_visitor->after_corner_move();
    return map;
  }

  Worker_pool<Map_minimizer::Comparing_worker> m_workers;
  const Border_walk m_loop;
  int m_least_step = 1;
  std::size_t m_most_at_once;
  Search_visitor* m_visitor;
  std::function<bool()> m_may_continue;
  std::mutex m_mutex; // of the callback and the visitor
  bool m_is_cancelled = false;
  std::size_t m_number_of_choices = 0;
  long m_work = 0;
  std::map<Corners, Warm_start> m_warm_starts;
  Minimized_map m_best_map;
  Corners m_best_corners{};
};

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SEARCH_CORNER_EVALUATION_H
