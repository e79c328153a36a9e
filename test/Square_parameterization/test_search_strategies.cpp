// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The strategies of the paper as pure decisions over arrays of numbers.

#include "search_curve.h"
#include "test_meshes.h"

#include <CGAL_ext/Square_parameterization/Bracketing_corner_search.h>
#include <CGAL_ext/Square_parameterization/Hybrid_corner_search.h>
#include <CGAL_ext/Square_parameterization/Particle_swarm_corner_search.h>
#include <CGAL_ext/Square_parameterization/Step_sampling_corner_search.h>
#include <CGAL_ext/Square_parameterization/circle_corner_searches.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <utility>

using namespace CGAL_ext;

namespace {

/// a border of as many vertices as candidates; candidate j puts vertex j onto a corner, and vertices far from j (in
/// index) far from it. `circle_stretch` is given.
Search_conditions circle_conditions(int n, std::vector<double> circle_stretch)
{
  Search_conditions conditions;
  conditions.circle_stretch = std::move(circle_stretch);
  conditions.corner_distances = [n](int candidate) {
    std::vector<double> distances;
    for(int v = 0; v < n; ++v) {
      const int gap = std::abs(v - candidate);
      distances.push_back(2. * (std::min)(gap, n - gap) / n);
    }
    return distances;
  };
  return conditions;
}

/// a peak of stretch at border vertex `peak`
Search_conditions peak_at(int n, int peak)
{
  std::vector<double> stretch(n, 1.);
  stretch[peak] = 3;
  return circle_conditions(n, stretch);
}

std::vector<std::pair<std::string, Corner_search>> all_strategies()
{
  return {{"step", Step_sampling_corner_search()},
          {"step 1", Step_sampling_corner_search(1)},
          {"step 1000", Step_sampling_corner_search(1000)},
          {"swarm", Particle_swarm_corner_search()},
          {"one particle", Particle_swarm_corner_search(1)},
          {"single", Single_highest_corner_search()},
          {"many", Many_high_corner_search()},
          {"better", Better_of_two_corner_search()},
          {"hybrid", Hybrid_corner_search()},
          {"hybrid 1", Hybrid_corner_search(1)},
          {"hybrid 1000", Hybrid_corner_search(1000)},
          {"bracketing", Bracketing_corner_search()},
          {"bracketing 3", Bracketing_corner_search(3)}};
}

} // namespace

TEST_CASE("the step of the paper")
{
  // table 1 and 4 of the paper: vertices, faces, candidates, step
  const int models[][4] = {{863, 1548, 45, 5},     {6885, 13164, 153, 8},  {38658, 75618, 440, 14},
                           {35073, 69465, 166, 9}, {35068, 69662, 108, 7}, {174296, 345952, 655, 18}};
  for(const auto& [vertices, faces, candidates, step] : models) {
    Corner_search_problem problem;
    problem.number_of_vertices = vertices;
    problem.number_of_faces = faces;
    problem.number_of_candidates = candidates;
    CHECK(internal::sampling_step(problem) == step);
  }
  Corner_search_problem tiny;
  tiny.number_of_candidates = 1;
  CHECK(internal::sampling_step(tiny) == 2);
}

TEST_CASE("step sampling evaluates the samples, then all between the best and its neighbors")
{
  const Search_report report = search_curve(valley(20, 9), Step_sampling_corner_search(4));
  CHECK(report.best_candidate == 9);
  CHECK(evaluated(report) == std::set<int>{0, 4, 8, 12, 16, 5, 6, 7, 9, 10, 11});
}

TEST_CASE("step sampling looks across the ends of the ring")
{
  const Search_report low = search_curve(valley(20, 19), Step_sampling_corner_search(4)); // best sample is 0
  CHECK(low.best_candidate == 19);
  CHECK(evaluated(low) == std::set<int>{0, 4, 8, 12, 16, 1, 2, 3, 17, 18, 19});
  const Search_report high = search_curve(valley(20, 18), Step_sampling_corner_search(4)); // best sample is 16
  CHECK(high.best_candidate == 18);
}

