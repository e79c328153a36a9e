// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "closed_meshes.h"
#include "opened_surface.h"

#include <CGAL_ext/Square_parameterization/Bracketing_corner_search.h>
#include <CGAL_ext/Square_parameterization/internal/cut/cut_to_disk.h>
#include <CGAL_ext/Square_parameterization/internal/cut/grow_cut.h>
#include <CGAL_ext/Square_parameterization/internal/cut/judge_cuts.h>
#include <CGAL_ext/Square_parameterization/internal/cut/refine_cut.h>
#include <CGAL_ext/Square_parameterization/internal/cut/rerouted_initial_cuts.h>
#include <CGAL_ext/Square_parameterization/internal/cut/search_cut.h>
#include <CGAL_ext/Square_parameterization/internal/cut/short_cuts.h>
#include <CGAL_ext/Square_parameterization/internal/cut/simplified_copy.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/make_minimizer.h>
#include <CGAL_ext/Square_parameterization/internal/search/square_search.h>

#include <catch2/catch.hpp>

#include <chrono>
#include <cmath>
#include <vector>

using namespace CGAL_ext;
using namespace CGAL_ext::internal;
using Catch::Matchers::Contains;

namespace {

typedef std::vector<std::array<int, 2>> Seams;

struct Decision
{
  Cut cut;
  Cut_report report;
};

Decision decide(const Triangle_surface& surface, const Seam_options& options = {}, const Seams& seams = {})
{
  Cut_report report;
  Cut cut = cut_to_disk(surface, seams, options, report);
  return {std::move(cut), report};
}

Seam_options shortest()
{
  Seam_options options;
  options.mode = Cut_mode::SHORTEST;
  return options;
}

/// the stretch of the opened surface when its corners are searched and its map is minimised as that to be delivered
double searched_stretch(const Triangle_surface& surface, const Cut& cut, double balance = Seam_options().balance,
                        std::optional<double> aspect = 1, bool moves_corners = true)
{
  Balanced_minimization minimization;
  minimization.balance = balance;
  minimization.aspect = aspect;
  const Patch patch = patch_of_cut(surface, cut);
  Square_search_options options;
  options.moves_corners = moves_corners;
  return search_square_map(patch, *make_minimizer(patch, minimization), Bracketing_corner_search(), options)
      .map.report.l2;
}

std::string refusal(const Triangle_surface& surface, const Seams& seams)
{
  try {
    decide(surface, {}, seams);
  } catch(const Unmappable& error) {
    return error.what();
  }
  return "not refused";
}

bool contains(const Triangle_surface& surface, const Cut& cut, const std::array<int, 2>& seam)
{
  for(int e : cut.edges())
    if(surface.edges[e] == seam || surface.edges[e] == std::array<int, 2>{seam[1], seam[0]})
      return true;
  return false;
}

} // namespace

TEST_CASE("every surface is cut to a disk by the short and by the best cut")
{
  for(const Named_mesh& named : many_surfaces()) {
    INFO(named.name);
    const Triangle_surface surface = surface_of(named.mesh);
    for(const Seam_options& options : {Seam_options(), shortest()}) {
      const Decision decision = decide(surface, options);
      CHECK(opened_surface(surface, decision.cut).is_disk());
      CHECK(decision.report.seam_edges == decision.cut.edges().size());
      CHECK(decision.report.cut_length == Approx(decision.cut.length(surface) / std::sqrt(surface.area)));
    }
  }
}

TEST_CASE("a disk is left alone")
{
  const Decision decision = decide(surface_of(plane(6, 3)));
  CHECK(decision.cut.edges().empty());
  CHECK(decision.report.cut_length == 0);
  CHECK(decision.report.history.empty());
}

