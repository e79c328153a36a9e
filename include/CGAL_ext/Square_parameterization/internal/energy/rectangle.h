// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ENERGY_RECTANGLE_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ENERGY_RECTANGLE_H

#include <CGAL_ext/Square_parameterization/internal/patch/Patch.h>

#include <cmath>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// what takes the unit square to the rectangle of area 1 whose width is \p aspect times its height: the factors of u and
/// of v. Those of the square are exactly 1.
inline Eigen::RowVector2d scale_to_rectangle(double aspect)
{
  const double width = std::sqrt(aspect);
  return {width, 1 / width};
}

/// a map onto the unit square (#V by 2) as one onto that rectangle, where its stretch is measured
inline Uv_coordinates on_rectangle(const Uv_coordinates& uv, double aspect)
{
  return uv * scale_to_rectangle(aspect).asDiagonal();
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ENERGY_RECTANGLE_H
