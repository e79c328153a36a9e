// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ENERGY_BALANCED_ENERGY_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ENERGY_BALANCED_ENERGY_H

#include <CGAL_ext/Square_parameterization/internal/common/ranges.h>
#include <CGAL_ext/Square_parameterization/internal/energy/rectangle.h>
#include <CGAL_ext/Square_parameterization/internal/patch/Patch.h>
#include <CGAL_ext/Square_parameterization/internal/patch/Patch_division.h>

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// the balanced stretch of a map: the sum over the triangles of their area A times
///
///     f(K) = 1/s1^2 + 1/s2^2 + b (s1^2 + s2^2) = |K|^2 / det(K)^2 + b |K|^2
///
/// where K is the Jacobian of the map from the triangle's own plane to the uv plane and s1 >= s2 > 0 its singular
/// values. b = 0 is twice the squared L2 stretch, b = 1 the symmetric Dirichlet energy. It is infinite when a triangle
/// is not counter-clockwise.
///
/// With D twice the uv area and N = |x1 db - x2 da|^2 + y2^2 |da|^2, da and db the uv edges from the first corner and
/// (x1, 0), (x2, y2) the edges in the plane, |K|^2 = N / (4 A^2) and det K = D / (2 A): a triangle contributes
///
///     N (A / D^2 + b / (4 A))
///
/// which is a sum of squares times a number, exact for slivers, too.
///
/// On a rectangle of area 1 and width w, the squared gradients of u count w^2 times, and those of v 1 / w^2: the energy is
/// w^2 P + Q / w^2, where P and Q are those of u and of v. It is least at w^4 = Q / P, and then 2 sqrt(P Q): the aspect
/// w^2 is no unknown, and by the envelope theorem the gradient is that at this w.
///
/// Sums are made by the threads of the current team, in an order that does not depend on their number.
class Balanced_energy
{
public:
  /// \param aspect width over height of the rectangle; none for the best one of each map
  /// \param division of the patch, which must live as long; null for none: then one thread computes the gradient
  Balanced_energy(const Patch& patch, double balance, std::optional<double> aspect = 1,
                  const Patch_division* division = nullptr)
    : m_patch(patch),
      m_balance(balance),
      m_aspect(aspect.value_or(1)),
      m_is_aspect_given(aspect.has_value()),
      m_division(division)
  {}

  const Patch& patch() const { return m_patch; }
  double balance() const { return m_balance; }

  /// width over height of the rectangle on which the map (#V by 2) is measured; 1 when a triangle is not
  /// counter-clockwise and the best is asked for
  double aspect(const Uv_coordinates& uv) const
  {
    if(m_is_aspect_given)
      return m_aspect;
    // P and Q; not a number when a triangle is not counter-clockwise
    const Eigen::Array2d along = sum_over_triangles(Eigen::Array2d(0, 0), [&](std::size_t begin, std::size_t end) {
      double along_u = 0, along_v = 0;
      for(std::size_t f = begin; f < end; ++f) {
        const Terms terms(m_patch.shapes[f], m_patch.triangles[f], uv, {1, 1});
        if(!(terms.determinant > 0))
          return Eigen::Array2d(Eigen::Array2d::Constant(std::numeric_limits<double>::quiet_NaN()));
        const double weight = factor(f, terms.determinant), y2 = m_patch.shapes[f].y2;
        along_u += weight * (terms.across.x() * terms.across.x() + y2 * y2 * terms.da.x() * terms.da.x());
        along_v += weight * (terms.across.y() * terms.across.y() + y2 * y2 * terms.da.y() * terms.da.y());
      }
      return Eigen::Array2d(along_u, along_v);
    });
    const double result = std::sqrt(along[1] / along[0]);
    return std::isfinite(result) && result > 0 ? result : 1;
  }

  /// what takes the unit square to that rectangle: see `scale_to_rectangle()`
  Eigen::RowVector2d scale(const Uv_coordinates& uv) const { return scale_to_rectangle(aspect(uv)); }

