// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "test_meshes.h"

#include <CGAL_ext/Square_parameterization/internal/border/border_curves.h>

#include <catch2/catch.hpp>

using namespace CGAL_ext::internal;
using CGAL_ext::Corner_rule;
using CGAL_ext::Walk;

namespace {

typedef std::vector<double> Lengths;

Corners corners_of(const Lengths& lengths, int candidate, Corner_rule rule)
{
  return corners_of_candidate(Border_walk(lengths, Walk::COUNTER_CLOCKWISE), candidate, rule);
}

Square_border border_of(const Lengths& lengths, int candidate, Corner_rule rule, Walk walk = Walk::COUNTER_CLOCKWISE)
{
  const Border_walk border_walk(lengths, walk);
  return square_border(border_walk, corners_of_candidate(border_walk, candidate, rule));
}

/// arc length on the unit square from (0, 0) counter-clockwise, in [0, 4[; -1 for a point that is not on the square
double position_on_square(double u, double v)
{
  if(v == 0 && u >= 0 && u < 1)
    return u;
  if(u == 1 && v >= 0 && v < 1)
    return 1 + v;
  if(v == 1 && u > 0 && u <= 1)
    return 2 + (1 - u);
  if(u == 0 && v > 0 && v <= 1)
    return 3 + (1 - v);
  return -1;
}

/// as above, in the resolution that a side has on its own: the side and the offset along it from its end of smaller uv
bool comes_before(const Eigen::RowVector2d& p, const Eigen::RowVector2d& q)
{
  const int side_p = static_cast<int>(position_on_square(p.x(), p.y())),
            side_q = static_cast<int>(position_on_square(q.x(), q.y()));
  if(side_p != side_q)
    return side_p < side_q;
  const int axis = side_p % 2;
  return side_p < 2 ? p[axis] < q[axis] : p[axis] > q[axis];
}

void check_square_border(const Lengths& lengths, int candidate, Corner_rule rule)
{
  const int n = static_cast<int>(lengths.size());
  const Square_border border = border_of(lengths, candidate, rule);
  CAPTURE(n, candidate, static_cast<int>(rule));

  REQUIRE(border.corners[0] == candidate);
  REQUIRE(are_corners_in_order(border.corners, n));
  for(int side = 0; side < 4; ++side) {
    const auto corner = border.uv.row(border.corners[side]);
    CHECK(position_on_square(corner.x(), corner.y()) == side);
  }
  for(int i = 0; i < n; ++i) {
    const auto p = border.uv.row((candidate + i) % n);
    REQUIRE(position_on_square(p.x(), p.y()) >= 0);
    if(i + 1 < n)
      REQUIRE(comes_before(p, border.uv.row((candidate + i + 1) % n)));
  }
}

void check_every_start(const Lengths& lengths)
{
  for(int candidate = 0; candidate < static_cast<int>(lengths.size()); ++candidate)
    for(Corner_rule rule : {Corner_rule::AUTHOR, Corner_rule::NEAREST})
      check_square_border(lengths, candidate, rule);
}

Lengths random_lengths(Random_numbers& random, int n, double decades)
{
  Lengths lengths;
  for(int k = 0; k < n; ++k)
    lengths.push_back(std::pow(10, random(-decades, 0)));
  return lengths;
}

} // namespace

TEST_CASE("the corner rules close sides where a hand would")
{
  const Lengths lengths{1.5, 0.8, 0.9, 0.8, 1, 1, 1, 1}; // a quarter is 2, 1.1 quarters are 2.2
  // 1.5 | 2.3 is too long; 0.8 1.7 | 2.5 is too long; 0.8 1.8 | 2.8 is too long; the rest
  CHECK(corners_of(lengths, 0, Corner_rule::AUTHOR) == Corners{0, 1, 3, 5});
  // 2.3 is nearer to 2 than 1.5; 4; 6
  CHECK(corners_of(lengths, 0, Corner_rule::NEAREST) == Corners{0, 2, 4, 6});
  // 1 2 |; 1 2 |; 1.5 | 2.3 is too long
  CHECK(corners_of(lengths, 4, Corner_rule::AUTHOR) == Corners{4, 6, 0, 1});
  // 2; 4; 5.5 and 6.3: 6.3 is nearer to 6
  CHECK(corners_of(lengths, 4, Corner_rule::NEAREST) == Corners{4, 6, 0, 2});

  const Lengths just_over{1.5, 0.6, 0.4, 1.5, 0.9, 1.15, 0.95, 1};
  // 2.1 is accepted; 1.9 | 2.8 is too long; 2.05 is accepted
  CHECK(corners_of(just_over, 0, Corner_rule::AUTHOR) == Corners{0, 2, 4, 6});

  const Lengths long_edge{3, 1, 1, 1, 1, 1}; // a side takes its first edge however long it is
  CHECK(corners_of(long_edge, 0, Corner_rule::AUTHOR) == Corners{0, 1, 3, 5});
  CHECK(corners_of(long_edge, 0, Corner_rule::NEAREST) == Corners{0, 1, 2, 4});
}