TEST_CASE("the best cut is better than a short one, and the history and the front tell how it was found")
{
  for(const Closed_mesh& mesh : {ellipsoid(3, 4), torus(16, 9), with_holes(ellipsoid(3), 3, 5)}) {
    const Triangle_surface surface = surface_of(mesh);
    const Decision decision = decide(surface);
    const auto& history = decision.report.history;
    REQUIRE(!history.empty());
    CHECK(history.front().kind == Cut_step::INITIAL);
    for(const Cut_step& step : history)
      CHECK(step.score == Approx(step.stretch + 0.05 * step.length));
    CHECK(decision.report.score == Approx(decision.report.stretch + 0.05 * decision.report.cut_length));
    const double searched = searched_stretch(surface, decision.cut);
    CHECK(decision.report.stretch > 0.995 * searched);
    CHECK(decision.report.stretch < 1.03 * searched); // without a rival, of eight choices of corners
    const Decision short_one = decide(surface, shortest());
    CHECK(std::isinf(short_one.report.score));
    CHECK(short_one.report.front.empty());
    CHECK(searched + 0.05 * decision.report.cut_length <=
          1.005 * (searched_stretch(surface, short_one.cut) + 0.05 * short_one.report.cut_length));
  }
}

TEST_CASE("the front falls, is convex, and has the cut that is taken as its best one at the weight wanted")
{
  const Triangle_surface surface = surface_of(ellipsoid(3, 4));
  for(double weight : {0., 0.0125, 0.05, 0.07, 0.2, 1.}) {
    INFO(weight);
    Seam_options options;
    options.cut_weight = weight;
    const Cut_report report = decide(surface, options).report;
    const std::vector<Cut_choice>& front = report.front;
    REQUIRE(!front.empty());
    double best = std::numeric_limits<double>::infinity();
    for(std::size_t i = 0; i < front.size(); ++i) {
      best = (std::min)(best, front[i].stretch + weight * front[i].length);
      if(i > 0) {
        CHECK(front[i].length > front[i - 1].length);
        CHECK(front[i].stretch < front[i - 1].stretch);
      }
      if(i > 1)
        CHECK((front[i - 1].stretch - front[i - 2].stretch) * (front[i].length - front[i - 1].length) <
              (front[i].stretch - front[i - 1].stretch) * (front[i - 1].length - front[i - 2].length));
    }
    CHECK(report.score == Approx(best));
  }
}

TEST_CASE("the cut for a weight is not beaten there by the cut for another")
{
  for(const Closed_mesh& mesh : {ellipsoid(3, 4), torus(24, 10), with_holes(ellipsoid(3), 3, 5)}) {
    const Triangle_surface surface = surface_of(mesh);
    const std::vector<double> weights{0.0125, 0.05, 0.2};
    std::vector<Cut_report> reports;
    for(double weight : weights) {
      Seam_options options;
      options.cut_weight = weight;
      reports.push_back(decide(surface, options).report);
    }
    for(std::size_t i = 0; i < weights.size(); ++i)
      for(const Cut_report& other : reports)
        CHECK(reports[i].score <= 1.003 * (other.stretch + weights[i] * other.cut_length));
  }
}

TEST_CASE("the last few cuts are judged by a search of their corners, which move where they may")
{
  for(const Closed_mesh& mesh : {ellipsoid(3, 4), torus(24, 10)})
    for(bool moves_corners : {false, true}) {
      INFO(moves_corners);
      const Triangle_surface surface = surface_of(mesh);
      Seam_options options;
      options.moves_corners = moves_corners;
      const Decision decision = decide(surface, options);
      REQUIRE(decision.report.decision_faces == surface.triangles.size());
      REQUIRE(decision.report.front.size() > 1);
      const double searched = searched_stretch(surface, decision.cut, options.balance, options.aspect, moves_corners);
      // the eight choices of a score may beat the quarter of the border
      CHECK(decision.report.stretch <= 1.001 * searched);
      CHECK(decision.report.stretch > 0.99 * searched);
    }
}

