// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_GROW_CUT_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_GROW_CUT_H

#include <CGAL_ext/Square_parameterization/internal/cut/Cut_pool.h>
#include <CGAL_ext/Square_parameterization/internal/cut/candidate_terminals.h>

#include <algorithm>
#include <utility>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// grows a cut: terminals are added, dropped and moved while that pays
class Cut_growth
{
public:
  Cut_growth(Cut_pool& pool, Cut_report& report)
    : m_pool(pool), m_surface(pool.surface()), m_numbers(pool.numbers()), m_report(report)
  {}

  /// what all scores may cost, in vertices mapped; growth may end earlier
  long most_work() const
  {
    return (std::min)(m_numbers.growth_work_per_vertex * m_surface.number_of_vertices(),
                      has_many_loops(m_surface, m_numbers) ? m_numbers.little_growth_work : m_numbers.growth_work);
  }

  /// the best cut met on the way from the best of \p starts to long cuts, and back
  Cut grow(const std::vector<Cut>& starts)
  {
    Scored_cut best = best_start(starts);
    Scored_cut overgrown = add_terminals(best);
    drop_terminals(std::move(overgrown), best);
    return best.cut;
  }

  /// moves the terminals of the best of \p cuts, and drops those that no longer pay: better cuts come into the pool
  void polish(const std::vector<Cut>& cuts)
  {
    Scored_cut best = best_start(cuts);
    move_terminals(best);
    drop_terminals(best, best);
  }

private:
  /// indicates whether another terminal, with all of its candidates, would be too much work, in vertices to map
  bool is_exhausted() const
  {
    const long next_terminal = 2 * m_numbers.candidates * m_pool.vertices_per_score();
    return m_pool.is_exhausted(most_work() - next_terminal + 1); // with it, beyond the limit
  }

  /// the best of the cuts (ties: the first)
  static Scored_cut best_of(const std::vector<Scored_cut>& cuts)
  {
    return *std::min_element(cuts.begin(), cuts.end(), is_better);
  }

  Scored_cut best_start(const std::vector<Cut>& cuts)
  {
    Scored_cut best = best_of(m_pool.start(cuts));
    record(best, m_report);
    return best;
  }

  /// the cuts that reach one terminal more
  std::vector<Scored_cut> extensions(const Cut& shorter, const std::vector<int>& terminals, Cut_step::Kind kind)
  {
    std::vector<Scored_cut> cuts;
    for(int terminal : terminals)
      cuts.push_back({shorter, kind, terminal});
    return m_pool(std::move(cuts), [this](Scored_cut& cut) { extend_cut(m_surface, cut.terminal, cut.cut); });
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
      follow(best_of(longer), current, best, failures);
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
      shorter = m_pool(std::move(shorter), [this](Scored_cut& cut) { free_cut(m_surface, cut.terminal, cut.cut); });
      follow(best_of(shorter), current, best, failures);
    }
  }

  /// goes on to the next cut
  void follow(const Scored_cut& next, Scored_cut& current, Scored_cut& best, int& failures)
  {
    current = next;
    record(current, m_report);
    failures = is_better(current, best) ? 0 : failures + 1;
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
        for(int e : m_surface.vertex_edges[terminal])
          places.push_back(m_surface.other_end(e, terminal));
        const auto moved = extensions(shorter, places, Cut_step::MOVED);
        const auto found = std::min_element(moved.begin(), moved.end(), is_better);
        if(found == moved.end() || !is_better(*found, best))
          continue;
        best = *found;
        record(best, m_report);
        is_changed = true;
      }
    }
  }

  Cut_pool& m_pool;
  const Triangle_surface& m_surface;
  const Cut_numbers& m_numbers;
  Cut_report& m_report;
};

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_GROW_CUT_H
