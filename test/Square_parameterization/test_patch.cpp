// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "make_patch_of.h"

#include <catch2/catch.hpp>

#include <limits>
#include <numeric>
#include <set>

namespace SMP = CGAL::Surface_mesh_parameterization;
using Catch::Matchers::Contains;
using namespace CGAL_ext::internal;

namespace {

double total_area(const Patch& patch)
{
  return std::accumulate(patch.shapes.begin(), patch.shapes.end(), 0.,
                         [](double sum, const auto& shape) { return sum + shape.area(); });
}

/// the error code with which the mesh is refused, and the message in `message`
SMP::Error_code refusal(const Flat_mesh& mesh, std::string& message)
{
  try {
    make_patch_of(mesh);
  } catch(const Unmappable& error) {
    message = error.what();
    return error.code();
  }
  message.clear();
  return SMP::OK;
}

} // namespace

TEST_CASE("a patch has area one and the shape of the mesh")
{
  const double scale = GENERATE(1e-300, 1e-8, 1., 1e8, 1e150, 1e300);
  const Flat_mesh mesh = scaled(noisy_height_field(6), scale);
  const Patch patch = make_patch_of(mesh);

  CHECK(total_area(patch) == Approx(1).epsilon(1e-14));
  CHECK(std::accumulate(patch.vertex_areas.begin(), patch.vertex_areas.end(), 0.) == Approx(3).epsilon(1e-14));

  const double ratio = (patch.points[1] - patch.points[0]).norm() / ((mesh.points[1] - mesh.points[0]) / scale).norm();
  for(std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    const auto& [a, b, c] = mesh.triangles[f];
    const auto length = [&](int v, int w) { return ratio * ((mesh.points[w] - mesh.points[v]) / scale).norm(); };
    const auto& shape = patch.shapes[f];
    CHECK(shape.x1 == Approx(length(a, b)).epsilon(1e-12));
    CHECK(std::hypot(shape.x2, shape.y2) == Approx(length(a, c)).epsilon(1e-12));
    CHECK(std::hypot(shape.x2 - shape.x1, shape.y2) == Approx(length(b, c)).epsilon(1e-12));
    CHECK(shape.y2 > 0);
  }
  for(std::size_t k = 0; k < mesh.border.size(); ++k) {
    const Eigen::Vector3d edge =
        patch.points[patch.border[(k + 1) % patch.border.size()]] - patch.points[patch.border[k]];
    CHECK(patch.border_lengths[k] == Approx(edge.norm()).epsilon(1e-12));
  }
}

TEST_CASE("a patch does not depend on where the mesh lies")
{
  const Flat_mesh mesh = saddle(5);
  const Patch here = make_patch_of(mesh), there = make_patch_of(translated(mesh, {1e3, -2e3, 3e3}));
  for(std::size_t f = 0; f < here.shapes.size(); ++f) {
    // a coordinate near 3e3 is rounded to 2e-13
    CHECK(there.shapes[f].x1 == Approx(here.shapes[f].x1).margin(1e-11));
    CHECK(there.shapes[f].x2 == Approx(here.shapes[f].x2).margin(1e-11));
    CHECK(there.shapes[f].y2 == Approx(here.shapes[f].y2).margin(1e-11));
  }
}

TEST_CASE("a patch numbers its edges")
{
  const Flat_mesh mesh = saddle(6);
  const Patch patch = make_patch_of(mesh);
  std::set<std::array<int, 2>> edges;
  for(const auto& t : mesh.triangles)
    for(int k = 0; k < 3; ++k)
      edges.insert({std::min(t[k], t[(k + 1) % 3]), std::max(t[k], t[(k + 1) % 3])});

  CHECK(std::vector<std::array<int, 2>>(edges.begin(), edges.end()) == patch.edges);
  for(std::size_t f = 0; f < mesh.triangles.size(); ++f)
    for(int k = 0; k < 3; ++k) {
      const auto& edge = patch.edges[patch.triangle_edges[f][k]];
      const int a = mesh.triangles[f][(k + 1) % 3], b = mesh.triangles[f][(k + 2) % 3];
      CHECK(edge == std::array<int, 2>{std::min(a, b), std::max(a, b)});
    }
  CHECK(patch.chords.empty());
}

TEST_CASE("a patch knows its chords")
{
  const std::vector<std::array<int, 2>> ears{{1, 2}, {4, 5}, {7, 8}, {10, 11}};
  CHECK(make_patch_of(fan_with_ears(12, 3)).chords == ears);
  // one row of cells: 5 inner rungs and 6 diagonals
  CHECK(make_patch_of(rectangle(6, 1, 6, 1, 1)).chords.size() == 11);
  CHECK(make_patch_of(flat_disk()).chords.empty());
}

