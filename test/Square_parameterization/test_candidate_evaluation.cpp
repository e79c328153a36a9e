// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "On_threads.h"
#include "make_patch_of.h"
#include "search_curve.h"
#include "test_meshes.h"

#include <CGAL_ext/Square_parameterization/internal/search/Corner_evaluation.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <mutex>
#include <numeric>
#include <thread>
#include <utility>

using namespace CGAL_ext;
using internal::Candidate_evaluation;
using internal::Search_cancelled;

namespace {

Stretch_curve random_curve(int n, unsigned int seed)
{
  Random_numbers random(seed);
  Stretch_curve curve;
  for(int k = 0; k < n; ++k)
    curve.push_back(1 + random.below(20) / 8.); // many ties
  return curve;
}

std::vector<int> all_of(const Stretch_curve& curve)
{
  std::vector<int> all(curve.size());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

Candidate_evaluation evaluation_of(const Stretch_curve& curve, Search_visitor* visitor = nullptr,
                                   std::function<bool(double)> callback = {})
{
  return Candidate_evaluation(
      static_cast<int>(curve.size()), [&curve] { return worker_of(curve); }, visitor, std::move(callback));
}

/// counts its calls and notices when two overlap
class Counting_visitor : public Search_visitor
{
public:
  void after_evaluation(const Search_report::Sample& sample) override
  {
    if(m_is_inside.exchange(true))
      calls_overlap = true;
    samples.push_back(sample);
    m_is_inside = false;
  }

  std::vector<Search_report::Sample> samples;
  bool calls_overlap = false;

private:
  std::atomic<bool> m_is_inside{false};
};

} // namespace

TEST_CASE("stretches come in the order of the candidates, repeated ones too")
{
  const Stretch_curve curve{5, 4, 3, 2, 1};
  Candidate_evaluation evaluation = evaluation_of(curve);
  CHECK(evaluation({3, 0, 3, 1}) == std::vector<double>{2, 5, 2, 4});
  CHECK(evaluation({}).empty());
  CHECK(evaluation({1, 4}) == std::vector<double>{4, 1});
}

TEST_CASE("a candidate is mapped once and counted once")
{
  const Stretch_curve curve = random_curve(40, 41);
  std::vector<std::atomic<int>> calls(curve.size());
  const auto make_worker = [&]() -> Candidate_evaluation::Worker {
    return [&, worker = worker_of(curve)](int candidate, const internal::Uv_coordinates* warm_start) {
      ++calls[candidate];
      return worker(candidate, warm_start);
    };
  };
  const On_threads eight(8);
  Candidate_evaluation evaluation(40, make_worker, nullptr, {});
  evaluation({7, 3, 7, 7, 12});
  evaluation({12, 3, 20});
  evaluation({20, 20});
  const Search_report report = evaluation.report();
  CHECK(report.candidates == 40);
  CHECK(report.evaluations == 4);
  for(int k = 0; k < 40; ++k)
    CHECK(calls[k] == (k == 3 || k == 7 || k == 12 || k == 20 ? 1 : 0));
  REQUIRE(report.curve.size() == 4);
  const int expected[] = {3, 7, 12, 20};
  for(int i = 0; i < 4; ++i) {
    CHECK(report.curve[i].candidate == expected[i]);
    CHECK(report.curve[i].objective == curve[expected[i]]);
  }
}

TEST_CASE("the best map is that of least stretch, of the lowest candidate among equals")
{
  const Stretch_curve curve{3, 2, 1.5, 4, 1.5, 1.5};
  Candidate_evaluation evaluation = evaluation_of(curve);
  evaluation({5});
  CHECK(evaluation.report().best_candidate == 5);
  evaluation({0, 4});
  CHECK(evaluation.report().best_candidate == 4);
  evaluation({2, 1, 3});
  CHECK(evaluation.report().best_candidate == 2);
  CHECK(evaluation.report().best_objective == 1.5);
  CHECK(evaluation.best_map().uv(0, 0) == 2);
}

TEST_CASE("the result is the same for any number of threads and for every run")
{
  for(unsigned int seed = 0; seed < 5; ++seed) {
    const Stretch_curve curve = random_curve(200, seed);
    const int expected = static_cast<int>(std::min_element(curve.begin(), curve.end()) - curve.begin());
    for(unsigned int threads : {1, 2, 8, 0})
      for(int run = 0; run < 5; ++run) {
        const On_threads team(threads);
        Candidate_evaluation evaluation = evaluation_of(curve);
        CHECK(evaluation(all_of(curve)) == curve);
        CHECK(evaluation.report().best_candidate == expected);
        CHECK(evaluation.best_map().uv(0, 0) == expected);
      }
  }
}

TEST_CASE("the memory of the threads can be freed, and the best map stays")
{
  const auto memory = std::make_shared<int>();
  const auto make_worker = [&memory]() -> Candidate_evaluation::Worker {
    return [own = memory](int candidate, const internal::Uv_coordinates*) {
      internal::Minimized_map map;
      map.uv.setConstant(1, 2, candidate);
      map.report.objective = candidate;
      return map;
    };
  };
  const On_threads two(2);
  Candidate_evaluation evaluation(10, make_worker, nullptr, {});
  evaluation({7, 5, 6});
  CHECK(memory.use_count() > 1);
  evaluation.release_workers();
  CHECK(memory.use_count() == 1);
  CHECK(evaluation.best_map().uv(0, 0) == 5);
}

namespace {

/// waits until three threads have come to it, or, in vain, for long; tells which
bool meets_two_others(std::atomic<int>& met)
{
  ++met;
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  while(met < 3 && std::chrono::steady_clock::now() < end)
    std::this_thread::yield();
  return met >= 3;
}

} // namespace

TEST_CASE("candidates and choices of corners are mapped by all threads of the current team")
{
  const On_threads three(3);
  std::atomic<int> met{0}, together{0};
  const auto make_worker = [&]() -> Candidate_evaluation::Worker {
    return [&](int, const internal::Uv_coordinates*) {
      together += meets_two_others(met) ? 1 : 0;
      return internal::Minimized_map();
    };
  };
  Candidate_evaluation(3, make_worker, nullptr, {})({0, 1, 2});
  CHECK(together == 3);

  met = together = 0;
  const Patch patch = make_patch_of(unit_square(1));
  const auto make_comparing_worker = [&]() -> internal::Map_minimizer::Comparing_worker {
    return [&](const internal::Uv_coordinates&, const internal::Uv_coordinates*, double) {
      together += meets_two_others(met) ? 1 : 0;
      return internal::Minimized_map();
    };
  };
  internal::Corner_evaluation evaluation(make_comparing_worker, patch, nullptr, [] { return true; });
  evaluation({{0, 1, 2, 3}, {1, 2, 3, 0}, {2, 3, 0, 1}});
  CHECK(together == 3);
}

TEST_CASE("of large surfaces few maps are under way at a time")
{
  CHECK(internal::most_maps_at_once(1) == 1000000);
  CHECK(internal::most_maps_at_once(10000) == 100);
  CHECK(internal::most_maps_at_once(400000) == 2);
  CHECK(internal::most_maps_at_once(600000) == 1);
  CHECK(internal::most_maps_at_once(50000000) == 1);
  for(std::size_t most : {1u, 2u, 3u}) {
    std::atomic<std::size_t> under_way{0}, largest{0};
    const auto make_worker = [&]() -> Candidate_evaluation::Worker {
      return [&](int candidate, const internal::Uv_coordinates*) {
        const std::size_t now = ++under_way;
        for(std::size_t before = largest; before < now && !largest.compare_exchange_weak(before, now);) {
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        --under_way;
        internal::Minimized_map map;
        map.report.objective = candidate;
        return map;
      };
    };
    std::vector<int> candidates(30);
    std::iota(candidates.begin(), candidates.end(), 0);
    const On_threads eight(8);
    Candidate_evaluation evaluation(30, make_worker, nullptr, {}, most);
    CHECK(evaluation(candidates).back() == 29);
    CHECK(largest <= most);
  }
}

TEST_CASE("candidates without a map are evaluated but never the best")
{
  const Stretch_curve curve{INFEASIBLE, 3, INFEASIBLE, 2};
  Candidate_evaluation evaluation = evaluation_of(curve);
  CHECK(evaluation({0, 2}) == std::vector<double>{INFEASIBLE, INFEASIBLE});
  CHECK_FALSE(evaluation.report().best_candidate);
  CHECK(evaluation.report().best_objective == INFEASIBLE);
  CHECK(evaluation.best_map().uv.rows() == 0);
  CHECK(evaluation.report().evaluations == 2);
  evaluation({0, 1, 2, 3});
  CHECK(evaluation.report().best_candidate == 3);
  CHECK(evaluation.report().evaluations == 4);
}

TEST_CASE("the callback sees the share of the candidates evaluated, before each evaluation")
{
  const Stretch_curve curve = random_curve(8, 42);
  std::vector<double> shares;
  Candidate_evaluation evaluation = evaluation_of(curve, nullptr, [&](double share) {
    shares.push_back(share);
    return true;
  });
  evaluation({0, 1, 2});
  evaluation({2, 3});
  CHECK(shares == std::vector<double>{0, 1 / 8., 2 / 8., 3 / 8.});
  CHECK_FALSE(evaluation.report().is_cancelled);
}

TEST_CASE("a cancelled search keeps the best so far and stops within one evaluation per thread")
{
  const unsigned int threads = GENERATE(1u, 2u, 8u);
  const Stretch_curve curve = random_curve(500, 43);
  Counting_visitor visitor;
  std::atomic<int> asked{0};
  const On_threads team(threads);
  Candidate_evaluation evaluation = evaluation_of(curve, &visitor, [&](double) { return ++asked <= 20; });
  CHECK_THROWS_AS(evaluation(all_of(curve)), Search_cancelled);

  const Search_report report = evaluation.report();
  CHECK(report.is_cancelled);
  CHECK(asked == 21); // not asked again after the refusal
  CHECK(report.evaluations == 20);
  CHECK(visitor.samples.size() == 20);
  double least = INFEASIBLE;
  for(const auto& sample : report.curve) {
    CHECK(sample.objective == curve[sample.candidate]);
    least = std::min(least, sample.objective);
  }
  CHECK(report.best_objective == least);
  CHECK(evaluation.best_map().uv(0, 0) == *report.best_candidate);
}

TEST_CASE("a search cancelled at once has no best")
{
  const Stretch_curve curve{1, 2};
  Candidate_evaluation evaluation = evaluation_of(curve, nullptr, [](double) { return false; });
  CHECK_THROWS_AS(evaluation({0, 1}), Search_cancelled);
  CHECK(evaluation.report().evaluations == 0);
  CHECK_FALSE(evaluation.report().best_candidate);
  CHECK(evaluation.report().is_cancelled);
}

TEST_CASE("the visitor is told of every evaluation, one at a time")
{
  const Stretch_curve curve = random_curve(100, 44);
  Counting_visitor visitor;
  const On_threads eight(8);
  Candidate_evaluation evaluation = evaluation_of(curve, &visitor);
  evaluation({4, 4, 5});
  evaluation(all_of(curve));
  CHECK_FALSE(visitor.calls_overlap);
  REQUIRE(visitor.samples.size() == 100);
  std::sort(visitor.samples.begin(), visitor.samples.end(),
            [](const auto& a, const auto& b) { return a.candidate < b.candidate; });
  for(int k = 0; k < 100; ++k) {
    CHECK(visitor.samples[k].candidate == k);
    CHECK(visitor.samples[k].objective == curve[k]);
  }
}

TEST_CASE("each thread has a worker of its own, used by one thread at a time")
{
  std::atomic<bool> is_shared{false};
  const auto make_worker = [&is_shared]() -> Candidate_evaluation::Worker {
    return [&is_shared, is_busy = std::make_shared<std::atomic<bool>>(false)](int candidate,
                                                                              const internal::Uv_coordinates*) {
      if(is_busy->exchange(true))
        is_shared = true;
      std::this_thread::yield();
      internal::Minimized_map map;
      map.report.l2 = candidate;
      *is_busy = false;
      return map;
    };
  };
  const On_threads eight(8);
  Candidate_evaluation evaluation(300, make_worker, nullptr, {});
  evaluation(all_of(Stretch_curve(300)));
  CHECK_FALSE(is_shared);
}

TEST_CASE("a map starts from that of the nearest candidate of an earlier call, whatever the number of threads")
{
  for(unsigned int threads : {1u, 8u}) {
    std::vector<double> started_from(20, -2);
    const auto make_worker = [&started_from]() -> Candidate_evaluation::Worker {
      return [&started_from](int candidate, const internal::Uv_coordinates* warm_start) {
        started_from[candidate] = warm_start == nullptr ? -1 : (*warm_start)(0, 0);
        internal::Minimized_map map;
        map.report.objective = candidate;
        if(candidate != 4) // has no warm start to offer
          map.warm_start = internal::Uv_coordinates::Constant(1, 2, candidate);
        return map;
      };
    };
    const On_threads team(threads);
    Candidate_evaluation evaluation(20, make_worker, nullptr, {});
    evaluation({10}); // keeps none
    evaluation({0, 4, 8}, true);
    evaluation({1, 5, 6, 19, 14}, true);
    evaluation({7});
    evaluation({13}, true);
    CHECK(started_from[0] == -1);
    CHECK(started_from[8] == -1);
    CHECK(started_from[1] == 0);
    CHECK(started_from[5] == 8);
    CHECK(started_from[6] == 8);
    CHECK(started_from[19] == 0); // the candidates are a ring
    CHECK(started_from[14] == 0); // as near as 8: the lower
    CHECK(started_from[7] == -1);
    CHECK(started_from[13] == 14);
  }
}
