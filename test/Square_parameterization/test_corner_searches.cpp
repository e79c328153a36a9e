// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "search_curve.h"
#include "test_meshes.h"

#include <CGAL_ext/Square_parameterization/Bracketing_corner_search.h>

#include <catch2/catch.hpp>

#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

using namespace CGAL_ext;

namespace {

Stretch_curve smooth_curve(int n, double phase)
{
  Stretch_curve curve;
  for(int k = 0; k < n; ++k)
    curve.push_back(1.5 + std::cos(2 * PI * (k - phase) / n) / 4);
  return curve;
}

int minimum_of(const Stretch_curve& curve)
{
  return static_cast<int>(std::min_element(curve.begin(), curve.end()) - curve.begin());
}

} // namespace

TEST_CASE("brute force finds the optimum with one evaluation per candidate")
{
  for(const Corner_search& search :
      {Corner_search(Brute_force_corner_search()), Corner_search(Quarter_brute_force_corner_search())})
    for(double phase : {0., 3.3, 17.}) {
      const Stretch_curve curve = smooth_curve(37, phase);
      const Search_report report = search_curve(curve, search);
      CHECK(report.best_candidate == minimum_of(curve));
      CHECK(report.best_objective == curve[minimum_of(curve)]);
      CHECK(report.evaluations == 37);
      CHECK(report.candidates == 37);
      REQUIRE(report.curve.size() == 37);
      for(int k = 0; k < 37; ++k)
        CHECK((report.curve[k].candidate == k && report.curve[k].objective == curve[k]));
    }
}

TEST_CASE("brute force passes over candidates without a map")
{
  Stretch_curve curve = smooth_curve(20, 4);
  const int best = minimum_of(curve);
  curve[best] = INFEASIBLE;
  CHECK(search_curve(curve, Brute_force_corner_search()).best_candidate == minimum_of(curve));
  CHECK_FALSE(search_curve(Stretch_curve(20, INFEASIBLE), Brute_force_corner_search()).best_candidate);
}

TEST_CASE("no search evaluates the first candidate alone")
{
  const Stretch_curve curve = smooth_curve(20, 4);
  const Search_report report = search_curve(curve, First_candidate_corner_search());
  CHECK(report.best_candidate == 0);
  CHECK(report.evaluations == 1);
  CHECK(report.candidates == 20);
}

TEST_CASE("a strategy says from which candidates it chooses")
{
  CHECK(Corner_search(Brute_force_corner_search()).candidate_set() == Candidate_set::FULL);
  CHECK(Corner_search(Quarter_brute_force_corner_search()).candidate_set() == Candidate_set::QUARTER);
  CHECK(Corner_search(First_candidate_corner_search()).candidate_set() == Candidate_set::QUARTER);
}

TEST_CASE("a single candidate is enough for every strategy")
{
  for(const Corner_search& search :
      {Corner_search(Brute_force_corner_search()), Corner_search(Quarter_brute_force_corner_search()),
       Corner_search(First_candidate_corner_search())}) {
    const Search_report report = search_curve({1.25}, search);
    CHECK(report.best_candidate == 0);
    CHECK(report.best_objective == 1.25);
    CHECK(report.evaluations == 1);
  }
}

TEST_CASE("a strategy that is cancelled reports the best so far")
{
  const Stretch_curve curve = smooth_curve(30, 0);
  int asked = 0;
  const Search_report report =
      search_curve(curve, Brute_force_corner_search(), {1, nullptr, [&](double) { return ++asked <= 10; }});
  CHECK(report.is_cancelled);
  CHECK(report.evaluations == 10);
  CHECK(report.best_candidate == 9); // the curve falls from 0 to 15, and one thread goes in order
}

namespace {

/// asks for given batches of candidates, one after the other, and then does what else it is told
struct Batches_corner_search
{
  Candidate_set candidate_set() const { return Candidate_set::FULL; }

  void operator()(const Corner_search_problem& problem) const
  {
    for(const std::vector<int>& batch : batches) {
      const std::size_t answers = problem.objective_of(batch).size(); // outside of CHECK, which would keep an exception
      CHECK(answers == batch.size());
    }
    if(then)
      then(problem);
  }

  std::vector<std::vector<int>> batches = {};
  std::function<void(const Corner_search_problem&)> then = {};
};

} // namespace

TEST_CASE("a candidate that does not exist is refused, and nothing of its batch is mapped")
{
  for(int wrong : {-1, 9, 1000000, std::numeric_limits<int>::max(), std::numeric_limits<int>::min()}) {
    const std::string text =
        "the corner search asked for candidate " + std::to_string(wrong) + "; the candidates are 0 to 8";
    int asked = 0;
    const Search_conditions conditions{1, nullptr, [&asked](double) { return ++asked > 0; }};
    CHECK_THROWS_WITH(search_curve(valley(9, 4), Batches_corner_search{{{3}, {1, wrong, 2}}}, conditions), text);
    CHECK(asked == 1);
    const auto ask_for_distances = [wrong](const Corner_search_problem& problem) { problem.corner_distances(wrong); };
    Search_conditions with_distances;
    with_distances.corner_distances = [](int) { return std::vector<double>(9, 0.); };
    CHECK_THROWS_WITH(search_curve(valley(9, 4), Batches_corner_search{{{3}}, ask_for_distances}, with_distances),
                      text);
  }
}

