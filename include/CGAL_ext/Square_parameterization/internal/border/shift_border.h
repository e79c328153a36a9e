// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_BORDER_SHIFT_BORDER_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_BORDER_SHIFT_BORDER_H

#include <CGAL_ext/Square_parameterization/internal/border/square_sides.h>
#include <CGAL_ext/Square_parameterization/internal/patch/Patch.h>

#include <array>
#include <cmath>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// a border for other corners of which the vertices are spread as on the border of a map: each side is scaled to the
/// part of the square that its vertices occupied
///
/// \param uv a map (#V by 2) whose border vertices are on the unit square, in order
/// \param border_uv #B by 2, a border that tells the corners; returned as it is where two vertices share a place
inline Uv_coordinates shift_border(const Patch& patch, const Uv_coordinates& uv, const Uv_coordinates& border_uv)
{
  const int n = static_cast<int>(border_uv.rows());
  std::array<int, 4> corners{};
  std::array<int, 4> found{};
  for(int k = 0; k < n; ++k)
    if(const double way = way_round_square(border_uv.row(k)); way == std::floor(way)) {
      corners[static_cast<int>(way) % 4] = k;
      ++found[static_cast<int>(way) % 4];
    }
  if(found != std::array<int, 4>{1, 1, 1, 1})
    return border_uv;
  Uv_coordinates result(n, 2);
  const auto way_from = [&](int begin, int k) {
    const double way = way_round_square(uv.row(patch.border[k])) - way_round_square(uv.row(patch.border[begin]));
    return way < 0 ? way + 4 : way;
  };
  for(int side = 0; side < 4; ++side) {
    const int begin = corners[side], end = corners[(side + 1) % 4];
    const double length = way_from(begin, end);
    double before = -1;
    for(int k = begin; k != end; k = (k + 1) % n) {
      const double share = way_from(begin, k) / length;
      if(!(share > before && share < 1))
        return border_uv;
      result.row(k) = point_at_share(side, share);
      before = share;
    }
  }
  return result;
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_BORDER_SHIFT_BORDER_H
