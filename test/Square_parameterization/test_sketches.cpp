// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Thread_watcher.h"
#include "closed_meshes.h"
#include "mapped_patches.h"
#include "search_curve.h"

#include <CGAL_ext/Square_parameterization/Balanced_minimization.h>
#include <CGAL_ext/Square_parameterization/Bracketing_corner_search.h>
#include <CGAL_ext/Square_parameterization/corner_searches.h>
#include <CGAL_ext/Square_parameterization/internal/cut/rerouted_initial_cuts.h>
#include <CGAL_ext/Square_parameterization/internal/cut/score_cut.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/make_minimizer.h>
#include <CGAL_ext/Square_parameterization/internal/search/square_search.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <set>

using namespace CGAL_ext;
using namespace CGAL_ext::internal;

namespace {

Search_conditions with_sketches(Stretch_curve sketched_stretch)
{
  Search_conditions conditions;
  conditions.sketched_stretch = std::move(sketched_stretch);
  return conditions;
}

/// patches that are large enough for sketches
std::vector<Patch> large_patches()
{
  return {make_patch_of(saddle(92)), make_patch_of(noisy_height_field(92))};
}

} // namespace

TEST_CASE("bracketing settles for the best sketch")
{
  const Search_report report =
      search_curve(valley(200, 78), Bracketing_corner_search(), with_sketches(valley(200, 75)));
  CHECK(evaluated(report) == std::set<int>{75});
}

TEST_CASE("the best sketch is found among few candidates")
{
  for(int n : {1, 2, 3, 5, 31, 32, 33, 100, 1000, 20000})
    for(int bottom = 0; bottom < n; bottom += 1 + n / 40) {
      INFO(n << " candidates, bottom " << bottom);
      const Stretch_curve curve = valley(n, bottom);
      const Search_report report = search_curve(curve, Bracketing_corner_search(), with_sketches(curve));
      CHECK(report.best_candidate == bottom);
      CHECK(report.evaluations == 1);
      CHECK(double(report.sketches) <= 32 * (1 + std::log(double(n)) / std::log(16)));
    }
}

TEST_CASE("where there is no sketch bracketing does without")
{
  const Stretch_curve curve = valley(200, 78);
  const std::set<int> without = evaluated(search_curve(curve, Bracketing_corner_search()));
  const Stretch_curve none(200, INFEASIBLE);
  CHECK(evaluated(search_curve(curve, Bracketing_corner_search(), with_sketches(none))) == without);
}

TEST_CASE("sketches of large patches tell their borders apart as their maps do")
{
  for(const Patch& patch : large_patches()) {
    const auto minimizer = make_minimizer(patch, Balanced_minimization());
    REQUIRE(minimizer->has_sketches());
    const auto map_for = minimizer->make_worker();
    const auto sketch_for = minimizer->make_comparing_worker(Coarse_maps::SKETCHES);
    Stretch_curve energies, sketched;
    for(const Uv_coordinates& border_uv : spread_borders(patch, 6)) {
      energies.push_back(map_for(border_uv, nullptr).report.objective);
      const Minimized_map sketch = sketch_for(border_uv, nullptr, std::numeric_limits<double>::infinity());
      CHECK(sketch.uv.rows() == 0);
      sketched.push_back(sketch.report.objective);
    }
    REQUIRE(energies.size() == 6);
    for(int i = 0; i < 6; ++i)
      for(int j = 0; j < 6; ++j)
        if(energies[i] < 0.995 * energies[j])
          CHECK(sketched[i] < sketched[j]);
    const auto spread = std::minmax_element(energies.begin(), energies.end());
    CHECK(*spread.second > 1.02 * *spread.first); // there is something to tell apart
  }
}

