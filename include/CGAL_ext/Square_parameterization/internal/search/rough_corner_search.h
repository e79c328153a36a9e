// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SEARCH_ROUGH_CORNER_SEARCH_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SEARCH_ROUGH_CORNER_SEARCH_H

#include <CGAL_ext/Square_parameterization/internal/common/Deadline.h>
#include <CGAL_ext/Square_parameterization/internal/common/Minimizer_numbers.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/Map_minimizer.h>
#include <CGAL_ext/Square_parameterization/internal/search/Corner_evaluation.h>
#include <CGAL_ext/Square_parameterization/internal/search/Corner_moves.h>
#include <CGAL_ext/Square_parameterization/internal/search/search_work.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// the candidates from the best to the worst, by rough maps: a few are mapped afresh, the others from the best of these
inline std::vector<Corner_choice> ranked_candidates(const Patch& patch, Corner_moves& moves)
{
  constexpr std::size_t PER_FRESH_MAP = 4;
  const std::vector<Corners> candidates = corners_of_spread_candidates(patch.border_lengths);
  std::vector<Corners> first;
  for(std::size_t i = 0; i < candidates.size(); i += PER_FRESH_MAP)
    first.push_back(candidates[i]);
  const Corner_choice best = moves.compare(first).front();
  return moves.compare(candidates, &best);
}

/// the corners of which the rough map is best: of a few candidates the best one, and those to which the corners of the best
/// two, and on a rectangle others, too, move. On a small patch, whose rough maps tell the best one well, it moves alone.
inline Corners best_rough_corners(const Patch& patch, bool moves_corners, Corner_evaluation& rough_maps)
{
  const std::size_t most_starts = patch.number_of_vertices() > 4 * Minimizer_numbers::LARGEST_ROUGH ? 2 : 1;
  double most_work = std::numeric_limits<double>::infinity(); // until the first maps tell the aspect
  Corner_moves moves = moves_by_maps(patch, rough_maps, [&] { return double(rough_maps.work()) > most_work; });
  std::vector<Corner_choice> starts = ranked_candidates(patch, moves);
  Corner_choice best = starts.front();
  if(!moves_corners)
    return best.corners;
  const bool is_square = rough_maps.best_map().aspect == 1;
  most_work = most_judging_work(is_square, patch.number_of_vertices());
  starts.resize((std::min)(starts.size(), most_starts));
  if(!is_square)
    for(const Corner_choice& choice : moves.best_of_spread())
      starts.push_back(choice);
  for(const Corner_choice& start : starts)
    best = (std::min)(best, moves.descend_from_afar(start.corners, is_square));
  return best.corners;
}

/// a search for the corners in less than half of the work of `search_corners()`: rough maps alone are compared, and the
/// best choice is mapped to the tolerance of a search. Without uv when that has no map, or the deadline has passed.
/// \param moves_corners see `Square_search_options`
/// \pre `minimizer.has_coarse_maps()`
inline Minimized_map search_corners_roughly(const Patch& patch, const Map_minimizer& minimizer, bool moves_corners,
                                            const Deadline& deadline)
{
  const auto is_in_time = [&deadline] { return !has_passed(deadline); };
  try {
    Corner_evaluation rough_maps(minimizer, Coarse_maps::ROUGH, patch, nullptr, is_in_time);
    const Corners corners = best_rough_corners(patch, moves_corners, rough_maps);
    Corner_evaluation maps([&minimizer] { return Map_minimizer::without_limit(minimizer.make_worker()); }, patch,
                           nullptr, is_in_time);
    maps({corners}, {rough_maps.warm_start(corners)});
    return maps.best_map();
  } catch(const Search_cancelled&) {
    return Minimized_map();
  }
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SEARCH_ROUGH_CORNER_SEARCH_H
