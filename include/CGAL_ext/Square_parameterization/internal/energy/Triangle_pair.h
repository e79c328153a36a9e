// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ENERGY_TRIANGLE_PAIR_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ENERGY_TRIANGLE_PAIR_H

#include <CGAL_ext/Square_parameterization/internal/patch/Patch.h>

#include <array>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// what the energy of a triangle needs to know of its shape when one of its corners moves; all on the surface
struct Corner_shape
{
  double inverse_twice_area;
  double squared_side;   ///< of the side opposite to the corner, in units of four times the area
  double squared_height; ///< over that side, in the same units
  double foot;           ///< where the height divides the side: 0 at the next corner, 1 at the one after it
};

inline Corner_shape corner_shape(const Flat_triangle& shape, int corner)
{
  const std::array<Eigen::Vector2d, 3> plane{Eigen::Vector2d(0, 0), Eigen::Vector2d(shape.x1, 0),
                                             Eigen::Vector2d(shape.x2, shape.y2)};
  const Eigen::Vector2d& start = plane[(corner + 1) % 3];
  const Eigen::Vector2d side = plane[(corner + 2) % 3] - start;
  const double squared_side = side.squaredNorm(), area = shape.area();
  return {1 / (2 * area), squared_side / (4 * area), area / squared_side,
          (plane[corner] - start).dot(side) / squared_side};
}

/// two triangles that share the corner that moves: what is computed of one is computed of both by the same instructions
struct Corner_pair
{
  Corner_pair() = default;
  Corner_pair(const Corner_shape& a, const Corner_shape& b)
    : inverse_twice_area(a.inverse_twice_area, b.inverse_twice_area),
      squared_side(a.squared_side, b.squared_side),
      squared_height(a.squared_height, b.squared_height),
      foot(a.foot, b.foot)
  {}

  /// one triangle, which counts as two with half of the energy
  static Corner_pair of_one(Corner_shape shape)
  {
    shape.squared_side /= 2;
    shape.squared_height /= 2;
    return {shape, shape};
  }

  Eigen::Array2d inverse_twice_area, squared_side, squared_height, foot; // see `Corner_shape`
};

/// the same, with the uv positions of their other corners: q and r, the next two after the one that moves
struct Triangle_pair
{
  typedef Eigen::Array2d Numbers; // of both triangles

  template <class Position>
  Triangle_pair(const Corner_pair& shapes_, const Position& q0, const Position& q1, const Position& r0,
                const Position& r1)
    : shapes(shapes_), q_u(q0.x(), q1.x()), q_v(q0.y(), q1.y()), r_u(r0.x(), r1.x()), r_v(r0.y(), r1.y())
  {}

  /// one triangle
  template <class Position>
  Triangle_pair(const Corner_shape& shape, const Position& q, const Position& r)
    : Triangle_pair(Corner_pair::of_one(shape), q, q, r, r)
  {}

  Corner_pair shapes;
  Numbers q_u, q_v, r_u, r_v;
};

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ENERGY_TRIANGLE_PAIR_H
