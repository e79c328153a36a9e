// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SAMPLING_SEAM_FIT_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SAMPLING_SEAM_FIT_H

#include <CGAL_ext/Square_parameterization/Grid_size.h>
#include <CGAL_ext/Square_parameterization/internal/sampling/Border_segments.h>
#include <CGAL_ext/Square_parameterization/internal/sampling/fit_counts.h>

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// a border loop that seams part, as it lies on the square
struct Seamed_border
{
  std::vector<int> originals; ///< per position, the vertex of the uncut surface
  std::vector<int> partners;  ///< per edge, the same edge on the other side of its seam, or -1
  std::vector<double> shares; ///< per edge, its length in sides of the square

  int size() const { return static_cast<int>(originals.size()); }

  /// length of a segment, in sides of the square
  double length(const Border_segment& segment) const
  {
    double sum = 0;
    for(int k = 0; k < segment.edges; ++k)
      sum += shares[(segment.first + k) % size()];
    return sum;
  }
};

/// how many intervals of a grid the segments of a border get: both sides of a seam the same number
struct Seam_fit
{
  Corners corners{}; ///< positions of the corners of the square
  std::vector<Border_segment> segments;
  std::vector<int> counts; ///< per segment, the intervals between samples on it
  double cost = std::numeric_limits<double>::infinity();
};

/// number of intervals on each side of the square
inline std::array<int, 4> intervals_of_sides(const Grid_size& grid)
{
  return {grid.width - 1, grid.height - 1, grid.width - 1, grid.height - 1};
}

/// per segment, the least number of intervals: with fewer, samples of different edges of the rebuilt mesh would be the
/// same two
inline std::vector<int> least_counts(const Seamed_border& border, const std::vector<Border_segment>& segments)
{
  const auto ends = [&border](const Border_segment& segment) {
    return std::minmax(border.originals[segment.first],
                       border.originals[(segment.first + segment.edges) % border.size()]);
  };
  std::map<std::pair<int, int>, int> seams_between;
  for(std::size_t s = 0; s < segments.size(); ++s)
    if(segments[s].partner < static_cast<int>(s)) // once for a segment and its partner
      ++seams_between[ends(segments[s])];
  std::vector<int> least;
  for(const Border_segment& segment : segments) {
    const auto [a, b] = ends(segment);
    least.push_back(a == b ? 3 : seams_between.at({a, b}) > 1 ? 2 : 1);
  }
  return least;
}

/// indicates whether a seam ends at a corner: the two sides of the square that meet there are the same beside it
inline bool has_tip_at_corner(const Seamed_border& border, const Corners& corners)
{
  return std::any_of(corners.begin(), corners.end(), [&](int k) { return is_seam_tip(border.partners, k); });
}

/// fits the intervals for given corners; nothing when there are none that fit
inline std::optional<Seam_fit> fit_seams(const Seamed_border& border, const Corners& corners, const Grid_size& grid)
{
  Seam_fit fit{corners, border_segments(border.partners, corners), {}};
  const std::array<int, 4> intervals = intervals_of_sides(grid);
  const std::vector<int> least = least_counts(border, fit.segments);
  std::vector<Interval_count> counts;
  std::vector<std::size_t> count_of(fit.segments.size());
  for(std::size_t s = 0; s < fit.segments.size(); ++s) {
    const Border_segment& segment = fit.segments[s];
    const double ideal = border.length(segment) * intervals[segment.side];
    if(segment.partner < 0 || segment.partner > static_cast<int>(s)) {
      count_of[s] = counts.size();
      counts.push_back({{segment.side, -1}, ideal, least[s]});
    } else {
      Interval_count& count = counts[count_of[s] = count_of[segment.partner]];
      count.sides[1] = segment.side;
      count.ideal = (count.ideal + ideal) / 2;
    }
  }
  Count_fitting fitting(counts);
  const auto chosen = fitting(intervals);
  if(!chosen)
    return {};
  for(std::size_t c : count_of)
    fit.counts.push_back((*chosen)[c]);
  fit.cost = fitting.cost();
  return fit;
}

/// of the fits with some corners moved along the border the cheapest, if there is any; no corner is left at a seam's end
/// \param moved numbers of corners
/// \param distances in border vertices, to be tried for each
inline std::optional<Seam_fit> fit_with_moved_corners(const Seamed_border& border, const Corners& corners,
                                                      const Grid_size& grid, const std::vector<int>& moved,
                                                      const std::vector<int>& distances)
{
  std::optional<Seam_fit> best;
  std::vector<std::size_t> choice(moved.size(), 0);
  while(true) {
    Corners trial = corners;
    for(std::size_t k = 0; k < moved.size(); ++k)
      trial[moved[k]] = ((trial[moved[k]] + distances[choice[k]]) % border.size() + border.size()) % border.size();
    if(are_corners_in_order(trial, border.size()) && !has_tip_at_corner(border, trial))
      if(auto fit = fit_seams(border, trial, grid); fit && (!best || fit->cost < best->cost))
        best = std::move(fit);
    std::size_t k = 0;
    while(k < choice.size() && ++choice[k] == distances.size())
      choice[k++] = 0;
    if(k == choice.size())
      return best;
  }
}

/// distances up to that of the whole border, ever farther apart, in both directions
inline std::vector<int> far_distances(int border_size)
{
  std::vector<int> distances;
  for(int distance = 1; distance < border_size; distance += 1 + distance / 8)
    distances.insert(distances.end(), {-distance, distance});
  return distances;
}

/// fits the intervals of a grid to a border, with the corners where they are when that is possible. Else one, two or
/// all of them are moved: away from the end of a seam, and where a side is folded onto its neighbor at a seam, so that
/// both would need as many intervals. On the shortest borders there is no other place, and a seam ends at a corner.
inline std::optional<Seam_fit> fit_seams_somehow(const Seamed_border& border, const Corners& corners,
                                                 const Grid_size& grid)
{
  if(auto fit = fit_seams(border, corners, grid); fit && !has_tip_at_corner(border, corners))
    return fit;
  std::optional<Seam_fit> best;
  const auto try_moved = [&](const std::vector<int>& moved, const std::vector<int>& distances) {
    if(auto fit = fit_with_moved_corners(border, corners, grid, moved, distances);
       fit && (!best || fit->cost < best->cost))
      best = std::move(fit);
  };
  const std::vector<int> far = far_distances(border.size());
  for(int k = 0; k < 4; ++k)
    try_moved({k}, far);
  for(int k = 0; k < 4 && !best; ++k)
    for(int l = k + 1; l < 4; ++l)
      try_moved({k, l}, {-2, -1, 1, 2});
  if(!best)
    try_moved({0, 1, 2, 3}, {-1, 0, 1});
  return best ? best : fit_seams(border, corners, grid);
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SAMPLING_SEAM_FIT_H