TEST_CASE("step sampling finds the bottom of every valley, with the evaluations of the formula at most")
{
  for(int n : {1, 2, 3, 4, 5, 16, 45, 153})
    for(int step : {2, 3, 5, 8})
      for(int bottom = 0; bottom < n; ++bottom) {
        const Search_report report = search_curve(valley(n, bottom), Step_sampling_corner_search(step));
        CHECK(report.best_candidate == bottom);
        CHECK(static_cast<int>(report.evaluations) <= (n + step - 1) / step + 2 * (step - 1));
      }
}

TEST_CASE("the evaluations of the paper are not exceeded on its sizes")
{
  // m, step, evaluations of step sampling and of hybrid, table 1 and 2 of the paper
  const int models[][4] = {{45, 5, 18, 10}, {153, 8, 35, 18}, {108, 7, 29, 14}, {655, 18, 72, 36}};
  for(const auto& [m, step, sampling, hybrid] : models) {
    const int bottom = m / 2 + 1;
    CHECK(static_cast<int>(search_curve(valley(m, bottom), Step_sampling_corner_search(step)).evaluations) <= sampling);
    const Search_report report = search_curve(valley(m, bottom), Hybrid_corner_search(step - 1), peak_at(m, bottom));
    CHECK(report.best_candidate == bottom);
    CHECK(static_cast<int>(report.evaluations) <= hybrid);
  }
}

TEST_CASE("hybrid walks downhill from the prediction, also across the ends, and finds the bottom of a valley")
{
  const int n = 40;
  for(int interval : {1, 2, 3, 5})
    for(int start = 0; start < n; start += 3)
      for(int bottom = 0; bottom < n; ++bottom) {
        INFO("interval " << interval << ", start " << start << ", bottom " << bottom);
        CHECK(search_curve(valley(n, bottom), Hybrid_corner_search(interval), peak_at(n, start)).best_candidate ==
              bottom);
      }
}

TEST_CASE("hybrid evaluates both ways together and stops where the stretch rises")
{
  std::vector<std::set<int>> batches;
  Corner_search_problem problem;
  const Stretch_curve curve = valley(30, 14);
  const Search_conditions conditions = peak_at(30, 12);
  problem.number_of_candidates = 30;
  problem.circle_stretch = [&] { return conditions.circle_stretch; };
  problem.corner_distances = conditions.corner_distances;
  problem.objective_of = [&](const std::vector<int>& batch) {
    batches.emplace_back(batch.begin(), batch.end());
    std::vector<double> stretch;
    for(int candidate : batch)
      stretch.push_back(curve[candidate]);
    return stretch;
  };
  Hybrid_corner_search(3)(problem);
  REQUIRE(batches.size() == 4);
  CHECK(batches[0] == std::set<int>{12});    // both predictions agree
  CHECK(batches[1] == std::set<int>{9, 15}); // left rises, right falls
  CHECK(batches[2] == std::set<int>{18});    // right rises
  CHECK(batches[3] == std::set<int>{13, 14, 16, 17});
}

TEST_CASE("bracketing closes in but once where corners move afterwards, and refines no sketches")
{
  const int n = 655;
  int sketches = 0, maps = 0, settled = -1;
  const auto count = [](int& sum) {
    return [&sum](const std::vector<int>& batch) {
      sum += int(batch.size());
      std::vector<double> objectives;
      for(int k : batch)
        objectives.push_back(1.5 - 0.3 * std::cos(2 * PI * (k - 100.3) / n));
      return objectives;
    };
  };
  Corner_search_problem problem;
  problem.number_of_candidates = n;
  problem.objective_of = count(maps);
  Bracketing_corner_search()(problem);
  const int all_maps = std::exchange(maps, 0);
  problem.is_refined_by_moves = true;
  Bracketing_corner_search()(problem);
  CHECK(maps == 5 + 2); // even ones, and one on either side of the best
  CHECK(maps < all_maps);

  problem.sketched_objective_of = count(sketches);
  problem.settle_for = [&](int k) { settled = k; };
  Bracketing_corner_search()(problem);
  CHECK(sketches == 32);
  CHECK(std::abs(settled - 100.3) <= n / 64.); // half of the distance of even ones
  problem.is_refined_by_moves = false;
  sketches = 0;
  Bracketing_corner_search()(problem);
  CHECK(settled == 100);
  CHECK(sketches > 32);
}

