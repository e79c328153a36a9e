// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "energy_by_definition.h"
#include "multilevel_cases.h"

#include <CGAL_ext/Square_parameterization/internal/coarsening/insert_vertices.h>
#include <CGAL_ext/Square_parameterization/internal/common/Thread_team.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/Multilevel_minimizer.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/make_minimizer.h>
#include <CGAL_ext/Square_parameterization/internal/patch/exact_orientation.h>
#include <CGAL_ext/Square_parameterization/internal/patch/point_in_kernel.h>
#include <CGAL_ext/Square_parameterization/internal/patch/vertices_along_curve.h>
#include <CGAL_ext/Square_parameterization/internal/pipeline/other_starts.h>

#include <CGAL/hilbert_sort.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <random>
#include <set>
#include <vector>

using namespace CGAL_ext;
using namespace CGAL_ext::internal;

namespace {

/// patches large enough for coarse ones
std::vector<Patch> large_patches()
{
  return {make_patch_of(saddle(30)), make_patch_of(cone(4, 20, 41)), make_patch_of(noisy_height_field(30)),
          make_patch_of(hemisphere(20, 40))};
}

} // namespace

TEST_CASE("vertices lie along the curve as CGAL sorts them, for any number of threads")
{
  std::mt19937 random(7);
  std::uniform_int_distribution<int> coordinate(0, 40); // many points have one in common, and some all three
  for(int size : {0, 1, 2, 3, 5, 7, 8, 9, 64, 5000}) {
    std::vector<Eigen::Vector3d> points;
    for(int i = 0; i < size; ++i)
      points.emplace_back(coordinate(random), coordinate(random), coordinate(random));
    std::vector<int> sorted(points.size());
    std::iota(sorted.begin(), sorted.end(), 0);
    CGAL::hilbert_sort(sorted.begin(), sorted.end(), Numbered_points_traits{{&points, 0}, {&points, 1}, {&points, 2}},
                       CGAL::Hilbert_sort_median_policy());
    for(unsigned int threads : {1u, 3u}) {
      Thread_team team(threads);
      const Thread_team::Scope scope(team);
      CHECK(vertices_along_curve(points) == sorted);
    }
  }
}

TEST_CASE("a coarse patch is a disk with the same border, and its vertices are among the fine ones")
{
  for(const Patch& fine : large_patches())
    for(const bool is_divided : {false, true}) {
      CAPTURE(fine.number_of_vertices(), is_divided);
      const int target = fine.number_of_vertices() / 2;
      const std::vector<int> curve = is_divided ? vertices_along_curve(fine.points) : std::vector<int>();
      const Coarse_patch coarse = Patch_coarsener(fine)(target, curve, 150);
      const Patch& patch = coarse.patch;
      CHECK(patch.number_of_vertices() == target);
      CHECK(patch.number_of_vertices() + static_cast<int>(coarse.removals.size()) == fine.number_of_vertices());
      CHECK(patch.number_of_vertices() - static_cast<int>(patch.edges.size()) + patch.number_of_faces() == 1);
      CHECK(patch.chords.size() == fine.chords.size());
      REQUIRE(patch.border.size() == fine.border.size());
      for(std::size_t k = 0; k < patch.border.size(); ++k)
        CHECK(coarse.fine_vertex[patch.border[k]] == fine.border[k]);
      std::set<std::array<int, 2>> sides;
      for(const auto& t : patch.triangles)
        for(int k = 0; k < 3; ++k)
          CHECK(sides.insert({t[k], t[(k + 1) % 3]}).second); // oriented, and no edge with three triangles
      std::set<int> left(coarse.fine_vertex.begin(), coarse.fine_vertex.end());
      CHECK(static_cast<int>(left.size()) == target);
      for(const auto& removal : coarse.removals)
        CHECK(left.count(removal.vertex) == 0);
    }
}