TEST_CASE("sketches that start from that of a neighbor are as low, and given up only where they stay above the limit, "
          "within a percent")
{
  for(const Patch& patch : large_patches()) {
    const auto minimizer = make_minimizer(patch, Balanced_minimization());
    const auto sketch_for = minimizer->make_comparing_worker(Coarse_maps::SKETCHES);
    const std::vector<Uv_coordinates> borders = spread_borders(patch, static_cast<int>(patch.border.size()) / 4);
    const double none = std::numeric_limits<double>::infinity();
    for(std::size_t i = 0; i + 4 < borders.size(); i += 8) {
      const Minimized_map first = sketch_for(borders[i], nullptr, none);
      REQUIRE(first.warm_start.rows() > 0);
      for(std::size_t j : {i, i + 1, i + 4}) {
        const double cold = sketch_for(borders[j], nullptr, none).report.objective;
        const double warm = sketch_for(borders[j], &first.warm_start, none).report.objective;
        CHECK(std::abs(warm - cold) < 1e-3 * cold);
        for(double limit : {0.9 * warm, 0.99 * warm, 0.999 * warm})
          CHECK(sketch_for(borders[j], &first.warm_start, limit).report.objective >= limit);
        CHECK(sketch_for(borders[j], &first.warm_start, 1.01 * warm).report.objective < 1.01 * warm);
      }
    }
  }
}

TEST_CASE("no sketch of a plate of many holes is lost on the way from coarse to fine")
{
  for(int period : {4, 5}) {
    const Triangle_surface plate =
        surface_of(voxels(82, 82, 1, [period](int x, int y, int) { return x % period < 2 || y % period < 2; }));
    Thread_team team(1);
    const Patch patch = patch_of_cut(plate, shortest_cut(plate, team));
    const auto minimizer = make_minimizer(patch, Balanced_minimization());
    REQUIRE(minimizer->has_sketches());
    const auto sketch_for = minimizer->make_comparing_worker(Coarse_maps::SKETCHES);
    Stretch_curve energies;
    for(const Uv_coordinates& border_uv : spread_borders(patch, 8))
      energies.push_back(sketch_for(border_uv, nullptr, std::numeric_limits<double>::infinity()).report.objective);
    const auto spread = std::minmax_element(energies.begin(), energies.end());
    CHECK(*spread.second < 1.5 * *spread.first);
  }
}

TEST_CASE("small patches are mapped without sketches, and so is any patch by the iteration")
{
  const Patch small = make_patch_of(saddle(30)), large = make_patch_of(saddle(92));
  CHECK_FALSE(make_minimizer(small, Balanced_minimization())->has_sketches());
  CHECK_FALSE(make_minimizer(large, Stretch_minimization())->has_sketches());
}

TEST_CASE("a strategy is told that corners move on sketches afterwards, but not where they stay or move on rough maps")
{
  struct Flag_reader
  {
    Candidate_set candidate_set() const { return Candidate_set::QUARTER; }
    void operator()(const Corner_search_problem& problem) const
    {
      problem.objective_of({0});
      told = problem.is_refined_by_moves;
    }
    bool& told;
  };
  const auto is_told = [](int cells, const auto& minimization, bool moves_corners) {
    const Patch patch = make_patch_of(noisy_height_field(cells));
    bool told = false;
    Square_search_options options;
    options.moves_corners = moves_corners;
    search_corners(patch, *make_minimizer(patch, minimization), Flag_reader{told}, options);
    return told;
  };
  CHECK(is_told(50, Balanced_minimization(), true));
  CHECK_FALSE(is_told(50, Balanced_minimization(), false));
  CHECK_FALSE(is_told(50, Stretch_minimization(), true));
  CHECK_FALSE(is_told(30, Balanced_minimization(), true)); // of 961 vertices, which has no sketches
}

TEST_CASE("a search over a large patch makes sketches, and the same for any number of threads")
{
  const Patch patch = make_patch_of(noisy_height_field(92));
  const auto minimizer = make_minimizer(patch, Balanced_minimization());
  struct Sketch_counter : Search_visitor
  {
    void after_sketch(const Search_report::Sample& sample) override
    {
      CHECK(evaluations == 0);
      candidates.insert(sample.candidate);
    }
    void after_evaluation(const Search_report::Sample&) override { ++evaluations; }
    std::set<int> candidates;
    std::size_t evaluations = 0;
  } visitor;
  Square_search_options options;
  options.number_of_threads = 1;
  options.visitor = &visitor;
  const Search_outcome one = search_square_map(patch, *minimizer, Bracketing_corner_search(), options);
  CHECK(one.report.sketches == 32); // moves tell those between apart
  CHECK(one.report.evaluations < 12);
  CHECK(visitor.candidates.size() == one.report.sketches);
  CHECK(visitor.evaluations == one.report.evaluations);
  options.visitor = nullptr;
  options.number_of_threads = 3;
  const Search_outcome three = search_square_map(patch, *minimizer, Bracketing_corner_search(), options);
  CHECK(three.map.uv == one.map.uv);
  CHECK(three.report.sketches == one.report.sketches);
}

