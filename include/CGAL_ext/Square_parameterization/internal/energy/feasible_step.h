// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ENERGY_FEASIBLE_STEP_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ENERGY_FEASIBLE_STEP_H

#include <CGAL_ext/Square_parameterization/internal/common/ranges.h>
#include <CGAL_ext/Square_parameterization/internal/patch/Patch.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// which coordinates of the vertices may move: #V by 2
typedef Eigen::Matrix<bool, Eigen::Dynamic, 2, Eigen::RowMajor> Free_coordinates;

/// indicates whether a point lies on a side of the unit square
inline bool is_on_unit_square(const Eigen::RowVector2d& p)
{
  return p.x() == 0 || p.x() == 1 || p.y() == 0 || p.y() == 1;
}

/// the interior moves; the border stays, or slides along the sides of the unit square with its corners fixed. A border
/// elsewhere stays.
inline Free_coordinates free_coordinates(const Patch& patch, const Uv_coordinates& uv, bool is_border_sliding)
{
  Free_coordinates is_free = Free_coordinates::Constant(uv.rows(), 2, true);
  const bool may_slide = is_border_sliding && std::all_of(patch.border.begin(), patch.border.end(),
                                                          [&uv](int v) { return is_on_unit_square(uv.row(v)); });
  for(int v : patch.border)
    for(int axis = 0; axis < 2; ++axis) {
      const double across = uv(v, 1 - axis), along = uv(v, axis);
      is_free(v, axis) = may_slide && (across == 0 || across == 1) && along > 0 && along < 1;
    }
  return is_free;
}

/// the largest t for which the uv triangle of the vertices \p t does not lose its area on the way from uv to
/// uv + t direction; infinite when it does not
/// \param bound beyond which it need not be known: then it may be infinite, too
inline double largest_step(const std::array<int, 3>& t, const Uv_coordinates& uv, const Uv_coordinates& direction,
                           double bound = std::numeric_limits<double>::infinity())
{
  const Eigen::RowVector2d a = uv.row(t[1]) - uv.row(t[0]), b = uv.row(t[2]) - uv.row(t[0]);
  const Eigen::RowVector2d da = direction.row(t[1]) - direction.row(t[0]),
                           db = direction.row(t[2]) - direction.row(t[0]);
  const auto cross = [](const Eigen::RowVector2d& p, const Eigen::RowVector2d& q) {
    return p.x() * q.y() - q.x() * p.y();
  };
  // twice the area is constant + linear t + quadratic t^2; its least positive root, without cancellation
  const double quadratic = cross(da, db), linear = cross(a, db) + cross(da, b), constant = cross(a, b);
  // up to the bound the parabola is above its tangent at 0, or above its chord
  if(constant + bound * (std::min)(linear, linear + bound * quadratic) > 0)
    return std::numeric_limits<double>::infinity();
  const double discriminant = linear * linear - 4 * quadratic * constant;
  if(discriminant < 0 || (linear >= 0 && quadratic >= 0))
    return std::numeric_limits<double>::infinity();
  const double root = std::sqrt(discriminant);
  return linear < 0 ? 2 * constant / (root - linear) : -(linear + root) / (2 * quadratic);
}

/// the same for all triangles of a patch
inline double largest_step(const Patch& patch, const Uv_coordinates& uv, const Uv_coordinates& direction)
{
  struct Least
  {
    double value;
    void operator+=(const Least& other) { value = (std::min)(value, other.value); }
  };
  const Least unbounded{std::numeric_limits<double>::infinity()};
  return sum_of_ranges(patch.triangles.size(), unbounded,
                       [&](std::size_t begin, std::size_t end) {
                         Least least = unbounded;
                         for(std::size_t f = begin; f < end; ++f)
                           least += {largest_step(patch.triangles[f], uv, direction, least.value)};
                         return least;
                       })
      .value;
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ENERGY_FEASIBLE_STEP_H