TEST_CASE("a patch that is made coarse in blocks loses edges as short as one that is made coarse as a whole")
{
  const auto length_of_edges = [](const Patch& patch) {
    double sum = 0;
    for(const auto& [a, b] : patch.edges)
      sum += (patch.points[a] - patch.points[b]).norm();
    return sum / double(patch.edges.size());
  };
  for(const Patch& fine : large_patches()) {
    const int target = fine.number_of_vertices() / 2;
    const Coarse_patch whole = Patch_coarsener(fine)(target);
    const Coarse_patch in_blocks = Patch_coarsener(fine)(target, vertices_along_curve(fine.points), 200);
    CHECK(in_blocks.fine_vertex != whole.fine_vertex);
    CHECK(length_of_edges(in_blocks.patch) == Approx(length_of_edges(whole.patch)).epsilon(0.02));
    // where the border gets coarse there are no blocks
    const Coarse_patch without_curve = Patch_coarsener(fine, std::nullopt, false)(target);
    const Coarse_patch with_curve =
        Patch_coarsener(fine, std::nullopt, false)(target, vertices_along_curve(fine.points), 200);
    CHECK(with_curve.rings == without_curve.rings);
    CHECK(
        Patch_coarsener(fine)(fine.number_of_vertices() + 1, vertices_along_curve(fine.points), 200).removals.empty());
  }
}

TEST_CASE("a patch without chords that need not keep its shape is made as coarse as a wheel")
{
  for(const Patch& fine :
      {make_patch_of(noisy_height_field(30)), make_patch_of(hemisphere(20, 40)), patch_without_chords(comb(18, 1))}) {
    const int wheel = static_cast<int>(fine.border.size()) + 1;
    CHECK(Patch_coarsener(fine)(wheel).patch.number_of_vertices() > wheel);
    const Coarse_patch coarse = Patch_coarsener(fine, std::nullopt)(wheel);
    CHECK(coarse.patch.number_of_vertices() == wheel);
    CHECK(coarse.patch.triangles.size() == fine.border.size());
    CHECK(coarse.patch.chords.empty());
  }
}

TEST_CASE("vertices on the rim of a large fan are put back in as few waves as asked for")
{
  constexpr int SPOKES = 200;
  Flat_mesh wheel;
  wheel.points.emplace_back(0, 0, 0);
  for(int ring : {1, 2})
    for(int i = 0; i < SPOKES; ++i) {
      const double angle =
          2 * 3.14159265358979 * std::pow(1.15, i - SPOKES); // short edges go first, one after the other
      wheel.points.emplace_back(ring * std::cos(angle), ring * std::sin(angle), 0);
    }
  for(int i = 0; i < SPOKES; ++i) {
    const int inner = 1 + i, next = 1 + (i + 1) % SPOKES, outer = inner + SPOKES, next_outer = next + SPOKES;
    wheel.triangles.push_back({0, inner, next});
    wheel.triangles.push_back({inner, outer, next});
    wheel.triangles.push_back({outer, next_outer, next});
    wheel.border.push_back(outer);
  }
  const Patch fine = make_patch_of(wheel);
  const int target = SPOKES + SPOKES / 2;
  CHECK(Patch_coarsener(fine, std::nullopt)(target).waves.size() > 10);
  const Coarse_patch coarse = Patch_coarsener(fine, std::nullopt, true, {6})(target);
  CHECK(coarse.waves.size() <= 6);
  CHECK(coarse.patch.number_of_vertices() == target);
}

TEST_CASE("vertices put back into any map without flips leave it without flips")
{
  for(const Patch& fine : large_patches()) {
    const Coarse_patch coarse = Patch_coarsener(fine)(fine.number_of_vertices() / 3);
    Stretch_iteration::Workspace workspace;
    for(int candidate : {0, 1, 5}) {
      const Uv_coordinates border = square_border_of(fine, candidate);
      const Uv_coordinates coarse_uv = start_of(coarse.patch).minimize(border, 1, workspace).uv;
      REQUIRE(number_of_flipped_faces(coarse.patch.triangles, coarse_uv) == 0);
      const auto uv = insert_vertices(fine, coarse, coarse_uv, {}, 0.3);
      REQUIRE(uv);
      CHECK(number_of_flipped_faces(fine.triangles, *uv) == 0);
      for(std::size_t v = 0; v < coarse.fine_vertex.size(); ++v)
        CHECK(uv->row(coarse.fine_vertex[v]) == coarse_uv.row(v));
    }
  }
}

