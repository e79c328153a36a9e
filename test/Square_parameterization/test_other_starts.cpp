// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "make_patch_of.h"
#include "test_meshes.h"

#include <CGAL_ext/Square_parameterization/internal/pipeline/map_patch.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <variant>
#include <vector>

using namespace CGAL_ext;
using namespace CGAL_ext::internal;

TEST_CASE("a search without a map goes on where it has stopped for what maps cost, and work is left for one more")
{
  const Patch patch = make_patch_of(unit_square(4));
  Search_outcome outcome;
  outcome.report.candidates = 10;
  outcome.report.evaluations = 5;
  outcome.heeds_work = true;
  outcome.work = 0.8 * most_work_of_starts(patch.number_of_vertices());
  REQUIRE(would_go_on(patch, outcome));
  SECTION("no other candidates are left")
  {
    outcome.report.evaluations = 10;
  }
  SECTION("one more costs too much")
  {
    outcome.report.evaluations = 2;
  }
  SECTION("the strategy did not ask")
  {
    outcome.heeds_work = false;
  }
  SECTION("there is a map")
  {
    outcome.map.uv.setZero(patch.number_of_vertices(), 2);
  }
  CHECK_FALSE(would_go_on(patch, outcome));
}

TEST_CASE("another start that leads to the same poor map is the last")
{
  // any map of a strip that is a few million times as long as wide is stretched a thousand times
  const Patch patch = make_patch_of(rectangle(8, 8, 5e6, 1, 1));
  const Corners corners{0, 8, 16, 24};
  const Square_map_settings settings;
  const auto map_from = [&](const Map_minimizer& minimizer) { return map_with_corners(patch, minimizer, corners); };
  const auto first = make_minimizer(patch, settings.minimization);
  Search_outcome best = map_from(*first);
  REQUIRE(is_poor(best, Minimizer_numbers::HOPELESS_RESULT));
  const auto starts = other_starts(patch, std::get<Balanced_minimization>(settings.minimization), {});
  const Search_outcome second = map_from(*starts.front().make_minimizer());
  const double energy = best.map.report.objective, work = best.work + second.work;
  REQUIRE(do_agree(best, second));
  SECTION("the best map agrees with it")
  {
    try_other_starts(patch, *first, corners, settings, best);
    CHECK(best.work == work);
    CHECK(best.map.report.objective == (std::min)(energy, second.map.report.objective));
  }
  SECTION("the best map is another one")
  {
    best.map.report.objective *= 1.1;
    CHECK_FALSE(do_agree(best, second));
    try_other_starts(patch, *first, corners, settings, best);
    CHECK(best.work > work);
  }
  SECTION("two are tried whatever they cost")
  {
    best.map.report.objective *= 1.1;
    best.work = 2 * most_work_of_starts(patch.number_of_vertices());
    const double work_of_three = best.work + second.work + map_from(*starts[1].make_minimizer()).work;
    try_other_starts(patch, *first, corners, settings, best);
    CHECK(best.work == work_of_three);
  }
  SECTION("maps that are lost tell nothing")
  {
    Search_outcome lost = best;
    lost.map.report.objective = 1e10;
    CHECK_FALSE(do_agree(lost, lost));
  }
}

TEST_CASE("without a map all starts are tried, unless another cut may have one")
{
  const Patch patch = make_patch_of(fan_with_ears(2400, 3)); // one start is tried whatever it costs
  REQUIRE(least_other_starts(patch.number_of_vertices()) == 1);
  const auto is_ear = [&](int k) { // its tip is between places k and k + 2 of the border
    const auto first = patch.border.begin() + k, end = first + 3;
    return std::any_of(patch.triangles.begin(), patch.triangles.end(), [&](const std::array<int, 3>& t) {
      return std::all_of(t.begin(), t.end(), [&](int v) { return std::find(first, end, v) != end; });
    });
  };
  int ear = 0;
  while(!is_ear(ear))
    ++ear;
  const Corners corners{ear, ear + 2, ear + 3, ear + 4}; // on one side it is flat, from any start
  REQUIRE(corners[3] < static_cast<int>(patch.border.size()));
  const Square_map_settings settings;
  const auto first = make_minimizer(patch, settings.minimization);
  Search_outcome best = map_with_corners(patch, *first, corners);
  REQUIRE_FALSE(has_map(best));
  const auto try_others = [&](Persistence persistence) {
    return try_other_starts(patch, *first, corners, settings, best, persistence);
  };
  CHECK(try_others(Persistence::WITHIN_WORK).are_all); // they cost nothing
  best.work = 2 * most_work_of_starts(patch.number_of_vertices());
  CHECK_FALSE(try_others(Persistence::WITHIN_WORK).are_all);
  CHECK(try_others(Persistence::TO_THE_END).are_all);
  Square_map_report report;
  CHECK_THROWS_AS(map_patch(patch, *first, corners, settings, Persistence::WITHIN_WORK, report), Unmappable);
  CHECK_FALSE(has_map(best));
}

TEST_CASE("where starts are not cheap none is tried when it would cost too much")
{
  const Patch patch = make_patch_of(rectangle(51, 51, 5e6, 1, 1));
  const Corners corners{0, 51, 102, 153};
  const Square_map_settings settings;
  const auto first = make_minimizer(patch, settings.minimization);
  Search_outcome best = map_with_corners(patch, *first, corners);
  const auto starts = other_starts(patch, std::get<Balanced_minimization>(settings.minimization), {});
  const Search_outcome second = map_with_corners(patch, *starts.front().make_minimizer(), corners);
  best.map.report.objective *= 1.1;
  REQUIRE_FALSE(do_agree(best, second));
  REQUIRE(is_poor(second, Minimizer_numbers::HOPELESS_RESULT));
  const double most_work = most_work_of_starts(patch.number_of_vertices());
  best.work = most_work - 1.01 * second.work;
  const double work_of_two = best.work + second.work;
  REQUIRE(work_of_two < most_work);
  REQUIRE(1.5 * work_of_two > MOST_EXCESS_OF_STARTS * most_work);
  try_other_starts(patch, *first, corners, settings, best);
  CHECK(best.work == work_of_two);
}

