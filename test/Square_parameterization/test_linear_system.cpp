// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "make_patch_of.h"
#include "map_cases.h"
#include "weight_cases.h"

#include <CGAL_ext/Square_parameterization/internal/iteration/Convex_combination_system.h>

#include <Eigen/LU>

#include <catch2/catch.hpp>

using namespace CGAL_ext;
using namespace CGAL_ext::internal;

namespace {

/// the map by a dense solve of  sum_j w_ij s_j (p_j - p_i) = 0,  one row per vertex
Uv_coordinates dense_map(const Patch& patch, const Edge_weights& weights, const std::vector<double>& s,
                         const Uv_coordinates& border_uv)
{
  const int n = patch.number_of_vertices();
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n, n);
  Eigen::MatrixXd right_hand_sides = Eigen::MatrixXd::Zero(n, 2);
  for(std::size_t e = 0; e < patch.edges.size(); ++e)
    for(int end = 0; end < 2; ++end) {
      const int i = patch.edges[e][end], j = patch.edges[e][1 - end];
      const double w = weights.values[e][end] * s[j];
      matrix(i, i) -= w;
      matrix(i, j) += w;
    }
  for(std::size_t k = 0; k < patch.border.size(); ++k) {
    matrix.row(patch.border[k]).setZero();
    matrix(patch.border[k], patch.border[k]) = 1;
    right_hand_sides.row(patch.border[k]) = border_uv.row(k);
  }
  return matrix.fullPivLu().solve(right_hand_sides);
}

Uv_coordinates sparse_map(const Patch& patch, const Edge_weights& weights, const std::vector<double>& s,
                          const Uv_coordinates& border_uv, Linear_solver& solver)
{
  const Convex_combination_system system(patch, weights);
  Convex_combination_system::Equations equations;
  system.assemble(s, border_uv, equations);
  Right_hand_sides solution;
  REQUIRE(solver.factorize(equations.matrix));
  REQUIRE(solver.solve(equations.right_hand_sides, solution));
  Uv_coordinates uv;
  system.compose(solution, border_uv, uv);
  return uv;
}

double largest_difference(const Uv_coordinates& a, const Uv_coordinates& b)
{
  return (a - b).cwiseAbs().maxCoeff();
}

std::vector<double> random_factors(const Patch& patch, unsigned int seed)
{
  Random_numbers random(seed);
  std::vector<double> s;
  for(int v = 0; v < patch.number_of_vertices(); ++v)
    s.push_back(std::pow(10, random(-2, 2)));
  return s;
}

} // namespace

TEST_CASE("sparse and dense solutions agree for all weights and any factors")
{
  for(const Weight_case& weight_case : all_weights()) {
    if(!weight_case.is_positive)
      continue;
    CAPTURE(weight_case.name);
    const Patch patch = make_patch_of(noisy_height_field(8));
    const Edge_weights weights = weight_case.weights(patch);
    const Uv_coordinates border_uv = square_border_of(patch, 0);
    // one solver for all factors, as the iteration uses it
    const std::unique_ptr<Linear_solver> solver = make_direct_solver(weights.is_symmetric);
    std::vector<double> s(patch.points.size(), 1.);
    for(unsigned int seed = 0; seed < 4; ++seed) {
      CHECK(largest_difference(sparse_map(patch, weights, s, border_uv, *solver),
                               dense_map(patch, weights, s, border_uv)) < 1e-11);
      s = random_factors(patch, seed);
    }
  }
}

TEST_CASE("the map is the same in any order of elimination")
{
  Patch patch = make_patch_of(noisy_height_field(8));
  const Edge_weights weights = Mean_value_weights()(patch);
  const Uv_coordinates border_uv = square_border_of(patch, 0);
  const std::vector<double> s = random_factors(patch, 1);
  for(int v = patch.number_of_vertices(); v > 0; --v)
    patch.elimination_places.push_back(v - 1);
  REQUIRE(elimination_places_of(patch) == patch.elimination_places);
  const std::unique_ptr<Linear_solver> solver = make_direct_solver(weights.is_symmetric);
  CHECK(largest_difference(sparse_map(patch, weights, s, border_uv, *solver),
                           dense_map(patch, weights, s, border_uv)) < 1e-11);
}

