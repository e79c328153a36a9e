// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PATCH_EXACT_ORIENTATION_IMPL_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PATCH_EXACT_ORIENTATION_IMPL_H

#include <CGAL_ext/Square_parameterization/internal/common/compiled_core.h>
#include <CGAL_ext/Square_parameterization/internal/common/ranges.h>
#include <CGAL_ext/Square_parameterization/internal/patch/exact_orientation.h>

#include <CGAL/MP_Float.h>

#include <cmath>
#include <limits>
#include <optional>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// products of which the sum of the amounts is below may have lost bits to underflow
constexpr double MAGNITUDE_WITHOUT_UNDERFLOW = 1e-270;

// CGAL's filtered kernels decide the same, but bring the number types of all their predicates along: 2 s and 90 MB more
// for each program that is compiled.

/// twice the signed area of a triangle in exact arithmetic. The coordinates are finite.
inline CGAL::MP_Float exact_twice_area(const Uv_point& p, const Uv_point& q, const Uv_point& r)
{
  const auto side = [&p](const Uv_point& to, int axis) { return CGAL::MP_Float(to[axis]) - CGAL::MP_Float(p[axis]); };
  return side(q, 0) * side(r, 1) - side(q, 1) * side(r, 0);
}

inline bool are_finite(const Uv_point& p, const Uv_point& q, const Uv_point& r)
{
  return p.allFinite() && q.allFinite() && r.allFinite();
}

/// twice the signed area of a triangle in floating-point numbers
struct Rounded_twice_area
{
  Rounded_twice_area(const Uv_point& p, const Uv_point& q, const Uv_point& r)
  {
    const double left = (q[0] - p[0]) * (r[1] - p[1]), right = (q[1] - p[1]) * (r[0] - p[0]);
    value = left - right;
    magnitude = std::abs(left) + std::abs(right);
  }

  /// indicates whether the relative error is below a bound, surely
  bool is_accurate(double relative_error) const
  {
    // Shewchuk 1997, orient2d's first error bound: three roundings each of the products, one of the difference
    constexpr double EPSILON = std::numeric_limits<double>::epsilon() / 2, BOUND = (3 + 16 * EPSILON) * EPSILON;
    return std::isfinite(magnitude) && magnitude >= MAGNITUDE_WITHOUT_UNDERFLOW &&
           std::abs(value) * relative_error > BOUND * magnitude;
  }

  double value, magnitude;
};

/// a sum of two numbers of which the second is what rounding loses of the first
struct Exact_sum
{
  Exact_sum(double a, double b) : value(a + b)
  {
    const double from_b = value - a;
    rest = (a - (value - from_b)) + (b - from_b); // Knuth 1969
  }

  double value, rest;
};

/// a product, as two such numbers. \pre a factor is 0, or the product has at least `MAGNITUDE_WITHOUT_UNDERFLOW`
struct Exact_product
{
  Exact_product(double a, double b) : value(a * b), rest(std::fma(a, b, -value)) {}

  double value, rest;
};

/// the sign of the area of a triangle of which two corners coincide, or whose sides are floating-point numbers, as those of
/// tiny ones are: most triangles that are flat but for rounding are like that. Nothing for others, nor where the difference of
/// the products needs more digits than two numbers have.
inline std::optional<int> orientation_by_exact_sides(const Uv_point& p, const Uv_point& q, const Uv_point& r)
{
  if(p == q || q == r || r == p)
    return 0;
  const Exact_sum qu(q[0], -p[0]), qv(q[1], -p[1]), ru(r[0], -p[0]), rv(r[1], -p[1]);
  if(qu.rest != 0 || qv.rest != 0 || ru.rest != 0 || rv.rest != 0)
    return {};
  const auto is_exact = [](double a, double b) {
    return a == 0 || b == 0 || std::abs(a * b) >= MAGNITUDE_WITHOUT_UNDERFLOW;
  };
  if(!is_exact(qu.value, rv.value) || !is_exact(qv.value, ru.value))
    return {};
  const Exact_product left(qu.value, rv.value), right(qv.value, ru.value);
  const Exact_sum values(left.value, -right.value), rests(left.rest, -right.rest);
  const Exact_sum sum(values.value, rests.value);
  if(values.rest != 0 || sum.rest != 0)
    return {};
  return sum.value > -rests.rest ? 1 : sum.value < -rests.rest ? -1 : 0;
}

CGAL_EXT_INLINE_FUNCTION int orientation(const Uv_point& p, const Uv_point& q, const Uv_point& r)
{
  const Rounded_twice_area rounded(p, q, r);
  if(rounded.is_accurate(1))
    return rounded.value > 0 ? 1 : -1;
  if(!are_finite(p, q, r))
    return 0;
  const std::optional<int> sign = orientation_by_exact_sides(p, q, r);
  return sign ? *sign : static_cast<int>(exact_twice_area(p, q, r).sign());
}

CGAL_EXT_INLINE_FUNCTION double accurate_twice_area(const Uv_point& p, const Uv_point& q, const Uv_point& r)
{
  constexpr double RELATIVE_ERROR = 1e-11;
  const Rounded_twice_area rounded(p, q, r);
  return rounded.is_accurate(RELATIVE_ERROR) || !are_finite(p, q, r) ? rounded.value
                                                                     : CGAL::to_double(exact_twice_area(p, q, r));
}

CGAL_EXT_INLINE_FUNCTION bool is_counterclockwise(const Uv_coordinates& uv, const std::array<int, 3>& t)
{
  return orientation(uv.row(t[0]), uv.row(t[1]), uv.row(t[2])) > 0;
}

CGAL_EXT_INLINE_FUNCTION std::size_t number_of_flipped_faces(const std::vector<std::array<int, 3>>& triangles,
                                                             const Uv_coordinates& uv)
{
  return sum_of_ranges(triangles.size(), std::size_t(0), [&](std::size_t begin, std::size_t end) {
    std::size_t flipped = 0;
    for(std::size_t f = begin; f < end; ++f)
      flipped += is_counterclockwise(uv, triangles[f]) ? 0 : 1;
    return flipped;
  });
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PATCH_EXACT_ORIENTATION_IMPL_H