TEST_CASE("the kernel of a polygon")
{
  const auto polygon = [](std::initializer_list<std::array<double, 2>> points) {
    std::vector<Eigen::RowVector2d> result;
    for(const auto& [u, v] : points)
      result.emplace_back(u, v);
    return result;
  };
  const auto square = point_in_kernel(polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}}));
  REQUIRE(square);
  CHECK((*square - Eigen::RowVector2d(0.5, 0.5)).norm() < 1e-15);
  // an L: only the square at its bend sees both arms
  const auto bend = point_in_kernel(polygon({{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}}));
  REQUIRE(bend);
  CHECK(bend->minCoeff() > 0);
  CHECK(bend->maxCoeff() < 1);
  // an U has no kernel
  CHECK_FALSE(point_in_kernel(polygon({{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}})));
}

TEST_CASE(
    "a line that cuts off a part of a convex polygon adds one corner at most, however rounding has moved the others")
{
  // points on one line, to which a degenerate map goes again and again, and three others: the ring of a vertex of a double
  // fan, where the number of corners doubled with every few sides until there were millions
  const std::vector<Eigen::RowVector2d> points{
      {0.57794526173655336, 0.370927796224507},   {0.56120360960505522, 0.33383501660205622},
      {0.56353927891859712, 0.33900992206763619}, {0.5604948695080969, 0.33226473309481463},
      {0.54978884678812467, 0.30854448504129439}, {0.55054983097592014, 0.31023052047867855},
      {0.57116352726326758, 0.35590219538776008}, {1, 0},
      {0.84224152402194952, 0.60291366022255466}, {0.33328924354761813, 0.55145108479321547}};
  const std::vector<int> ring{0, 1, 2, 3, 4, 5, 0, 6, 4, 5, 0, 1, 2, 3, 5, 0, 1, 2, 1, 2, 3, 5, 0, 1,
                              2, 3, 5, 0, 1, 2, 3, 4, 5, 0, 1, 2, 3, 5, 2, 3, 5, 0, 1, 2, 3, 7, 8, 9};
  Eigen::AlignedBox2d box;
  for(const Eigen::RowVector2d& p : points)
    box.extend(p.transpose());
  Convex_polygon polygon(box);
  for(std::size_t i = 0; i < ring.size(); ++i) {
    const std::size_t before = polygon.corners().size();
    polygon.cut_off(points[ring[i]], points[ring[(i + 1) % ring.size()]]);
    CHECK(polygon.corners().size() <= before + 1);
  }
}

TEST_CASE(
    "a patch of which all vertices are near the border is factored however large it is, another only while it is small")
{
  const auto flat_grid = [](int columns, int rows) {
    return make_patch_of(rectangle(columns, rows, columns, rows, 1));
  };
  constexpr int DEPTH = Minimizer_numbers::LARGEST_DEPTH_FACTORED;
  CHECK(is_near_border(flat_grid(20, 2 * DEPTH)));
  CHECK(is_near_border(flat_grid(20, 2 * DEPTH + 1)));
  CHECK_FALSE(is_near_border(flat_grid(20, 2 * DEPTH + 2)));
  const auto is_factored = [](const Patch& patch) {
    const Minimizer_levels levels(patch, Balanced_minimization(), true, {}, Coarsening::BY_HALVES);
    return levels.is_factored(0);
  };
  CHECK(is_factored(flat_grid(8000, 2)));        // 24003 vertices
  CHECK_FALSE(is_factored(flat_grid(154, 154))); // 24025
  CHECK(is_factored(flat_grid(100, 100)));
}

TEST_CASE(
    "a hopeless map may cost sweeps over the mesh, more of a small one, and no more than the steps on a delivered map")
{
  const auto check = [](int cells, const auto& expected) {
    const Patch patch = make_patch_of(rectangle(cells, cells, cells, cells, 1));
    const Minimizer_levels levels(patch, Balanced_minimization(), true, {}, Coarsening::BY_HALVES);
    CHECK(levels.most_hopeless_work() == expected(levels, patch.number_of_vertices()));
  };
  check(20, [](const Minimizer_levels&, long) { return Minimizer_numbers::LEAST_HOPELESS_WORK; });
  check(50, [](const Minimizer_levels&, long vertices) { return Minimizer_numbers::MOST_HOPELESS_SWEEPS * vertices; });
  check(100, [](const Minimizer_levels& levels, long) { return levels.most_final_work(); });
}

