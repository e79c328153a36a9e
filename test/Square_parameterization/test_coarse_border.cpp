// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "multilevel_cases.h"

#include <CGAL_ext/Square_parameterization/Balanced_minimization.h>
#include <CGAL_ext/Square_parameterization/internal/coarsening/insert_vertices.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/Multilevel_minimizer.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/make_minimizer.h>
#include <CGAL_ext/Square_parameterization/internal/patch/exact_orientation.h>

#include <catch2/catch.hpp>

#include <set>

using namespace CGAL_ext;
using namespace CGAL_ext::internal;

namespace {

/// a flat square of concentric rings, each with half as many vertices as the one around it: half of them are border.
/// The first border vertex is the corner (0, 0).
Patch square_of_rings(int border_vertices)
{
  Flat_mesh mesh;
  std::vector<int> outer;
  const double width = 8. / border_vertices; // of the first ring; the next are twice as wide
  for(int n = border_vertices; n >= 16; n /= 2) {
    const double inset = width * (double(border_vertices) / n - 1);
    std::vector<int> ring;
    for(int i = 0; i < n; ++i) {
      const double t = 4. * (i % (n / 4)) / n;
      const double corners[5][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}};
      const auto &from = corners[i / (n / 4)], &to = corners[i / (n / 4) + 1];
      const Eigen::Vector3d p(from[0] + t * (to[0] - from[0]), from[1] + t * (to[1] - from[1]), 0);
      ring.push_back(static_cast<int>(mesh.points.size()));
      mesh.points.push_back(p + 2 * inset * (Eigen::Vector3d(0.5, 0.5, 0) - p));
    }
    for(int i = 0; i < n && !outer.empty(); ++i) {
      const int a = ring[i], b = ring[(i + 1) % n];
      const int p = outer[2 * i], q = outer[2 * i + 1], r = outer[(2 * i + 2) % outer.size()];
      mesh.triangles.insert(mesh.triangles.end(), {{p, q, a}, {q, b, a}, {q, r, b}});
    }
    if(mesh.border.empty())
      mesh.border = ring;
    outer.swap(ring);
  }
  const int center = static_cast<int>(mesh.points.size());
  mesh.points.emplace_back(0.5, 0.5, 0);
  for(std::size_t i = 0; i < outer.size(); ++i)
    mesh.triangles.push_back({outer[i], outer[(i + 1) % outer.size()], center});
  return make_patch_of(mesh);
}

std::vector<Patch> patches_of_much_border()
{
  return {square_of_rings(2048), patch_without_chords(comb(50, 3))};
}

/// where on the border of the square a point is: 0 at (0, 0), 1 at (1, 0), 2 at (1, 1), 3 at (0, 1)
double place_on_border(const Eigen::RowVector2d& p)
{
  REQUIRE(is_on_unit_square(p));
  return p.y() == 0 && p.x() < 1   ? p.x()
         : p.x() == 1 && p.y() < 1 ? 1 + p.y()
         : p.y() == 1 && p.x() > 0 ? 3 - p.x()
                                   : 4 - p.y();
}

/// the places of the border vertices in the corners of the square
std::set<int> corners_of(const Uv_coordinates& border_uv)
{
  std::set<int> corners;
  for(Eigen::Index k = 0; k < border_uv.rows(); ++k)
    if(const double place = place_on_border(border_uv.row(k)); place == std::floor(place))
      corners.insert(static_cast<int>(k));
  return corners;
}

/// checks that the border goes once round the square, through its four corners
void check_border(const Uv_coordinates& border_uv)
{
  std::set<double> corners;
  int turns = 0;
  for(Eigen::Index k = 0; k < border_uv.rows(); ++k) {
    const double place = place_on_border(border_uv.row(k));
    const double next = place_on_border(border_uv.row((k + 1) % border_uv.rows()));
    CHECK(place != next);
    turns += next < place;
    if(place == std::floor(place))
      corners.insert(place);
  }
  CHECK(turns == 1);
  CHECK(corners == std::set<double>{0, 1, 2, 3});
}

