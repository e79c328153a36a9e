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