TEST_CASE("what the steps on a delivered map may cost grows more slowly than the mesh where the map is not hopeless")
{
  const auto check = [](int columns, int rows, long usual, long most) {
    const Patch patch = make_patch_of(rectangle(columns, rows, columns, rows, 1));
    const Minimizer_levels levels(patch, Balanced_minimization(), true, {}, Coarsening::BY_HALVES);
    CHECK(levels.usual_final_work() == usual);
    CHECK(levels.most_final_work() == most);
  };
  constexpr long SWEEPS = Minimizer_numbers::MOST_FINAL_SWEEPS, VERTICES = Minimizer_numbers::FINAL_VERTICES;
  constexpr long OF_SMALL = Minimizer_numbers::MOST_TIMES_FINAL_VERTICES * 1111;
  check(100, 10, SWEEPS * OF_SMALL, SWEEPS * OF_SMALL);
  check(100, 100, SWEEPS * VERTICES, SWEEPS * VERTICES);
  check(8000, 2, SWEEPS * VERTICES + Minimizer_numbers::MOST_FINAL_SWEEPS_OF_MORE * (24003 - VERTICES), SWEEPS * 24003);
}

TEST_CASE("coarse to fine ends where the minimizer alone ends")
{
  for(const Patch& patch : large_patches())
    for(bool is_sliding : {false, true}) {
      Balanced_minimization options;
      options.border = is_sliding ? Border_motion::SLIDING : Border_motion::FIXED;
      options.search_tolerance = options.tolerance = 1e-9;
      Multilevel_minimizer::Workspace workspace;
      const Multilevel_minimizer minimizer(patch, options);
      const Minimized_map map = minimizer.finish(minimizer.minimize(square_border_of(patch, 2), workspace));
      Stretch_iteration::Workspace iteration_workspace;
      Balanced_minimizer::Workspace alone_workspace;
      Uv_coordinates start = start_of(patch).minimize(square_border_of(patch, 2), 1, iteration_workspace).uv;
      const Minimized_map alone =
          Balanced_minimizer(patch, options).minimize({std::move(start), {}, {}}, 1e-9, alone_workspace);
      CHECK(number_of_flipped_faces(patch.triangles, map.uv) == 0);
      CHECK(map.report.objective == Approx(alone.report.objective).epsilon(1e-6));
      CHECK(map.report.objective == Approx(energy_by_definition(patch, map.uv, 0.3)).epsilon(1e-9));
    }
}

TEST_CASE("a workspace may be used for one border after the other, and the result does not depend on it")
{
  const Patch patch = make_patch_of(saddle(25));
  const Multilevel_minimizer minimizer(patch);
  Multilevel_minimizer::Workspace used, fresh;
  minimizer.minimize(square_border_of(patch, 7), used);
  CHECK(minimizer.minimize(square_border_of(patch, 3), used).uv ==
        minimizer.minimize(square_border_of(patch, 3), fresh).uv);
}

TEST_CASE("a map carried over to its own border is itself, and to another border has no flips")
{
  for(const Patch& patch : patches()) {
    const Uv_coordinates uv = some_map(patch);
    const Map_transport transport(patch);
    Map_transport::Workspace workspace;
    CHECK((transport(uv, square_border_of(patch, 1), workspace) - uv).cwiseAbs().maxCoeff() < 1e-10);
    const Uv_coordinates other = transport(uv, square_border_of(patch, 3), workspace);
    REQUIRE(other.rows() == uv.rows());
    CHECK(number_of_flipped_faces(patch.triangles, other) == 0);
    for(std::size_t k = 0; k < patch.border.size(); ++k)
      CHECK(other.row(patch.border[k]) == square_border_of(patch, 3).row(k));
  }
}

