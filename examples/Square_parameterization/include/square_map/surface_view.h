// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_SURFACE_VIEW_H
#define SQUARE_MAP_SURFACE_VIEW_H

#include "Canvas.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <vector>

namespace square_map {

/// a surface as it is seen from one side, in the middle of a picture
class Surface_view
{
public:
  /// \param front towards the one who looks; not parallel to \p up
  Surface_view(const std::vector<Eigen::Vector3d>& points, const Eigen::Vector3d& front, const Eigen::Vector3d& up)
  {
    Eigen::AlignedBox3d box;
    for(const Eigen::Vector3d& p : points)
      box.extend(p);
    m_center = box.center();
    m_axes.row(2) = front.normalized();
    m_axes.row(0) = up.cross(front).normalized();
    m_axes.row(1) = m_axes.row(2).cross(m_axes.row(0));
    for(const Eigen::Vector3d& p : points)
      m_extent = (std::max)(m_extent, (m_axes * (p - m_center)).head<2>().cwiseAbs().maxCoeff());
  }

  Place place(const Eigen::Vector3d& point) const
  {
    return m_axes * (point - m_center) * (m_extent > 0 ? 0.46 / m_extent : 1.) + Eigen::Vector3d::Constant(0.5);
  }

  /// the brightness of a side with this normal, from the front or from the back
  double light(const Eigen::Vector3d& normal) const { return 0.35 + 0.65 * std::abs(m_axes.row(2).dot(normal)); }

private:
  Eigen::Matrix3d m_axes;
  Eigen::Vector3d m_center;
  double m_extent = 0;
};

/// the color of a checkerboard on the square, \p squares along each side
inline Eigen::Vector3d checkerboard_at(double u, double v, int squares)
{
  const bool is_light =
      (static_cast<int>(std::floor(u * squares)) + static_cast<int>(std::floor(v * squares))) % 2 == 0;
  return is_light ? Eigen::Vector3d(240, 240, 235) : Eigen::Vector3d(60, 90, 140);
}

} // namespace square_map

#endif // SQUARE_MAP_SURFACE_VIEW_H
