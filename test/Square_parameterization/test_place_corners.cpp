// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL_ext/Square_parameterization/internal/border/place_corners.h>

#include <catch2/catch.hpp>

#include <random>

using namespace CGAL_ext::internal;

namespace {

/// the shortest of the four sides, by walking along the border
double shortest_side(const std::vector<double>& lengths, const Corners& corners)
{
  double shortest = std::numeric_limits<double>::infinity();
  for(int k = 0; k < 4; ++k) {
    double side = 0;
    for(int i = corners[k]; i != corners[(k + 1) % 4]; i = (i + 1) % static_cast<int>(lengths.size()))
      side += lengths[i];
    shortest = (std::min)(shortest, side);
  }
  return shortest;
}

} // namespace

TEST_CASE("of all places for four corners those in order with the longest shortest side are taken")
{
  std::mt19937 generator(7);
  const auto random = [&generator](int n) { return static_cast<int>(generator() % n); };
  int placed = 0;
  for(int trial = 0; trial < 400; ++trial) {
    std::vector<double> lengths(4 + random(6));
    for(double& length : lengths)
      length = 1 + random(4);
    const int n = static_cast<int>(lengths.size());
    std::array<std::vector<int>, 4> places;
    for(auto& of_corner : places)
      for(int i = 1 + random(3); i > 0; --i)
        of_corner.push_back(random(n));

    double longest = 0; // by brute force
    for(int a : places[0])
      for(int b : places[1])
        for(int c : places[2])
          for(int d : places[3])
            if(are_corners_in_order({a, b, c, d}, n))
              longest = (std::max)(longest, shortest_side(lengths, {a, b, c, d}));
    const std::optional<Corners> corners = place_corners(lengths, places);
    REQUIRE(corners.has_value() == (longest > 0));
    if(!corners)
      continue;
    ++placed;
    CHECK(are_corners_in_order(*corners, n));
    CHECK(shortest_side(lengths, *corners) == longest);
    for(int k = 0; k < 4; ++k)
      CHECK(std::count(places[k].begin(), places[k].end(), (*corners)[k]) > 0);
  }
  CHECK(placed > 100);
  CHECK(placed < 300);
}

TEST_CASE("a vertex with hundreds of copies may be all four corners")
{
  const int n = 400;
  std::vector<int> everywhere(n);
  std::iota(everywhere.begin(), everywhere.end(), 0);
  const auto corners = place_corners(std::vector<double>(n, 1.), {everywhere, everywhere, everywhere, everywhere});
  REQUIRE(corners.has_value());
  CHECK(*corners == Corners{0, 100, 200, 300});
}