TEST_CASE("a border of a map that is shifted to its own corners is itself, and to others keeps its order on the sides")
{
  for(const Patch& patch : patches()) {
    const Uv_coordinates uv = some_map(patch);
    const Uv_coordinates own = shift_border(patch, uv, square_border_of(patch, 1));
    const Uv_coordinates aim = square_border_of(patch, 3), other = shift_border(patch, uv, aim);
    const int n = static_cast<int>(patch.border.size());
    double way = 0;
    for(int k = 0; k < n; ++k) {
      CHECK((own.row(k) - uv.row(patch.border[k])).norm() < 1e-15);
      CHECK(is_on_unit_square(other.row(k)));
      const double step = way_round_square(other.row((k + 1) % n)) - way_round_square(other.row(k));
      way += step < 0 ? step + 4 : step;
      if(way_round_square(aim.row(k)) == std::floor(way_round_square(aim.row(k))))
        CHECK(other.row(k) == aim.row(k)); // corners
    }
    CHECK(std::abs(way - 4) < 1e-12); // one round
  }
}

TEST_CASE("a warm start leads to the same minimum")
{
  const Patch patch = make_patch_of(saddle(40));
  Balanced_minimization options;
  options.search_tolerance = 1e-9;
  const Multilevel_minimizer minimizer(patch, options);
  Multilevel_minimizer::Workspace workspace;
  const Minimized_map neighbor = minimizer.minimize(square_border_of(patch, 4), workspace);
  REQUIRE(neighbor.warm_start.rows() > 0);
  CHECK(neighbor.warm_start.rows() <= 1000);
  const Minimized_map cold = minimizer.minimize(square_border_of(patch, 6), workspace);
  const Minimized_map warm = minimizer.minimize(square_border_of(patch, 6), workspace, &neighbor.warm_start);
  CHECK(warm.report.objective == Approx(cold.report.objective).epsilon(1e-6));
  CHECK(number_of_flipped_faces(patch.triangles, warm.uv) == 0);
}

TEST_CASE("coarse to fine has no flips at any balance, however early it is stopped")
{
  for(const Patch& patch : large_patches())
    for(double balance : {0., 0.01, 0.1, 0.3, 1.})
      for(unsigned int steps : {0u, 1u, 5u}) {
        Balanced_minimization options;
        options.balance = balance;
        options.maximum_iterations = steps;
        Multilevel_minimizer::Workspace workspace;
        const Minimized_map map = Multilevel_minimizer(patch, options).minimize(square_border_of(patch, 0), workspace);
        CHECK(number_of_flipped_faces(patch.triangles, map.uv) == 0);
      }
}

TEST_CASE("a mesh whose Tutte map has triangles of area below 1e-12 is mapped without flips, and converges")
{
  for(int rings : {40, 60}) { // ever longer protrusions
    const Patch patch = make_patch_of(cone(rings, rings, 16));
    Stretch_minimization tutte;
    tutte.weights = Uniform_weights();
    tutte.maximum_iterations = 0;
    Stretch_iteration::Workspace iteration_workspace;
    const Minimized_map hard =
        Stretch_iteration(patch, tutte).minimize(square_border_of(patch, 0), 1, iteration_workspace);
    double least_area = 1;
    for(const auto& t : patch.triangles)
      least_area = hard.uv.rows() > 0 ? (std::min)(least_area, twice_uv_area(hard.uv, t) / 2) : 0;
    INFO(rings << " rings, least area " << least_area);
    REQUIRE(least_area < 1e-12);
    Balanced_minimization options;
    options.search_tolerance = options.tolerance = 1e-6;
    Multilevel_minimizer::Workspace workspace;
    const Multilevel_minimizer minimizer(patch, options);
    const Minimized_map compared = minimizer.minimize(square_border_of(patch, 0), workspace);
    REQUIRE(compared.uv.rows() > 0);
    CHECK(compared.report.iterations <= Minimizer_numbers::SEARCH_ITERATIONS);
    const Minimized_map map = minimizer.finish(compared);
    CHECK(map.report.stop_reason == Stop_reason::CONVERGED);
    CHECK(number_of_flipped_faces(patch.triangles, map.uv) == 0);
  }
}