/// the border with corners at the given places of the border loop
Uv_coordinates border_with_corners(const Patch& patch, const Corners& corners)
{
  return square_border(Border_walk(patch.border_lengths, Walk::COUNTER_CLOCKWISE), corners).uv;
}

} // namespace

TEST_CASE("a coarse patch with a coarse border is a disk without chords")
{
  for(const Patch& fine : patches_of_much_border())
    for(int target : {fine.number_of_vertices() / 2, 0}) {
      const Coarse_patch coarse = Patch_coarsener(fine, 0.05, false)(target);
      const Patch& patch = coarse.patch;
      CHECK(patch.number_of_vertices() + static_cast<int>(coarse.removals.size()) == fine.number_of_vertices());
      CHECK(patch.number_of_vertices() - static_cast<int>(patch.edges.size()) + patch.number_of_faces() == 1);
      CHECK(patch.chords.empty());
      CHECK(double(patch.border.size()) < 0.75 * double(fine.border.size()));
      CHECK(patch.border.size() >= 32);
      std::size_t k = 0;
      for(int v : patch.border) {
        while(k < fine.border.size() && fine.border[k] != coarse.fine_vertex[v])
          ++k;
        CHECK(k < fine.border.size());
      }
      std::set<std::array<int, 2>> sides;
      for(const auto& t : patch.triangles)
        for(int i = 0; i < 3; ++i)
          CHECK(sides.insert({t[i], t[(i + 1) % 3]}).second);
    }
}

TEST_CASE("the border stays as it is when asked to, and where it is short")
{
  const Patch comb_patch = patch_without_chords(comb(50, 3)), small = make_patch_of(unit_square(8));
  CHECK(Patch_coarsener(comb_patch)(0).patch.border.size() == comb_patch.border.size());
  CHECK(small.border.size() == 32);
  CHECK(Patch_coarsener(small, std::nullopt, false)(0).patch.border.size() == 32);
}

TEST_CASE("a vertex stands for each corner that a coarse border leaves out, and a vertex put back gets the corner back")
{
  for(const Patch& fine : patches_of_much_border()) {
    const Coarse_patch coarse = Patch_coarsener(fine, 0.05, false)(fine.number_of_vertices() / 2);
    int removed_corners = 0;
    for(int candidate : {0, 1, 2, 3, 50, 77}) {
      const Uv_coordinates border_uv = square_border_of(fine, candidate);
      const auto coarse_place = coarse_border(coarse, finest_border(border_uv));
      REQUIRE(coarse_place);
      const auto& [coarse_uv, corners, removed] = *coarse_place;
      CHECK(std::set<int>(corners.begin(), corners.end()) == corners_of(coarse_uv));
      removed_corners += static_cast<int>(removed.size());
      REQUIRE(coarse_uv.rows() == static_cast<Eigen::Index>(coarse.patch.border.size()));
      check_border(coarse_uv);
      Multilevel_minimizer::Workspace workspace;
      const Uv_coordinates map = Multilevel_minimizer(coarse.patch).minimize(coarse_uv, workspace).uv;
      REQUIRE(number_of_flipped_faces(coarse.patch.triangles, map) == 0);
      const auto uv = insert_vertices(fine, coarse, map, removed, 0.3);
      REQUIRE(uv);
      CHECK(number_of_flipped_faces(fine.triangles, *uv) == 0);
      const Uv_coordinates border = border_coordinates(fine, *uv);
      check_border(border);
      for(Eigen::Index k = 0; k < border.rows(); ++k)
        if(place_on_border(border_uv.row(k)) == std::floor(place_on_border(border_uv.row(k))))
          CHECK(border.row(k) == border_uv.row(k));
    }
    CHECK(removed_corners > 2);
  }
}

