// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What a deadline ends: simplification, the comparison of cuts, sketches, candidates and minimizations. What is left then
// is a cut that makes a disk, and a map that is one-to-one, or none.

#include "closed_meshes.h"
#include "multilevel_cases.h"
#include "opened_surface.h"

#include <CGAL_ext/Square_parameterization/Bracketing_corner_search.h>
#include <CGAL_ext/Square_parameterization/internal/cut/cut_to_disk.h>
#include <CGAL_ext/Square_parameterization/internal/cut/rerouted_initial_cuts.h>
#include <CGAL_ext/Square_parameterization/internal/cut/search_cut.h>
#include <CGAL_ext/Square_parameterization/internal/cut/simplified_copy.h>
#include <CGAL_ext/Square_parameterization/internal/surface/decimate_surface.h>

#include <catch2/catch.hpp>

#include <chrono>

using namespace CGAL_ext;
using namespace CGAL_ext::internal;

namespace {

typedef std::chrono::steady_clock Clock;

Clock::time_point in_seconds(double seconds)
{
  return Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
}

double seconds_since(Clock::time_point start)
{
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// large enough for sketches
Patch large_patch()
{
  return patch_without_chords(plane(92, 1));
}

/// a user's search that sketches all candidates before it would map one, and dreams for a second after a few
struct Sketching_search
{
  Candidate_set candidate_set() const { return Candidate_set::FULL; }

  void operator()(const Corner_search_problem& problem) const
  {
    for(int candidate = 0; candidate < problem.number_of_candidates; ++candidate) {
      if(candidate == 8)
        std::this_thread::sleep_for(std::chrono::milliseconds(1100));
      sketched.emplace_back(problem.sketched_objective_of({candidate})[0], candidate);
    }
  }

  std::vector<std::pair<double, int>>& sketched;
};

Square_search_options one_thread(const Deadline& deadline)
{
  Square_search_options options;
  options.number_of_threads = 1;
  options.deadline = deadline;
  return options;
}

} // namespace

TEST_CASE("a score of a cut whose deadline has passed is that of a map that is left as it was begun")
{
  const Triangle_surface surface = surface_of(ellipsoid(4, 2));
  Thread_team team(1);
  const Cut cut = shortest_cut(surface, team);
  const auto score_by = [&](const Deadline& deadline) {
    Cut_score_options options;
    options.deadline = deadline;
    return score_cut(surface, cut, options);
  };
  const Cut_score least = score_by({}), in_time = score_by(in_seconds(3600)), too_late = score_by(in_seconds(-1));
  CHECK(in_time.stretch == least.stretch);
  CHECK(too_late.stretch > least.stretch);
  CHECK(std::isfinite(too_late.stretch));
  CHECK(too_late.length == least.length);
}

TEST_CASE("a minimization whose deadline has passed gives a one-to-one map, and one that is not yet the least")
{
  const Patch patch = patch_without_chords(without_triangles(ellipsoid(4, 2), {0}));
  const Uv_coordinates border = square_border_of(patch, 0);
  const std::vector<Minimization> minimizations{Balanced_minimization(), Stretch_minimization()};
  for(const Minimization& minimization : minimizations) {
    const auto in_time = make_minimizer(patch, minimization, in_seconds(3600)),
               too_late = make_minimizer(patch, minimization, in_seconds(-1)),
               without = make_minimizer(patch, minimization);
    const Minimized_map least = in_time->finish(in_time->make_worker()(border, nullptr));
    CHECK(least.uv == without->finish(without->make_worker()(border, nullptr)).uv); // not the time, but what is done
    CHECK(least.report.stop_reason != Stop_reason::DEADLINE);
    const Minimized_map map = too_late->finish(too_late->make_worker()(border, nullptr));
    REQUIRE(map.uv.rows() == patch.number_of_vertices());
    CHECK(number_of_flipped_faces(patch.triangles, map.uv) == 0);
    CHECK(map.report.stop_reason == Stop_reason::DEADLINE);
    CHECK(map.report.iterations == 0);
    CHECK(map.report.objective > least.report.objective);
    CHECK(std::isfinite(map.report.objective));
  }
}

TEST_CASE("a deadline ends a long search with the best map so far")
{
  const Patch patch = large_patch();
  REQUIRE(make_minimizer(patch, Balanced_minimization())->has_sketches());
  const auto start = Clock::now();
  const Square_search_options options = one_thread(in_seconds(1));
  const auto minimizer = make_minimizer(patch, Balanced_minimization(), options.deadline);
  const Search_outcome outcome = search_square_map(patch, *minimizer, Brute_force_corner_search(), options);
  CHECK(seconds_since(start) < 20); // all candidates take minutes
  CHECK(outcome.report.is_cancelled);
  CHECK(outcome.report.evaluations >= 1);
  CHECK(outcome.report.evaluations < patch.border.size());
  REQUIRE(outcome.report.best_candidate);
  CHECK(number_of_flipped_faces(patch.triangles, outcome.map.uv) == 0);
  CHECK(outcome.report.best_objective == outcome.map.report.objective);
}

TEST_CASE("a deadline that has passed before the search leaves no map")
{
  const Patch patch = large_patch();
  for(const Corner_search& search :
      {Corner_search(Bracketing_corner_search()), Corner_search(Brute_force_corner_search())}) {
    const Square_search_options options = one_thread(in_seconds(-1));
    const auto minimizer = make_minimizer(patch, Balanced_minimization(), options.deadline);
    const Search_outcome outcome = search_square_map(patch, *minimizer, search, options);
    CHECK(outcome.report.is_cancelled);
    CHECK(outcome.report.evaluations == 0);
    CHECK(outcome.report.sketches == 0);
    CHECK_FALSE(outcome.report.best_candidate);
    CHECK(outcome.map.uv.rows() == 0);
  }
}

TEST_CASE("sketches leave time for a map, and the best of them tells which")
{
  const Patch patch = large_patch();
  const auto minimizer = make_minimizer(patch, Balanced_minimization());
  REQUIRE(minimizer->has_sketches());
  std::vector<std::pair<double, int>> sketched;
  const Search_outcome outcome =
      search_square_map(patch, *minimizer, Sketching_search{sketched}, one_thread(in_seconds(2)));
  CHECK(outcome.report.is_cancelled);
  REQUIRE(outcome.report.evaluations == 1);
  CHECK(*outcome.report.best_candidate == std::min_element(sketched.begin(), sketched.end())->second);
  CHECK(number_of_flipped_faces(patch.triangles, outcome.map.uv) == 0);
}

TEST_CASE("a map with given corners whose deadline passes is marked")
{
  const Patch patch = patch_without_chords(without_triangles(ellipsoid(4, 2), {0}));
  const auto minimizer = make_minimizer(patch, Balanced_minimization(), in_seconds(-1));
  const int quarter = static_cast<int>(patch.border.size() / 4);
  Search_outcome outcome = map_with_corners(patch, *minimizer, {0, quarter, 2 * quarter, 3 * quarter});
  finish_map(*minimizer, nullptr, outcome);
  CHECK(outcome.report.is_cancelled);
  CHECK(outcome.report.best_candidate);
}

TEST_CASE("a deadline of long ago has parts that are over, too")
{
  const Deadline deadline = std::chrono::steady_clock::time_point::min();
  CHECK(part_way_to(deadline, 0.5) == deadline);
  CHECK_FALSE(part_way_to({}, 0.5));
}

TEST_CASE("a simplification whose deadline has passed gives nothing")
{
  const Triangle_surface surface = surface_of(ellipsoid(5));
  REQUIRE(surface.number_of_faces() > 5000);
  CHECK(decimate_surface(surface, 1000, in_seconds(3600)));
  CHECK_FALSE(decimate_surface(surface, 1000, in_seconds(-1)));
  CHECK_FALSE(simplified_copy(surface, 1000, {}, in_seconds(-1)));
}

TEST_CASE("a cut whose deadline has passed, or passes, makes a disk and is marked")
{
  for(double seconds : {-1., 0.001, 0.02, 0.2})
    for(const Closed_mesh& mesh : {ellipsoid(5, 3), ellipsoid(3, 3), torus(60, 40), plate_with_handles(5, 5)}) {
      const Triangle_surface surface = surface_of(mesh);
      INFO(surface.number_of_faces() << " faces, " << seconds << " s");
      Seam_options options;
      options.number_of_threads = 2;
      options.deadline = in_seconds(seconds);
      Cut_report report;
      const auto start = Clock::now();
      const Cut cut = cut_to_disk(surface, {}, options, report);
      CHECK(seconds_since(start) < 20);
      CHECK(opened_surface(surface, cut).is_disk());
      CHECK(report.seam_edges == cut.edges().size());
      if(seconds <= 0.001)
        CHECK(report.is_cancelled);
      if(seconds < 0)
        CHECK(report.history.empty()); // nothing was compared
    }
}

TEST_CASE("a disk that might be cut stays whole when there is no time to compare")
{
  Seam_options options;
  options.cuts_disk = true;
  options.deadline = in_seconds(-1);
  Cut_report report;
  CHECK(cut_to_disk(surface_of(plane(20, 1)), {}, options, report).edges().empty());
  CHECK(report.is_cancelled);
}