TEST_CASE("no more cuts are judged than a few, the best by their scores")
{
  const Triangle_surface surface = surface_of(ellipsoid(3, 4));
  const Cut first = decide(surface, shortest()).cut;
  Cut_score_options options;
  options.numbers.far_from_best = 100; // so that none is left out for its score
  const double unjudged = 9, weight = 0.05;
  std::vector<Scored_cut> cuts;
  for(int i = 0; i < 6; ++i) {
    Cut cut = first;
    if(i > 0)
      extend_cut(surface, i * surface.number_of_vertices() / 6, cut);
    cuts.push_back({cut, Cut_step::INITIAL, -1});
    cuts.back().score.length = double((i + 3) % 6); // the first is the fourth by its score
    cuts.back().score.stretch = unjudged;
  }
  Cut_progress progress(nullptr);
  judge_cuts(surface, weight, options, Thread_team::current(), progress, cuts);
  REQUIRE(cuts.size() == 6);
  int judged = 0;
  for(const Scored_cut& cut : cuts) {
    const bool is_judged = cut.score.stretch < unjudged;
    CHECK(is_judged == (cut.score.length < 2.5));
    judged += is_judged ? 1 : 0;
  }
  CHECK(judged == 3);
}

TEST_CASE("a cut is judged on the rectangle that is wanted")
{
  // cut along its equator twice as long as the shortest way, a long spindle unfolds to a strip
  const Triangle_surface surface = surface_of(ellipsoid(3, 8));
  Seam_options square, rectangle;
  rectangle.aspect = std::nullopt;
  const Decision on_square = decide(surface, square), on_rectangle = decide(surface, rectangle);
  const auto worth = [&](const Decision& decision) {
    return searched_stretch(surface, decision.cut, 0.3, std::nullopt) + 0.05 * decision.report.cut_length;
  };
  CHECK(on_rectangle.report.score < on_square.report.score - 0.05);
  CHECK(worth(on_rectangle) <= 1.003 * worth(on_square));
  CHECK(on_rectangle.report.stretch > 0.995 * searched_stretch(surface, on_rectangle.cut, 0.3, std::nullopt));
}

TEST_CASE("the cut for the best rectangle is not beaten there by the cut for the square")
{
  for(const Closed_mesh& mesh : {ellipsoid(2, 3), ellipsoid(3, 3), torus(12, 8)}) {
    const Triangle_surface surface = surface_of(mesh);
    Seam_options square, rectangle;
    rectangle.aspect = std::nullopt;
    CHECK(decide(surface, rectangle).report.score <= decide(surface, square).report.score);
  }
}

TEST_CASE("a longer cut of an elongated sphere leaves less stretch, and a heavier weight a shorter cut")
{
  const Triangle_surface surface = surface_of(ellipsoid(3));
  Seam_options light, heavy;
  light.cut_weight = 0.001;
  heavy.cut_weight = 1;
  const Decision long_cut = decide(surface, light), short_cut = decide(surface, heavy);
  CHECK(long_cut.report.cut_length > short_cut.report.cut_length);
  CHECK(long_cut.report.stretch < short_cut.report.stretch);
}

TEST_CASE("no cut is extended beyond the greatest length")
{
  const Triangle_surface surface = surface_of(ellipsoid(3));
  Seam_options options;
  options.cut_weight = 0;
  const double free_length = decide(surface, options).report.cut_length;
  options.max_cut_length = 0.8 * free_length;
  CHECK(decide(surface, options).report.cut_length <= options.max_cut_length);
}

