// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PATCH_VERTICES_ALONG_CURVE_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PATCH_VERTICES_ALONG_CURVE_H

#include <CGAL_ext/Square_parameterization/internal/common/Thread_team.h>

#include <CGAL/hilbert_sort.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// compares numbers of points by one of their coordinates
struct Less_along_axis
{
  const std::vector<Eigen::Vector3d>* points;
  int axis;
  bool is_reversed = false;

  bool operator()(int p, int q) const
  {
    if(is_reversed)
      std::swap(p, q);
    const double a = (*points)[p][axis], b = (*points)[q][axis];
    return a < b || (a == b && p < q); // copies on the two sides of a seam
  }

  Less_along_axis reversed() const { return {points, axis, !is_reversed}; }
};

/// a model of CGAL's `SpatialSortingTraits_3` whose points are numbers of points, with any coordinates for x, y and z
struct Numbered_points_traits
{
  typedef int Point_3;
  typedef Less_along_axis Less_x_3;
  typedef Less_along_axis Less_y_3;
  typedef Less_along_axis Less_z_3;

  Less_x_3 less_x_3_object() const { return x; }
  Less_y_3 less_y_3_object() const { return y; }
  Less_z_3 less_z_3_object() const { return z; }

  Less_along_axis x, y, z;
};

/// the eight pieces of Hilbert's curve through a set of points
class Curve_pieces
{
public:
  static constexpr std::size_t NUMBER = 8;

  /// puts the points of each piece together, in the order of the pieces, with the threads of the current team
  explicit Curve_pieces(const Numbered_points_traits& traits, std::vector<int>& order)
    : m_traits(traits), m_order(order)
  {
    const auto& [x, y, z] = traits;
    m_ends[NUMBER] = static_cast<std::ptrdiff_t>(order.size());
    halve(0, 8, x);
    Thread_team::current()(2, [&, by = y](std::size_t i) { halve(4 * i, 4, i == 0 ? by : by.reversed()); });
    Thread_team::current()(4, [&, by = z](std::size_t i) { halve(2 * i, 2, i % 2 == 0 ? by : by.reversed()); });
  }

  /// sorts the points of a piece along it
  void sort(std::size_t piece) const
  {
    CGAL::hilbert_sort(m_order.begin() + m_ends[piece], m_order.begin() + m_ends[piece + 1], frame(piece),
                       CGAL::Hilbert_sort_median_policy());
  }

private:
  /// divides the points of so many pieces, from the first one on, at the median
  void halve(std::size_t first, std::size_t pieces, const Less_along_axis& less)
  {
    const std::ptrdiff_t begin = m_ends[first], end = m_ends[first + pieces], middle = begin + (end - begin) / 2;
    std::nth_element(m_order.begin() + begin, m_order.begin() + middle, m_order.begin() + end, less);
    m_ends[first + pieces / 2] = middle;
  }

  /// the coordinates along which a piece runs as the whole curve runs along x, y and z
  Numbered_points_traits frame(std::size_t piece) const
  {
    const auto& [x, y, z] = m_traits;
    const std::array<Numbered_points_traits, NUMBER> frames{{{z, x, y},
                                                             {y, z, x},
                                                             {y, z, x},
                                                             {x, y.reversed(), z.reversed()},
                                                             {x, y.reversed(), z.reversed()},
                                                             {y.reversed(), z, x.reversed()},
                                                             {y.reversed(), z, x.reversed()},
                                                             {z.reversed(), x.reversed(), y}}};
    return frames[piece];
  }

  const Numbered_points_traits m_traits;
  std::vector<int>& m_order;
  std::array<std::ptrdiff_t, NUMBER + 1> m_ends{}; // of the pieces before each
};

/// the vertices along Hilbert's curve through space: what is near in the list is near on the surface, and consecutive
/// vertices are pieces with short borders. With the threads of the current team; CGAL's parallel sort needs TBB.
inline std::vector<int> vertices_along_curve(const std::vector<Eigen::Vector3d>& points)
{
  std::vector<int> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  const Curve_pieces pieces({{&points, 0}, {&points, 1}, {&points, 2}}, order);
  Thread_team::current()(Curve_pieces::NUMBER, [&pieces](std::size_t piece) { pieces.sort(piece); });
  return order;
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PATCH_VERTICES_ALONG_CURVE_H
