// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PATCH_POINT_IN_KERNEL_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PATCH_POINT_IN_KERNEL_H

#include <Eigen/Geometry>

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

/// a point well inside the kernel of a counter-clockwise polygon, the set of points that see all of it; none when the
/// kernel is lost in rounding
inline std::optional<Eigen::RowVector2d> point_in_kernel(const std::vector<Eigen::RowVector2d>& polygon)
{
  Eigen::AlignedBox2d box;
  for(const Eigen::RowVector2d& p : polygon)
    box.extend(p.transpose());
  const Eigen::Vector2d low = box.min(), high = box.max();
  std::vector<Eigen::RowVector2d> kernel{Eigen::RowVector2d(low.x(), low.y()), Eigen::RowVector2d(high.x(), low.y()),
                                         Eigen::RowVector2d(high.x(), high.y()), Eigen::RowVector2d(low.x(), high.y())};
  for(std::size_t i = 0; i < polygon.size(); ++i) { // cuts off what is right of side i
    const Eigen::RowVector2d &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    std::vector<Eigen::RowVector2d> rest;
    for(std::size_t j = 0; j < kernel.size(); ++j) {
      const Eigen::RowVector2d &p = kernel[j], &q = kernel[(j + 1) % kernel.size()];
      const double at_p = twice_area(a, b, p), at_q = twice_area(a, b, q);
      if(at_p >= 0)
        rest.push_back(p);
      if((at_p > 0 && at_q < 0) || (at_p < 0 && at_q > 0))
        rest.push_back(p + at_p / (at_p - at_q) * (q - p));
    }
    kernel.swap(rest);
    if(kernel.size() < 3)
      return {};
  }
  Eigen::RowVector2d center(0, 0);
  for(const Eigen::RowVector2d& p : kernel)
    center += p / static_cast<double>(kernel.size());
  return center;
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PATCH_POINT_IN_KERNEL_H