TEST_CASE("bracketing maps the candidate that is best by rough maps, and others where its map is hopeless")
{
  const int n = 655;
  const auto distance = [](int k) { return std::abs((k + n - 327) % n - n / 2.); };
  for(double objective : {2.7, 1e7}) {
    std::vector<int> maps;
    int rough = 0;
    Corner_search_problem problem;
    problem.number_of_candidates = n;
    problem.is_refined_by_moves = true;
    problem.objective_of = [&](const std::vector<int>& batch) {
      maps.insert(maps.end(), batch.begin(), batch.end());
      return std::vector<double>(batch.size(), objective);
    };
    problem.rough_objective_of = [&](const std::vector<int>& batch) {
      std::vector<double> objectives;
      for(int k : batch)
        objectives.push_back(3 + std::abs(distance(k) - 40));
      rough += int(batch.size());
      return objectives;
    };
    Bracketing_corner_search()(problem);
    CHECK(rough == 32);
    REQUIRE_FALSE(maps.empty());
    CHECK(std::abs(distance(maps[0]) - 40) <= n / 64. + 1);
    CHECK((maps.size() > 1) == (objective > 1e6));
  }
}

TEST_CASE("bracketing maps several candidates where none has a rough map, and one where the first map is slow")
{
  const int n = 655;
  for(bool has_rough_maps : {true, false}) {
    std::set<int> maps;
    Corner_search_problem problem;
    problem.number_of_candidates = n;
    problem.number_of_vertices = 4000;
    problem.is_refined_by_moves = true;
    problem.work = [&] { return has_rough_maps ? 350. * double(maps.size()) : 0; };
    problem.objective_of = [&](const std::vector<int>& batch) {
      maps.insert(batch.begin(), batch.end());
      return std::vector<double>(batch.size(), 2.7);
    };
    problem.rough_objective_of = [&](const std::vector<int>& batch) {
      return std::vector<double>(batch.size(), has_rough_maps ? 3 : std::numeric_limits<double>::infinity());
    };
    Bracketing_corner_search()(problem);
    CHECK(maps.size() == (has_rough_maps ? 1 : 7)); // with two on either side of the best
  }
}

TEST_CASE("bracketing goes on where corners move afterwards while no candidate has a map from which they do")
{
  const int n = 655;
  for(double least : {std::numeric_limits<double>::infinity(), 1e7}) {
    std::set<int> maps;
    Corner_search_problem problem;
    problem.number_of_candidates = n;
    problem.objective_of = [&](const std::vector<int>& batch) {
      maps.insert(batch.begin(), batch.end());
      std::vector<double> objectives;
      for(int k : batch)
        objectives.push_back(least * (2 - std::cos(2 * PI * (k - 100.3) / n)));
      return objectives;
    };
    Bracketing_corner_search()(problem);
    const std::set<int> all = std::exchange(maps, {});
    REQUIRE(all.size() > 7);
    problem.is_refined_by_moves = true;
    Bracketing_corner_search()(problem);
    CHECK(maps == all);
  }
}