TEST_CASE("right hand sides alone are those of the equations for factors of one")
{
  for(const Weight_case& weight_case : all_weights())
    for(const Patch& patch : {make_patch_of(saddle(6)), make_patch_of(noisy_height_field(6))}) {
      CAPTURE(weight_case.name, patch.number_of_vertices());
      const Convex_combination_system system(patch, weight_case.weights(patch));
      const Uv_coordinates border_uv = square_border_of(patch, 0);
      Convex_combination_system::Equations equations;
      system.assemble(std::vector<double>(patch.points.size(), 1.), border_uv, equations);
      Right_hand_sides alone;
      system.assemble(border_uv, alone);
      CHECK(alone == equations.right_hand_sides);
      CHECK(alone.cwiseAbs().maxCoeff() > 0);
    }
}

TEST_CASE("symmetric weights have the same map with the general solver")
{
  const Patch patch = make_patch_of(hemisphere());
  const Uv_coordinates border_uv = square_border_of(patch, 0);
  const Edge_weights weights = Symmetric_mean_value_weights()(patch);
  Edge_weights general = weights;
  general.is_symmetric = false;
  const std::vector<double> s = random_factors(patch, 5);
  const auto symmetric_solver = make_direct_solver(true), general_solver = make_direct_solver(false);
  CHECK(largest_difference(sparse_map(patch, weights, s, border_uv, *symmetric_solver),
                           sparse_map(patch, general, s, border_uv, *general_solver)) < 1e-12);
}

TEST_CASE("the matrix of symmetric weights is stored once, as an upper triangle")
{
  const Patch patch = make_patch_of(saddle(6));
  Convex_combination_system::Equations equations;
  const Convex_combination_system system(patch, Uniform_weights()(patch));
  system.assemble(random_factors(patch, 6), square_border_of(patch, 0), equations);
  CHECK(system.is_symmetric());
  CHECK(equations.matrix.rows() == 5 * 5);
  CHECK(equations.matrix.isCompressed());
  CHECK(equations.matrix.toDense().triangularView<Eigen::StrictlyLower>().toDenseMatrix().isZero(0));
}

TEST_CASE("the map of uniform weights is that of a solution by hand")
{
  // the corners of a square, a = 4 joined to all of them and to b = 5, and b joined to the right corners and to a:
  // 5 a = (2, 2) + b and 3 b = (2, 1) + a
  const Flat_mesh mesh{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {.3, .5, .1}, {.8, .5, 0}},
                       {{0, 1, 4}, {1, 5, 4}, {1, 2, 5}, {2, 4, 5}, {2, 3, 4}, {3, 0, 4}},
                       {0, 1, 2, 3}};
  const Patch patch = make_patch_of(mesh);
  const auto solver = make_direct_solver(true);
  const Uv_coordinates uv =
      sparse_map(patch, Uniform_weights()(patch), std::vector<double>(6, 1.), square_border_of(patch, 0), *solver);
  CHECK(uv(4, 0) == Approx(4 / 7.).epsilon(1e-14));
  CHECK(uv(4, 1) == Approx(1 / 2.).epsilon(1e-14));
  CHECK(uv(5, 0) == Approx(6 / 7.).epsilon(1e-14));
  CHECK(uv(5, 1) == Approx(1 / 2.).epsilon(1e-14));
}

TEST_CASE("elimination without pivots solves the systems of the iteration as dense elimination with pivots does")
{
  const Patch patch = make_patch_of(noisy_height_field(20));
  const Convex_combination_system system(patch, Mean_value_weights()(patch));
  REQUIRE_FALSE(system.is_symmetric());
  const auto solver = make_direct_solver(false);
  Convex_combination_system::Equations equations;
  for(unsigned int seed = 0; seed < 3; ++seed) {
    system.assemble(random_factors(patch, seed), square_border_of(patch, 0), equations);
    Right_hand_sides solution;
    REQUIRE(solver->factorize(equations.matrix));
    REQUIRE(solver->solve(equations.right_hand_sides, solution));
    const Eigen::MatrixXd matrix = equations.matrix, right_hand_sides = equations.right_hand_sides;
    const Eigen::MatrixXd expected = matrix.fullPivLu().solve(right_hand_sides);
    CHECK((solution - expected).cwiseAbs().maxCoeff() < 1e-10);
  }
}

TEST_CASE("a singular matrix is reported, not solved")
{
  Sparse_matrix zero(3, 3);
  for(int i = 0; i < 3; ++i)
    zero.insert(i, i) = 0;
  zero.makeCompressed();
  for(bool is_symmetric : {true, false}) {
    const auto solver = make_direct_solver(is_symmetric);
    Right_hand_sides solution;
    CHECK_FALSE((solver->factorize(zero) && solver->solve(Right_hand_sides::Ones(3, 2), solution)));
  }
}
