// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SAMPLING_BORDER_SEGMENTS_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SAMPLING_BORDER_SEGMENTS_H

#include <CGAL_ext/Square_parameterization/internal/border/border_curves.h>

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// a run of edges of the border loop that lies on one side of the square, and on one side of one seam or on none
struct Border_segment
{
  int first;        ///< position in the border loop where it begins
  int edges;        ///< number of its edges
  int side;         ///< of the square, 0 to 3, counter-clockwise from (0, 0)
  int partner = -1; ///< number of the segment on the other side of the seam; -1 where there is none
};

/// per edge of a border loop, edge k between positions k and k + 1, the one that was the same edge before the surface
/// was cut open; -1 for an edge of the uncut border
/// \param originals per position, the vertex of the uncut surface
inline std::vector<int> partner_edges(const std::vector<int>& originals)
{
  const int n = static_cast<int>(originals.size());
  std::vector<int> partners(n, -1);
  std::map<std::pair<int, int>, int> first_edge;
  for(int k = 0; k < n; ++k) {
    const auto [entry, is_new] = first_edge.emplace(std::minmax(originals[k], originals[(k + 1) % n]), k);
    if(!is_new) {
      partners[k] = entry->second;
      partners[entry->second] = k;
    }
  }
  return partners;
}

/// indicates whether the two sides of a seam meet at a position: the seam ends there inside the surface
inline bool is_seam_tip(const std::vector<int>& partners, int position)
{
  const int n = static_cast<int>(partners.size());
  return partners[position] == (position + n - 1) % n;
}

/// indicates whether a seam ends or meets others at a position
inline bool is_seam_node(const std::vector<int>& partners, int position)
{
  const int n = static_cast<int>(partners.size());
  const int here = partners[position], before = partners[(position + n - 1) % n];
  if(here < 0 && before < 0)
    return false;
  return here < 0 || before < 0 || is_seam_tip(partners, position) || before != (here + 1) % n;
}

/// per position, whether a segment ends there: at nodes of seams, at the corners, and across the seams from the corners
inline std::vector<bool> segment_ends(const std::vector<int>& partners, const Corners& corners)
{
  const int n = static_cast<int>(partners.size());
  std::vector<bool> is_end(n, false);
  for(int k = 0; k < n; ++k)
    is_end[k] = is_seam_node(partners, k);
  for(int corner : corners) {
    is_end[corner] = true;
    if(partners[corner] >= 0) // the other side of the seam runs the other way
      is_end[(partners[corner] + 1) % n] = true;
    if(const int before = partners[(corner + n - 1) % n]; before >= 0)
      is_end[before] = true;
  }
  return is_end;
}

/// the segments of a border loop, in their order from the first corner on
/// \param partners of the edges, as `partner_edges()` gives them
/// \pre the corners are distinct and in counter-clockwise order
inline std::vector<Border_segment> border_segments(const std::vector<int>& partners, const Corners& corners)
{
  const int n = static_cast<int>(partners.size());
  const std::vector<bool> is_end = segment_ends(partners, corners);
  std::vector<Border_segment> segments;
  std::vector<int> segment_before(n, -1); // the segment that ends at a position
  int side = -1;
  for(int step = 0; step < n; ++step) {
    const int position = (corners[0] + step) % n;
    if(std::find(corners.begin(), corners.end(), position) != corners.end())
      ++side;
    if(is_end[position])
      segments.push_back({position, 0, side});
    ++segments.back().edges;
    segment_before[(position + 1) % n] = static_cast<int>(segments.size()) - 1;
  }
  for(Border_segment& segment : segments)
    if(const int partner = partners[segment.first]; partner >= 0)
      segment.partner = segment_before[(partner + 1) % n];
  return segments;
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SAMPLING_BORDER_SEGMENTS_H