  /// the energy of a map (#V by 2)
  double operator()(const Uv_coordinates& uv) const
  {
    const Eigen::RowVector2d to_rectangle = scale(uv);
    return sum_over_triangles(0., [&](std::size_t begin, std::size_t end) {
      double energy = 0;
      for(std::size_t f = begin; f < end; ++f) {
        const Terms terms(m_patch.shapes[f], m_patch.triangles[f], uv, to_rectangle);
        if(!(terms.determinant > 0))
          return std::numeric_limits<double>::infinity();
        energy += terms.norm * factor(f, terms.determinant);
      }
      return energy;
    });
  }

  /// the energy of a map without flips, and its gradient (#V by 2)
  double gradient(const Uv_coordinates& uv, Uv_coordinates& gradient) const
  {
    gradient.setZero(uv.rows(), 2);
    const Eigen::RowVector2d to_rectangle = scale(uv);
    double energy = 0;
    const auto add = [&](int f, const Slope& slope, double& sum) {
      const auto& t = m_patch.triangles[f];
      sum += slope.energy;
      gradient.row(t[0]) -= slope.by_da + slope.by_db;
      gradient.row(t[1]) += slope.by_da;
      gradient.row(t[2]) += slope.by_db;
    };
    if(m_division == nullptr || !m_division->is_divided())
      for(int f = 0; f < m_patch.number_of_faces(); ++f)
        add(f, slope_of(f, uv, to_rectangle), energy);
    else
      for_divided_triangles<Slope>(
          *m_division, energy, [&](int f) { return slope_of(f, uv, to_rectangle); }, add);
    gradient *= to_rectangle.asDiagonal();
    return energy;
  }

  /// the multiple of det(K) that is added for Hessians, where no other is given: see `hessian_blocks()`
  static constexpr double AREA_MULTIPLE = 2;

  /// second derivatives of one triangle with respect to the u of its corners, and to the v; those with respect to an u
  /// and a v are left out. Of each the numbers of both axes.
  struct Hessian_blocks
  {
    std::array<Eigen::Array2d, 3> diagonal; ///< twice by corner k
    std::array<Eigen::Array2d, 3> sides;    ///< by corner k and the next one

    /// the derivatives by the coordinates of one axis
    Eigen::Matrix3d of_axis(int axis) const
    {
      Eigen::Matrix3d block;
      for(int k = 0; k < 3; ++k) {
        block(k, k) = diagonal[k][axis];
        block(k, (k + 1) % 3) = block((k + 1) % 3, k) = sides[k][axis];
      }
      return block;
    }
  };

  /// twice the squared L2 stretch of a map: 2 where nothing is stretched. See `hessian_blocks()`.
  /// \param to_rectangle what `scale(uv)` gives
  double twice_squared_l2(const Uv_coordinates& uv, const Eigen::RowVector2d& to_rectangle) const
  {
    return sum_over_triangles(0., [&](std::size_t begin, std::size_t end) {
      double sum = 0;
      for(std::size_t f = begin; f < end; ++f) {
        const Terms terms(m_patch.shapes[f], m_patch.triangles[f], uv, to_rectangle);
        sum += terms.norm * m_patch.shapes[f].area() / (terms.determinant * terms.determinant);
      }
      return sum;
    });
  }

