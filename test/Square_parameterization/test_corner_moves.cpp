// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "On_threads.h"
#include "closed_meshes.h"
#include "mapped_patches.h"
#include "test_meshes.h"

#include <CGAL_ext/Square_parameterization/Bracketing_corner_search.h>
#include <CGAL_ext/Square_parameterization/internal/cut/Cut_pool.h>
#include <CGAL_ext/Square_parameterization/internal/cut/rerouted_initial_cuts.h>
#include <CGAL_ext/Square_parameterization/internal/cut/score_cut.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/make_minimizer.h>
#include <CGAL_ext/Square_parameterization/internal/search/Corner_evaluation.h>
#include <CGAL_ext/Square_parameterization/internal/search/Corner_moves.h>
#include <CGAL_ext/Square_parameterization/internal/search/Free_corners.h>
#include <CGAL_ext/Square_parameterization/internal/search/rough_corner_search.h>
#include <CGAL_ext/Square_parameterization/internal/search/search_work.h>
#include <CGAL_ext/Square_parameterization/internal/search/square_search.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <set>
#include <vector>

using namespace CGAL_ext;
using namespace CGAL_ext::internal;

TEST_CASE("corners that move find what brute force over all four corners finds, on 9 of 10 surfaces")
{
  int found = 0;
  const bool is_square = GENERATE(true, false);
  for(unsigned int seed = 0; seed < 10; ++seed) {
    const Patch patch = make_patch_of(seed % 2 == 0 ? rectangle(6, 4, 2.5, 1, seed) : noisy_height_field(5, seed));
    REQUIRE(patch.border.size() == 20);
    Balanced_minimization minimization;
    if(!is_square)
      minimization.aspect.reset();
    const auto minimizer = make_minimizer(patch, minimization);
    Corner_evaluation all([&] { return Map_minimizer::without_limit(minimizer->make_worker()); }, patch, nullptr,
                          [] { return true; });
    std::vector<Corners> choices;
    for(int a = 0; a < 20; ++a)
      for(int b = a + 1; b < 20; ++b)
        for(int c = b + 1; c < 20; ++c)
          for(int d = c + 1; d < 20; ++d)
            choices.push_back({a, b, c, d});
    const On_threads all_cores(0);
    all(choices);
    Square_search_options options;
    options.moves_corners = true;
    const double energy =
        search_square_map(patch, *minimizer, Bracketing_corner_search(), options).map.report.objective;
    found += energy <= 1.001 * all.best_map().report.objective;
  }
  CHECK(found >= 9);
}

TEST_CASE("corners move on for a gain of twenty millionths, and do not creep along the border for two")
{
  const Corners start{0, 25, 50, 75};
  const auto end_at_gain = [&start](double gain) { // which each vertex that the first corner moves on has
    Corner_moves moves(std::vector<double>(100, 1.), [gain](const std::vector<Corners>& choices, const Corner_choice*) {
      std::vector<double> objectives;
      for(const Corners& corners : choices)
        objectives.push_back(1 + gain * (std::min)(std::abs(corners[0] - 20), 120 - corners[0])); // a ring of 100
      return objectives;
    });
    return moves.descend(start, 1, Corner_moves::ALL).corners;
  };
  CHECK(end_at_gain(2e-6) == start);
  CHECK(end_at_gain(2e-5)[0] == 20);
}

TEST_CASE("corners are moved by small steps where large ones tell of a lower place between, or nothing")
{
  struct Result
  {
    int first_corner;
    std::size_t evaluations;
  };
  // the lowest place is five vertices from the start
  const auto move = [](const auto& objective_of, const auto& rougher) {
    const auto moves_at = [](const auto& of_distance) {
      return Corner_moves(std::vector<double>(4000, 1.),
                          [of_distance](const std::vector<Corners>& choices, const Corner_choice*) {
                            std::vector<double> objectives;
                            for(const Corners& corners : choices)
                              objectives.push_back(of_distance(std::abs(corners[0] - 505.)));
                            return objectives;
                          });
    };
    Corner_moves fine = moves_at(objective_of), rough = moves_at(rougher);
    const Corners end = fine.descend_where_likely({500, 1500, 2500, 3500}, 128, rough).corners;
    return Result{end[0], fine.evaluations()};
  };
  const auto square = [](double factor) {
    return [factor](double distance) { return 1 + factor * distance * distance; };
  };
  const auto nearby = [](double distance) {
    return distance < 30 ? 1 + 1e-4 * distance * distance : std::numeric_limits<double>::infinity();
  };
  // with the second rough objective large steps rise too much, and are not tried
  CHECK(std::abs(move(square(1e-6), square(1e-9)).first_corner - 505) <= 3); // from there a move gains 9e-6 at most
  CHECK(std::abs(move(square(1e-6), square(1e-6)).first_corner - 505) <= 3);
  CHECK(move(nearby, nearby).first_corner == 505);

  const std::size_t once = 1 + Corner_moves::number_of_moves(); // the start, and each move
  for(double factor : {0., 1e-9, -1e-10})
    CHECK(move(square(factor), square(factor)).evaluations <= once);
}