TEST_CASE("where two corners fall into one vertex there is no coarse border, and the patch is mapped all the same")
{
  const Patch fine = patch_without_chords(comb(50, 3));
  const int size = static_cast<int>(fine.border.size());
  const Coarse_patch coarse = Patch_coarsener(fine, 0.05, false)(fine.number_of_vertices() / 2);
  const auto removal = std::find_if(coarse.removals.begin(), coarse.removals.end(),
                                    [](const Coarse_patch::Removal& r) { return r.is_on_border(); });
  REQUIRE(removal != coarse.removals.end());
  const auto place = [&fine](int v) {
    return static_cast<int>(std::find(fine.border.begin(), fine.border.end(), v) - fine.border.begin());
  };
  const int a = place(removal->vertex), b = place(removal->target);
  const int first = (a + 1) % size == b ? a : b;
  const Uv_coordinates border_uv =
      border_with_corners(fine, {first, (first + 1) % size, (first + size / 3) % size, (first + 2 * size / 3) % size});
  CHECK_FALSE(coarse_border(coarse, finest_border(border_uv)));
  const Minimized_map map = make_minimizer(fine, Balanced_minimization())->make_worker()(border_uv, nullptr);
  REQUIRE(map.uv.rows() == fine.number_of_vertices());
  CHECK(number_of_flipped_faces(fine.triangles, map.uv) == 0);
  check_border(border_coordinates(fine, map.uv));
  CHECK(map.warm_start.rows() == 0); // its coarse patches are not those of other maps
}

TEST_CASE("a flat square, half of whose vertices are border, is mapped onto itself")
{
  const Patch patch = square_of_rings(2048);
  REQUIRE(patch.number_of_vertices() > 2000);
  Balanced_minimization options;
  options.search_tolerance = 1e-9;
  const Multilevel_minimizer minimizer(patch, options);
  CHECK_FALSE(minimizer.keeps_border());
  Multilevel_minimizer::Workspace workspace;
  const Minimized_map map = minimizer.minimize(border_with_corners(patch, {0, 512, 1024, 1536}), workspace);
  REQUIRE(map.uv.rows() == patch.number_of_vertices());
  CHECK(number_of_flipped_faces(patch.triangles, map.uv) == 0);
  CHECK(map.report.l2 == Approx(1).epsilon(1e-6));
}

TEST_CASE("a coarse border leads to the minimum that the minimizer alone finds")
{
  const Patch patch = square_of_rings(2048);
  Balanced_minimization options;
  options.search_tolerance = 1e-9;
  for(int candidate : {100, 333}) {
    const Uv_coordinates border_uv = square_border_of(patch, candidate);
    Multilevel_minimizer::Workspace workspace;
    const Minimized_map map = Multilevel_minimizer(patch, options).minimize(border_uv, workspace);
    Balanced_minimizer::Workspace alone_workspace;
    Stretch_iteration::Workspace iteration_workspace;
    Uv_coordinates start = start_of(patch).minimize(border_uv, 1, iteration_workspace).uv;
    const Minimized_map alone =
        Balanced_minimizer(patch, options).minimize({std::move(start), {}, {}}, 1e-9, alone_workspace);
    CHECK(map.report.objective == Approx(alone.report.objective).epsilon(1e-5));
    CHECK(map.report.objective > 1.3); // not the identity
  }
}

TEST_CASE("a border that slides on the square stays on any other curve, however much of it there is")
{
  const Patch patch = patch_without_chords(comb(50, 3));
  const Uv_coordinates circle = circular_border(patch.border_lengths, 1);
  const Minimized_map map = make_minimizer(patch, Balanced_minimization())->map_border(circle);
  REQUIRE(map.uv.rows() == patch.number_of_vertices());
  CHECK(number_of_flipped_faces(patch.triangles, map.uv) == 0);
  CHECK(border_coordinates(patch, map.uv) == circle);
}