  /// the blocks of the Hessian of triangle \p f, made positive semidefinite by clamping the negative of its
  /// eigenvalues, which are known in closed form (Smith, de Goes, Kim 2019).
  ///
  /// The total signed area of a map with fixed border, or with a border that slides along the square, is constant, so
  /// any multiple of det(K) may be added: the objective and its gradient stay, and fewer eigenvalues need clamping.
  /// \param to_rectangle what `scale(uv)` gives; the aspect is taken as fixed
  /// \param area_multiple this multiple, the same for all triangles
  Hessian_blocks hessian_blocks(int f, const Uv_coordinates& uv, const Eigen::RowVector2d& to_rectangle,
                                double area_multiple = AREA_MULTIPLE) const
  {
    const Flat_triangle& shape = m_patch.shapes[f];
    const Modes modes(jacobian(f, uv, to_rectangle), m_balance, area_multiple);
    const auto [xx, xy, yy] = modes.forms_on_rows();
    // gradients of the hat functions of corners 1, (a, b), and 2, (0, c); that of corner 0 is minus their sum
    const double a = 1 / shape.x1, c = 1 / shape.y2, b = -shape.x2 * a * c;
    const Eigen::Array2d scale = to_rectangle.transpose().array().square() * (shape.area() / 2);
    const Eigen::Array2d h11 = scale * (a * a * xx + 2 * a * b * xy + b * b * yy);
    const Eigen::Array2d h12 = scale * c * (a * xy + b * yy), h22 = scale * (c * c * yy);
    return {{h11 + 2 * h12 + h22, h11, h22}, {-h11 - h12, h12, -h12 - h22}};
  }

private:
  /// what the energy of a triangle is made of
  struct Terms
  {
    Terms(const Flat_triangle& shape, const std::array<int, 3>& t, const Uv_coordinates& uv,
          const Eigen::RowVector2d& to_rectangle)
      : da((uv.row(t[1]) - uv.row(t[0])).cwiseProduct(to_rectangle)),
        db((uv.row(t[2]) - uv.row(t[0])).cwiseProduct(to_rectangle)),
        across(shape.x1 * db - shape.x2 * da),
        norm(across.squaredNorm() + shape.y2 * shape.y2 * da.squaredNorm()),
        determinant(da.x() * db.y() - da.y() * db.x())
    {}

    Eigen::RowVector2d da, db, across;
    double norm, determinant; // N and D
  };

  /// the energy of a triangle and its derivatives by da and db
  struct Slope
  {
    double energy;
    Eigen::RowVector2d by_da, by_db;
  };

  Slope slope_of(int f, const Uv_coordinates& uv, const Eigen::RowVector2d& to_rectangle) const
  {
    const Flat_triangle& shape = m_patch.shapes[f];
    const Terms terms(shape, m_patch.triangles[f], uv, to_rectangle);
    const double D = terms.determinant, weight = factor(f, D);
    // weight times the derivative of N, plus N times the derivative of the weight
    const double by_determinant = -2 * terms.norm * shape.area() / (D * D * D);
    const Eigen::RowVector2d along = 2 * weight * shape.x1 * terms.across;
    return {terms.norm * weight,
            2 * weight * (shape.y2 * shape.y2 * terms.da - shape.x2 * terms.across) +
                by_determinant * Eigen::RowVector2d(terms.db.y(), -terms.db.x()),
            along + by_determinant * Eigen::RowVector2d(-terms.da.y(), terms.da.x())};
  }

  template <class Sum, class Summand>
  Sum sum_over_triangles(Sum zero, const Summand& summand) const
  {
    return sum_of_ranges(m_patch.triangles.size(), zero, summand);
  }

  /// the eigenmodes of f at K, with K = U diag(s1, s2) V^T, and the clamped eigenvalues.
  ///
  /// The modes are products of U, V^T and the four matrices diag(1, 1), diag(1, -1), [0 -1; 1 0] and [0 1; 1 0]: the
  /// first and third depend on the angle of U V^T alone, the others on that of the reflection. f mixes the first two.
  struct Modes
  {
    Modes(const Eigen::Matrix2d& K, double balance, double area_multiple)
    {
      const double turn_cos = (K(0, 0) + K(1, 1)) / 2, turn_sin = (K(1, 0) - K(0, 1)) / 2;
      const double mirror_cos = (K(0, 0) - K(1, 1)) / 2, mirror_sin = (K(1, 0) + K(0, 1)) / 2;
      const double mean = std::sqrt(turn_cos * turn_cos + turn_sin * turn_sin); // (s1 + s2) / 2
      const double half_difference = std::sqrt(mirror_cos * mirror_cos + mirror_sin * mirror_sin);
      turn = {turn_cos / mean, turn_sin / mean};
      mirror = half_difference > 0 ? Eigen::Vector2d(mirror_cos, mirror_sin) / half_difference : Eigen::Vector2d(1, 0);
      const double s1 = mean + half_difference, s2 = K.determinant() / s1; // mean - half_difference would cancel
      const double i1 = 1 / (s1 * s1), i2 = 1 / (s2 * s2), cubes = i1 * i2 / (s1 * s2);
      twist = (std::max)(0., 2 * (balance - (s1 * s1 - s1 * s2 + s2 * s2) * cubes) + area_multiple);
      flip = (std::max)(0., 2 * (balance + (s1 * s1 + s1 * s2 + s2 * s2) * cubes) - area_multiple);
      const double h11 = 6 * i1 * i1 + 2 * balance, h22 = 6 * i2 * i2 + 2 * balance;
      scaling << (h11 + h22) / 2 + area_multiple, (h11 - h22) / 2, (h11 - h22) / 2, (h11 + h22) / 2 - area_multiple;
      clamp(scaling);
    }

