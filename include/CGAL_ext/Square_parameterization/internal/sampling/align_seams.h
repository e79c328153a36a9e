// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SAMPLING_ALIGN_SEAMS_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SAMPLING_ALIGN_SEAMS_H

#include <CGAL_ext/Square_parameterization/Minimization.h>
#include <CGAL_ext/Square_parameterization/internal/border/square_sides.h>
#include <CGAL_ext/Square_parameterization/internal/common/Deadline.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/make_minimizer.h>
#include <CGAL_ext/Square_parameterization/internal/sampling/Seam_fit.h>
#include <CGAL_ext/Square_parameterization/internal/sampling/grid_border.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// a map whose seams have the same samples of a grid on both sides
struct Aligned_map
{
  std::string message;       ///< why there is no map; empty when there is one
  bool is_cancelled = false; ///< the deadline ended it
  Minimized_map map;
  Corners corners{}; ///< positions in the border loop
  /// pairs of samples of the border that are the same point of the surface, counted counter-clockwise from (0, 0)
  std::vector<std::array<int, 2>> seam_samples;
};

/// the point of the square at \p position intervals from the beginning of a side: exactly a sample at a whole number
inline Uv_point point_on_side(int side, double position, const Grid_size& grid)
{
  const int intervals = intervals_of_sides(grid)[side];
  return point_of_side(side, (side < 2 ? position : intervals - position) / intervals);
}

/// the share of a segment that lies before each of its vertices but the last, from 0 on: the mean of both sides of a
/// seam. Edges without length get a little, for vertices must be distinct.
inline std::vector<double> shares_before(const Seamed_border& border, const std::vector<Border_segment>& segments,
                                         std::size_t s)
{
  constexpr double LEAST_SHARE = 1e-7;
  const Border_segment& segment = segments[s];
  const double length = border.length(segment);
  const double partner_length = segment.partner < 0 ? 0 : border.length(segments[segment.partner]);
  std::vector<double> before{0};
  for(int k = 0; k < segment.edges; ++k) {
    const int e = (segment.first + k) % border.size();
    double share = length > 0 ? border.shares[e] / length : 0;
    if(segment.partner >= 0)
      share = (share + (partner_length > 0 ? border.shares[border.partners[e]] / partner_length : 0)) / 2;
    before.push_back(before.back() + (std::max)(share, LEAST_SHARE));
  }
  const double sum = before.back();
  before.pop_back();
  for(double& x : before)
    x /= sum;
  return before;
}

/// where the border lies so that each segment gets its intervals (#B by 2), and the samples that seams share
inline Uv_coordinates aligned_border(const Seamed_border& border, const Seam_fit& fit, const Grid_size& grid,
                                     std::vector<std::array<int, 2>>& seam_samples)
{
  const std::array<int, 4> intervals = intervals_of_sides(grid);
  Uv_coordinates uv(border.size(), 2);
  std::vector<int> first_samples;
  int sample = 0, side_begin = 0, side = 0;
  for(std::size_t s = 0; s < fit.segments.size(); ++s) {
    const Border_segment& segment = fit.segments[s];
    for(; side < segment.side; ++side)
      side_begin += intervals[side];
    const std::vector<double> before = shares_before(border, fit.segments, s);
    for(int k = 0; k < segment.edges; ++k)
      uv.row((segment.first + k) % border.size()) =
          point_on_side(side, sample - side_begin + before[k] * fit.counts[s], grid);
    first_samples.push_back(sample);
    sample += fit.counts[s];
  }
  const int total = number_of_border_samples(grid);
  for(std::size_t s = 0; s < fit.segments.size(); ++s)
    if(const int partner = fit.segments[s].partner; partner > static_cast<int>(s))
      for(int k = 0; k <= fit.counts[s]; ++k)
        seam_samples.push_back({(first_samples[s] + k) % total, (first_samples[partner] + fit.counts[s] - k) % total});
  return uv;
}

/// the minimization with a border that stays
inline Minimization with_fixed_border(Minimization minimization)
{
  if(auto* const balanced = std::get_if<Balanced_minimization>(&minimization))
    balanced->border = Border_motion::FIXED;
  return minimization;
}

/// the border of a map onto the unit square
/// \param originals #V, the vertices of the uncut surface
inline Seamed_border seamed_border(const Patch& patch, const std::vector<int>& originals, const Uv_coordinates& uv)
{
  Seamed_border border;
  for(int v : patch.border)
    border.originals.push_back(originals[v]);
  border.partners = partner_edges(border.originals);
  for(int k = 0; k < border.size(); ++k) // edges lie on sides of the square
    border.shares.push_back((uv.row(patch.border[(k + 1) % border.size()]) - uv.row(patch.border[k])).lpNorm<1>());
  return border;
}

/// why no numbers of intervals fit
inline std::string why_nothing_fits(const Seamed_border& border, const Corners& corners, const Grid_size& grid)
{
  const std::vector<int> least = least_counts(border, border_segments(border.partners, corners));
  const int needed = std::accumulate(least.begin(), least.end(), 0), given = number_of_border_samples(grid);
  if(needed > given)
    return "the pieces into which seams and corners divide the border need " + std::to_string(needed) +
           " intervals between samples, and the border of the grid has " + std::to_string(given);
  return "no numbers of intervals between samples are the same on both sides of every seam and fill the sides of the "
         "grid";
}

/// maps a patch that was cut open once more, so that the two sides of every seam have the same samples of a grid: each
/// gets the same number of intervals, near the mean of what both have in a given map, and the border is fixed so; after
/// Gu, Gortler and Hoppe 2002. The ends of seams, the corners, and what lies across a seam from a corner are samples.
/// Corners move where there are no such numbers, and away from the ends of seams.
///
/// \param originals #V, the vertices of the uncut surface
/// \param uv #V by 2, a map onto the unit square
/// \param corners its corners, positions in the border loop
/// \param deadline when it has passed no map is begun, and what is being minimised is left as it is
/// \return with a message when the grid has too few samples for the seams, or there is no time for a map, or no
/// one-to-one one was found
inline Aligned_map align_seams(const Patch& patch, const std::vector<int>& originals, const Uv_coordinates& uv,
                               const Corners& corners, const Grid_size& grid, const Minimization& minimization,
                               const Deadline& deadline)
{
  Aligned_map result;
  if(has_passed(deadline)) {
    result.message = "the time was over before the map with the same samples on both sides was begun";
    result.is_cancelled = true;
    return result;
  }
  const Seamed_border border = seamed_border(patch, originals, uv);
  const auto fit = fit_seams_somehow(border, corners, grid);
  if(!fit) {
    result.message = why_nothing_fits(border, corners, grid);
    return result;
  }
  const Uv_coordinates border_uv = aligned_border(border, *fit, grid, result.seam_samples);
  result.corners = fit->corners;
  const auto minimizer = make_minimizer(patch, with_fixed_border(minimization), deadline);
  result.map = minimizer->finish(minimizer->make_worker()(border_uv, nullptr));
  result.is_cancelled = result.map.report.stop_reason == Stop_reason::DEADLINE;
  if(result.map.uv.rows() == 0)
    result.message = "the map with the same samples on both sides of every seam is not one-to-one";
  return result;
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SAMPLING_ALIGN_SEAMS_H
