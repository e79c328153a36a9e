// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_GROW_CUT_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_GROW_CUT_H

#include <CGAL_ext/Square_parameterization/internal/cut/Cut_history.h>
#include <CGAL_ext/Square_parameterization/internal/cut/Cut_pool.h>
#include <CGAL_ext/Square_parameterization/internal/cut/candidate_terminals.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// grows a cut: terminals are added, dropped and moved while that lowers the score at one weight
class Cut_growth
{
public:
  /// \param work at which it ends, of all scores of the pool together, in vertices mapped
  Cut_growth(Cut_pool& pool, double weight, long work, Cut_history& history)
    : m_pool(pool),
      m_surface(pool.surface()),
      m_numbers(pool.numbers()),
      m_is_better{weight},
      m_work(work),
      m_history(history)
  {}

  /// goes from the best cut of the pool to longer cuts, and back, and moves the terminals of the best cut met
  void operator()()
  {
    Scored_cut best = m_pool.best(m_is_better.weight);
    m_history.add(best);
    Scored_cut overgrown = add_terminals(best);
    drop_terminals(std::move(overgrown), best);
    move_terminals(best);
  }

private:
  /// indicates whether another terminal, with all of its candidates, would be too much work
  bool is_exhausted() const
  {
    const long next_terminal = 2 * m_numbers.candidates * m_pool.work_per_score();
    return m_pool.is_exhausted(m_work, next_terminal);
  }

  /// the cuts that reach one terminal more
  std::vector<Scored_cut> extensions(const Cut& shorter, const std::vector<int>& terminals, Cut_step::Kind kind)
  {
    std::vector<Scored_cut> cuts;
    for(int terminal : terminals)
      cuts.push_back({shorter, kind, terminal});
    return m_pool(std::move(cuts), m_is_better.weight,
                  [this](Scored_cut& cut) { extend_cut(m_surface, cut.terminal, cut.cut); });
  }

  /// adds, as long as patience lasts, the terminal that gives the least score; \p best becomes the best on the way.
  /// Returns the last.
  Scored_cut add_terminals(Scored_cut& best)
  {
    Scored_cut current = best;
    int failures = 0;
    for(int i = 0; i < m_numbers.most_additions && failures < m_numbers.patience && !is_exhausted(); ++i) {
      const auto longer =
          extensions(current.cut, candidate_terminals(m_surface, current.cut, m_numbers), Cut_step::ADDED);
      if(longer.empty())
        break;
      follow(best_of(longer, m_is_better.weight), current, best, failures);
    }
    return current;
  }

  /// drops, as long as patience lasts, the terminal whose loss gives the least score; \p best becomes the best on the
  /// way
  void drop_terminals(Scored_cut current, Scored_cut& best)
  {
    for(int failures = 0; failures < m_numbers.patience && may_be_freed(m_surface, current.cut) && !is_exhausted();) {
      std::vector<Scored_cut> shorter;
      for(int terminal : current.cut.terminals())
        shorter.push_back({current.cut, Cut_step::DROPPED, terminal});
      shorter = m_pool(std::move(shorter), m_is_better.weight,
                       [this](Scored_cut& cut) { free_cut(m_surface, cut.terminal, cut.cut); });
      follow(best_of(shorter, m_is_better.weight), current, best, failures);
    }
  }

  /// goes on to the next cut
  void follow(const Scored_cut& next, Scored_cut& current, Scored_cut& best, int& failures)
  {
    current = next;
    m_history.add(current);
    failures = m_is_better(current, best) ? 0 : failures + 1;
    if(failures == 0)
      best = current;
  }

  /// lets each terminal in turn give way to a better one, as long as the score falls
  void move_terminals(Scored_cut& best)
  {
    bool is_changed = true;
    for(int round = 0; round < m_numbers.move_rounds && is_changed; ++round) {
      is_changed = false;
      for(int terminal : std::vector<int>(best.cut.terminals())) {
        if(!may_be_freed(m_surface, best.cut) || is_exhausted())
          return;
        Cut shorter = best.cut;
        free_cut(m_surface, terminal, shorter);
        std::vector<int> places = candidate_terminals(m_surface, shorter, m_numbers);
        for(int neighbor : some_neighbors(terminal))
          places.push_back(neighbor);
        const auto moved = extensions(shorter, places, Cut_step::MOVED);
        const auto found = std::min_element(moved.begin(), moved.end(), m_is_better);
        if(found == moved.end() || !m_is_better(*found, best))
          continue;
        best = *found;
        m_history.add(best);
        is_changed = true;
      }
    }
  }

  /// the neighbors of a vertex; of one with many only some, at equal steps in the order of its edges
  std::vector<int> some_neighbors(int v) const
  {
    const auto edges = m_surface.vertex_edges[v];
    const std::ptrdiff_t degree = edges.end() - edges.begin(),
                         count = (std::min)(degree, std::ptrdiff_t(m_numbers.most_neighbors));
    std::vector<int> neighbors;
    for(std::ptrdiff_t i = 0; i < count; ++i)
      neighbors.push_back(m_surface.other_end(edges.begin()[i * degree / count], v));
    return neighbors;
  }

  Cut_pool& m_pool;
  const Triangle_surface& m_surface;
  const Cut_numbers& m_numbers;
  const Is_better m_is_better;
  const long m_work;
  Cut_history& m_history;
};

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_GROW_CUT_H
