// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_REFINE_CUT_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_REFINE_CUT_H

#include <CGAL_ext/Square_parameterization/internal/cut/Cut_history.h>
#include <CGAL_ext/Square_parameterization/internal/cut/Cut_pool.h>
#include <CGAL_ext/Square_parameterization/internal/cut/candidate_terminals.h>

#include <algorithm>
#include <utility>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// lets each terminal of the cut go, or give way to one at a distance, where that lowers the score; false when it never
/// does. Ends early when the scores of the pool have cost \p work, or its deadline has passed.
inline bool improve_cut(Cut_pool& pool, double weight, double distance, long work, Scored_cut& best,
                        Cut_history& history)
{
  const Triangle_surface& surface = pool.surface();
  bool is_improved = false;
  for(int terminal : std::vector<int>(best.cut.terminals())) {
    if(pool.is_exhausted(work))
      break;
    std::vector<Scored_cut> cuts;
    if(may_be_freed(surface, best.cut))
      cuts.push_back({best.cut, Cut_step::DROPPED, terminal});
    for(int place : nearby_places(surface, best.cut, terminal, distance, pool.numbers().directions))
      cuts.push_back({best.cut, Cut_step::MOVED, place});
    cuts = pool(std::move(cuts), weight, [&](Scored_cut& cut) {
      if(cut.kind == Cut_step::MOVED)
        extend_cut(surface, cut.terminal, cut.cut);
      free_cut(surface, terminal, cut.cut);
    });
    const Is_better is_better{weight};
    const auto found = std::min_element(cuts.begin(), cuts.end(), is_better);
    if(found == cuts.end() || !is_better(*found, best))
      continue;
    best = *found;
    history.add(best);
    is_improved = true;
  }
  return is_improved;
}

/// moves, or drops, terminals of a cut as long as that lowers its score: first by large steps, then by smaller ones. A cut
/// stays as it is where it leaves too much stretch, or has no map, or a score costs too much.
/// \param most_work of it, in vertices mapped
inline void refine_cut(Cut_pool& pool, double weight, long most_work, Scored_cut& cut, Cut_history& history)
{
  const Cut_numbers& numbers = pool.numbers();
  history.add(cut);
  if(cut.score.stretch > numbers.largest_refined_stretch || pool.work_per_score() > most_work)
    return;
  const long work = pool.work() + most_work;
  for(double step = numbers.first_step; step >= numbers.last_step && !pool.is_exhausted(work);)
    if(!improve_cut(pool, weight, step * std::sqrt(pool.surface().area), work, cut, history))
      step /= 2;
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_REFINE_CUT_H
