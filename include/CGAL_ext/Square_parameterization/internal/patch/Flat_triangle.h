// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PATCH_FLAT_TRIANGLE_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PATCH_FLAT_TRIANGLE_H

#include <CGAL_ext/Square_parameterization/base_weight_types.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// the least height of a face, and the least length of a border edge, in a metric that can be mapped one-to-one, in
/// units of sqrt(area): a degenerate face is given this height over its longest side, or less; see `widened_height()`. The
/// points are left as they are.
constexpr double LEAST_LENGTH = 1e-4;

/// the height, in the same units, below which a face is degenerate. Thinner ones have no maps with digits to spare.
constexpr double DEGENERATE_HEIGHT = 1e-8;

using CGAL_ext::Flat_triangle;

/// lays triangle `pqr` into the plane; a height or a base that is lost in the rounding of the coordinates gives an
/// `y2` of zero
inline Flat_triangle flatten(const Eigen::Vector3d& p, const Eigen::Vector3d& q, const Eigen::Vector3d& r,
                             double least_length)
{
  const Eigen::Vector3d a = q - p, b = r - p;
  const double x1 = a.norm();
  if(!(x1 > least_length))
    return {x1, b.norm(), 0};
  const Eigen::Vector3d axis = a / x1;
  // the height is taken over the longest side: over a short side rounding would look like a height
  const double twice_area = a.cross(b).norm();
  const double longest = (std::max)({x1, b.norm(), (r - q).norm()});
  if(!(twice_area > least_length * longest))
    return {x1, axis.dot(b), 0};
  return {x1, axis.dot(b), twice_area / x1};
}

/// lays the triangle `pqr`, which is degenerate, into the plane as if its height were \p least_length over its longest
/// side, and that side no shorter
inline Flat_triangle widened(const Eigen::Vector3d& p, const Eigen::Vector3d& q, const Eigen::Vector3d& r,
                             double least_length)
{
  const std::array<Eigen::Vector3d, 3> corners{p, q, r};
  const auto squared_side = [&](int k) { return (corners[(k + 2) % 3] - corners[(k + 1) % 3]).squaredNorm(); };
  int top = 0; // opposite to the longest side
  for(int k : {1, 2})
    if(squared_side(k) > squared_side(top))
      top = k;
  const Eigen::Vector3d side = corners[(top + 2) % 3] - corners[(top + 1) % 3];
  const double share = side.squaredNorm() > 0 ? (corners[top] - corners[(top + 1) % 3]).dot(side) / side.squaredNorm()
                                              : 0.5; // of the side, where the foot of the height divides it
  const double base = (std::max)(side.norm(), least_length);
  std::array<Eigen::Vector2d, 3> plane;
  plane[top] = {(std::clamp)(share, 0., 1.) * base, least_length};
  plane[(top + 1) % 3] = {0, 0};
  plane[(top + 2) % 3] = {base, 0};
  const Eigen::Vector2d a = plane[1] - plane[0], b = plane[2] - plane[0];
  return {a.norm(), a.dot(b) / a.norm(), (a.x() * b.y() - a.y() * b.x()) / a.norm()};
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PATCH_FLAT_TRIANGLE_H
