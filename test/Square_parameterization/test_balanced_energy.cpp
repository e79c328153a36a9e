// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "energy_by_definition.h"
#include "mapped_patches.h"

#include <CGAL_ext/Square_parameterization/internal/energy/Balanced_energy.h>
#include <CGAL_ext/Square_parameterization/internal/energy/feasible_step.h>
#include <CGAL_ext/Square_parameterization/internal/patch/exact_orientation.h>
#include <CGAL_ext/Square_parameterization/measure_stretch.h>

#include <Eigen/SVD>

#include <catch2/catch.hpp>

using namespace CGAL_ext;
using namespace CGAL_ext::internal;

namespace {

Eigen::Matrix2d cofactor(const Eigen::Matrix2d& M)
{
  Eigen::Matrix2d result;
  result << M(1, 1), -M(1, 0), -M(0, 1), M(0, 0);
  return result;
}

/// the rows are the gradients of the hat functions of the three corners, in the plane of the triangle
Eigen::Matrix<double, 3, 2> hat_gradients(const Flat_triangle& shape)
{
  Eigen::Matrix2d surface;
  surface << shape.x1, shape.x2, 0, shape.y2;
  const Eigen::Matrix2d inverse = surface.inverse();
  Eigen::Matrix<double, 3, 2> gradients;
  gradients << -inverse.row(0) - inverse.row(1), inverse;
  return gradients;
}

/// the second derivatives of f(K) = |K|^2 / J^2 + b |K|^2, J = det K with derivative C, by the entries 00, 01, 10, 11
/// of K; along A and B they are 2 (1/J^2 + b) <A,B> - 4/J^3 (<K,A><C,B> + <C,A><K,B>) + 6 |K|^2/J^4 <C,A><C,B> - 2
/// |K|^2/J^3 <A, cof B>. Adds `shift` times those of J.
Eigen::Matrix4d jacobian_hessian(const Eigen::Matrix2d& K, double balance, double shift)
{
  const auto inner = [](const Eigen::Matrix2d& M, const Eigen::Matrix2d& N) { return M.cwiseProduct(N).sum(); };
  const Eigen::Matrix2d C = cofactor(K);
  const double J = K.determinant(), norm = K.squaredNorm();
  Eigen::Matrix4d hessian;
  for(int i = 0; i < 4; ++i)
    for(int j = 0; j < 4; ++j) {
      Eigen::Matrix2d A = Eigen::Matrix2d::Zero(), B = Eigen::Matrix2d::Zero();
      A(i / 2, i % 2) = B(j / 2, j % 2) = 1;
      const double CA = inner(C, A), CB = inner(C, B);
      hessian(i, j) = 2 * (1 / (J * J) + balance) * inner(A, B) -
                      4 / (J * J * J) * (inner(K, A) * CB + CA * inner(K, B)) + 6 * norm / (J * J * J * J) * CA * CB +
                      (shift - 2 * norm / (J * J * J)) * inner(A, cofactor(B));
    }
  return hessian;
}

Eigen::Matrix2d jacobian(const Patch& patch, int f, const Uv_coordinates& uv)
{
  Eigen::Matrix<double, 2, 3> corners;
  for(int k = 0; k < 3; ++k)
    corners.col(k) = uv.row(patch.triangles[f][k]).transpose();
  return corners * hat_gradients(patch.shapes[f]);
}

/// second derivatives of the energy of a triangle by u0, v0, u1, v1, u2, v2, from those by the Jacobian
Eigen::Matrix<double, 6, 6> by_corners(const Flat_triangle& shape, const Eigen::Matrix4d& by_jacobian)
{
  const Eigen::Matrix<double, 3, 2> g = hat_gradients(shape);
  Eigen::Matrix<double, 4, 6> chain = Eigen::Matrix<double, 4, 6>::Zero();
  for(int k = 0; k < 3; ++k)
    for(int axis = 0; axis < 2; ++axis)
      chain.block<2, 1>(2 * axis, 2 * k + axis) = g.row(k).transpose();
  return shape.area() * chain.transpose() * by_jacobian * chain;
}

Eigen::Matrix<double, 6, 6> exact_hessian(const Patch& patch, double balance, int f, const Uv_coordinates& uv)
{
  return by_corners(patch.shapes[f], jacobian_hessian(jacobian(patch, f, uv), balance, 0));
}

/// a symmetric matrix with its negative eigenvalues replaced by zero. Singular values are absolute values of eigenvalues, and V S V^T
/// is the matrix with these.
Eigen::Matrix4d clamped_matrix(const Eigen::Matrix4d& matrix)
{
  const Eigen::JacobiSVD<Eigen::Matrix4d, Eigen::NoQRPreconditioner> svd(matrix, Eigen::ComputeFullV);
  return (matrix + svd.matrixV() * svd.singularValues().asDiagonal() * svd.matrixV().transpose()) / 2;
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

TEST_CASE("on a rectangle the energy is that of the stretched map, and the best aspect is that of a scan")
{
  for(const Patch& patch : patches())
    for(double balance : {0., 0.3, 1.}) {
      const Uv_coordinates uv = some_map(patch);
      const Balanced_energy best(patch, balance, std::nullopt);
      double least = std::numeric_limits<double>::infinity();
      for(int k = -400; k <= 400; ++k) {
        const double aspect = std::exp(0.01 * k);
        const double energy = Balanced_energy(patch, balance, aspect)(uv);
        Uv_coordinates stretched = uv;
        stretched.col(0) *= std::sqrt(aspect);
        stretched.col(1) /= std::sqrt(aspect);
        CHECK(energy == Approx(energy_by_definition(patch, stretched, balance)).epsilon(1e-12));
        least = (std::min)(least, energy);
      }
      CHECK(best(uv) <= least);
      CHECK(best(uv) == Approx(least).epsilon(1e-3));
      CHECK(best(uv) == Approx(Balanced_energy(patch, balance, best.aspect(uv))(uv)).epsilon(1e-14));
    }
}

TEST_CASE("the gradient of the energy on the best rectangle, and on a given one, agrees with finite differences")
{
  const double h = 1e-6;
  for(const Patch& patch : patches())
    for(std::optional<double> aspect :
        {std::optional<double>(), std::optional<double>(3), std::optional<double>(0.02)}) {
      const Balanced_energy energy(patch, 0.3, aspect);
      Uv_coordinates uv = some_map(patch), gradient;
      energy.gradient(uv, gradient);
      for(int k = 0; k < 2 * uv.rows(); k += 5) {
        double& x = uv(k / 2, k % 2);
        const double here = x;
        x = here + h;
        const double above = energy(uv);
        x = here - h;
        const double below = energy(uv);
        x = here;
        CHECK(std::abs((above - below) / (2 * h) - gradient(k / 2, k % 2)) < 1e-5 * gradient.cwiseAbs().maxCoeff());
      }
    }
}

TEST_CASE("the blocks of the Hessian are those of the shifted Hessian with its negative eigenvalues clamped")
{
  for(const Patch& patch : patches()) {
    const Uv_coordinates uv = some_map(patch);
    for(const auto& [balance, area_multiple] :
        {std::pair(0., 2.), std::pair(0.3, 2.), std::pair(1., 2.), std::pair(0.3, 30.)})
      for(int f = 0; f < patch.number_of_faces(); ++f) {
        const std::array<int, 2> faces{f, patch.number_of_faces() - 1 - f};
        const auto blocks = Balanced_energy(patch, balance).hessian_blocks(faces, uv, {1, 1}, area_multiple);
        for(int which = 0; which < 2; ++which) {
          const Eigen::Matrix4d clamped =
              clamped_matrix(jacobian_hessian(jacobian(patch, faces[which], uv), balance, area_multiple));
          const Eigen::Matrix<double, 6, 6> expected = by_corners(patch.shapes[faces[which]], clamped);
          for(int i = 0; i < 3; ++i)
            for(int j = 0; j < 3; ++j)
              for(int axis = 0; axis < 2; ++axis)
                CHECK(std::abs(blocks[which].of_axis(axis)(i, j) - expected(2 * i + axis, 2 * j + axis)) <
                      1e-9 * expected.cwiseAbs().maxCoeff());
        }
      }
  }
}

TEST_CASE("twice the squared L2 stretch of a map is its energy without balance, on the rectangle")
{
  for(const Patch& patch : patches()) {
    Uv_coordinates uv = some_map(patch);
    const Balanced_energy energy(patch, 0.3, 4);
    const double twice_squared_l2 = energy.twice_squared_l2(uv, energy.scale(uv));
    uv.col(0) *= 2;
    uv.col(1) /= 2;
    CHECK(twice_squared_l2 == Approx(energy_by_definition(patch, uv, 0)).epsilon(1e-12));
  }
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
    double least = std::numeric_limits<double>::infinity();
    for(const auto& t : patch.triangles) { // what a bound leaves out is beyond it
      const double of_triangle = largest_step(t, uv, direction);
      least = (std::min)(least, of_triangle);
      for(double bound : {0.5 * step, step, 3 * step})
        if(const double bounded = largest_step(t, uv, direction, bound); bounded != of_triangle)
          CHECK((std::isinf(bounded) && of_triangle >= bound));
    }
    CHECK(step == least);
  }
  CHECK(std::isinf(largest_step(patch, uv, Uv_coordinates::Constant(uv.rows(), 2, 0.5)))); // a translation
}