TEST_CASE("bracketing finds the bottom of smooth valleys within its bound, and of the deeper of two")
{
  for(int n : {1, 2, 3, 4, 8, 16, 39, 153, 655})
    for(int bottom = 0; bottom < n; bottom += 1 + n / 20) {
      Stretch_curve one, two;
      for(int k = 0; k < n; ++k) {
        const double angle = 2 * PI * (k - bottom) / n;
        one.push_back(1.5 - 0.3 * std::cos(angle));
        two.push_back(1.5 - 0.3 * std::cos(2 * angle) -
                      0.1 * std::cos(angle)); // the other valley is half round the ring
      }
      const int bound = (std::max)(12, static_cast<int>(2 * std::log2(double(n))) + 4);
      for(const Stretch_curve& curve : {one, two}) {
        if(curve == two && n < 16)
          continue; // a valley of four candidates is narrower than two samples
        INFO(n << " candidates, bottom " << bottom);
        const Search_report report = search_curve(curve, Bracketing_corner_search());
        CHECK(report.best_objective == Approx(1.5 - (curve == one ? 0.3 : 0.4)).epsilon(2e-4));
        CHECK(static_cast<int>(report.evaluations) <= bound);
      }
    }
}

TEST_CASE("single highest and many high predict what their definitions say")
{
  const int n = 24;
  CHECK(search_curve(valley(n, 0), Single_highest_corner_search(), peak_at(n, 17)).best_candidate == 17);
  CHECK(search_curve(valley(n, 0), Many_high_corner_search(), peak_at(n, 17)).best_candidate == 17);
  // one sharp peak at 3, a broad one of more weight around 15: the two predictions part
  std::vector<double> stretch(n, 1.);
  stretch[3] = 4;
  for(int v = 13; v <= 17; ++v)
    stretch[v] = 3.5;
  const Search_conditions two_peaks = circle_conditions(n, stretch);
  CHECK(search_curve(valley(n, 0), Single_highest_corner_search(), two_peaks).best_candidate == 3);
  CHECK(search_curve(valley(n, 0), Many_high_corner_search(), two_peaks).best_candidate == 15);
  const Search_report better = search_curve(valley(n, 14), Better_of_two_corner_search(), two_peaks);
  CHECK(better.best_candidate == 15);
  CHECK(better.evaluations == 2);
}

TEST_CASE("the predictions fall back to the first candidate when there is no circular map")
{
  for(const Corner_search& search :
      {Corner_search(Single_highest_corner_search()), Corner_search(Many_high_corner_search()),
       Corner_search(Better_of_two_corner_search())}) {
    const Search_report report = search_curve(valley(9, 4), search);
    CHECK(report.best_candidate == 0);
    CHECK(report.evaluations == 1);
  }
}

TEST_CASE("a swarm is the same for a seed, differs between seeds, and stays within its bound")
{
  Random_numbers random(5);
  Stretch_curve noise;
  for(int k = 0; k < 200; ++k)
    noise.push_back(random(1, 2));
  const auto run = [&](unsigned int seed) {
    return evaluated(search_curve(noise, Particle_swarm_corner_search(8, 10, 10, seed)));
  };
  CHECK(run(1) == run(1));
  CHECK(run(1) != run(2));
  CHECK(run(1).size() <= 8 * 11);
  CHECK(evaluated(search_curve(noise, Particle_swarm_corner_search(5, 0, 1, 0))).size() == 5); // never moves
}

TEST_CASE("a swarm finds the bottom of a wide valley")
{
  for(unsigned int seed = 0; seed < 20; ++seed)
    CHECK(search_curve(valley(100, 37), Particle_swarm_corner_search(12, 40, 10, seed)).best_objective <= 1.02);
}

TEST_CASE("every strategy ends on every curve, within the number of candidates, with the best it has seen")
{
  Random_numbers random(11);
  for(int n : {1, 2, 3, 7, 31}) {
    Stretch_curve plateau(n, 1.5), noise, bimodal, gaps;
    for(int k = 0; k < n; ++k) {
      noise.push_back(random(1, 2));
      bimodal.push_back(1.5 + 0.3 * std::cos(4 * PI * k / n) + 0.01 * k);
      gaps.push_back(k % 3 == 1 ? 1 + 0.01 * k : INFEASIBLE);
    }
    for(const Stretch_curve& curve : {plateau, noise, bimodal, gaps, Stretch_curve(n, INFEASIBLE)})
      for(const auto& [name, search] : all_strategies()) {
        INFO(name << " on " << n << " candidates");
        const Search_conditions conditions = peak_at(n, n / 2);
        const Search_report report = search_curve(curve, search, conditions);
        CHECK(report.evaluations >= 1);
        CHECK(static_cast<int>(report.evaluations) <= n);
        double least = INFEASIBLE;
        for(const auto& sample : report.curve) {
          CHECK(sample.objective == curve[sample.candidate]);
          least = (std::min)(least, sample.objective);
        }
        CHECK(report.best_objective == least);
      }
  }
}

