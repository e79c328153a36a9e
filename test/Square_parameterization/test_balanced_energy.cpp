// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "make_patch_of.h"
#include "test_meshes.h"

#include <CGAL_ext/Square_parameterization/Balanced_minimization.h>
#include <CGAL_ext/Square_parameterization/internal/border_curves.h>
#include <CGAL_ext/Square_parameterization/measure_stretch.h>

#include <Eigen/SVD>

#include <catch2/catch.hpp>

using namespace CGAL_ext;
using namespace CGAL_ext::internal;

namespace {

/// a map without flips that is no minimum of anything: the uniform map of the patch with uneven corners, jittered
Uv_coordinates some_map(const Patch& patch)
{
  Stretch_minimization uniform;
  uniform.weights = Uniform_weights();
  uniform.maximum_iterations = 0;
  const Border_walk walk(patch.border_lengths, Walk::COUNTER_CLOCKWISE);
  const Corners corners = corners_of_candidate(walk, 1, Corner_rule::NEAREST);
  Stretch_iteration::Workspace workspace;
  const Stretch_iteration iteration = uniform.make_iteration(patch);
  return iteration.minimize(square_border(walk, corners).uv, 1, workspace).uv;
}

/// the energy by its definition: singular values of the 3D-to-uv map of each triangle, found by Eigen's SVD
double energy_by_definition(const Patch& patch, const Uv_coordinates& uv, double balance)
{
  double energy = 0;
  for(const auto& [a, b, c] : patch.triangles) {
    Eigen::Matrix<double, 3, 2> surface;
    surface << patch.points[b] - patch.points[a], patch.points[c] - patch.points[a];
    Eigen::Matrix2d plane;
    plane << (uv.row(b) - uv.row(a)).transpose(), (uv.row(c) - uv.row(a)).transpose();
    const double area = surface.col(0).cross(surface.col(1)).norm() / 2;
    // the Jacobian of the inverse map, plane to surface, has the inverse singular values
    const Eigen::Matrix<double, 3, 2> inverse = surface * plane.inverse();
    const Eigen::Vector2d s = inverse.jacobiSvd().singularValues();
    energy += area * (s.squaredNorm() + balance * s.cwiseInverse().squaredNorm());
  }
  return energy;
}

/// the second derivatives of a triangle's energy with respect to its corners, from those of f(K) = |K|^2 / J^2 + b |K|^2
/// along A and B, with J = det K and C its derivative:
/// 2 (1/J^2 + b) <A,B> - 4/J^3 (<K,A><C,B> + <C,A><K,B>) + 6 |K|^2/J^4 <C,A><C,B> - 2 |K|^2/J^3 <A, cof B>
Balanced_energy::Element_hessian exact_hessian(const Patch& patch, double balance, int f, const Uv_coordinates& uv)
{
  const auto cofactor = [](const Eigen::Matrix2d& M) {
    Eigen::Matrix2d result;
    result << M(1, 1), -M(1, 0), -M(0, 1), M(0, 0);
    return result;
  };
  const auto inner = [](const Eigen::Matrix2d& M, const Eigen::Matrix2d& N) { return M.cwiseProduct(N).sum(); };
  const auto& [a, b, c] = patch.triangles[f];
  const Flat_triangle& shape = patch.shapes[f];
  Eigen::Matrix2d plane, surface;
  plane << (uv.row(b) - uv.row(a)).transpose(), (uv.row(c) - uv.row(a)).transpose();
  surface << shape.x1, shape.x2, 0, shape.y2;
  const Eigen::Matrix2d inverse = surface.inverse(), K = plane * inverse, C = cofactor(K);
  // the rows of the inverse are the gradients of the hat functions of corners 1 and 2
  const std::array<Eigen::RowVector2d, 3> g{-inverse.row(0) - inverse.row(1), inverse.row(0), inverse.row(1)};
  const double J = K.determinant(), norm = K.squaredNorm();
  Balanced_energy::Element_hessian hessian;
  for(int i = 0; i < 6; ++i)
    for(int j = 0; j < 6; ++j) {
      Eigen::Matrix2d A = Eigen::Matrix2d::Zero(), B = Eigen::Matrix2d::Zero();
      A.row(i % 2) = g[i / 2];
      B.row(j % 2) = g[j / 2];
      const double CA = inner(C, A), CB = inner(C, B);
      hessian(i, j) = 2 * (1 / (J * J) + balance) * inner(A, B) -
                      4 / (J * J * J) * (inner(K, A) * CB + CA * inner(K, B)) + 6 * norm / (J * J * J * J) * CA * CB -
                      2 * norm / (J * J * J) * inner(A, cofactor(B));
    }
  return shape.area() * hessian;
}

std::vector<Patch> patches()
{
  return {make_patch_of(saddle(6)), make_patch_of(cone()), make_patch_of(noisy_height_field(6)),
          make_patch_of(long_strip(12))};
}

} // namespace