TEST_CASE(
    "of a patch of a few thousand vertices one candidate is mapped, the best of rough maps, and its corners move as "
    "low as if many were mapped")
{
  struct All_candidates // of which 32 are mapped
  {
    Candidate_set candidate_set() const { return Candidate_set::QUARTER; }
    void operator()(const Corner_search_problem& problem) const
    {
      std::vector<int> even;
      for(int i = 0; i < 32; ++i)
        even.push_back(i * problem.number_of_candidates / 32);
      problem.objective_of(even);
    }
  };
  for(unsigned int seed : {3u, 5u}) {
    const Patch patch = make_patch_of(noisy_height_field(48, seed));
    const auto minimizer = make_minimizer(patch, Balanced_minimization());
    Square_search_options options;
    options.number_of_threads = 1;
    const Search_outcome one = search_square_map(patch, *minimizer, Bracketing_corner_search(), options);
    CHECK(one.report.evaluations == 1);
    CHECK(one.report.sketches == 32);
    const auto& curve = one.report.sketched_curve;
    const auto best = std::min_element(curve.begin(), curve.end(),
                                       [](const auto& a, const auto& b) { return a.objective < b.objective; });
    CHECK(one.report.best_candidate == best->candidate);
    CHECK(one.report.corner_moves > 1);
    CHECK(one.map.report.objective <=
          1.001 * search_square_map(patch, *minimizer, All_candidates(), options).map.report.objective);
    options.number_of_threads = 3;
    CHECK(search_square_map(patch, *minimizer, Bracketing_corner_search(), options).map.uv == one.map.uv);
  }
}

TEST_CASE("a search that has no team has as many threads as its options say")
{
  const Patch patch = make_patch_of(unit_square(6));
  const auto minimizer = make_minimizer(patch, Balanced_minimization());
  for(std::size_t threads : {1u, 2u}) {
    Thread_watcher watcher;
    Square_search_options options;
    options.number_of_threads = static_cast<unsigned int>(threads);
    options.visitor = &watcher;
    search_square_map(patch, *minimizer, Brute_force_corner_search(), options);
    CHECK(watcher.threads.size() == threads);
  }
}

TEST_CASE("a search may be cancelled while it makes sketches")
{
  const Patch patch = make_patch_of(saddle(92));
  const auto minimizer = make_minimizer(patch, Balanced_minimization());
  Square_search_options options;
  options.number_of_threads = 1;
  int asked = 0;
  options.callback = [&asked](double share) {
    CHECK(share == 0);
    return ++asked < 5;
  };
  const Search_outcome outcome = search_square_map(patch, *minimizer, Bracketing_corner_search(), options);
  CHECK(asked == 5);
  CHECK(outcome.report.is_cancelled);
  CHECK_FALSE(outcome.report.best_candidate);
  CHECK(outcome.map.uv.rows() == 0);
}

TEST_CASE("a search that may take longer is told of as much less work, whatever it has cost")
{
  struct Asking_search
  {
    Candidate_set candidate_set() const { return Candidate_set::QUARTER; }
    void operator()(const Corner_search_problem& problem) const
    {
      problem.objective_of({0, 1});
      told = problem.work();
    }
    double& told;
  };
  const Patch patch = make_patch_of(noisy_height_field(30));
  const auto minimizer = make_minimizer(patch, Balanced_minimization());
  Square_search_options options;
  options.moves_corners = false;
  double told = 0, told_less = 0;
  const Search_outcome usual = search_corners(patch, *minimizer, Asking_search{told}, options);
  const Search_outcome longer = search_corners(patch, *minimizer, Asking_search{told_less}, options, 8);
  CHECK(usual.heeds_work);
  CHECK(usual.work == longer.work);
  CHECK(told == Approx(usual.work / patch.number_of_vertices()));
  CHECK(told_less == Approx(told / 8));
}
