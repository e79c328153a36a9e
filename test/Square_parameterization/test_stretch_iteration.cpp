// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "make_patch_of.h"
#include "map_cases.h"
#include "reference_stretch.h"
#include "weight_cases.h"

#include <CGAL_ext/Square_parameterization/internal/iteration/Stretch_iteration.h>

#include <catch2/catch.hpp>

#include <limits>

using namespace CGAL_ext;
using namespace CGAL_ext::internal;

namespace {

/// the numbers of the iteration but for its weights
struct Numbers
{
  double eta = Stretch_minimization().eta;
  unsigned int patience = Stretch_minimization().patience;
  unsigned int maximum_iterations = Stretch_minimization().maximum_iterations;
};

Stretch_minimization minimization(const Edge_weights& weights, const Numbers& numbers)
{
  return {[weights](const Patch&) { return weights; }, numbers.eta, numbers.patience, numbers.maximum_iterations};
}

Minimized_map minimize(const Patch& patch, const Edge_weights& weights, const Numbers& numbers,
                       const Uv_coordinates& border_uv, double uv_area = 1)
{
  const Stretch_iteration iteration(patch, minimization(weights, numbers));
  Stretch_iteration::Workspace workspace;
  return iteration.minimize(border_uv, uv_area, workspace);
}

Minimized_map minimize(const Patch& patch, const Edge_weights& weights, const Numbers& numbers)
{
  return minimize(patch, weights, numbers, square_border_of(patch, 0));
}

/// the first iterate of least stretch
std::size_t first_minimum(const std::vector<double>& history)
{
  return std::min_element(history.begin(), history.end()) - history.begin();
}

std::vector<Flat_mesh> curved_meshes()
{
  return {saddle(10), cone(3), hemisphere(), noisy_height_field(10)};
}

} // namespace

TEST_CASE("a flat square is mapped to itself, without stretch")
{
  const Flat_mesh mesh = unit_square(10);
  const Patch patch = make_patch_of(mesh);
  for(const Weight_case& weight_case : weights_with_linear_precision()) {
    CAPTURE(weight_case.name);
    const Minimized_map map = minimize(patch, weight_case.weights(patch), {});
    CHECK(std::abs(map.report.l2 - 1) < 1e-12);
    REQUIRE(map.uv.rows() == patch.number_of_vertices());
    for(int v = 0; v < patch.number_of_vertices(); ++v)
      CHECK((map.uv.row(v).transpose() - mesh.points[v].head<2>()).cwiseAbs().maxCoeff() < 1e-10);
  }
}

TEST_CASE("the best iterate is kept, and the report tells the history")
{
  for(const Flat_mesh& mesh : curved_meshes())
    for(const Weight_case& weight_case : all_weights()) {
      if(!weight_case.is_positive)
        continue;
      CAPTURE(weight_case.name);
      const Patch patch = make_patch_of(mesh);
      const Minimized_map map = minimize(patch, weight_case.weights(patch), {0.5, 2, 100});
      const Minimization_report& report = map.report;

      REQUIRE(report.history.size() == report.iterations + 1);
      CHECK(report.best_iteration == first_minimum(report.history));
      CHECK(report.l2 == report.history[report.best_iteration]);
      if(report.stop_reason == Stop_reason::STRETCH_GROWS)
        CHECK(report.iterations == report.best_iteration + 3);
      else
        CHECK((report.stop_reason == Stop_reason::MAXIMUM_ITERATIONS && report.iterations == 100));
      CHECK(report.l2 == Approx(reference_stretch(patch.points, mesh.triangles, as_points(map.uv)).l2).epsilon(1e-12));
    }
}

TEST_CASE("the iteration lowers the stretch of curved meshes")
{
  for(const Flat_mesh& mesh : curved_meshes()) {
    const Patch patch = make_patch_of(mesh);
    const Minimization_report report = minimize(patch, Uniform_weights()(patch), {0.5, 1, 100}).report;
    CHECK(report.best_iteration > 0);
    CHECK(report.l2 < report.history[0]);
  }
}

TEST_CASE("without patience the iteration stops at the first iterate that is not lower")
{
  for(const Flat_mesh& mesh : curved_meshes()) {
    const Patch patch = make_patch_of(mesh);
    const Minimization_report report = minimize(patch, Blended_weights()(patch), {1, 0, 100}).report;
    REQUIRE(report.history.size() >= 2);
    for(std::size_t i = 1; i + 1 < report.history.size(); ++i)
      CHECK(report.history[i] < report.history[i - 1]);
    CHECK(report.history.back() >= report.l2);
    CHECK(report.best_iteration + 1 == report.iterations);
  }
}