TEST_CASE("a patch with long teeth, whose first map is lost in rounding, is mapped without flips")
{
  for(unsigned int seed : {1, 2})
    for(bool is_sliding : {false, true}) {
      const Patch patch = patch_without_chords(comb(70, seed));
      const Uv_coordinates border = square_border_of(patch, 0);
      Stretch_iteration::Workspace iteration_workspace;
      REQUIRE(start_of(patch).minimize(border, 1, iteration_workspace).uv.rows() == 0);
      Balanced_minimization options;
      options.border = is_sliding ? Border_motion::SLIDING : Border_motion::FIXED;
      Multilevel_minimizer::Workspace workspace;
      const Minimized_map map = Multilevel_minimizer(patch, options).minimize(border, workspace);
      REQUIRE(map.uv.rows() == patch.number_of_vertices());
      CHECK(map.report.stop_reason == Stop_reason::CONVERGED);
      CHECK(number_of_flipped_faces(patch.triangles, map.uv) == 0);
    }
}

TEST_CASE("patches that are coarsened by eighths are four times as many, and lead to a map that is lost by halves")
{
  unsigned int lost = 0;
  for(unsigned int seed : {1, 2, 3, 4}) {
    const Patch patch = make_patch_of(crumpled_tube(150, seed));
    Patch_sequence halves(patch, false), eighths(patch, false, Coarsening::BY_EIGHTHS);
    halves.coarsen({std::nullopt});
    eighths.coarsen({std::nullopt});
    CHECK(eighths.size() > 3 * halves.size());
    for(std::size_t level = 1; level + 1 < eighths.size(); ++level)
      CHECK(eighths[level].number_of_vertices() >= 0.85 * eighths[level - 1].number_of_vertices() - 1);
    CHECK(eighths[eighths.size() - 1].number_of_vertices() <= 4 + Minimizer_numbers::COARSEST);

    Multilevel_minimizer::Workspace workspace, gradual_workspace;
    lost += Multilevel_minimizer(patch).minimize(square_border_of(patch, 0), workspace).uv.rows() == 0;
    const Minimized_map map = Multilevel_minimizer(patch, {}, true, {}, Coarsening::BY_EIGHTHS)
                                  .minimize(square_border_of(patch, 0), gradual_workspace);
    REQUIRE(map.uv.rows() == patch.number_of_vertices());
    CHECK(number_of_flipped_faces(patch.triangles, map.uv) == 0);
    CHECK(map.report.objective == Approx(energy_by_definition(patch, map.uv, 0.3)).epsilon(1e-6));
  }
  CHECK(lost > 0);
}

TEST_CASE("a hair with shorter edges at its tip is coarsened by eighths in few waves, and has a map then")
{
  constexpr int RINGS = 120;
  Flat_mesh hair = crumpled_tube(RINGS, 1);
  for(int i = 0; i < RINGS; ++i)
    for(int j = 0; j < 4; ++j) {
      const double radius = 1 - 0.9 * i / RINGS, angle = j * 3.14159265358979 / 2;
      hair.points[4 * i + j] = {radius * std::cos(angle), radius * std::sin(angle), 0.5 * i};
    }
  hair.points.back() = {0, 0, 0.5 * RINGS};
  const Patch patch = make_patch_of(hair);
  const auto most_waves = [&](Coarsening coarsening) {
    Patch_sequence patches(patch, false, coarsening);
    patches.coarsen({std::nullopt});
    std::size_t most = 0;
    for(std::size_t level = 1; level < patches.size(); ++level)
      most = (std::max)(most, patches.coarse(level).waves.size());
    return most;
  };
  CHECK(most_waves(Coarsening::BY_HALVES) > 100);
  CHECK(most_waves(Coarsening::BY_EIGHTHS) <= std::size_t(Minimizer_numbers::MOST_WAVES_OF_GRADUAL));
  const auto map_by = [&](Coarsening coarsening) {
    Multilevel_minimizer::Workspace workspace;
    return Multilevel_minimizer(patch, {}, true, {}, coarsening).minimize(square_border_of(patch, 0), workspace);
  };
  CHECK(map_by(Coarsening::BY_HALVES).uv.rows() == 0);
  const Minimized_map map = map_by(Coarsening::BY_EIGHTHS);
  REQUIRE(map.uv.rows() == patch.number_of_vertices());
  CHECK(number_of_flipped_faces(patch.triangles, map.uv) == 0);
}