TEST_CASE("the balanced energy is the one of its definition, and b = 0 and 1 are L2 and symmetric Dirichlet")
{
  for(const Patch& patch : patches()) {
    const Uv_coordinates uv = some_map(patch);
    for(double balance : {0., 0.3, 1.})
      CHECK(Balanced_energy(patch, balance)(uv) == Approx(energy_by_definition(patch, uv, balance)).epsilon(1e-12));
    const Stretch_measures measures = measure(patch.shapes, patch.triangles, uv);
    CHECK(std::sqrt(Balanced_energy(patch, 0)(uv) / 2) == Approx(measures.l2).epsilon(1e-12));
    CHECK(Balanced_energy(patch, 1)(uv) / 4 == Approx(measures.symmetric_dirichlet).epsilon(1e-12));
  }
}

TEST_CASE("gradient and Hessian of the balanced energy agree with finite differences")
{
  const double h = 1e-6;
  for(const Patch& patch : patches())
    for(double balance : {0., 0.3, 1.}) {
      const Balanced_energy energy(patch, balance);
      Uv_coordinates uv = some_map(patch), gradient, plus, minus;
      energy.gradient(uv, gradient);
      Eigen::MatrixXd hessian = Eigen::MatrixXd::Zero(2 * uv.rows(), 2 * uv.rows());
      for(int f = 0; f < patch.number_of_faces(); ++f) {
        const auto element = exact_hessian(patch, balance, f, uv);
        for(int i = 0; i < 6; ++i)
          for(int j = 0; j < 6; ++j)
            hessian(2 * patch.triangles[f][i / 2] + i % 2, 2 * patch.triangles[f][j / 2] + j % 2) += element(i, j);
      }
      const double gradient_scale = gradient.cwiseAbs().maxCoeff(), hessian_scale = hessian.cwiseAbs().maxCoeff();
      for(int k = 0; k < 2 * uv.rows(); k += 5) {
        double& x = uv(k / 2, k % 2);
        const double here = x;
        x = here + h;
        const double above = energy.gradient(uv, plus);
        x = here - h;
        const double below = energy.gradient(uv, minus);
        x = here;
        CHECK(std::abs((above - below) / (2 * h) - gradient(k / 2, k % 2)) < 1e-5 * gradient_scale);
        const Uv_coordinates difference = (plus - minus) / (2 * h);
        CHECK((Eigen::Map<const Eigen::VectorXd>(difference.data(), difference.size()) - hessian.col(k))
                  .cwiseAbs()
                  .maxCoeff() < 1e-5 * hessian_scale);
      }
    }
}

TEST_CASE("the projected Hessian of a triangle is positive semidefinite, and exact up to the area term where that is")
{
  const Patch patch = make_patch_of(saddle(5));
  const Uv_coordinates uv = some_map(patch);
  for(double balance : {0., 0.3, 1.}) {
    const Balanced_energy energy(patch, balance);
    for(int f = 0; f < patch.number_of_faces(); ++f) {
      const Balanced_energy::Element_hessian projected = energy.hessian(f, uv);
      const double scale = projected.cwiseAbs().maxCoeff();
      CHECK(projected.selfadjointView<Eigen::Upper>().eigenvalues().minCoeff() > -1e-9 * scale);
    }
  }
  // an isometry is a minimum of the symmetric Dirichlet energy: nothing is clamped there, and the area term cancels over
  // the triangles around an interior vertex
  const Patch flat = make_patch_of(unit_square(4));
  Uv_coordinates identity(flat.points.size(), 2);
  for(std::size_t v = 0; v < flat.points.size(); ++v)
    identity.row(v) = flat.points[v].head<2>().transpose();
  const Balanced_energy dirichlet(flat, 1);
  Eigen::Matrix2d difference = Eigen::Matrix2d::Zero();
  int inside = 0;
  while(std::find(flat.border.begin(), flat.border.end(), inside) != flat.border.end())
    ++inside;
  for(int f = 0; f < flat.number_of_faces(); ++f)
    for(int k = 0; k < 3; ++k)
      if(flat.triangles[f][k] == inside)
        difference += (dirichlet.hessian(f, identity) - exact_hessian(flat, 1, f, identity)).block<2, 2>(2 * k, 2 * k);
  CHECK(difference.cwiseAbs().maxCoeff() < 1e-9);
}

