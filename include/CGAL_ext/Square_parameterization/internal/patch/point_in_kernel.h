// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PATCH_POINT_IN_KERNEL_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PATCH_POINT_IN_KERNEL_H

#include <Eigen/Geometry>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// twice the signed area of triangle `pqr`
inline double twice_area(const Eigen::RowVector2d& p, const Eigen::RowVector2d& q, const Eigen::RowVector2d& r)
{
  return (q.x() - p.x()) * (r.y() - p.y()) - (q.y() - p.y()) * (r.x() - p.x());
}

/// a convex polygon of which lines cut off parts, as far as rounding lets it be convex
class Convex_polygon
{
public:
  Convex_polygon() = default;
  explicit Convex_polygon(const Eigen::AlignedBox2d& box) { become(box); }

  /// becomes a box, in the memory that there is
  void become(const Eigen::AlignedBox2d& box)
  {
    m_corners.clear();
    for(const auto corner : {Eigen::AlignedBox2d::BottomLeft, Eigen::AlignedBox2d::BottomRight,
                             Eigen::AlignedBox2d::TopRight, Eigen::AlignedBox2d::TopLeft})
      m_corners.push_back(box.corner(corner).transpose());
  }

  /// counter-clockwise
  const std::vector<Eigen::RowVector2d>& corners() const { return m_corners; }

  /// cuts off what is right of the line from `a` to `b`. Adds one corner at most.
  void cut_off(const Eigen::RowVector2d& a, const Eigen::RowVector2d& b)
  {
    m_areas.clear();
    for(const Eigen::RowVector2d& p : m_corners)
      m_areas.push_back(twice_area(a, b, p));
    const auto farthest = std::min_element(m_areas.begin(), m_areas.end());
    if(farthest == m_areas.end() || *farthest >= 0)
      return;
    ignore_rounding(static_cast<std::size_t>(farthest - m_areas.begin()));
    m_rest.clear();
    for(std::size_t i = 0; i < m_corners.size(); ++i) {
      const std::size_t next = after(i);
      const double at_p = m_areas[i], at_q = m_areas[next];
      if(at_p >= 0)
        m_rest.push_back(m_corners[i]);
      if((at_p > 0 && at_q < 0) || (at_p < 0 && at_q > 0))
        m_rest.push_back(m_corners[i] + at_p / (at_p - at_q) * (m_corners[next] - m_corners[i]));
    }
    m_corners.swap(m_rest);
  }

private:
  std::size_t after(std::size_t i) const { return i + 1 == m_corners.size() ? 0 : i + 1; }
  std::size_t before(std::size_t i) const { return (i == 0 ? m_corners.size() : i) - 1; }

  /// of the corners right of the line only those in a row around the farthest are cut off; others are there by rounding, and
  /// count as on the line. If each were cut off, corners that are all but on the line could double their number.
  void ignore_rounding(std::size_t farthest)
  {
    std::size_t first = after(farthest), last = before(farthest); // of those that stay
    while(m_areas[first] < 0 && first != farthest)
      first = after(first);
    while(m_areas[last] < 0 && last != farthest)
      last = before(last);
    for(std::size_t i = first; i != farthest && i != after(last); i = after(i))
      m_areas[i] = (std::max)(m_areas[i], 0.);
  }

  std::vector<Eigen::RowVector2d> m_corners, m_rest;
  std::vector<double> m_areas; // twice those of the triangles of the line and each corner
};

/// a point well inside the kernel of a counter-clockwise polygon, the set of points that see all of it; none when the
/// kernel is lost in rounding
/// \param kernel memory of many calls
inline std::optional<Eigen::RowVector2d> point_in_kernel(const std::vector<Eigen::RowVector2d>& polygon,
                                                         Convex_polygon& kernel)
{
  Eigen::AlignedBox2d box;
  for(const Eigen::RowVector2d& p : polygon)
    box.extend(p.transpose());
  kernel.become(box);
  for(std::size_t i = 0; i < polygon.size(); ++i) {
    kernel.cut_off(polygon[i], polygon[(i + 1) % polygon.size()]);
    if(kernel.corners().size() < 3)
      return {};
  }
  Eigen::RowVector2d center(0, 0);
  for(const Eigen::RowVector2d& p : kernel.corners())
    center += p / static_cast<double>(kernel.corners().size());
  return center;
}

/// the same for a single call
inline std::optional<Eigen::RowVector2d> point_in_kernel(const std::vector<Eigen::RowVector2d>& polygon)
{
  Convex_polygon kernel;
  return point_in_kernel(polygon, kernel);
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PATCH_POINT_IN_KERNEL_H