TEST_CASE("a regular border has its corners a quarter apart")
{
  const Lengths lengths(20, 0.05);
  const auto rule = GENERATE(Corner_rule::AUTHOR, Corner_rule::NEAREST);
  for(int candidate = 0; candidate < 20; ++candidate)
    CHECK(corners_of(lengths, candidate, rule) ==
          Corners{candidate, (candidate + 5) % 20, (candidate + 10) % 20, (candidate + 15) % 20});
}

TEST_CASE("the nearest rule finds the nearest vertices, by brute force")
{
  Random_numbers random(21);
  for(int trial = 0; trial < 200; ++trial) {
    const Lengths lengths = random_lengths(random, 30 + random.below(40), 0.5); // short edges: no side can be empty
    const int n = static_cast<int>(lengths.size()), candidate = random.below(n);
    const double quarter = Border_walk(lengths, Walk::COUNTER_CLOCKWISE).total_length() / 4;
    Corners expected{candidate, 0, 0, 0};
    for(int side = 1; side < 4; ++side) {
      double length = 0, nearest = 1e9;
      for(int i = 0; i < n; ++i) {
        if(std::abs(length - side * quarter) < nearest) {
          nearest = std::abs(length - side * quarter);
          expected[side] = (candidate + i) % n;
        }
        length += lengths[(candidate + i) % n];
      }
    }
    CHECK(corners_of(lengths, candidate, Corner_rule::NEAREST) == expected);
  }
}

TEST_CASE("a side of the author rule ends at a quarter, or before an edge that leads past 1.1 quarters")
{
  Random_numbers random(22);
  for(int trial = 0; trial < 200; ++trial) {
    const Lengths lengths = random_lengths(random, 30 + random.below(40), 0.5);
    const int n = static_cast<int>(lengths.size()), candidate = random.below(n);
    const double quarter = Border_walk(lengths, Walk::COUNTER_CLOCKWISE).total_length() / 4;
    const Corners corners = corners_of(lengths, candidate, Corner_rule::AUTHOR);
    for(int side = 0; side < 3; ++side) {
      double length = 0, last = 0;
      for(int i = corners[side]; i != corners[side + 1]; i = (i + 1) % n)
        length += last = lengths[i];
      const double next = lengths[corners[side + 1]];
      CHECK(length < 1.1 * quarter);
      CHECK(length - last < quarter);
      CHECK((length >= quarter || length + next >= 1.1 * quarter));
    }
  }
}

TEST_CASE("every border lies on the square, in order, with four distinct corners")
{
  SECTION("edge lengths 3, 3, 1, 1")
  {
    check_every_start({3, 3, 1, 1});
  }
  SECTION("almost all of the border in two edges")
  {
    check_every_start({.499, .002, .003, .002, .002, .491});
  }
  SECTION("one edge is almost all of the border")
  {
    check_every_start({1e-9, 1, 1e-9, 1e-9, 1e-9, 1e-9, 1e-9});
  }
  SECTION("edge lengths over twelve orders of magnitude")
  {
    Random_numbers random(23);
    for(int trial = 0; trial < 300; ++trial)
      check_every_start(random_lengths(random, 4 + random.below(12), 12));
  }
}

TEST_CASE("positions on a side are the running length over the length of the side")
{
  const Lengths lengths{1.5, 0.8, 0.9, 0.8, 1, 1, 1, 1};
  const Uv_coordinates uv = border_of(lengths, 0, Corner_rule::AUTHOR).uv; // corners 0, 1, 3, 5
  Uv_coordinates expected(8, 2);
  expected << 0, 0, 1, 0, 1, 0.8 / 1.7, 1, 1, 1 - 0.8 / 1.8, 1, 0, 1, 0, 1 - 1 / 3., 0, 1 - 2 / 3.;
  CHECK((uv - expected).cwiseAbs().maxCoeff() < 1e-15);
}