TEST_CASE(
    "where starts cost little other weights come before small steps, more maps are poor, and two starts are tried")
{
  const auto first_start = [](int cells) {
    const Patch patch = make_patch_of(unit_square(cells));
    return other_starts(patch, {}, {}).front().start;
  };
  CHECK(first_start(49) == Map_start::UNIFORM_WEIGHTS); // 2500 vertices
  CHECK(first_start(50) == Map_start::GRADUAL_COARSENING);
  CHECK(least_poor_objective(2500) < least_poor_objective(2501));
  CHECK(least_other_starts(2500) == 2);
  CHECK(least_other_starts(2501) == 1);
}

TEST_CASE("weights that are chosen are not tried again, and blended ones are the first of the others")
{
  const Patch patch = make_patch_of(unit_square(4));
  Balanced_minimization chosen;
  const auto others = [&] {
    std::vector<Map_start> usual;
    for(const Other_weights& other : other_weights(chosen))
      usual.push_back(other.usual);
    const std::size_t n = usual.size();
    CHECK(other_starts(patch, chosen, {}).size() == n + (n + 1) + (n + 1));
    return usual;
  };
  CHECK(others() == std::vector<Map_start>{Map_start::UNIFORM_WEIGHTS, Map_start::MEAN_VALUE_WEIGHTS});
  chosen.start.weights = Uniform_weights();
  CHECK(others() == std::vector<Map_start>{Map_start::BLENDED_WEIGHTS, Map_start::MEAN_VALUE_WEIGHTS});
  chosen.start.weights = Mean_value_weights();
  CHECK(others() == std::vector<Map_start>{Map_start::BLENDED_WEIGHTS, Map_start::UNIFORM_WEIGHTS});
  chosen.start.weights = Harmonic_weights();
  CHECK(others() ==
        std::vector<Map_start>{Map_start::BLENDED_WEIGHTS, Map_start::UNIFORM_WEIGHTS, Map_start::MEAN_VALUE_WEIGHTS});
}

TEST_CASE("starts that share coarse patches lead to the maps to which each leads alone")
{
  // the border of a large strip is made coarse, too, which has no room for corners that are side by side
  const bool is_large = GENERATE(true, false);
  const Patch patch = make_patch_of(is_large ? long_strip(700) : noisy_height_field(12));
  const int quarter = static_cast<int>(patch.border.size()) / 4;
  const Corners corners = GENERATE_COPY(Corners{0, quarter, 2 * quarter, 3 * quarter}, Corners{0, 1, 2, 3});
  const auto first = make_minimizer(patch, Balanced_minimization());
  const std::vector<Other_start> sharing = other_starts(patch, {}, {}, first.get());
  bool has_whole_border = false;
  for(std::size_t i = 0; i < sharing.size(); ++i) {
    const Other_start alone = other_starts(patch, {}, {})[i];
    const Search_outcome a = map_with_corners(patch, *alone.make_minimizer(), corners);
    const Search_outcome b = map_with_corners(patch, *sharing[i].make_minimizer(), corners);
    CHECK(alone.start == sharing[i].start);
    REQUIRE(a.map.uv.rows() == patch.number_of_vertices());
    REQUIRE(b.map.uv.rows() == patch.number_of_vertices());
    CHECK(a.map.uv == b.map.uv);
    CHECK(a.work == b.work);
    has_whole_border = has_whole_border || (a.map.warm_start.rows() == 0 && b.map.warm_start.rows() == 0);
  }
  CHECK(has_whole_border == (is_large && corners[3] == 3)); // only these are mapped by patches with the whole border
}

TEST_CASE("a border that is fixed first slides in the end, to the map of the usual start")
{
  const Patch patch = make_patch_of(noisy_height_field(12));
  const Corners corners{0, 12, 24, 36};
  const Square_map_settings settings;
  const auto starts = other_starts(patch, std::get<Balanced_minimization>(settings.minimization), {});
  const auto fixed_first = std::find_if(starts.begin(), starts.end(), [](const Other_start& other) {
    return other.start == Map_start::FIXED_BORDER_FIRST;
  });
  REQUIRE(fixed_first != starts.end());
  Search_outcome outcome = map_with_corners(patch, *fixed_first->make_minimizer(), corners);
  const Uv_coordinates fixed = square_border(Border_walk(patch.border_lengths, Walk::COUNTER_CLOCKWISE), corners).uv;
  const auto is_fixed = [&](const Uv_coordinates& uv) {
    for(std::size_t k = 0; k < patch.border.size(); ++k)
      if(uv.row(patch.border[k]) != fixed.row(static_cast<Eigen::Index>(k)))
        return false;
    return true;
  };
  REQUIRE(is_fixed(outcome.map.uv));
  const auto usual = make_minimizer(patch, settings.minimization);
  finish_map(*usual, nullptr, outcome);
  CHECK_FALSE(is_fixed(outcome.map.uv));
  Search_outcome usual_outcome = map_with_corners(patch, *usual, corners);
  finish_map(*usual, nullptr, usual_outcome);
  CHECK(outcome.map.report.objective == Approx(usual_outcome.map.report.objective).epsilon(1e-5));
}
