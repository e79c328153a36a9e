// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SOUP_POLYGON_PLANE_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SOUP_POLYGON_PLANE_H

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// a polygon in space, seen along the axis nearest to its normal, from where it is counter-clockwise: no rounding, and what
/// lies on a line stays there
class Polygon_plane
{
public:
  /// \param corners of the polygon, at least three
  explicit Polygon_plane(const std::vector<Eigen::Vector3d>& corners) : m_small(corners)
  {
    make_small();
    for(std::size_t k = 0; k < m_small.size(); ++k)
      m_normal += m_small[k].cross(m_small[(k + 1) % m_small.size()]);
    int axis = 0;
    m_normal.cwiseAbs().maxCoeff(&axis);
    const int next = (axis + 1) % 3, last = (axis + 2) % 3;
    m_axes = m_normal[axis] < 0 ? std::array<int, 3>{last, next, axis} : std::array<int, 3>{next, last, axis};
  }

  /// the corners as differences from the first, made so small that no product overflows
  const std::vector<Eigen::Vector3d>& small_corners() const { return m_small; }

  /// the two coordinates of a point that are seen
  Eigen::Vector2d seen(const Eigen::Vector3d& p) const { return {p[m_axes[0]], p[m_axes[1]]}; }

  /// indicates whether the corners lie in a plane, but for so much of the size of the polygon
  bool is_flat(double tolerance) const
  {
    const double length = m_normal.norm();
    const Eigen::Vector3d origin = mean(m_small);
    return length > 0 && std::all_of(m_small.begin(), m_small.end(), [&](const Eigen::Vector3d& p) {
             return std::abs(m_normal.dot(p - origin)) <= tolerance * length;
           });
  }

  /// the point of the plane that is seen at \p p
  /// \param origin a point of the plane
  Eigen::Vector3d point_seen_at(const Eigen::Vector2d& p, const Eigen::Vector3d& origin) const
  {
    const Eigen::Vector2d from_origin = p - seen(origin);
    Eigen::Vector3d result;
    result[m_axes[0]] = p.x();
    result[m_axes[1]] = p.y();
    result[m_axes[2]] = origin[m_axes[2]] - from_origin.dot(seen(m_normal)) / m_normal[m_axes[2]];
    return result;
  }

  static Eigen::Vector3d mean(const std::vector<Eigen::Vector3d>& points)
  {
    Eigen::Vector3d sum(0, 0, 0);
    for(const Eigen::Vector3d& p : points)
      sum += p / static_cast<double>(points.size());
    return sum;
  }

private:
  void make_small()
  {
    const Eigen::Vector3d origin = m_small.front();
    double size = 0;
    for(Eigen::Vector3d& p : m_small) {
      p = p / 2 - origin / 2;
      size = (std::max)(size, p.cwiseAbs().maxCoeff());
    }
    for(Eigen::Vector3d& p : m_small)
      p = p.unaryExpr([size](double x) { return size > 0 ? x / size : 0; });
  }

  std::vector<Eigen::Vector3d> m_small;
  Eigen::Vector3d m_normal{0, 0, 0}; // of the small polygon; zero when it has none
  std::array<int, 3> m_axes{};       // the two that are seen, and the one along which they are
};

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SOUP_POLYGON_PLANE_H
