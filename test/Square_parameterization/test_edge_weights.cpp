// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "make_patch_of.h"
#include "weight_cases.h"

#include <catch2/catch.hpp>

using namespace CGAL_ext;
using internal::Edge_weights;
using internal::Patch;

namespace {

std::vector<bool> interior_vertices(const Patch& patch)
{
  std::vector<bool> is_interior(patch.points.size(), true);
  for(int v : patch.border)
    is_interior[v] = false;
  return is_interior;
}

/// sum_j w_ij (p_j - p_i) at every vertex, in units of sum_j w_ij |p_j - p_i|
std::vector<double> imbalance(const Patch& patch, const Edge_weights& weights)
{
  std::vector<Eigen::Vector3d> sum(patch.points.size(), Eigen::Vector3d::Zero());
  std::vector<double> size(patch.points.size(), 0.);
  for(std::size_t e = 0; e < patch.edges.size(); ++e)
    for(int end = 0; end < 2; ++end) {
      const int i = patch.edges[e][end], j = patch.edges[e][1 - end];
      const Eigen::Vector3d term = weights.values[e][end] * (patch.points[j] - patch.points[i]);
      sum[i] += term;
      size[i] += term.norm();
    }
  std::vector<double> result;
  for(std::size_t v = 0; v < sum.size(); ++v)
    result.push_back(sum[v].norm() / size[v]);
  return result;
}

double angle_at(const Patch& patch, int at, int from, int to)
{
  const Eigen::Vector3d a = patch.points[from] - patch.points[at], b = patch.points[to] - patch.points[at];
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// for every edge and end: calls f(e, end, i, j, k) for each triangle ijk beside the edge ij
template <class Function>
void for_each_wing(const Patch& patch, Function f)
{
  for(std::size_t e = 0; e < patch.edges.size(); ++e)
    for(const auto& t : patch.triangles)
      for(int k = 0; k < 3; ++k) {
        const int a = t[(k + 1) % 3], b = t[(k + 2) % 3];
        if(std::min(a, b) != patch.edges[e][0] || std::max(a, b) != patch.edges[e][1])
          continue;
        f(e, 0, patch.edges[e][0], patch.edges[e][1], t[k]);
        f(e, 1, patch.edges[e][1], patch.edges[e][0], t[k]);
      }
}

/// one interior vertex, 0, at the tip of a spike: the directions of its four neighbors almost lie in a plane, in which
/// the last sector is as wide as the three others together. Flattened, it is (almost) pi wide.
Flat_mesh spike(double lift)
{
  Flat_mesh mesh;
  mesh.points.emplace_back(0, 0, 0);
  const double angles[] = {0, 0.3, 0.6, 0.9}, lengths[] = {1, 1.5, 0.8, 1.2}, heights[] = {0, 1, 1, 0};
  for(int k = 0; k < 4; ++k) {
    mesh.points.emplace_back(lengths[k] * std::cos(angles[k]), lengths[k] * std::sin(angles[k]), lift * heights[k]);
    mesh.triangles.push_back({0, 1 + k, 1 + (k + 1) % 4});
    mesh.border.push_back(1 + k);
  }
  return mesh;
}

} // namespace

TEST_CASE("weights with linear precision balance every interior vertex of a planar mesh")
{
  const std::vector<Flat_mesh> meshes{unit_square(9), flat_disk(), spiral(), long_strip()};
  for(const Weight_case& weight_case : weights_with_linear_precision()) {
    CAPTURE(weight_case.name);
    for(const Flat_mesh& mesh : meshes) {
      const Patch patch = make_patch_of(mesh);
      const std::vector<bool> is_interior = interior_vertices(patch);
      const std::vector<double> residual = imbalance(patch, weight_case.weights(patch));
      for(std::size_t v = 0; v < residual.size(); ++v)
        if(is_interior[v])
          CHECK(residual[v] < 1e-12);
    }
  }
}

TEST_CASE("weights that promise to be positive are, and those that claim symmetry have it")
{
  const std::vector<Flat_mesh> meshes{saddle(8),    cone(8),    hemisphere(), noisy_height_field(9),
                                      long_strip(), spike(0.1), spike(1e-9)};
  for(const Weight_case& weight_case : all_weights())
    for(const Flat_mesh& mesh : meshes) {
      CAPTURE(weight_case.name);
      const Patch patch = make_patch_of(mesh);
      const std::vector<bool> is_interior = interior_vertices(patch);
      const Edge_weights weights = weight_case.weights(patch);
      REQUIRE(weights.values.size() == patch.edges.size());
      for(std::size_t e = 0; e < patch.edges.size(); ++e) {
        for(int end = 0; end < 2; ++end) {
          CHECK(std::isfinite(weights.values[e][end]));
          if(weight_case.is_positive && is_interior[patch.edges[e][end]])
            CHECK(weights.values[e][end] > 0);
        }
        if(weights.is_symmetric)
          CHECK(weights.values[e][0] == weights.values[e][1]);
      }
    }
}

TEST_CASE("symmetry is claimed by the weights that have it")
{
  const Patch patch = make_patch_of(saddle(4));
  CHECK(Uniform_weights()(patch).is_symmetric);
  CHECK(Clamped_cotangent_weights()(patch).is_symmetric);
  CHECK(Blended_weights()(patch).is_symmetric);
  CHECK(Harmonic_weights()(patch).is_symmetric);
  CHECK(Symmetric_mean_value_weights()(patch).is_symmetric);
  CHECK_FALSE(Mean_value_weights()(patch).is_symmetric);
  CHECK_FALSE(Shape_preserving_weights()(patch).is_symmetric);
}

TEST_CASE("cotangent weights are half the sum of the cotangents of the opposite angles")
{
  const Patch patch = make_patch_of(noisy_height_field(6));
  std::vector<double> expected(patch.edges.size(), 0.);
  for_each_wing(patch, [&](std::size_t e, int end, int i, int j, int k) {
    expected[e] += end == 0 ? 0.5 / std::tan(angle_at(patch, k, i, j)) : 0;
  });
  const Edge_weights harmonic = Harmonic_weights()(patch), clamped = Clamped_cotangent_weights(0.3)(patch);
  for(std::size_t e = 0; e < expected.size(); ++e) {
    CHECK(harmonic.values[e][0] == Approx(expected[e]).margin(1e-12));
    CHECK(clamped.values[e][0] == Approx(std::max(0.3, expected[e])).margin(1e-12));
  }
}

TEST_CASE("mean value weights are the tangents of the half angles over the length")
{
  const Patch patch = make_patch_of(noisy_height_field(6));
  std::vector<std::array<double, 2>> expected(patch.edges.size(), {0, 0});
  for_each_wing(patch, [&](std::size_t e, int end, int i, int j, int k) {
    expected[e][end] += std::tan(angle_at(patch, i, j, k) / 2) / (patch.points[j] - patch.points[i]).norm();
  });
  const Edge_weights plain = Mean_value_weights()(patch), symmetric = Symmetric_mean_value_weights()(patch);
  for(std::size_t e = 0; e < expected.size(); ++e) {
    CHECK(plain.values[e][0] == Approx(expected[e][0]).epsilon(1e-12));
    CHECK(plain.values[e][1] == Approx(expected[e][1]).epsilon(1e-12));
    CHECK(symmetric.values[e][0] == Approx((expected[e][0] + expected[e][1]) / 2).epsilon(1e-12));
  }
}

TEST_CASE(
    "shape-preserving weights of a symmetric fan are equal, and on a quadrilateral they are those of its diagonals")
{
  using Average = Shape_preserving_weights::Average;
  const auto average = GENERATE(Average::PLAIN, Average::INVERSE_DISTANCE);
  const double height = GENERATE(0., 1., 30.); // a cone flattens to the same fan
  Flat_mesh fan;
  fan.points.emplace_back(0, 0, height);
  for(int k = 0; k < 6; ++k) {
    fan.points.emplace_back(std::cos(k * PI / 3), std::sin(k * PI / 3), 0);
    fan.triangles.push_back({0, 1 + k, 1 + (k + 1) % 6});
    fan.border.push_back(1 + k);
  }
  const Patch patch = make_patch_of(fan);
  const Edge_weights weights = Shape_preserving_weights(average)(patch);
  for(std::size_t e = 1; e < patch.edges.size(); ++e)
    if(patch.edges[e][0] == 0)
      CHECK(weights.values[e][0] == Approx(weights.values[0][0]).epsilon(1e-12));

  // neighbors on two lines through the centre: the centre divides each line, and each neighbor sees only its line
  Flat_mesh cross{{{0, 0, 0}, {3, 0, 0}, {0, 2, 0}, {-1, 0, 0}, {0, -4, 0}},
                  {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}},
                  {1, 2, 3, 4}};
  const Patch cross_patch = make_patch_of(cross);
  const Edge_weights of_cross = Shape_preserving_weights(average)(cross_patch);
  REQUIRE(cross_patch.edges[3] == std::array<int, 2>{0, 4});
  CHECK(of_cross.values[2][0] / of_cross.values[0][0] == Approx(3).epsilon(1e-9)); // right 3, left 1
  CHECK(of_cross.values[1][0] / of_cross.values[3][0] == Approx(2).epsilon(1e-9)); // up 2, down 4
}