TEST_CASE("a sphere with a small hole is cut where that is asked for, as well as by any one path from the hole")
{
  const Triangle_surface surface = surface_of(without_triangles(ellipsoid(2), {7}));
  REQUIRE(surface.is_disk());
  const auto score_of = [&](const Cut& cut) {
    return searched_stretch(surface, cut, 0.3) + 0.05 * cut.length(surface) / std::sqrt(surface.area);
  };
  const double whole = score_of(Cut(surface));
  double best = whole;
  for(int v = 0; v < surface.number_of_vertices(); v += 3) {
    if(surface.is_border_vertex[v])
      continue;
    Cut path(surface);
    extend_cut(surface, v, path);
    best = (std::min)(best, score_of(path));
  }
  REQUIRE(best < whole - 0.1);

  Seam_options options;
  options.cuts_disk = true;
  const Decision decision = decide(surface, options);
  CHECK(opened_surface(surface, decision.cut).is_disk());
  CHECK(score_of(decision.cut) <= 1.005 * best);
  Seam_options bounded = options, costly = options, without = options, short_one = options;
  bounded.max_cut_length = 0.8 * decision.report.cut_length;
  const Decision shorter = decide(surface, bounded);
  CHECK(shorter.report.cut_length <= bounded.max_cut_length);
  CHECK(score_of(shorter.cut) < whole);
  costly.cut_weight = 100;
  without.mode = Cut_mode::NONE;
  short_one.mode = Cut_mode::SHORTEST;
  for(const Seam_options& hindering : {costly, without, short_one})
    CHECK(decide(surface, hindering).cut.edges().empty());
}

TEST_CASE("a disk stays whole when no cut pays, and otherwise the cut is lifted from a simple copy")
{
  Seam_options options;
  options.cuts_disk = true;
  const Flat_mesh half = hemisphere();
  for(const Closed_mesh& mesh : {plane(12, 1), plane(60, 1), Closed_mesh{half.points, half.triangles}}) {
    const Triangle_surface surface = surface_of(mesh);
    const Decision decision = decide(surface, options);
    CHECK(decision.cut.edges().empty());
    CHECK(decision.report.cut_length == 0);
    CHECK(decision.report.score == Approx(searched_stretch(surface, decision.cut, 0.3)).epsilon(0.01));
  }
  const Triangle_surface surface = surface_of(without_triangles(ellipsoid(5), {7}));
  const Decision decision = decide(surface, options);
  CHECK(decision.report.decision_faces < surface.triangles.size());
  CHECK(opened_surface(surface, decision.cut).is_disk());
  CHECK(searched_stretch(surface, decision.cut, 0.3) + 0.05 * decision.report.cut_length <
        searched_stretch(surface, Cut(surface), 0.3) - 0.1);
}

TEST_CASE("the decision is the same for any number of threads")
{
  for(const Closed_mesh& mesh : {with_holes(torus(20, 12), 2, 9), ellipsoid(4, 3)}) {
    const Triangle_surface surface = surface_of(mesh);
    Seam_options options;
    options.number_of_threads = 1;
    const Decision one = decide(surface, options);
    for(unsigned int threads : {2, 5, 0}) {
      options.number_of_threads = threads;
      const Decision other = decide(surface, options);
      CHECK(other.cut.edges() == one.cut.edges());
      CHECK(other.report.score == one.report.score);
      REQUIRE(other.report.history.size() == one.report.history.size());
      for(std::size_t i = 0; i < one.report.history.size(); ++i)
        CHECK(other.report.history[i].score == one.report.history[i].score);
    }
  }
}

TEST_CASE("the quick score knows the stretch that long parts end with")
{
  // both halves of a spindle stick out of a short cut across its middle: fifty steps do not flatten them
  const Triangle_surface surface = surface_of(ellipsoid(4, 16));
  Cut cut(surface);
  insert_path(surface, shortest_paths(surface, {0}), 1, cut); // these are opposite each other on the equator
  REQUIRE(opened_surface(surface, cut).is_disk());
  Cut_score_options options;
  options.balance = 0;
  CHECK(score_cut(surface, cut, options).stretch < 1.02 * searched_stretch(surface, cut, options.balance));
}

