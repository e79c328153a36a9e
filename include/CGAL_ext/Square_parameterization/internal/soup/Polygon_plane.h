// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SOUP_POLYGON_PLANE_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SOUP_POLYGON_PLANE_H

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
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
    for(const Eigen::Vector3d& p : corners)
      m_mean += p / static_cast<double>(corners.size());
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

  /// indicates whether there is a plane: the polygon has an area, seen from somewhere
  bool has_normal() const { return m_normal.norm() > 0; }

  /// how far a point is from the plane, along the axis
  double height(const Eigen::Vector3d& p) const { return p[m_axes[2]] - level(seen(p)); }

  /// the point that is seen at \p p and has the height
  Eigen::Vector3d point(const Eigen::Vector2d& p, double height) const
  {
    Eigen::Vector3d result;
    result[m_axes[0]] = p.x();
    result[m_axes[1]] = p.y();
    result[m_axes[2]] = level(p) + height;
    return result;
  }

private:
  /// the coordinate along the axis of the plane through the mean of the corners. \pre `has_normal()`
  double level(const Eigen::Vector2d& p) const
  {
    return m_mean[m_axes[2]] - (p - seen(m_mean)).dot(seen(m_normal)) / m_normal[m_axes[2]];
  }

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

  Eigen::Vector3d m_mean{0, 0, 0};
  std::vector<Eigen::Vector3d> m_small;
  Eigen::Vector3d m_normal{0, 0, 0}; // of the small polygon; zero when it has none
  std::array<int, 3> m_axes{};       // the two that are seen, and the one along which they are
};

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SOUP_POLYGON_PLANE_H
