// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COARSENING_IS_GOOD_REPLACEMENT_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COARSENING_IS_GOOD_REPLACEMENT_H
#include <CGAL_ext/Square_parameterization/internal/common/Minimizer_numbers.h>

#include <Eigen/Geometry>

#include <algorithm>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// indicates whether triangle \p to, \p a, \p b looks the same way as \p from, \p a, \p b and keeps a share of its
/// shape
inline bool is_good_replacement(const Eigen::Vector3d& from, const Eigen::Vector3d& to, const Eigen::Vector3d& a,
                                const Eigen::Vector3d& b, double least_shape_kept)
{
  const auto shape = [&](const Eigen::Vector3d& p, double twice_area) { // height over longest side
    return twice_area / (std::max)({(a - p).squaredNorm(), (b - p).squaredNorm(), (b - a).squaredNorm()});
  };
  const Eigen::Vector3d old_normal = (a - from).cross(b - from), new_normal = (a - to).cross(b - to);
  const double old_size = old_normal.norm(), new_size = new_normal.norm();
  if(!(new_normal.dot(old_normal) > Minimizer_numbers::LEAST_NORMAL_COSINE * new_size * old_size))
    return false;
  const double new_shape = shape(to, new_size);
  return new_shape > Minimizer_numbers::GOOD_SHAPE || new_shape > least_shape_kept * shape(from, old_size);
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COARSENING_IS_GOOD_REPLACEMENT_H