TEST_CASE("a patch is refused with the place named")
{
  std::string message;
  Flat_mesh mesh = unit_square(4);
  SECTION("nothing is wrong")
  {
    CHECK(refusal(mesh, message) == SMP::OK);
  }
  SECTION("a coordinate that is not a number")
  {
    mesh.points[7].y() = GENERATE(std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity());
    CHECK(refusal(mesh, message) == SMP::ERROR_WRONG_PARAMETER);
    CHECK_THAT(message, Contains("vertex 7 "));
  }
  SECTION("all faces without area")
  {
    for(auto& p : mesh.points)
      p = {p.x(), 2 * p.x(), 3 * p.x()};
    CHECK(refusal(mesh, message) == SMP::ERROR_NO_1_TO_1_MAPPING);
    CHECK_THAT(message, Contains("none of its faces has an area"));
  }
  SECTION("a surface in one point")
  {
    for(auto& p : mesh.points)
      p = {1, 2, 3};
    CHECK(refusal(mesh, message) == SMP::ERROR_NO_1_TO_1_MAPPING);
    CHECK_THAT(message, Contains("no extent"));
  }
  SECTION("three border vertices")
  {
    mesh = polar_disk(2, 3, 1, [](double r, double t) { return Eigen::Vector3d(r * cos(t), r * sin(t), 0); });
    CHECK(refusal(mesh, message) == SMP::ERROR_BORDER_TOO_SHORT);
    CHECK_THAT(message, Contains("3 vertices"));
  }
  SECTION("no face")
  {
    CHECK(refusal({}, message) == SMP::ERROR_EMPTY_MESH);
    CHECK_THAT(message, Contains("no faces"));
  }
}

namespace {

/// squared lengths of the sides of a laid out triangle, side k opposite to corner k
std::array<double, 3> squared_sides(const Flat_triangle& t)
{
  return {(t.x2 - t.x1) * (t.x2 - t.x1) + t.y2 * t.y2, t.x2 * t.x2 + t.y2 * t.y2, t.x1 * t.x1};
}

} // namespace

TEST_CASE("a triangle without area is laid out with the least height over its longest side")
{
  const double h = 0.01;
  const std::vector<Eigen::Vector3d> points{{0, 0, 0}, {1, 0, 0}, {0.25, 0, 0}};
  std::array<int, 3> order{0, 1, 2};
  do { // whichever corner comes first
    std::array<Eigen::Vector3d, 3> q{points[order[0]], points[order[1]], points[order[2]]};
    const Flat_triangle shape = widened(q[0], q[1], q[2], h);
    CHECK(shape.x1 > 0);
    CHECK(shape.area() == Approx(h / 2));
    const auto sides = squared_sides(shape);
    for(int k = 0; k < 3; ++k) {
      const double base = (q[(k + 1) % 3] - q[(k + 2) % 3]).squaredNorm();
      CHECK(sides[k] == Approx(base == 1 ? 1 : base + h * h));
    }
  } while(std::next_permutation(order.begin(), order.end()));

  const Flat_triangle needle = widened(points[0], points[1], points[1], h); // two corners in one place
  CHECK(needle.area() == Approx(h / 2));
  CHECK(squared_sides(needle)[0] == Approx(h * h));
  const Flat_triangle dot = widened(points[1], points[1], points[1], h); // all three
  CHECK(dot.area() == Approx(h * h / 2));
  CHECK(squared_sides(dot)[1] == Approx(squared_sides(dot)[2]));
}

TEST_CASE("faces without area and border edges without length get the least length, points stay")
{
  Flat_mesh mesh = unit_square(4);
  const auto ends = [&](int k) { return std::make_pair(mesh.border[k], mesh.border[k + 1]); };
  mesh.points[ends(2).second] = mesh.points[ends(2).first];
  mesh.points[12] = mesh.points[13];
  const Patch patch = make_patch_of(mesh);
  CHECK(patch.degenerate_faces.size() == 3); // one at the border edge, two at the edge from 12 to 13
  CHECK(total_area(patch) == Approx(1));
  CHECK(patch.border_lengths[2] == LEAST_LENGTH);
  CHECK(patch.points[12] == patch.points[13]);
  const std::vector<Flat_triangle> given = shapes_as_given(patch);
  for(int f = 0; f < patch.number_of_faces(); ++f) {
    const bool is_degenerate = std::binary_search(patch.degenerate_faces.begin(), patch.degenerate_faces.end(), f);
    CHECK((given[f].area() == 0) == is_degenerate);
    const auto sides = squared_sides(patch.shapes[f]);
    const double longest = std::sqrt(*std::max_element(sides.begin(), sides.end()));
    if(is_degenerate)
      CHECK(2 * patch.shapes[f].area() / longest == Approx(LEAST_LENGTH).epsilon(1e-3));
    else
      CHECK(2 * patch.shapes[f].area() / longest > 10 * LEAST_LENGTH);
  }
}

TEST_CASE("faces without area count with less height on a border of more than 4000 vertices")
{
  Patch patch;
  patch.border.resize(4000);
  CHECK(widened_height(patch) == LEAST_LENGTH);
  patch.border.resize(40000);
  CHECK(widened_height(patch) == Approx(LEAST_LENGTH / 10));
}