TEST_CASE("shape-preserving weights are the mean of barycentric coordinates, by hand on a triangle")
{
  // three neighbors: all three see the same triangle, so that any average gives its barycentric coordinates
  Flat_mesh mesh{{{0, 0, 0}, {2, 0, 0}, {-1, 2, 0}, {-1, -1, 0}, {5, 5, 0}},
                 {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 4, 2}},
                 {1, 4, 2, 3}};
  using Average = Shape_preserving_weights::Average;
  const Patch patch = make_patch_of(mesh);
  const Edge_weights weights = Shape_preserving_weights(GENERATE(Average::PLAIN, Average::INVERSE_DISTANCE))(patch);
  // cross products of the two other neighbors: (-1,2)x(-1,-1) = 3, (-1,-1)x(2,0) = 2, (2,0)x(-1,2) = 4
  REQUIRE(patch.edges[2] == std::array<int, 2>{0, 3});
  CHECK(weights.values[0][0] / weights.values[1][0] == Approx(1.5).epsilon(1e-12));
  CHECK(weights.values[2][0] / weights.values[1][0] == Approx(2.).epsilon(1e-12));
}

TEST_CASE("the blend of cotangents and mean value coordinates lies between them on an equilateral mesh")
{
  // all interior angles are 60 degrees: cotangents and scaled mean value coordinates agree
  const Flat_mesh mesh = transformed(rectangle(8, 8, 8, 8, 1, 0), [](const Eigen::Vector3d& p) {
    return Eigen::Vector3d(p.x() + p.y() / 2, p.y() * std::sqrt(3) / 2, 0);
  });
  const Patch patch = make_patch_of(mesh);
  const Edge_weights cotangent = Harmonic_weights()(patch), almost = Blended_weights(1e-12)(patch);
  for(std::size_t e = 0; e < patch.edges.size(); ++e)
    CHECK(almost.values[e][0] == Approx(std::max(0., cotangent.values[e][0])).margin(1e-10));
}
