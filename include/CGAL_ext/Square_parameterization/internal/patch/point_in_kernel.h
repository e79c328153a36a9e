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
  std::vector<Eigen::RowVector2d> rest;
  std::vector<double> areas;                        // of side i and each corner of the kernel
  for(std::size_t i = 0; i < polygon.size(); ++i) { // cuts off what is right of side i
    const Eigen::RowVector2d &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    areas.clear();
    for(const Eigen::RowVector2d& p : kernel)
      areas.push_back(twice_area(a, b, p));
    if(std::all_of(areas.begin(), areas.end(), [](double area) { return area >= 0; }))
      continue;
    rest.clear();
    for(std::size_t j = 0; j < kernel.size(); ++j) {
      const std::size_t next = (j + 1) % kernel.size();
      const double at_p = areas[j], at_q = areas[next];
      if(at_p >= 0)
        rest.push_back(kernel[j]);
      if((at_p > 0 && at_q < 0) || (at_p < 0 && at_q > 0))
        rest.push_back(kernel[j] + at_p / (at_p - at_q) * (kernel[next] - kernel[j]));
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
