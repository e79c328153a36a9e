// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "test_meshes.h"

#include <CGAL_ext/Square_parameterization/internal/energy/stretch_kernel.h>
#include <CGAL_ext/Square_parameterization/internal/patch/exact_orientation.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

using namespace CGAL_ext;
using namespace CGAL_ext::internal;

namespace {

bool is_left_turn_by_cgal(const Uv_coordinates& uv)
{
  typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
  const auto point = [&](int v) { return Kernel::Point_2(uv(v, 0), uv(v, 1)); };
  return CGAL::orientation(point(0), point(1), point(2)) == CGAL::LEFT_TURN;
}

/// a triangle whose third vertex lies on the line of the others, but for rounding
Uv_coordinates nearly_flat_triangle(Random_numbers& random)
{
  Uv_coordinates uv(3, 2);
  uv << random(0, 1), random(0, 1), random(0, 1), random(0, 1), 0, 0;
  uv.row(2) = uv.row(0) + random(-1, 2) * (uv.row(1) - uv.row(0));
  return uv;
}

} // namespace

TEST_CASE("the orientation of triangles is that of CGAL's exact predicate")
{
  Random_numbers random(1);
  std::size_t agreements = 0, left_turns = 0;
  constexpr std::size_t TRIANGLES = 3000;
  for(double scale : {1., 1e-8, 1e8, 1e-150, 1e-160, 1e-300, 1e150, 1e300}) {
    CAPTURE(scale);
    agreements = left_turns = 0;
    for(std::size_t k = 0; k < TRIANGLES; ++k) {
      Uv_coordinates uv = nearly_flat_triangle(random);
      if(k % 3 == 1) // on a lattice: exactly flat, many of them
        uv = (uv * 4).array().round();
      if(k % 3 == 2)
        uv(2, 0) = std::nextafter(uv(2, 0), random(-9, 9));
      uv *= scale;
      const bool is_left_turn = is_left_turn_by_cgal(uv);
      left_turns += is_left_turn;
      agreements += is_left_turn == is_counterclockwise(uv, {0, 1, 2});
    }
    CHECK(agreements == TRIANGLES);
    CHECK(left_turns > TRIANGLES / 10);
    CHECK(left_turns < TRIANGLES * 9 / 10);
  }
}

TEST_CASE("the orientation of triangles whose sides are exact is that of CGAL's exact predicate")
{
  Random_numbers random(3);
  std::size_t left_turns = 0, flat = 0;
  constexpr std::size_t TRIANGLES = 3000;
  for(std::size_t k = 0; k < TRIANGLES; ++k) {
    // one side is a multiple of the other, but for the last bit of a coordinate; their products have more bits than a number
    const Uv_point corner{std::ldexp(1 + random.below(1 << 30), -31), std::ldexp(1 + random.below(1 << 30), -31)};
    const Uv_point side{double(random.below(1 << 30)), double(random.below(1 << 30))};
    const Uv_point off{double(random.below(3) - 1), double(random.below(3) - 1)};
    Uv_coordinates uv(3, 2);
    uv << corner, corner + std::ldexp(1, -53) * side,
        corner + std::ldexp(1, -53) * ((1 << random.below(10)) * side + (k % 3 == 0 ? 0 : 1) * off);
    const bool is_left_turn = is_left_turn_by_cgal(uv);
    left_turns += is_left_turn;
    flat += orientation(uv.row(0), uv.row(1), uv.row(2)) == 0;
    CHECK(is_counterclockwise(uv, {0, 1, 2}) == is_left_turn);
    CHECK(orientation(uv.row(0), uv.row(2), uv.row(1)) == -orientation(uv.row(0), uv.row(1), uv.row(2)));
  }
  CHECK(left_turns > TRIANGLES / 5);
  CHECK(flat > TRIANGLES / 5);
}

TEST_CASE("triangles of which two corners coincide are flat")
{
  Random_numbers random(4);
  for(int k = 0; k < 100; ++k) {
    const Uv_point p{random(0, 1), random(0, 1)}, q{random(0, 1e-3), random(0, 1e3)};
    CHECK(orientation(p, p, q) == 0);
    CHECK(orientation(p, q, p) == 0);
    CHECK(orientation(q, p, p) == 0);
  }
}

TEST_CASE("the area of triangles that are nearly flat is that of exact arithmetic")
{
  typedef CGAL::Exact_predicates_exact_constructions_kernel Kernel;
  Random_numbers random(2);
  int rounded_wrong = 0;
  for(double scale : {1., 1e-8, 1e8, 1e-140, 1e140})
    for(int k = 0; k < 300; ++k) {
      const Uv_coordinates uv = scale * nearly_flat_triangle(random);
      const auto point = [&uv](int v) { return Kernel::Point_2(uv(v, 0), uv(v, 1)); };
      const double expected = 2 * CGAL::to_double(CGAL::area(point(0), point(1), point(2)));
      CHECK(accurate_twice_area(uv.row(0), uv.row(1), uv.row(2)) == Approx(expected).epsilon(1e-11).margin(1e-300));
      rounded_wrong += std::abs(twice_uv_area(uv, {0, 1, 2}) - expected) > 1e-3 * std::abs(expected);
    }
  CHECK(rounded_wrong > 1000); // of 1500: what floating-point numbers make of such areas
}

TEST_CASE("a triangle with a coordinate that is not finite is not counter-clockwise")
{
  for(double bad : {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
    for(int place = 0; place < 6; ++place) {
      Uv_coordinates uv(3, 2);
      uv << 0, 0, 1, 0, 0, 1;
      uv(place / 2, place % 2) = bad;
      CHECK_FALSE(is_counterclockwise(uv, {0, 1, 2}));
    }
}