TEST_CASE("step sampling and hybrid look everywhere when no sample has a map")
{
  Stretch_curve curve(30, INFEASIBLE);
  curve[7] = 1.2;
  CHECK(search_curve(curve, Step_sampling_corner_search(5)).best_candidate == 7);
  CHECK(search_curve(curve, Hybrid_corner_search(5), peak_at(30, 20)).best_candidate == 7);
}

TEST_CASE("every strategy gives the same answer for any number of threads and for repeated runs")
{
  Random_numbers random(3);
  Stretch_curve noise;
  for(int k = 0; k < 60; ++k)
    noise.push_back(1 + 0.1 * random.below(8)); // ties
  for(const auto& [name, search] : all_strategies()) {
    INFO(name);
    Search_conditions conditions = peak_at(60, 40);
    const Search_report alone = search_curve(noise, search, conditions);
    for(unsigned int threads : {1u, 2u, 8u}) {
      conditions.number_of_threads = threads;
      const Search_report report = search_curve(noise, search, conditions);
      CHECK(report.best_candidate == alone.best_candidate);
      CHECK(evaluated(report) == evaluated(alone));
    }
  }
}

TEST_CASE("a number out of its range makes a strategy invalid, and a search with it is refused")
{
  for(const auto& [name, search] : all_strategies()) {
    INFO(name);
    CHECK(search.is_valid());
  }
  for(int wrong : {2, 1, 0, -1, -1000})
    CHECK(!Bracketing_corner_search(wrong).is_valid());
  for(int wrong : {-1, -1000}) {
    CHECK(!Step_sampling_corner_search(wrong).is_valid());
    CHECK(!Hybrid_corner_search(wrong).is_valid());
    CHECK(!Particle_swarm_corner_search(wrong).is_valid());
    CHECK(!Particle_swarm_corner_search(4, wrong).is_valid());
  }
  for(int wrong : {0, -1})
    CHECK(!Particle_swarm_corner_search(4, 20, wrong).is_valid());
  for(const Corner_search& wrong :
      {Corner_search(Bracketing_corner_search(2)), Corner_search(Step_sampling_corner_search(-1)),
       Corner_search(Hybrid_corner_search(-1)), Corner_search(Particle_swarm_corner_search(-1))}) {
    CHECK(!wrong.is_valid());
    CHECK(!Corner_search(wrong).is_valid()); // a copy
    CHECK_THROWS_WITH(search_curve(valley(9, 4), wrong), "a number of the corner search is out of its range");
  }
}

TEST_CASE("every strategy stops when it is cancelled, with the best so far")
{
  const Stretch_curve curve = valley(50, 20);
  for(const auto& [name, search] : all_strategies()) {
    INFO(name);
    Search_conditions conditions = peak_at(50, 10);
    const std::size_t all = search_curve(curve, search, conditions).evaluations;
    int asked = 0;
    conditions.callback = [&](double share) {
      CHECK((share >= 0 && share <= 1));
      return ++asked <= 3;
    };
    const Search_report report = search_curve(curve, search, conditions);
    CHECK(report.is_cancelled == (all > 3));
    CHECK(report.evaluations == (std::min)(all, std::size_t(3)));
    double least = INFEASIBLE;
    for(const auto& sample : report.curve)
      least = (std::min)(least, sample.objective);
    CHECK(report.best_objective == least);
  }
}
