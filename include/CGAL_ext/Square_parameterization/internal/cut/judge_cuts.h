// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_JUDGE_CUTS_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_JUDGE_CUTS_H

#include <CGAL_ext/Square_parameterization/internal/common/Thread_team.h>
#include <CGAL_ext/Square_parameterization/internal/cut/Cut_progress.h>
#include <CGAL_ext/Square_parameterization/internal/cut/Scored_cut.h>
#include <CGAL_ext/Square_parameterization/internal/cut/open_disk.h>
#include <CGAL_ext/Square_parameterization/internal/cut/score_cut.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/make_minimizer.h>
#include <CGAL_ext/Square_parameterization/internal/search/rough_corner_search.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// the L2 stretch that a cut leaves when its corners are searched roughly; infinite when no map is found
inline double stretch_with_searched_corners(const Triangle_surface& surface, const Cut& cut,
                                            const Cut_score_options& options)
{
  Balanced_minimization minimization;
  minimization.balance = options.balance;
  minimization.aspect = options.aspect;
  try {
    const Patch patch = patch_of_cut(surface, cut);
    const auto minimizer = make_minimizer(patch, minimization, options.deadline);
    return search_corners_roughly(patch, *minimizer, options.moves_corners, options.deadline).report.l2;
  } catch(const Unmappable&) {
    return std::numeric_limits<double>::infinity();
  }
}

/// judges the best cut at a weight, and then the next few that come near it, by the stretch that they leave when their corners
/// are searched: that of a few corners spread over the border is up to 3 % larger, for some cuts more than for others. A cut
/// keeps its score where the search finds nothing better.
/// \param progress of which this is the last part
/// \param cuts are sorted by the scores that they come with
inline void judge_cuts(const Triangle_surface& surface, double weight, const Cut_score_options& options,
                       Thread_team& team, Cut_progress& progress, std::vector<Scored_cut>& cuts)
{
  const auto judge = [&](Scored_cut& cut) {
    double& stretch = cut.score.stretch;
    if(stretch <= options.numbers.largest_judged_stretch)
      stretch = (std::min)(stretch, stretch_with_searched_corners(surface, cut.cut, options));
  };
  const std::size_t most = (std::min)(cuts.size(), std::size_t(options.numbers.most_judged));
  progress.begin_part(1, double(most));
  std::stable_sort(cuts.begin(), cuts.end(), Is_better{weight});
  judge(cuts.front());
  const double far = (1 + options.numbers.far_from_best) * cuts.front().score.at(weight);
  team(most, [&](std::size_t i) {
    if(i > 0 && cuts[i].score.at(weight) <= far)
      judge(cuts[i]);
    progress.advance(1);
  });
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_JUDGE_CUTS_H
