// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "mapped_patches.h"

#include <CGAL_ext/Square_parameterization/internal/sampling/locate_samples.h>
#include <CGAL_ext/Square_parameterization/internal/sampling/vertex_normals.h>

#include <catch2/catch.hpp>

#include <chrono>
#include <cmath>

using namespace CGAL_ext;
using namespace CGAL_ext::internal;

namespace {

/// the uv of a flat square are its own coordinates
Uv_coordinates flat_uv(const Flat_mesh& mesh)
{
  Uv_coordinates uv(mesh.points.size(), 2);
  for(std::size_t v = 0; v < mesh.points.size(); ++v)
    uv.row(v) = mesh.points[v].head<2>();
  return uv;
}

/// the uv of a located sample
Uv_point place_of(const Sample_location& location, const std::vector<std::array<int, 3>>& triangles,
                  const Uv_coordinates& uv)
{
  Uv_point place(0, 0);
  for(int k = 0; k < 3; ++k)
    place += location.weights[k] * uv.row(triangles[location.face][k]);
  return place;
}

/// the lowest face that contains a point, by asking all of them
int first_face_at(const Uv_point& p, const std::vector<std::array<int, 3>>& triangles, const Uv_coordinates& uv)
{
  for(std::size_t f = 0; f < triangles.size(); ++f) {
    const auto& t = triangles[f];
    if(orientation(uv.row(t[0]), uv.row(t[1]), p) >= 0 && orientation(uv.row(t[1]), uv.row(t[2]), p) >= 0 &&
       orientation(uv.row(t[2]), uv.row(t[0]), p) >= 0)
      return static_cast<int>(f);
  }
  return -1;
}

/// checks that each sample is in the face that brute force finds, and that its weights give its place
void check_locations(const std::vector<std::array<int, 3>>& triangles, const Uv_coordinates& uv, const Grid_size& grid)
{
  const auto locations = locate_samples(triangles, uv, grid);
  REQUIRE(locations.size() == grid.number_of_samples());
  std::size_t right_faces = 0, right_places = 0;
  for(int j = 0; j < grid.height; ++j)
    for(int i = 0; i < grid.width; ++i) {
      const Uv_point p(sample_coordinate(i, grid.width), sample_coordinate(j, grid.height));
      const Sample_location& location = locations[static_cast<std::size_t>(j) * grid.width + i];
      right_faces += location.face == first_face_at(p, triangles, uv);
      right_places += (place_of(location, triangles, uv) - p).norm() < 1e-14;
    }
  CHECK(right_faces == locations.size());
  CHECK(right_places == locations.size());
}

/// a fan of slivers round a point of the lower side, a strip above them that is 1e-13 high, and two triangles
void add_slivers(std::vector<std::array<int, 3>>& triangles, Uv_coordinates& uv)
{
  constexpr int STEPS = 20;
  uv.resize(2 * STEPS + 6, 2);
  uv.row(0) << 0, 0;
  uv.row(1) << 1, 0;
  uv.row(2) << 1, 1;
  uv.row(3) << 0, 1;
  for(int k = 0; k <= STEPS; ++k) { // on the right side, ever nearer to (1, 1)
    uv.row(4 + k) << 1, 1 - std::pow(0.25, k) / 2;
    if(k > 0)
      triangles.push_back({0, 3 + k, 4 + k});
  }
  triangles.push_back({0, 1, 4});
  triangles.push_back({0, 4 + STEPS, 2});
  triangles.push_back({0, 2, 3});
  uv.conservativeResize(5 + STEPS, 2);
}

} // namespace

TEST_CASE("a sample of a flat square is where it is")
{
  const Flat_mesh mesh = unit_square(9);
  for(const Grid_size& grid : {Grid_size{2, 2}, Grid_size{17, 33}, Grid_size{64, 10}})
    check_locations(mesh.triangles, flat_uv(mesh), grid);
}

TEST_CASE("samples on shared sides and at vertices belong to the first of their faces")
{
  Flat_mesh mesh = rectangle(8, 8, 1, 1, 1, 0); // a lattice: most samples lie on sides
  check_locations(mesh.triangles, flat_uv(mesh), {9, 17});
  std::reverse(mesh.triangles.begin(), mesh.triangles.end());
  check_locations(mesh.triangles, flat_uv(mesh), {9, 17});
}