TEST_CASE("corners move by at least as many vertices as an edge of the coarse border stands for")
{
  const Patch patch = make_patch_of(long_strip(2000));
  const auto minimizer = make_minimizer(patch, Balanced_minimization());
  Corner_evaluation maps(*minimizer, Coarse_maps::ROUGH, patch, nullptr, [] { return true; });
  const int step = maps.least_step();
  REQUIRE(step >= 8);
  const Corners corners{100, 1100, 2100, 3100};
  const double objective = maps({corners})[0];
  const auto is_the_same = [&](int first) { // by the map of its own for the first corner
    return maps({{first, 1100, 2100, 3100}})[0] == Approx(objective).epsilon(1e-9);
  };
  CHECK(is_the_same(101));
  CHECK_FALSE(is_the_same(100 + 3 * step));

  const int size = 4000, least_step = 10;
  for(const auto effort : {Corner_moves::ALL, Corner_moves::LIKELY}) {
    std::set<int> steps; // of the first corner from where it was
    const auto distances = [&](const std::vector<Corners>& choices, const Corner_choice* near) {
      std::vector<double> objectives;
      for(const Corners& choice : choices) {
        if(near != nullptr)
          steps.insert(std::abs(choice[0] - near->corners[0]));
        objectives.push_back(1 + 1e-6 * std::pow(choice[0] - 777., 2));
      }
      return objectives;
    };
    Corner_moves moves(std::vector<double>(size, 1.), distances, {}, least_step);
    const Corners end = moves.descend({500, 1500, 2500, 3500}, 512, effort).corners;
    CHECK(std::abs(end[0] - 777) <= 16);
    steps.erase(0);
    CHECK(*steps.begin() == 16); // 512, halved
    const std::size_t evaluations = moves.evaluations();
    moves.compare({{end[0], end[1], end[2] + 16, end[3]}, {end[0], end[1] - 16, end[2], end[3]}});
    CHECK(moves.evaluations() == evaluations); // all moves are tried at last

    Corner_moves rough(std::vector<double>(size, 1.), distances, {}, least_step);
    for(int first_step : {1, 512})
      CHECK(std::abs(moves.descend_where_likely({760, 1500, 2500, 3500}, first_step, rough).corners[0] - 777) <= 10);
  }
}

TEST_CASE("rough maps are made of a patch that gets no coarser than a hundred handles let it")
{
  const Triangle_surface plate = surface_of(plate_with_handles(10, 10));
  Thread_team team(1);
  const Patch patch = patch_of_cut(plate, shortest_cut(plate, team));
  const auto minimizer = make_minimizer(patch, Balanced_minimization());
  const auto map_for = minimizer->make_comparing_worker(Coarse_maps::ROUGH);
  for(const Uv_coordinates& border_uv : spread_borders(patch, 4))
    CHECK(map_for(border_uv, nullptr, std::numeric_limits<double>::infinity()).report.objective > 0);
}

TEST_CASE("corners do not move where rough maps are maps of the patch itself, and its map has cost too much")
{
  const auto is_too_costly = [](const Patch& patch, double share_of_most) {
    const auto minimizer = make_minimizer(patch, Balanced_minimization());
    const Free_corners corners(
        patch, *minimizer, nullptr, [] { return true; }, [] { return true; });
    Minimized_map map;
    map.work = static_cast<long>(share_of_most * most_moving_work(true, patch.number_of_vertices()));
    return corners.is_too_costly(map);
  };
  const Patch small = make_patch_of(noisy_height_field(8)), large = make_patch_of(noisy_height_field(40));
  CHECK(is_too_costly(small, 1.1)); // its rough maps are maps of the patch itself
  CHECK_FALSE(is_too_costly(small, 0.9));
  CHECK_FALSE(is_too_costly(large, 1.1));
}

TEST_CASE("a developable strip is mapped without stretch onto its rectangle")
{
  for(double aspect : {1., 2.5, 10., 100.}) {
    const int columns = aspect > 5 ? 60 : 16;
    const Patch patch = make_patch_of(rectangle(columns, aspect > 20 ? 4 : 6, aspect, 1, 5));
    Balanced_minimization minimization;
    minimization.aspect.reset();
    Square_search_options options;
    options.moves_corners = true;
    const Search_outcome outcome =
        search_square_map(patch, *make_minimizer(patch, minimization), Bracketing_corner_search(), options);
    CAPTURE(aspect);
    CHECK(outcome.map.report.objective == Approx(2.6).margin(1e-4));
    CHECK((std::max)(outcome.map.aspect, 1 / outcome.map.aspect) == Approx(aspect).epsilon(0.01));
  }
}

