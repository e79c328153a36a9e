// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PATCH_EXACT_ORIENTATION_IMPL_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PATCH_EXACT_ORIENTATION_IMPL_H

#include <CGAL_ext/Square_parameterization/internal/common/compiled_core.h>
#include <CGAL_ext/Square_parameterization/internal/patch/exact_orientation.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

CGAL_EXT_INLINE_FUNCTION bool is_counterclockwise(const Uv_coordinates& uv, const std::array<int, 3>& t)
{
  typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
  const auto point = [&](int v) { return Kernel::Point_2(uv(v, 0), uv(v, 1)); };
  return CGAL::orientation(point(t[0]), point(t[1]), point(t[2])) == CGAL::LEFT_TURN;
}

CGAL_EXT_INLINE_FUNCTION std::size_t number_of_flipped_faces(const std::vector<std::array<int, 3>>& triangles,
                                                             const Uv_coordinates& uv)
{
  std::size_t flipped = 0;
  for(const auto& t : triangles)
    if(!is_counterclockwise(uv, t))
      ++flipped;
  return flipped;
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PATCH_EXACT_ORIENTATION_IMPL_H