TEST_CASE("slivers of all directions lose no sample")
{
  std::vector<std::array<int, 3>> triangles;
  Uv_coordinates uv;
  add_slivers(triangles, uv);
  for(int turn = 0; turn < 4; ++turn) {
    CAPTURE(turn);
    check_locations(triangles, uv, {65, 129});
    const Eigen::VectorXd u = uv.col(0);
    uv.col(0) = 1 - uv.col(1).array();
    uv.col(1) = u;
  }
}

TEST_CASE("samples of maps of curved patches")
{
  for(const Patch& patch : patches())
    check_locations(patch.triangles, some_map(patch), {31, 23});
}

TEST_CASE("samples on the border lie on it, and corners on corners, exactly")
{
  const Patch patch = make_patch_of(saddle(6));
  const Uv_coordinates uv = some_map(patch);
  const Grid_size grid{20, 30};
  const auto locations = locate_samples(patch.triangles, uv, grid);
  std::vector<bool> is_border(patch.points.size(), false);
  for(int v : patch.border)
    is_border[v] = true;
  for(int j = 0; j < grid.height; ++j)
    for(int i = 0; i < grid.width; ++i) {
      const bool is_on_u = i == 0 || i == grid.width - 1, is_on_v = j == 0 || j == grid.height - 1;
      if(!is_on_u && !is_on_v)
        continue;
      const Sample_location& location = locations[static_cast<std::size_t>(j) * grid.width + i];
      int corners = 0;
      for(int k = 0; k < 3; ++k)
        if(location.weights[k] > 0) {
          ++corners;
          CHECK(is_border[patch.triangles[location.face][k]]);
        }
      CHECK(corners <= (is_on_u && is_on_v ? 1 : 2));
    }
}

TEST_CASE("maps that are not one-to-one onto the square are refused, with the place")
{
  const Flat_mesh mesh = unit_square(4);
  Uv_coordinates uv = flat_uv(mesh);
  const Grid_size grid{9, 9};
  CHECK_THROWS_WITH(locate_samples(mesh.triangles, uv / 2, grid),
                    Catch::Matchers::Contains("sample (5, 0) lies in no"));
  uv.col(0) *= -1;
  CHECK_THROWS_WITH(locate_samples(mesh.triangles, uv, grid),
                    Catch::Matchers::Contains("face 0 is not counter-clockwise"));
  uv(3, 0) = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(locate_samples(mesh.triangles, uv, grid), Unmappable);
}

TEST_CASE("normals of a sphere point outwards, however it is split, and copies share them")
{
  const Flat_mesh mesh = hemisphere(20, 60);
  const auto normals = vertex_normals(mesh.points, mesh.triangles);
  double worst = 1;
  for(std::size_t v = 0; v < normals.size(); ++v) {
    CHECK(normals[v].norm() == Approx(1).epsilon(1e-12));
    worst = std::min(worst, std::abs(normals[v].dot(mesh.points[v].normalized())));
  }
  CHECK(worst > 0.99);
  for(double scale : {1e-200, 1e200}) {
    const auto scaled_normals = vertex_normals(scaled(mesh, scale).points, mesh.triangles);
    for(std::size_t v = 0; v < normals.size(); ++v)
      CHECK((scaled_normals[v] - normals[v]).norm() < 1e-9);
  }
  // a cube's corner: three faces with the same angle, one of them split in two
  const std::vector<Eigen::Vector3d> corner{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}, {0, 0, 0}};
  const std::vector<std::array<int, 3>> faces{{0, 1, 4}, {0, 4, 2}, {5, 2, 3}, {5, 3, 1}};
  const auto corner_normals = vertex_normals(corner, faces, {0, 1, 2, 3, 4, 0});
  CHECK((corner_normals[0] - Eigen::Vector3d(1, 1, 1).normalized()).norm() < 1e-15);
  CHECK(corner_normals[5] == corner_normals[0]);
}