TEST_CASE("where most vertices are on the border, patches that are coarsened by eighths get smaller, too")
{
  const Patch patch = make_patch_of(rectangle(200, 2, 100, 1, 5));
  Patch_sequence eighths(patch, false, Coarsening::BY_EIGHTHS);
  eighths.coarsen({std::nullopt});
  REQUIRE(eighths.size() > 4);
  for(std::size_t level = 1; level + 1 < eighths.size(); ++level) {
    const int before = eighths[level - 1].number_of_vertices();
    const int removable = before - static_cast<int>(patch.border.size());
    const int wanted = (std::min)(before / Minimizer_numbers::LARGEST_PART_KEPT, removable / 2);
    CHECK(before - eighths[level].number_of_vertices() >= Minimizer_numbers::LEAST_REMOVED * wanted);
  }
}

TEST_CASE("what leads to no map counts as work")
{
  unsigned int lost = 0;
  for(unsigned int seed : {1, 2, 3, 4}) {
    const Patch patch = make_patch_of(crumpled_tube(150, seed));
    const Minimized_map map =
        make_minimizer(patch, Balanced_minimization())->make_worker()(square_border_of(patch, 0), nullptr);
    CHECK(map.work > 10L * patch.number_of_vertices());
    lost += map.uv.rows() == 0;
  }
  CHECK(lost > 0);
}

TEST_CASE("the other starts have a fixed order, and each leads to a map, and the last three keep the border as it is")
{
  const Patch patch = make_patch_of(noisy_height_field(30));
  const Uv_coordinates border = square_border_of(patch, 0);
  std::vector<Map_start> sliding, fixed;
  for(const Other_start& start : other_starts(patch, {}, {})) {
    const Minimized_map map = start.make_minimizer()->make_worker()(border, nullptr);
    REQUIRE(map.uv.rows() == patch.number_of_vertices());
    CHECK(number_of_flipped_faces(patch.triangles, map.uv) == 0);
    double moved = 0;
    for(std::size_t k = 0; k < patch.border.size(); ++k)
      moved = (std::max)(moved, (map.uv.row(patch.border[k]) - border.row(k)).norm());
    (moved == 0 ? fixed : sliding).push_back(start.start);
    CHECK((moved == 0 || fixed.empty()));
  }
  CHECK(sliding == std::vector<Map_start>{Map_start::UNIFORM_WEIGHTS, Map_start::GRADUAL_COARSENING,
                                          Map_start::MEAN_VALUE_WEIGHTS, Map_start::GRADUAL_COARSENING_UNIFORM_WEIGHTS,
                                          Map_start::GRADUAL_COARSENING_MEAN_VALUE_WEIGHTS});
  CHECK(fixed == std::vector<Map_start>{Map_start::FIXED_BORDER_FIRST, Map_start::FIXED_BORDER_FIRST_UNIFORM_WEIGHTS,
                                        Map_start::FIXED_BORDER_FIRST_MEAN_VALUE_WEIGHTS});
  Balanced_minimization with_fixed_border;
  with_fixed_border.border = Border_motion::FIXED;
  CHECK(other_starts(patch, with_fixed_border, {}).size() == sliding.size());
  CHECK(other_starts(make_patch_of(unit_square(1)), {}, {}).size() == sliding.size()); // four corners cannot slide
}

TEST_CASE(
    "a map that stays above a limit is left on its way, and finished by another call, and one below it is finished")
{
  const Patch patch = make_patch_of(rectangle(8, 8, 150, 1, 1));
  Balanced_minimization options;
  options.search_tolerance = 0.1;
  options.tolerance = 1e-9;
  const auto minimizer = make_minimizer(patch, options);
  const Minimized_map map = minimizer->make_worker()(square_border_of(patch, 0), nullptr);
  const Minimized_map finished = minimizer->finish(map);
  const double energy = finished.report.objective;
  REQUIRE(energy < 0.99 * map.report.objective);
  const Minimized_map below = minimizer->finish(map, 2 * energy);
  CHECK(below.uv == finished.uv);
  const Minimized_map left = minimizer->finish(map, energy / 10);
  CHECK(left.report.iterations < finished.report.iterations);
  CHECK(number_of_flipped_faces(patch.triangles, left.uv) == 0);
  CHECK(left.report.objective > energy / 10);
  CHECK(minimizer->finish(left).report.objective == Approx(energy).epsilon(1e-6));
}
