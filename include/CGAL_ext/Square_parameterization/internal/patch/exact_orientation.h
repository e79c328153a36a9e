// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PATCH_EXACT_ORIENTATION_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PATCH_EXACT_ORIENTATION_H

#include <CGAL_ext/Square_parameterization/internal/patch/Patch.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL_ext {
namespace internal {

/// a point of the plane
typedef Eigen::RowVector2d Uv_point;

/// 1 when \p p, \p q and \p r turn left, -1 when they turn right, 0 when they lie on a line: exactly. 0 when a coordinate
/// is not finite.
int orientation(const Uv_point& p, const Uv_point& q, const Uv_point& r);

/// twice the signed area of the triangle of \p p, \p q and \p r, with a relative error below 1e-11, however thin it is. As
/// floating-point numbers give it when a coordinate is not finite.
double accurate_twice_area(const Uv_point& p, const Uv_point& q, const Uv_point& r);

/// indicates whether the uv triangle \p t is counter-clockwise, exactly
bool is_counterclockwise(const Uv_coordinates& uv, const std::array<int, 3>& t);

/// number of uv triangles that are clockwise or flat, exactly. A map onto a convex border without such triangles is
/// one-to-one.
std::size_t number_of_flipped_faces(const std::vector<std::array<int, 3>>& triangles, const Uv_coordinates& uv);

} // namespace internal
} // namespace CGAL_ext

#ifndef CGAL_EXT_COMPILED_CORE
#include <CGAL_ext/Square_parameterization/internal/patch/exact_orientation_impl.h>
#endif

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PATCH_EXACT_ORIENTATION_H