    /// symmetric 2 by 2 matrices, one for each axis
    struct Forms
    {
      Eigen::Array2d xx, xy, yy;
    };

    /// the quadratic forms on the two rows of a change of K, times 2.
    ///
    /// With (c, s) the turn and (d, e) the mirror the modes have the rows (c, -s) and (s, c), (d, e) and (e, -d); twist and
    /// flip have these pairs of rows exchanged, but for signs.
    Forms forms_on_rows() const
    {
      const double c = turn.x(), s = turn.y(), d = mirror.x(), e = mirror.y();
      const double even = scaling(0, 0) * c * c + scaling(1, 1) * d * d + twist * s * s + flip * e * e;
      const double odd = scaling(0, 0) * s * s + scaling(1, 1) * e * e + twist * c * c + flip * d * d;
      const double even_mixed = 2 * scaling(0, 1) * c * d, odd_mixed = 2 * scaling(0, 1) * s * e;
      const double mixed = scaling(0, 1) * (c * e - s * d);
      const double across = (scaling(1, 1) - flip) * d * e - (scaling(0, 0) - twist) * c * s;
      return {
          {even + even_mixed, odd + odd_mixed}, {mixed + across, mixed - across}, {odd - odd_mixed, even - even_mixed}};
    }

    /// replaces a negative eigenvalue of a symmetric matrix with a positive one by zero
    static void clamp(Eigen::Matrix2d& matrix)
    {
      const double mean = (matrix(0, 0) + matrix(1, 1)) / 2, half = (matrix(0, 0) - matrix(1, 1)) / 2;
      const double radius = std::sqrt(half * half + matrix(0, 1) * matrix(0, 1));
      if(radius <= mean)
        return;
      const Eigen::Vector2d direction(half + radius, matrix(0, 1)); // of the larger eigenvalue; half > 0 here
      matrix = (mean + radius) / direction.squaredNorm() * direction * direction.transpose();
    }

    Eigen::Vector2d turn, mirror; // cosine and sine
    double twist, flip;
    Eigen::Matrix2d scaling;
  };

  double factor(std::size_t f, double determinant) const
  {
    const double area = m_patch.shapes[f].area();
    return area / (determinant * determinant) + m_balance / (4 * area);
  }

  Eigen::Matrix2d jacobian(int f, const Uv_coordinates& uv, const Eigen::RowVector2d& to_rectangle) const
  {
    const auto& t = m_patch.triangles[f];
    const Flat_triangle& shape = m_patch.shapes[f];
    Eigen::Matrix2d K;
    const Eigen::Vector2d da = (uv.row(t[1]) - uv.row(t[0])).cwiseProduct(to_rectangle).transpose();
    const Eigen::Vector2d db = (uv.row(t[2]) - uv.row(t[0])).cwiseProduct(to_rectangle).transpose();
    K.col(0) = da / shape.x1;
    K.col(1) = (db - shape.x2 * K.col(0)) / shape.y2;
    return K;
  }

  const Patch& m_patch;
  double m_balance;
  double m_aspect;
  bool m_is_aspect_given;
  const Patch_division* m_division;
};

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ENERGY_BALANCED_ENERGY_H
