// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_BORDER_BORDER_CURVES_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_BORDER_BORDER_CURVES_H

#include <CGAL_ext/Square_parameterization/Corner_rule.h>
#include <CGAL_ext/Square_parameterization/internal/border/square_sides.h>
#include <CGAL_ext/Square_parameterization/internal/patch/Patch.h>

#include <array>
#include <cmath>
#include <numeric>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// positions in the border loop of the vertices at the corners (0, 0), (1, 0), (1, 1) and (0, 1)
using Corners = std::array<int, 4>;

/// the border loop as one walks it to count candidates and to close sides: counter-clockwise, or clockwise from the
/// same first vertex. All positions of the interface are positions on the walk.
class Border_walk
{
public:
  /// \param lengths #B, edge k joins border vertices k and k + 1, counter-clockwise
  Border_walk(const std::vector<double>& lengths, Walk walk) : m_lengths(lengths), m_clockwise(walk == Walk::CLOCKWISE)
  {
    if(m_clockwise)
      std::reverse(m_lengths.begin(), m_lengths.end());
    m_total = std::accumulate(m_lengths.begin(), m_lengths.end(), 0.);
  }

  int size() const { return static_cast<int>(m_lengths.size()); }
  double total_length() const { return m_total; }
  bool is_clockwise() const { return m_clockwise; }

  /// length of the edge from the `i`-th vertex of the walk to the next
  double length(int i) const { return m_lengths[wrapped(i)]; }

  /// position in the border loop of the `i`-th vertex of the walk
  int border_position(int i) const { return m_clockwise ? (size() - wrapped(i)) % size() : wrapped(i); }

private:
  /// a division takes longer than all else that is done for a border vertex
  int wrapped(int i) const { return i < size() ? i : i % size(); }

  std::vector<double> m_lengths;
  bool m_clockwise;
  double m_total;
};

/// number of candidates in the first quarter of the walk: those nearer than a quarter of the border to its start
inline int number_of_quarter_candidates(const Border_walk& walk)
{
  double length = 0;
  int m = 0;
  while(m < walk.size() && length < walk.total_length() / 4)
    length += walk.length(m++);
  return m;
}

/// last edges at which the sides 0, 1 and 2 may close, so that every later side keeps an edge
inline int last_closing(const Border_walk& walk, int side)
{
  return walk.size() - 3 + side;
}

/// closes three sides from walk position \p start as the authors of the method do: at the edge end where the length of
/// the side first reaches a quarter; before that edge when the length would be 1.1 quarters or more.
inline std::array<int, 3> close_sides_by_length(const Border_walk& walk, int start)
{
  const double quarter = walk.total_length() / 4;
  std::array<int, 3> closings{};
  int edges = 0;
  for(int side = 0; side < 3; ++side) {
    const int first_edge = edges;
    double length = 0;
    while(edges < last_closing(walk, side)) {
      const double longer = length + walk.length(start + edges);
      if(longer >= 1.1 * quarter && edges > first_edge)
        break;
      length = longer;
      ++edges;
      if(length >= quarter)
        break;
    }
    closings[side] = edges;
  }
  return closings;
}

/// closes three sides at the vertices whose length from walk position \p start is nearest to one, two and three
/// quarters; a side that would have no edge moves on to the next vertex.
inline std::array<int, 3> close_sides_at_nearest(const Border_walk& walk, int start)
{
  const double quarter = walk.total_length() / 4;
  std::array<int, 3> closings{};
  int edges = 0;
  double length = 0;
  for(int side = 0; side < 3; ++side) {
    const double aim = (side + 1) * quarter;
    length += walk.length(start + edges++);
    while(edges < last_closing(walk, side) &&
          std::abs(length + walk.length(start + edges) - aim) < std::abs(length - aim))
      length += walk.length(start + edges++);
    closings[side] = edges;
  }
  return closings;
}

/// the four corners, as positions on the walk, when the vertex at walk position \p candidate goes to (0, 0).
/// \pre the border has at least four vertices
inline Corners corners_of_candidate(const Border_walk& walk, int candidate, Corner_rule rule)
{
  const std::array<int, 3> closings =
      rule == Corner_rule::AUTHOR ? close_sides_by_length(walk, candidate) : close_sides_at_nearest(walk, candidate);
  Corners corners{candidate, 0, 0, 0};
  for(int side = 0; side < 3; ++side)
    corners[side + 1] = (candidate + closings[side]) % walk.size();
  return corners;
}

/// a border on the square: one uv per border vertex (#B by 2) and its corners, both in the order of the border loop
struct Square_border
{
  Uv_coordinates uv;
  Corners corners;
};

/// puts the border on the unit square by arc length, each side scaled by its own length.
///
/// A clockwise walk would mirror the map: u and v are exchanged, so that the map is never mirrored.
/// \param walk_corners positions on the walk, in order along it
inline Square_border square_border(const Border_walk& walk, const Corners& walk_corners)
{
  Square_border border;
  border.uv.resize(walk.size(), 2);
  for(int side = 0; side < 4; ++side) {
    const int begin = walk_corners[side];
    const int edges = (walk_corners[(side + 1) % 4] - begin + walk.size()) % walk.size();
    double side_length = 0;
    for(int i = 0; i < edges; ++i)
      side_length += walk.length(begin + i);
    double length = 0;
    for(int i = 0; i < edges; ++i) {
      border.uv.row(walk.border_position(begin + i)) = point_at_share(side, length / side_length);
      length += walk.length(begin + i);
    }
    border.corners[side] = walk.border_position(begin);
  }
  if(walk.is_clockwise()) {
    border.uv.col(0).swap(border.uv.col(1));
    std::swap(border.corners[1], border.corners[3]);
  }
  return border;
}

/// indicates whether the four border positions are distinct and met in this order on one round of the border
inline bool are_corners_in_order(const Corners& corners, int border_size)
{
  int previous = 0;
  for(int k = 1; k < 4; ++k) {
    const int distance = (corners[k] - corners[0] + border_size) % border_size;
    if(distance <= previous)
      return false;
    previous = distance;
  }
  return true;
}

/// the radius of the circle of area 1
inline double unit_area_radius()
{
  return static_cast<double>(std::sqrt(1 / EIGEN_PI));
}

/// puts the border on the circle of radius \p radius around the origin by arc length, counter-clockwise, its first
/// vertex at (radius, 0). Returns one uv per border vertex (#B by 2).
inline Uv_coordinates circular_border(const std::vector<double>& lengths, double radius)
{
  const auto two_pi = static_cast<double>(2 * EIGEN_PI);
  const double total = std::accumulate(lengths.begin(), lengths.end(), 0.);
  Uv_coordinates uv(lengths.size(), 2);
  double length = 0;
  for(std::size_t k = 0; k < lengths.size(); ++k) {
    uv(k, 0) = radius * std::cos(two_pi * length / total);
    uv(k, 1) = radius * std::sin(two_pi * length / total);
    length += lengths[k];
  }
  return uv;
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_BORDER_BORDER_CURVES_H