TEST_CASE("a quick score that is not done after its steps gives way to a map from coarse to fine")
{
  const Triangle_surface surface = surface_of(ellipsoid(5, 128)); // a needle
  Cut cut(surface);
  insert_path(surface, shortest_paths(surface, {0}), 1, cut); // across the middle
  const Patch patch = patch_of_cut(surface, cut);
  Cut_score_options options;
  options.numbers.score_steps = 3;
  REQUIRE(quick_start(patch, spread_borders(patch, options.numbers.corner_candidates), options).uv.rows() > 0);
  const double searched = searched_stretch(surface, cut, options.balance);
  Cut_scoring rough(surface, cut, options, true);
  rough.lower(options.numbers.rough_score_tolerance);
  REQUIRE(rough.score().stretch > 1.3 * searched);
  const Cut_score score = score_cut(surface, cut, options);
  CHECK(score.stretch < 1.05 * searched); // of eight choices of corners, in three steps on each patch
  CHECK(score.work > rough.score().work);
}

TEST_CASE("a cut with a slow score has the right one")
{
  const Triangle_surface surface = surface_of(ellipsoid(3, 128));
  Seam_options options;
  options.cut_weight = 20; // the needle is to be cut across
  const Decision decision = decide(surface, options);
  CHECK(decision.report.cut_length < 0.1);
  // a score has eight choices of corners and few steps: it is above what a search finds, by a few percent
  const double searched = searched_stretch(surface, decision.cut, options.balance);
  CHECK(decision.report.stretch > 0.995 * searched);
  CHECK(decision.report.stretch < 1.05 * searched);
  CHECK(decision.report.score == Approx(decision.report.stretch + options.cut_weight * decision.report.cut_length));
}

TEST_CASE("where length counts for more than stretch, a sphere is cut along a few edges")
{
  const Triangle_surface surface = surface_of(ellipsoid(4, 128));
  Seam_options options;
  options.cut_weight = 20;
  const Decision decision = decide(surface, options);
  CHECK(decision.report.cut_length < 0.15);
}