TEST_CASE("an empty batch is answered by an empty one, and a strategy that asks for no candidate is refused")
{
  const Search_report report = search_curve(valley(9, 4), Batches_corner_search{{{}, {5}, {}}});
  CHECK(report.best_candidate == 5);
  CHECK(report.evaluations == 1);
  CHECK_THROWS_WITH(search_curve(valley(9, 4), Batches_corner_search{}), "the corner search asked for no candidate");
  CHECK_THROWS_WITH(search_curve(valley(9, 4), Batches_corner_search{{{}, {}}}),
                    "the corner search asked for no candidate");
}

TEST_CASE("a strategy that is cancelled is left by what is no std::exception, and its objects are destroyed")
{
  struct On_exit
  {
    ~On_exit() { ++count; }
    int& count;
  };
  int destroyed = 0, errors = 0, others = 0;
  const auto careful = [&](const Corner_search_problem& problem) {
    const On_exit on_exit{destroyed};
    try {
      problem.objective_of({2});
    } catch(const std::exception&) {
      ++errors;
    } catch(...) {
      ++others;
      throw;
    }
  };
  const Batches_corner_search search{{{0}, {1}}, careful};
  int asked = 0;
  const Search_report report = search_curve(valley(9, 4), search, {1, nullptr, [&](double) { return ++asked <= 2; }});
  CHECK((report.is_cancelled && report.evaluations == 2 && report.best_candidate == 1));
  CHECK((destroyed == 1 && errors == 0 && others == 1));
  // cancelled before the first map: no strategy is to blame for that
  const Search_report none = search_curve(valley(9, 4), search, {1, nullptr, [](double) { return false; }});
  CHECK((none.is_cancelled && none.evaluations == 0 && !none.best_candidate));
}

TEST_CASE("a strategy's own exception comes out")
{
  const auto fail = [](const Corner_search_problem&) { throw std::domain_error("of the strategy"); };
  CHECK_THROWS_WITH(search_curve(valley(9, 4), Batches_corner_search{{{0}}, fail}), "of the strategy");
}

TEST_CASE("a strategy of the user sees the number of candidates and their stretch")
{
  struct Every_third_corner_search
  {
    Candidate_set candidate_set() const { return Candidate_set::FULL; }

    void operator()(const Corner_search_problem& problem) const
    {
      for(int k = 0; k < problem.number_of_candidates; k += 3)
        problem.objective_of({k});
    }
  };
  Stretch_curve curve(10, 2.);
  curve[6] = 1;
  curve[7] = 0.5;
  const Search_report report = search_curve(curve, Every_third_corner_search());
  CHECK(report.evaluations == 4);
  CHECK(report.best_candidate == 6);
}

TEST_CASE("bracketing ends early where maps are slow, and not where they are not")
{
  const Stretch_curve curve = valley(400, 137);
  Search_conditions conditions;
  conditions.work_per_map = 20;
  CHECK(search_curve(curve, Bracketing_corner_search(), conditions).best_candidate == 137);
  conditions.work_per_map = 1000;
  const Search_report slow = search_curve(curve, Bracketing_corner_search(), conditions);
  CHECK(slow.evaluations == 3); // the first, and, as little is left of the work, one step from there
  CHECK_FALSE(slow.is_cancelled);

  conditions.number_of_vertices = 5000; // of which a single map takes long
  CHECK(search_curve(curve, Bracketing_corner_search(), conditions).evaluations == 1);
  conditions.work_per_map = 400; // that of an ordinary surface, at most
  const auto evaluations_of = [&](int vertices, const Stretch_curve& energies) {
    Search_conditions of_mesh = conditions;
    of_mesh.number_of_vertices = vertices;
    return search_curve(energies, Bracketing_corner_search(), of_mesh).evaluations;
  };
  for(int vertices : {5000, 50000}) // half the sweeps of a smaller mesh
    CHECK(evaluations_of(vertices, curve) == 3);
  const std::size_t of_small = evaluations_of(2500, curve);
  CHECK(of_small > 3);
  CHECK(evaluations_of(1, curve) == of_small);
  const Stretch_curve without_maps(curve.size(), std::numeric_limits<double>::infinity());
  CHECK(evaluations_of(5000, without_maps) == evaluations_of(2500, without_maps));
  CHECK(evaluations_of(5000, without_maps) > 3);

  conditions.work_per_map = 500;
  conditions.sketched_stretch = valley(400, 140);
  const Search_report slow_sketches = search_curve(curve, Bracketing_corner_search(), conditions);
  CHECK(slow_sketches.sketches == 4);
  CHECK(slow_sketches.evaluations == 1);
  CHECK(slow_sketches.best_candidate == 100); // the best of four
  conditions.work_per_map = 10;
  CHECK(search_curve(curve, Bracketing_corner_search(), conditions).best_candidate == 140);
}