TEST_CASE("corners that move are never worse than those of the quarters, and do not depend on the threads")
{
  for(unsigned int seed : {1u, 2u}) {
    const Patch patch = make_patch_of(noisy_height_field(12, seed));
    const auto minimizer = make_minimizer(patch, Balanced_minimization());
    struct Move_counter : Search_visitor
    {
      void after_corner_move() override { ++moves; }
      void start_minimization() override { moves_before_end = moves; }
      std::size_t moves = 0, moves_before_end = 0;
    } visitor;
    Square_search_options options;
    options.number_of_threads = 1;
    options.visitor = &visitor;
    options.moves_corners = true;
    const Search_outcome moved = search_square_map(patch, *minimizer, Bracketing_corner_search(), options);
    CHECK(visitor.moves >= moved.report.corner_moves); // the best are mapped in full as well
    CHECK(visitor.moves == visitor.moves_before_end);
    options.visitor = nullptr;
    options.number_of_threads = 3;
    CHECK(search_square_map(patch, *minimizer, Bracketing_corner_search(), options).map.uv == moved.map.uv);
    CHECK(moved.report.corner_moves > 0);
    options.moves_corners = false;
    const Search_outcome quarters = search_square_map(patch, *minimizer, Bracketing_corner_search(), options);
    CHECK(moved.map.report.objective <= quarters.map.report.objective * (1 + 1e-6));
    CHECK(quarters.report.corner_moves == 0);
  }
}

TEST_CASE("a search on rough maps alone finds what brute force finds where these are maps of the patch itself")
{
  for(unsigned int seed : {1u, 2u, 3u}) {
    const Patch patch = make_patch_of(noisy_height_field(12, seed));
    REQUIRE(patch.number_of_vertices() < 300);
    const auto minimizer = make_minimizer(patch, Balanced_minimization());
    Square_search_options options;
    options.moves_corners = false;
    const Search_outcome quarter = search_square_map(patch, *minimizer, Quarter_brute_force_corner_search(), options);
    REQUIRE(quarter.report.candidates <= 16);
    const double best_candidate = quarter.map.report.objective;
    CHECK(search_corners_roughly(patch, *minimizer, false, {}).report.objective ==
          Approx(best_candidate).epsilon(1e-4));
    const double moved = search_corners_roughly(patch, *minimizer, true, {}).report.objective;
    CHECK(moved <= best_candidate * (1 + 1e-4));
    options.moves_corners = true;
    CHECK(moved ==
          Approx(search_square_map(patch, *minimizer, Bracketing_corner_search(), options).map.report.objective)
              .epsilon(5e-3));
  }
}

TEST_CASE("corners that move on a coarse patch first come to rest where they do on the patch of a few hundred vertices "
          "itself")
{
  for(unsigned int seed : {1u, 2u, 3u}) {
    const Patch patch = make_patch_of(noisy_height_field(16, seed));
    REQUIRE(Minimizer_numbers::moves_corners_twice(patch.number_of_vertices(), int(patch.border.size())));
    REQUIRE(patch.number_of_vertices() <= Minimizer_numbers::LARGEST_ROUGH);
    const auto minimizer = make_minimizer(patch, Balanced_minimization());
    CHECK(&minimizer->coarse_patch(Coarse_maps::ROUGH) == &patch);
    CHECK(minimizer->coarse_patch(Coarse_maps::FIRST_MOVES).number_of_vertices() < patch.number_of_vertices());
    Square_search_options options;
    options.moves_corners = true;
    const double twice = search_square_map(patch, *minimizer, Bracketing_corner_search(), options).map.report.objective;
    CHECK(twice <= 1.001 * search_corners_roughly(patch, *minimizer, true, {}).report.objective);
  }
}

TEST_CASE("a search on rough maps ends without a map when its time is over")
{
  const Patch patch = make_patch_of(noisy_height_field(12, 1));
  const auto minimizer = make_minimizer(patch, Balanced_minimization());
  CHECK(search_corners_roughly(patch, *minimizer, true, std::chrono::steady_clock::now()).uv.rows() == 0);
}

TEST_CASE("corners move from the best rough map, too, where that lies in another valley than the best candidate")
{
  Thread_team team(1);
  const Triangle_surface surface = surface_of(torus(32, 14));
  Cut cut = rerouted_initial_cuts(surface, {}, team).front();
  for(int terminal : {196, 60, 266})
    extend_cut(surface, terminal, cut);
  const Patch patch = patch_of_cut(surface, cut);
  const auto minimizer = make_minimizer(patch, Balanced_minimization());
  Square_search_options options;
  options.moves_corners = false;
  const double quarter = search_square_map(patch, *minimizer, Bracketing_corner_search(), options).map.report.objective;
  options.moves_corners = true;
  const double moved = search_square_map(patch, *minimizer, Bracketing_corner_search(), options).map.report.objective;
  CHECK(moved < 0.97 * quarter); // 0.98 in the valley of the best candidate, 0.96 in the other
  CHECK(moved <= 1.001 * search_corners_roughly(patch, *minimizer, true, {}).report.objective);
}
