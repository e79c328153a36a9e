// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Two cuts that the decision hardly tells apart are both mapped.

#include "closed_meshes.h"
#include "opened_surface.h"

#include <CGAL_ext/Square_parameterization/Step_sampling_corner_search.h>
#include <CGAL_ext/Square_parameterization/internal/cut/cut_to_disk.h>
#include <CGAL_ext/Square_parameterization/internal/cut/search_cut.h>
#include <CGAL_ext/Square_parameterization/internal/pipeline/map_surface.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <chrono>
#include <vector>

using namespace CGAL_ext;
using namespace CGAL_ext::internal;

namespace {

/// a surface of which two cuts all but tie on its copy, and the second is better
Closed_mesh lens()
{
  return ellipsoid(5, 0.4);
}

std::vector<Decided_cut> decided_cuts(const Triangle_surface& surface)
{
  Cut_report report;
  return cuts_to_disk(surface, {}, {}, report);
}

struct Counting_visitor : Search_visitor
{
  void start_search(std::size_t) override { ++searches; }
  void end_minimization(const Minimization_report&) override { ++ends; }

  int searches = 0, ends = 0;
};

/// the report of the map of a mesh, cut along given edges or where it is decided
Square_map_report map_mesh(const Closed_mesh& mesh, const Square_map_settings& settings,
                           const Chosen_elements& chosen = {})
{
  Square_map_report report;
  map_surface(arrays_of(mesh), chosen, settings, report);
  return report;
}

/// the edges of a cut as seams that are given
Chosen_elements along(const Triangle_surface& surface, const Cut& cut)
{
  Chosen_elements chosen;
  for(int e : cut.edges())
    chosen.seams.push_back(surface.edges[e]);
  return chosen;
}

double score(const Square_map_report& report, double weight)
{
  return report.measures.l2 + weight * report.cut.cut_length;
}

} // namespace

TEST_CASE("of two cuts that all but tie both are mapped, and the better map is delivered")
{
  std::vector<bool> is_second_better;
  for(const Closed_mesh& mesh : {lens(), ellipsoid(5, 1.25)}) {
    const Triangle_surface surface = surface_of(mesh);
    const std::vector<Decided_cut> cuts = decided_cuts(surface);
    REQUIRE(cuts.size() == 2);
    CHECK(cuts[0].cut.edges() != cuts[1].cut.edges());
    CHECK(cuts[1].score >= cuts[0].score);
    CHECK(cuts[1].score <= 1.0017 * cuts[0].score);
    Counting_visitor visitor;
    Square_map_settings settings;
    settings.search_options.visitor = &visitor;
    const Square_map_report report = map_mesh(mesh, settings);
    CHECK(visitor.searches == 2);
    CHECK(visitor.ends == 1);
    std::vector<double> scores;
    for(const Decided_cut& decided : cuts) {
      CHECK(opened_surface(surface, decided.cut).is_disk());
      scores.push_back(score(map_mesh(mesh, {}, along(surface, decided.cut)), settings.cut.cut_weight));
    }
    CHECK(score(report, settings.cut.cut_weight) == Approx((std::min)(scores[0], scores[1])).epsilon(1e-12));
    const Decided_cut& taken = cuts[scores[1] < scores[0]];
    CHECK(report.cut.seam_edges == taken.cut.edges().size());
    CHECK(report.cut.score == taken.score);
    CHECK(report.cut.stretch == taken.stretch);
    is_second_better.push_back(scores[1] < scores[0]);
  }
  CHECK(is_second_better == std::vector<bool>{true, false});
}

TEST_CASE(
    "of two cuts that all but tie the first is mapped alone where another search is wanted, or the search is stopped")
{
  const Closed_mesh mesh = lens();
  const std::vector<Decided_cut> cuts = decided_cuts(surface_of(mesh));
  REQUIRE(cuts.size() == 2);
  const double first_score = cuts.front().score;
  REQUIRE(cuts.back().score != first_score);
  Counting_visitor of_sampling;
  Square_map_settings sampling;
  sampling.search = Step_sampling_corner_search(8);
  sampling.search_options.visitor = &of_sampling;
  CHECK(map_mesh(mesh, sampling).cut.score == first_score);
  CHECK(of_sampling.searches == 1);

  struct First_alone : Counting_visitor
  {
    void end_search(const Search_report&) override { is_over = true; }
    bool is_over = false;
  } visitor;
  Square_map_settings settings;
  settings.search_options.visitor = &visitor;
  settings.search_options.callback = [&visitor](double) { return !visitor.is_over; };
  const Square_map_report report = map_mesh(mesh, settings);
  CHECK(report.cut.score == first_score);
  CHECK(report.search.is_cancelled);
  CHECK(report.search.evaluations > 0);
  CHECK(visitor.searches == 2);

  Counting_visitor of_stopped;
  settings.search_options.visitor = &of_stopped;
  settings.search_options.callback = [](double) { return false; };
  CHECK_THROWS_AS(map_mesh(mesh, settings), Unmappable);
  CHECK(of_stopped.searches == 1);
}

TEST_CASE("of a surface that is too large for two maps the best cut alone is decided for")
{
  const Triangle_surface surface = surface_of(lens());
  Thread_team team(0);
  Cut_report report;
  const auto cuts_with = [&](int largest) {
    Cut_numbers numbers;
    numbers.largest_mapped_twice = largest;
    return search_cut(surface, Seam_options(), team, report, numbers);
  };
  const std::vector<Decided_cut> one = cuts_with(surface.number_of_faces() - 1);
  const std::vector<Decided_cut> two = cuts_with(surface.number_of_faces());
  REQUIRE(one.size() == 1);
  REQUIRE(two.size() == 2);
  CHECK(one.front().score >= two.front().score); // the second may be the shorter when it is carried over
}

TEST_CASE("when the time is over before the search the report has the cut")
{
  Square_map_settings settings;
  settings.search_options.deadline = std::chrono::steady_clock::now();
  Square_map_report report;
  CHECK_THROWS_AS(map_surface(arrays_of(ellipsoid(3, 3)), {}, settings, report), Unmappable);
  CHECK(report.search.is_cancelled);
  CHECK(report.cut.seam_edges > 0);
  CHECK(report.cut.cut_length > 0);
}
