// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_BALANCED_ENERGY_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_BALANCED_ENERGY_H

#include <CGAL_ext/Square_parameterization/internal/stretch_kernel.h>

#include <Eigen/Eigenvalues>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL_ext {
namespace internal {

/// the balanced stretch of a triangle mapped by K, the Jacobian of the map from its own plane to the uv plane, with
/// singular values s1 >= s2 > 0:
///
///     f(K) = 1/s1^2 + 1/s2^2 + b (s1^2 + s2^2) = |K|^2 / det(K)^2 + b |K|^2
///
/// b = 0 is twice the squared L2 stretch, b = 1 the symmetric Dirichlet energy. The energy of a map is the sum of f
/// times the area over the triangles; it is infinite when a triangle is not counter-clockwise.
class Balanced_energy
{
public:
  /// gradients of the hat functions of a triangle in its own plane: the Jacobian is K = sum_k p_k g_k^T
  typedef std::array<Eigen::Vector2d, 3> Hat_gradients;

  /// second derivatives of one triangle with respect to (u0, v0, u1, v1, u2, v2)
  typedef Eigen::Matrix<double, 6, 6> Element_hessian;

  Balanced_energy(const Patch& patch, double balance) : m_patch(patch), m_balance(balance) {}

  const Patch& patch() const { return m_patch; }

  /// the energy of a map (#V by 2)
  double operator()(const Uv_coordinates& uv) const
  {
    double energy = 0;
    for(int f = 0; f < m_patch.number_of_faces(); ++f) {
      const double area = m_patch.shapes[f].area();
      const Triangle_stretch stretch = triangle_stretch(m_patch.shapes[f], uv, m_patch.triangles[f]);
      // |K|^2 = |K^-1|^2 det(K)^2, and |K^-1|^2 = 2 L2(T)^2 stays finite for slivers
      const double determinant = stretch.uv_area / area;
      energy += area * 2 * stretch.l2_squared * (1 + m_balance * determinant * determinant);
    }
    return energy;
  }

  /// the energy of a map, and its gradient (#V by 2)
  double gradient(const Uv_coordinates& uv, Uv_coordinates& gradient) const
  {
    gradient.setZero(uv.rows(), 2);
    for(int f = 0; f < m_patch.number_of_faces(); ++f) {
      const Hat_gradients g = hat_gradients(m_patch.shapes[f]);
      const Eigen::Matrix2d derivative = m_patch.shapes[f].area() * derivative_of(jacobian(f, uv, g));
      for(int k = 0; k < 3; ++k)
        gradient.row(m_patch.triangles[f][k]) += (derivative * g[k]).transpose();
    }
    return (*this)(uv);
  }

