// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ENERGY_BALANCED_ENERGY_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ENERGY_BALANCED_ENERGY_H

#include <CGAL_ext/Square_parameterization/internal/common/ranges.h>
#include <CGAL_ext/Square_parameterization/internal/energy/Hessian_modes.h>
#include <CGAL_ext/Square_parameterization/internal/energy/rectangle.h>
#include <CGAL_ext/Square_parameterization/internal/patch/Patch.h>
#include <CGAL_ext/Square_parameterization/internal/patch/for_triangles.h>

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
      for_divided_triangles<1>(
          *m_division, energy,
          [&](const std::array<int, 1>& f) { return std::array{slope_of(f[0], uv, to_rectangle)}; }, add);
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

  /// the blocks of the Hessians of two triangles, made positive semidefinite by clamping the negative of their
  /// eigenvalues, which are known in closed form (Smith, de Goes, Kim 2019).
  ///
  /// The total signed area of a map with fixed border, or with a border that slides along the square, is constant, so
  /// any multiple of det(K) may be added: the objective and its gradient stay, and fewer eigenvalues need clamping.
  /// \param to_rectangle what `scale(uv)` gives; the aspect is taken as fixed
  /// \param area_multiple this multiple, the same for all triangles
  std::array<Hessian_blocks, 2> hessian_blocks(const std::array<int, 2>& faces, const Uv_coordinates& uv,
                                               const Eigen::RowVector2d& to_rectangle,
                                               double area_multiple = AREA_MULTIPLE) const
  {
    const Triangle_edges edges(m_patch, faces, uv, to_rectangle);
    const auto& [x1, x2, y2, da_u, da_v, db_u, db_v] = edges;
    const Numbers K_uu = da_u / x1, K_vu = da_v / x1;
    const Hessian_modes modes({K_uu, (db_u - x2 * K_uu) / y2, K_vu, (db_v - x2 * K_vu) / y2}, m_balance, area_multiple);
    const std::array<Hessian_modes::Form, 2> forms = modes.forms_on_rows();
    // gradients of the hat functions of corners 1, (a, b), and 2, (0, c); that of corner 0 is minus their sum
    const Numbers a = 1 / x1, c = 1 / y2, b = -x2 * a * c, half_area = x1 * y2 / 2 / 2;
    std::array<Hessian_blocks, 2> result;
    for(int axis = 0; axis < 2; ++axis) {
      const auto& [xx, xy, yy] = forms[axis];
      const Numbers scale = to_rectangle[axis] * to_rectangle[axis] * half_area;
      const Numbers h11 = scale * (a * a * xx + 2 * a * b * xy + b * b * yy);
      const Numbers h12 = scale * c * (a * xy + b * yy), h22 = scale * (c * c * yy);
      const std::array<Numbers, 3> diagonal{h11 + 2 * h12 + h22, h11, h22}, sides{-h11 - h12, h12, -h12 - h22};
      for(int i = 0; i < 2; ++i)
        for(int k = 0; k < 3; ++k) {
          result[i].diagonal[k][axis] = diagonal[k][i];
          result[i].sides[k][axis] = sides[k][i];
        }
    }
    return result;
  }

private:
  typedef Eigen::Array2d Numbers; // of two triangles

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

  double factor(std::size_t f, double determinant) const
  {
    const double area = m_patch.shapes[f].area();
    return area / (determinant * determinant) + m_balance / (4 * area);
  }

  /// the shapes of two triangles, and their uv edges
  struct Triangle_edges
  {
    Triangle_edges(const Patch& patch, const std::array<int, 2>& faces, const Uv_coordinates& uv,
                   const Eigen::RowVector2d& to_rectangle)
    {
      const Flat_triangle &s = patch.shapes[faces[0]], &t = patch.shapes[faces[1]];
      x1 = Numbers(s.x1, t.x1), x2 = Numbers(s.x2, t.x2), y2 = Numbers(s.y2, t.y2);
      const auto &a = patch.triangles[faces[0]], &b = patch.triangles[faces[1]];
      const auto edge = [&](int corner, int axis) -> Numbers {
        return Numbers(uv(a[corner], axis) - uv(a[0], axis), uv(b[corner], axis) - uv(b[0], axis)) * to_rectangle[axis];
      };
      da_u = edge(1, 0), da_v = edge(1, 1), db_u = edge(2, 0), db_v = edge(2, 1);
    }

    Numbers x1, x2, y2, da_u, da_v, db_u, db_v;
  };

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
