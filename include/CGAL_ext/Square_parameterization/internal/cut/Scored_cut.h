// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_SCORED_CUT_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_SCORED_CUT_H

#include <CGAL_ext/Square_parameterization/Cut_report.h>
#include <CGAL_ext/Square_parameterization/internal/cut/Cut.h>
#include <CGAL_ext/Square_parameterization/internal/cut/score_cut.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// a cut, how it was made of another, and what it is worth
struct Scored_cut
{
  Cut cut;
  Cut_step::Kind kind;
  int terminal; ///< that it was changed for; -1 for none
  Cut_score score = {};
};

/// cuts to begin with, whose scores are not known
inline std::vector<Scored_cut> without_scores(std::vector<Cut> cuts)
{
  std::vector<Scored_cut> result;
  for(Cut& cut : cuts)
    result.push_back({std::move(cut), Cut_step::INITIAL, -1});
  return result;
}

/// indicates whether the first has the lower score at a weight: see `Cut_options::cut_weight`
struct Is_better
{
  double weight;

  bool operator()(const Scored_cut& a, const Scored_cut& b) const { return a.score.at(weight) < b.score.at(weight); }
};

/// the best of the cuts at a weight (ties: the first). \pre there is one
inline const Scored_cut& best_of(const std::vector<Scored_cut>& cuts, double weight)
{
  return *std::min_element(cuts.begin(), cuts.end(), Is_better{weight});
}

/// indicates whether \p middle is not below the line from \p first to \p last, of lengths in that order
inline bool is_above_line(const Scored_cut& first, const Scored_cut& middle, const Scored_cut& last)
{
  const Cut_score &a = first.score, &b = middle.score, &c = last.score;
  return (b.stretch - a.stretch) * (c.length - a.length) >= (c.stretch - a.stretch) * (b.length - a.length);
}

/// those of the cuts that are best at some weight, the shortest first: the lower left side of the convex hull, as points
/// of length and stretch
inline std::vector<const Scored_cut*> front_of(const std::vector<Scored_cut>& cuts)
{
  std::vector<const Scored_cut*> sorted;
  for(const Scored_cut& cut : cuts)
    if(std::isfinite(cut.score.stretch))
      sorted.push_back(&cut);
  std::stable_sort(sorted.begin(), sorted.end(), [](const Scored_cut* a, const Scored_cut* b) {
    return std::pair(a->score.length, a->score.stretch) < std::pair(b->score.length, b->score.stretch);
  });
  std::vector<const Scored_cut*> front;
  for(const Scored_cut* next : sorted) {
    if(!front.empty() && front.back()->score.stretch <= next->score.stretch)
      continue;
    while(front.size() > 1 && is_above_line(*front[front.size() - 2], *front.back(), *next))
      front.pop_back();
    front.push_back(next);
  }
  return front;
}

/// the stretch of the line through the cuts of the front. \pre the length is not outside
inline double stretch_of_front(const std::vector<const Scored_cut*>& front, double length)
{
  const auto next =
      std::find_if(front.begin(), front.end(), [length](const Scored_cut* cut) { return cut->score.length >= length; });
  if(next == front.begin())
    return (*next)->score.stretch;
  const Cut_score &b = (*next)->score, &a = (*std::prev(next))->score;
  return a.stretch + (b.stretch - a.stretch) * (length - a.length) / (b.length - a.length);
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_SCORED_CUT_H