TEST_CASE("short cuts have two edges, and leave a disk of a sphere however small")
{
  const Closed_mesh tetrahedron{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
  for(const Closed_mesh& mesh : {tetrahedron, ellipsoid(0), ellipsoid(3, 20)}) {
    const Triangle_surface surface = surface_of(mesh);
    const std::vector<Cut> cuts = short_cuts(surface);
    CHECK(cuts.size() == 3 * (std::min)(std::size_t(6), mesh.points.size()));
    for(const Cut& cut : cuts) {
      CHECK(cut.edges().size() == 2);
      CHECK(opened_surface(surface, cut).is_disk());
    }
  }
}

TEST_CASE("of the cuts that are carried over the best at an unusual weight comes first")
{
  const Triangle_surface surface = surface_of(ellipsoid(3, 20));
  Thread_team team(1);
  Cut_progress progress(nullptr);
  Cut_pool pool(surface, {}, 1e9, team, {}, progress);
  std::vector<Cut> cuts = rerouted_initial_cuts(surface, {}, team);
  for(const Cut& cut : short_cuts(surface))
    cuts.push_back(cut);
  pool.start(without_scores(cuts), 1000 * surface.number_of_vertices());
  REQUIRE(pool.best(20).cut.edges() != pool.best(0.05).cut.edges());
  CHECK(pool.selection(20).front().cut.edges() == pool.best(20).cut.edges());
}

TEST_CASE("a surface of many holes is cut and mapped, though the quick map of its score is lost in rounding")
{
  const Triangle_surface surface = surface_of(sieve(40, 1));
  const Decision decision = decide(surface);
  const Patch patch = patch_of_cut(surface, decision.cut);
  REQUIRE(quick_start(patch, spread_borders(patch, 1), {}).uv.rows() == 0);
  // the score is that of one map, before its corners are searched
  const double searched = searched_stretch(surface, decision.cut, Seam_options().balance);
  CHECK(decision.report.stretch >= searched);
  CHECK(decision.report.stretch <= 1.2 * searched);
  CHECK(decision.report.score == Approx(decision.report.stretch + 0.05 * decision.report.cut_length));
}

TEST_CASE("large surfaces are decided on by a simplified copy of the same topology")
{
  struct Case
  {
    Closed_mesh mesh;
    int genus, loops;
  };
  for(const Case& large :
      {Case{ellipsoid(5, 2), 0, 0}, Case{torus(90, 40), 1, 0}, Case{with_holes(torus(90, 40), 4, 3), 1, 4}}) {
    const Triangle_surface surface = surface_of(large.mesh);
    const auto simplified = simplified_copy(surface, 4000);
    REQUIRE(simplified);
    CHECK(simplified->genus() == large.genus);
    CHECK(static_cast<int>(simplified->border_loops.size()) == large.loops);
    CHECK(std::abs(simplified->number_of_faces() - 4000 - 12 * (2 * large.genus + large.loops)) < 100);
    CHECK(simplified->area == Approx(surface.area).epsilon(0.05));

    const Decision decision = decide(surface);
    CHECK(decision.report.decision_faces == simplified->triangles.size());
    CHECK(opened_surface(surface, decision.cut).is_disk());
    // the cut of the surface is like the one decided on
    const auto& front = decision.report.front;
    const auto taken = std::find_if(front.begin(), front.end(), [&decision](const Cut_choice& choice) {
      return choice.stretch == decision.report.stretch;
    });
    REQUIRE(taken != front.end());
    CHECK(decision.report.cut_length == Approx(taken->length).epsilon(0.15));
  }
}

TEST_CASE("seams that cut the surface to a disk are used as they are")
{
  const Triangle_surface surface = surface_of(ellipsoid(2));
  Cut cut(surface);
  initial_cut(surface, 7, cut);
  Seams seams;
  for(int e : cut.edges())
    seams.push_back({surface.edges[e][1], surface.edges[e][0]});
  CHECK(decide(surface, {}, seams).cut.edges() == cut.edges());
}

TEST_CASE("seams that do not suffice are completed")
{
  const Triangle_surface sphere = surface_of(ellipsoid(2));
  const Decision one_edge = decide(sphere, {}, {{sphere.edges[5]}});
  CHECK(contains(sphere, one_edge.cut, sphere.edges[5]));
  CHECK(one_edge.cut.edges().size() >= 2);
  CHECK(opened_surface(sphere, one_edge.cut).is_disk());

  // a meridian of a torus, and an edge elsewhere
  const Triangle_surface surface = surface_of(torus(16, 9));
  Seams seams{{8 * 9 + 3, 8 * 9 + 4}};
  for(int j = 0; j < 9; ++j)
    seams.push_back({j, (j + 1) % 9});
  const Decision decision = decide(surface, {}, seams);
  CHECK(opened_surface(surface, decision.cut).is_disk());
  for(const auto& seam : seams)
    CHECK(contains(surface, decision.cut, seam));
}

TEST_CASE("seams on a disk are cut, too")
{
  const Flat_mesh flat = rectangle(6, 6, 1, 1, 3);
  const Triangle_surface surface = surface_of({flat.points, flat.triangles});
  const Decision decision = decide(surface, {}, {{3 * 7 + 3, 3 * 7 + 4}});
  CHECK(contains(surface, decision.cut, {3 * 7 + 3, 3 * 7 + 4}));
  CHECK(opened_surface(surface, decision.cut).is_disk());
}

TEST_CASE("seams that make no sense are refused")
{
  const Triangle_surface surface = surface_of(tetrahedron());
  CHECK_THAT(refusal(surface, {{0, 1}, {1, 2}, {2, 0}}), Contains("2 pieces"));
  CHECK_THAT(refusal(surface_of(torus(9, 9)), {{0, 5}}), Contains("vertex 0 to vertex 5 is not an edge"));
}

TEST_CASE("what is no disk is refused when it is not to be cut")
{
  Seam_options options;
  options.mode = Cut_mode::NONE;
  CHECK_THROWS_AS(decide(surface_of(tetrahedron()), options), Unmappable);
  CHECK(decide(surface_of(plane(4, 1)), options).cut.edges().empty());
}

namespace {

struct Shares : Search_visitor
{
  void cut_progress(double share) override { shares.push_back(share); }
  std::vector<double> shares;
};

} // namespace

TEST_CASE("a visitor is told of the shares of the comparison of cuts that are done")
{
  for(unsigned int threads : {1u, 3u}) {
    Shares visitor;
    Seam_options options;
    options.visitor = &visitor;
    options.number_of_threads = threads;
    const Triangle_surface surface = surface_of(ellipsoid(3, 2));
    const Cut cut = decide(surface, options).cut;
    CHECK(cut.edges() == decide(surface).cut.edges());
    CHECK(visitor.shares.size() > 10);
    CHECK(visitor.shares.front() == 0);
    CHECK(visitor.shares.back() == 1);
    CHECK(std::is_sorted(visitor.shares.begin(), visitor.shares.end()));
    // most of it is told before the end
    CHECK(std::count_if(visitor.shares.begin(), visitor.shares.end(), [](double x) { return 0.1 < x && x < 0.9; }) > 5);
    visitor.shares.clear();
    options.mode = Cut_mode::SHORTEST;
    decide(surface, options);
    CHECK(visitor.shares.empty());
  }
}

TEST_CASE("cuts to begin with are scored as long as there is work left, and the first in any case")
{
  const Triangle_surface surface = surface_of(ellipsoid(3));
  const Cut_score_options scoring;
  std::vector<Cut> cuts;
  const auto paths = shortest_paths(surface, {0});
  for(int end : {20, 30, 40, 50, 60, 70, 80}) {
    cuts.emplace_back(surface);
    insert_path(surface, paths, end, cuts.back());
  }
  Thread_team team(2);
  Cut_progress progress(nullptr);
  const auto work_of = [&](std::size_t count, long most_work) {
    Cut_pool pool(surface, scoring, 1e9, team, {}, progress);
    pool.start(without_scores({cuts.begin(), cuts.begin() + count}), most_work);
    return pool.work();
  };
  const long all = work_of(cuts.size(), 1000 * surface.number_of_vertices());
  REQUIRE(work_of(1, 0) < all);
  CHECK(work_of(cuts.size(), 0) == work_of(1, 0));
  const long some = work_of(cuts.size(), (all + work_of(1, 0)) / 2);
  CHECK(work_of(1, 0) < some);
  CHECK(some < all);
}

TEST_CASE("where no time is left, cuts to begin with are compared by what they are worth on a simpler copy")
{
  const Triangle_surface surface = surface_of(ellipsoid(3));
  std::vector<Cut> cuts;
  const auto paths = shortest_paths(surface, {0});
  for(int end : {20, 30, 40}) {
    cuts.emplace_back(surface);
    insert_path(surface, paths, end, cuts.back());
  }
  Thread_team team(2);
  Cut_progress progress(nullptr);
  const auto start_too_late = [&](const std::vector<Scored_cut>& starts) {
    Cut_pool pool(surface, {}, 1e9, team, std::chrono::steady_clock::now(), progress);
    pool.start(starts, 1000 * surface.number_of_vertices());
    return pool;
  };
  std::vector<Scored_cut> starts = without_scores(cuts);
  const Cut_pool pool_of_first = start_too_late(starts);
  CHECK(pool_of_first.work() > 0);
  CHECK(pool_of_first.best(0.05).cut.edges() == cuts[0].edges()); // all that is known

  for(std::size_t i = 0; i < starts.size(); ++i)
    starts[i].score = {2 - 0.1 * double(i), 0.01 * double(i), 0};
  const Cut_pool pool = start_too_late(starts);
  CHECK(pool.work() == 0);
  CHECK(pool.best(0.05).cut.edges() == cuts[2].edges());
  const std::vector<Scored_cut> selection = pool.selection(0.05);
  REQUIRE(selection.size() == 1);
  CHECK(selection[0].cut.edges() == cuts[2].edges());
  CHECK(selection[0].score.stretch == 1.8);
}

TEST_CASE("a terminal with very many neighbors is moved to few of them")
{
  const Triangle_surface surface = surface_of(lids(100));
  Thread_team team(2);
  Cut_progress progress(nullptr);
  const auto work_of_growth = [&](int most_neighbors) {
    Cut_score_options scoring;
    scoring.numbers.most_neighbors = most_neighbors;
    Cut_pool pool(surface, scoring, 1e9, team, {}, progress);
    pool.start(without_scores(rerouted_initial_cuts(surface, scoring.numbers, team)), 0);
    Cut_history history(0.05);
    Cut_growth(pool, 0.05, 10000 * surface.number_of_vertices(), history)();
    return pool.work();
  };
  CHECK(2 * work_of_growth(Cut_numbers().most_neighbors) < work_of_growth(1000));
}

TEST_CASE("where no cut has a map, small steps of coarsening are tried for the first one alone")
{
  Flat_mesh tube = crumpled_tube(300, 2);
  for(std::size_t i = 0; i < tube.points.size(); ++i) // it ends in triangles too small for their maps to have digits
    tube.points[i] *= std::pow(0.9, double(i / 4));
  const Triangle_surface surface = surface_of(Closed_mesh{tube.points, tube.triangles});
  std::vector<Cut> cuts{Cut(surface), Cut(surface)};
  insert_path(surface, shortest_paths(surface, {0}), 40, cuts.back());
  const Cut_score_options options;
  const auto score = [&](std::size_t i, bool is_persistent) {
    return Cut_scoring(surface, cuts[i], options, is_persistent).score();
  };
  REQUIRE(std::isinf(score(0, true).stretch));
  REQUIRE(score(1, false).work < score(1, true).work);
  Thread_team team(1);
  Cut_progress progress(nullptr);
  Cut_pool pool(surface, options, 1e9, team, {}, progress);
  pool.start(without_scores(cuts), 1000 * surface.number_of_vertices());
  CHECK(pool.work() == score(0, true).work + score(1, false).work);
}

TEST_CASE("a cut is refined unless it leaves too much stretch, or a score costs more than the refinement may")
{
  const Triangle_surface surface = surface_of(ellipsoid(3));
  Thread_team team(1);
  const Cut cut = rerouted_initial_cuts(surface, {}, team).front();
  Cut_progress progress(nullptr);
  const auto is_refined = [&](const Cut_numbers& numbers, long most_work) {
    Cut_score_options scoring;
    scoring.numbers = numbers;
    Cut_pool pool(surface, scoring, 1e9, team, {}, progress);
    pool.start(without_scores({cut}), 0);
    const long work = pool.work();
    Cut_history history(0.05);
    Scored_cut best = pool.best(0.05);
    refine_cut(pool, 0.05, most_work, best, history);
    return pool.work() > work;
  };
  const long vertices = surface.number_of_vertices();
  CHECK(is_refined({}, 6 * vertices));
  Cut_numbers less_stretch;
  less_stretch.largest_refined_stretch = 1;
  CHECK_FALSE(is_refined(less_stretch, 6 * vertices));
  CHECK_FALSE(is_refined({}, vertices / 2));
}

TEST_CASE("cuts of a surface with many handles are not refined, unless the weight is an unusual one")
{
  const Triangle_surface surface = surface_of(torus(10, 10));
  REQUIRE(surface.genus() == 1);
  Thread_team team(1);
  const auto scores_with = [&](const Cut_numbers& numbers, double weight) {
    Shares visitor;
    Seam_options options;
    options.cut_weight = weight;
    options.visitor = &visitor;
    Cut_report report;
    search_cut(surface, options, team, report, numbers);
    return visitor.shares.size();
  };
  Cut_numbers enough, too_many, too_many_outside;
  enough.most_loops_refined = 2;
  too_many.most_loops_refined = too_many_outside.most_loops_refined = 1;
  too_many_outside.refinement_work_outside = 0;
  CHECK(scores_with(enough, 0.05) > scores_with(too_many, 0.05));
  CHECK(scores_with(too_many, 0.005) > scores_with(too_many_outside, 0.005));
}