TEST_CASE("no more systems are solved than allowed")
{
  const unsigned int maximum = GENERATE(0u, 1u, 3u);
  const Patch patch = make_patch_of(hemisphere());
  const Edge_weights weights = Uniform_weights()(patch);
  const Minimization_report all = minimize(patch, weights, {0.3, 1, 100}).report;
  const Minimization_report report = minimize(patch, weights, {0.3, 1, maximum}).report;
  REQUIRE(all.iterations > 3);
  CHECK(report.iterations == maximum);
  CHECK(report.stop_reason == Stop_reason::MAXIMUM_ITERATIONS);
  CHECK(report.history == std::vector<double>(all.history.begin(), all.history.begin() + maximum + 1));
}

TEST_CASE("the second system divides the weight of a neighbor by its stretch to the power eta, or to the power 0.7")
{
  const double eta = GENERATE(0.3, 1.);
  const double exponent = (std::max)(eta, 0.7); // the first exponent is long
  const Patch patch = make_patch_of(noisy_height_field(7));
  const Uv_coordinates border_uv = square_border_of(patch, 0);
  const Edge_weights weights = Mean_value_weights()(patch);
  const Minimized_map first = minimize(patch, weights, {eta, 1, 0}), second = minimize(patch, weights, {eta, 1, 1});
  REQUIRE(second.report.best_iteration == 1);
  const std::vector<double> sigma = reference_stretch(patch.points, patch.triangles, as_points(first.uv)).vertex_l2;

  // the residual of the equations with the divided weights, at the second map
  std::vector<bool> is_interior(patch.points.size(), true);
  for(int v : patch.border)
    is_interior[v] = false;
  Uv_coordinates residual = Uv_coordinates::Zero(patch.number_of_vertices(), 2);
  for(std::size_t e = 0; e < patch.edges.size(); ++e)
    for(int end = 0; end < 2; ++end) {
      const int i = patch.edges[e][end], j = patch.edges[e][1 - end];
      if(is_interior[i])
        residual.row(i) +=
            weights.values[e][end] / std::pow(sigma[j], exponent) * (second.uv.row(j) - second.uv.row(i));
    }
  CHECK(residual.cwiseAbs().maxCoeff() < 1e-12);
}

TEST_CASE("a workspace may serve many borders in any order")
{
  const Patch patch = make_patch_of(saddle(8));
  for(bool is_symmetric : {true, false}) {
    const Edge_weights weights = is_symmetric ? Blended_weights()(patch) : Mean_value_weights()(patch);
    const Stretch_iteration iteration(patch, minimization(weights, {}));
    Stretch_iteration::Workspace used;
    iteration.minimize(square_border_of(patch, 5), 1, used);
    const Minimized_map again = iteration.minimize(square_border_of(patch, 2), 1, used);
    CHECK(again.uv == minimize(patch, weights, {}, square_border_of(patch, 2)).uv);
  }
}

TEST_CASE("the stretch of a map onto a circle is normalised by the area of the uv triangles")
{
  const double radius = GENERATE(0.25, 1., 7.);
  const Patch patch = make_patch_of(hemisphere());
  const Uv_coordinates border_uv = circular_border(patch.border_lengths, radius);
  double area = 0;
  for(Eigen::Index k = 0; k < border_uv.rows(); ++k) {
    const auto p = border_uv.row(k), q = border_uv.row((k + 1) % border_uv.rows());
    area += (p.x() * q.y() - p.y() * q.x()) / 2;
  }
  const Minimized_map map = minimize(patch, Blended_weights()(patch), {}, border_uv, area);
  CHECK(map.report.l2 == Approx(reference_stretch(patch.points, patch.triangles, as_points(map.uv)).l2).epsilon(1e-12));
}

TEST_CASE("a disk without interior vertices is mapped by its border alone")
{
  const Flat_mesh mesh{{{0, 0, 0}, {2, 0, 0}, {2, 2, 1}, {0, 2, 0}}, {{0, 1, 2}, {0, 2, 3}}, {0, 1, 2, 3}};
  const Patch patch = make_patch_of(mesh);
  for(const Weight_case& weight_case : all_weights()) {
    CAPTURE(weight_case.name);
    const Minimized_map map = minimize(patch, weight_case.weights(patch), {});
    REQUIRE(map.uv.rows() == 4);
    CHECK(map.uv == square_border_of(patch, 0));
    CHECK(map.report.l2 == Approx(reference_stretch(patch.points, mesh.triangles, as_points(map.uv)).l2));
  }
}

TEST_CASE("a map with a flat triangle is no map")
{
  // the chord between vertices 4 and 6 of the border comes to lie on the right side of the square
  const Flat_mesh mesh = rectangle(2, 2, 1, 1, 1, 0);
  const Patch patch = make_patch_of(mesh);
  Uv_coordinates border_uv = square_border_of(patch, 0);
  for(int k = 1; k < 8; ++k)
    border_uv(k, 0) = 1; // all of the border but its first vertex on one line
  const Minimized_map map = minimize(patch, Uniform_weights()(patch), {}, border_uv);
  CHECK(map.uv.rows() == 0);
  CHECK(map.report.l2 == std::numeric_limits<double>::infinity());
}
