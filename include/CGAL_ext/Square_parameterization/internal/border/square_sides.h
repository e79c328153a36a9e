// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_BORDER_SQUARE_SIDES_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_BORDER_SQUARE_SIDES_H

#include <Eigen/Core>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

// The sides of the unit square are counted counter-clockwise from that between (0, 0) and (1, 0).

/// the point of a side of the unit square whose u (sides 0 and 2) or v (sides 1 and 3) is given
inline Eigen::RowVector2d point_of_side(int side, double coordinate)
{
  switch(side) {
  case 0:
    return {coordinate, 0};
  case 1:
    return {1, coordinate};
  case 2:
    return {coordinate, 1};
  default:
    return {0, coordinate};
  }
}

/// the point at a share, 0 to 1, of the way along a side of the unit square, counter-clockwise
inline Eigen::RowVector2d point_at_share(int side, double share)
{
  return point_of_side(side, side < 2 ? share : 1 - share);
}

/// how far a point on the unit square is round the border from (0, 0), counter-clockwise: 0 to 4, a corner at each
/// integer
inline double way_round_square(const Eigen::RowVector2d& p)
{
  if(p.y() == 0 && p.x() < 1)
    return p.x();
  if(p.x() == 1 && p.y() < 1)
    return 1 + p.y();
  if(p.y() == 1 && p.x() > 0)
    return 3 - p.x();
  return 4 - p.y();
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_BORDER_SQUARE_SIDES_H