TEST_CASE("the largest step is where the first triangle loses its area")
{
  const Patch patch = make_patch_of(saddle(5));
  const Uv_coordinates uv = some_map(patch);
  Random_numbers random(4);
  for(int round = 0; round < 20; ++round) {
    Uv_coordinates direction(uv.rows(), 2);
    for(int k = 0; k < direction.size(); ++k)
      direction(k / 2, k % 2) = random(-1, 1);
    const double step = largest_step(patch, uv, direction);
    REQUIRE(std::isfinite(step));
    CHECK(number_of_flipped_faces(patch.triangles, uv + 0.999999 * step * direction) == 0);
    CHECK(number_of_flipped_faces(patch.triangles, uv + 1.000001 * step * direction) > 0);
  }
  CHECK(std::isinf(largest_step(patch, uv, Uv_coordinates::Constant(uv.rows(), 2, 0.5)))); // a translation
}

TEST_CASE("the minimizer lowers the energy at every step to a stationary map without flips, at every balance")
{
  for(const Patch& patch : patches())
    for(double balance : {0., 0.1, 0.3, 1.})
      for(bool is_sliding : {false, true}) {
        const Balanced_minimizer minimizer(patch, {balance, is_sliding, 1e-10, 500});
        Balanced_minimizer::Workspace workspace;
        const Minimized_map map = minimizer.minimize(some_map(patch), workspace);
        INFO("balance " << balance << ", sliding " << is_sliding);
        CHECK(number_of_flipped_faces(patch.triangles, map.uv) == 0);
        for(std::size_t i = 1; i < map.report.history.size(); ++i)
          CHECK(map.report.history[i] < map.report.history[i - 1]);
        CHECK(
            (map.report.stop_reason == Stop_reason::CONVERGED || map.report.stop_reason == Stop_reason::NO_LOWER_MAP));
        CHECK(map.report.objective == Approx(energy_by_definition(patch, map.uv, balance)).epsilon(1e-9));
        CHECK(map.report.l2 == Approx(measure(patch.shapes, patch.triangles, map.uv).l2).epsilon(1e-12));
      }
}

TEST_CASE("a map stopped after any number of steps has no flips")
{
  const Patch patch = make_patch_of(cone(6, 6, 19));
  for(unsigned int steps = 0; steps < 12; ++steps) {
    const Balanced_minimizer minimizer(patch, {0, true, 0, steps});
    Balanced_minimizer::Workspace workspace;
    const Minimized_map map = minimizer.minimize(some_map(patch), workspace);
    CHECK(number_of_flipped_faces(patch.triangles, map.uv) == 0);
    CHECK(map.report.iterations <= steps);
  }
}

TEST_CASE("the flat square is found from a bad start, with its border fixed and sliding")
{
  const Patch patch = make_patch_of(unit_square(6));
  const Border_walk walk(patch.border_lengths, Walk::COUNTER_CLOCKWISE);
  Uv_coordinates expected(patch.points.size(), 2);
  const Eigen::Vector3d origin = patch.points[patch.border[0]];
  for(std::size_t v = 0; v < patch.points.size(); ++v)
    expected.row(v) = (patch.points[v] - origin).head<2>().transpose();
  Uv_coordinates start = some_map(patch);
  {
    Stretch_minimization uniform;
    uniform.weights = Uniform_weights();
    uniform.maximum_iterations = 0;
    const Stretch_iteration iteration = uniform.make_iteration(patch);
    Stretch_iteration::Workspace workspace;
    start =
        iteration.minimize(square_border(walk, corners_of_candidate(walk, 0, Corner_rule::NEAREST)).uv, 1, workspace)
            .uv;
  }
  for(bool is_sliding : {false, true}) {
    const Balanced_minimizer minimizer(patch, {0.3, is_sliding, 1e-14, 500});
    Balanced_minimizer::Workspace workspace;
    const Minimized_map map = minimizer.minimize(start, workspace);
    CHECK(map.report.l2 == Approx(1).epsilon(1e-10));
    CHECK((map.uv - expected).cwiseAbs().maxCoeff() < 1e-5);
  }
}