  /// the Hessian of triangle \p f, made positive semidefinite by clamping the negative of its closed-form eigenvalues
  /// (Smith, de Goes, Kim 2019).
  ///
  /// The total signed area of a map with fixed border, or with a border that slides along the square, is constant, so
  /// any multiple of det(K) may be added: the objective and its gradient stay, and fewer eigenvalues need clamping.
  Element_hessian hessian(int f, const Uv_coordinates& uv) const
  {
    constexpr double AREA_SHIFT = 2;
    const Hat_gradients g = hat_gradients(m_patch.shapes[f]);
    const Singular_values svd(jacobian(f, uv, g));
    const double s1 = svd.s1, s2 = svd.s2;
    const double cubes = 1 / (s1 * s1 * s1 * s2 * s2 * s2);
    const double twist = 2 * (m_balance - (s1 * s1 - s1 * s2 + s2 * s2) * cubes) + AREA_SHIFT;
    const double flip = 2 * (m_balance + (s1 * s1 + s1 * s2 + s2 * s2) * cubes) - AREA_SHIFT;
    Eigen::Matrix2d scaling;
    scaling << 6 / std::pow(s1, 4) + 2 * m_balance, AREA_SHIFT, AREA_SHIFT, 6 / std::pow(s2, 4) + 2 * m_balance;
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> scaling_modes;
    scaling_modes.computeDirect(scaling);

    const Eigen::Matrix2d stretch_1 = svd.u1 * svd.v1.transpose(), stretch_2 = svd.u2 * svd.v2.transpose();
    const Eigen::Matrix2d shear_1 = svd.u2 * svd.v1.transpose(), shear_2 = svd.u1 * svd.v2.transpose();
    const double area = m_patch.shapes[f].area();
    Element_hessian hessian = Element_hessian::Zero();
    const auto add_mode = [&](double eigenvalue, const Eigen::Matrix2d& mode) {
      if(!(eigenvalue > 0))
        return;
      Eigen::Matrix<double, 6, 1> column;
      column << mode * g[0], mode * g[1], mode * g[2];
      hessian.noalias() += (area * eigenvalue) * column * column.transpose();
    };
    add_mode(twist, (shear_1 - shear_2) / std::sqrt(2.));
    add_mode(flip, (shear_1 + shear_2) / std::sqrt(2.));
    for(int i = 0; i < 2; ++i) {
      const Eigen::Vector2d mode = scaling_modes.eigenvectors().col(i);
      add_mode(scaling_modes.eigenvalues()[i], mode[0] * stretch_1 + mode[1] * stretch_2);
    }
    return hessian;
  }

private:
  /// singular value decomposition K = s1 u1 v1^T + s2 u2 v2^T of a matrix with positive determinant
  struct Singular_values
  {
    explicit Singular_values(const Eigen::Matrix2d& K)
    {
      const double sum = std::atan2(K(1, 0) - K(0, 1), K(0, 0) + K(1, 1));
      const double difference = std::atan2(K(1, 0) + K(0, 1), K(0, 0) - K(1, 1));
      const double left = (sum + difference) / 2, right = (difference - sum) / 2;
      u1 = {std::cos(left), std::sin(left)};
      u2 = {-u1.y(), u1.x()};
      v1 = {std::cos(right), std::sin(right)};
      v2 = {-v1.y(), v1.x()};
      s1 = (std::hypot(K(0, 0) + K(1, 1), K(1, 0) - K(0, 1)) + std::hypot(K(0, 0) - K(1, 1), K(1, 0) + K(0, 1))) / 2;
      s2 = K.determinant() / s1; // a difference of the two lengths would cancel
    }

    double s1, s2;
    Eigen::Vector2d u1, u2, v1, v2;
  };

  static Hat_gradients hat_gradients(const Flat_triangle& shape)
  {
    const Eigen::Vector2d first(1 / shape.x1, -shape.x2 / (shape.x1 * shape.y2)), second(0, 1 / shape.y2);
    return {-first - second, first, second};
  }

  Eigen::Matrix2d jacobian(int f, const Uv_coordinates& uv, const Hat_gradients& g) const
  {
    const auto& t = m_patch.triangles[f];
    return (uv.row(t[1]) - uv.row(t[0])).transpose() * g[1].transpose() +
           (uv.row(t[2]) - uv.row(t[0])).transpose() * g[2].transpose();
  }

  /// the derivative of the determinant
  static Eigen::Matrix2d cofactor(const Eigen::Matrix2d& K)
  {
    Eigen::Matrix2d result;
    result << K(1, 1), -K(1, 0), -K(0, 1), K(0, 0);
    return result;
  }

  Eigen::Matrix2d derivative_of(const Eigen::Matrix2d& K) const
  {
    const double determinant = K.determinant(), inverse_2 = 1 / (determinant * determinant);
    return 2 * (inverse_2 + m_balance) * K - (2 * K.squaredNorm() * inverse_2 / determinant) * cofactor(K);
  }

  const Patch& m_patch;
  double m_balance;
};

} // namespace internal
} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_BALANCED_ENERGY_H