TEST_CASE("a clockwise walk is a counter-clockwise walk of the reversed border, and is not mirrored")
{
  Random_numbers random(24);
  for(int trial = 0; trial < 100; ++trial) {
    const Lengths lengths = random_lengths(random, 5 + random.below(30), 2);
    const int n = static_cast<int>(lengths.size()), candidate = random.below(n);
    const Lengths reversed(lengths.rbegin(), lengths.rend());
    const auto rule = trial % 2 == 0 ? Corner_rule::AUTHOR : Corner_rule::NEAREST;
    const Square_border border = border_of(lengths, candidate, rule, Walk::CLOCKWISE),
                        mirrored = border_of(reversed, candidate, rule);
    double twice_area = 0;
    for(int k = 0; k < n; ++k) {
      const auto p = border.uv.row(k), q = border.uv.row((k + 1) % n), r = mirrored.uv.row((n - k) % n);
      CHECK(p.x() == r.y());
      CHECK(p.y() == r.x());
      twice_area += p.x() * q.y() - p.y() * q.x();
    }
    CHECK(twice_area > 0);
    CHECK(are_corners_in_order(border.corners, n));
    CHECK(border.corners[0] == (n - candidate) % n);
    CHECK(border.uv.row(border.corners[1]) == Eigen::RowVector2d(1, 0));
    CHECK(border.uv.row(border.corners[3]) == Eigen::RowVector2d(0, 1));
  }
}

TEST_CASE("the quarter holds the vertices nearer to the start than a quarter of the border")
{
  const auto count = [](const Lengths& lengths, Walk walk) {
    return number_of_quarter_candidates(Border_walk(lengths, walk));
  };
  CHECK(count(Lengths(8, 1.), Walk::COUNTER_CLOCKWISE) == 2); // at 0 and 1, not at 2
  CHECK(count(Lengths(9, 1.), Walk::COUNTER_CLOCKWISE) == 3); // at 0, 1 and 2, below 2.25
  CHECK(count({3, 3, 1, 1}, Walk::COUNTER_CLOCKWISE) == 1);
  CHECK(count({3, 3, 1, 1}, Walk::CLOCKWISE) == 2); // at 0 and 1, not at 2
  CHECK(count({0.5, 0.5, 0.5, 3, 2, 1.5}, Walk::COUNTER_CLOCKWISE) == 4);
  CHECK(count({0.5, 0.5, 0.5, 3, 2, 1.5}, Walk::CLOCKWISE) == 2);
}

TEST_CASE("four positions in order on one round of the border are told from others")
{
  CHECK(are_corners_in_order({0, 1, 2, 3}, 4));
  CHECK(are_corners_in_order({7, 9, 0, 3}, 10));
  CHECK_FALSE(are_corners_in_order({0, 2, 1, 3}, 4));
  CHECK_FALSE(are_corners_in_order({0, 3, 2, 1}, 4));
  CHECK_FALSE(are_corners_in_order({5, 5, 6, 7}, 10));
  CHECK_FALSE(are_corners_in_order({5, 6, 7, 5}, 10));
  CHECK_FALSE(are_corners_in_order({5, 7, 7, 8}, 10));
}

TEST_CASE("the circle border is counter-clockwise by arc length")
{
  const Lengths lengths{4, 0.5, 2, 1, 0.25, 0.25}; // 8 in all, no two angles alike but the last
  const double radius = GENERATE(1., 0.3, 1e4);
  const Uv_coordinates uv = circular_border(lengths, radius);
  CHECK(uv(0, 0) == radius);
  CHECK(uv(0, 1) == 0);
  for(int k = 0; k < 6; ++k) {
    CHECK(uv.row(k).norm() == Approx(radius).epsilon(1e-15));
    // the angle between two vertices is that of the edge between them, not of an edge beside it
    const auto p = uv.row(k), q = uv.row((k + 1) % 6);
    double angle = std::atan2(p.x() * q.y() - p.y() * q.x(), p.dot(q));
    if(angle < -1e-9)
      angle += 2 * PI;
    CHECK(std::abs(angle) == Approx(2 * PI * lengths[k] / 8).epsilon(1e-12));
  }
}
