// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ENERGY_VERTEX_STAR_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ENERGY_VERTEX_STAR_H

#include <CGAL_ext/Square_parameterization/internal/common/Minimizer_numbers.h>
#include <CGAL_ext/Square_parameterization/internal/patch/Patch.h>

#include <array>
#include <cmath>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// what the energy of a triangle needs to know of its shape when one of its corners moves; all on the surface
struct Corner_shape
{
  double inverse_twice_area;
  double squared_side;   ///< of the side opposite to the corner, in units of four times the area
  double squared_height; ///< over that side, in the same units
  double foot;           ///< where the height divides the side: 0 at the next corner, 1 at the one after it
};

inline Corner_shape corner_shape(const Flat_triangle& shape, int corner)
{
  const std::array<Eigen::Vector2d, 3> plane{Eigen::Vector2d(0, 0), Eigen::Vector2d(shape.x1, 0),
                                             Eigen::Vector2d(shape.x2, shape.y2)};
  const Eigen::Vector2d& start = plane[(corner + 1) % 3];
  const Eigen::Vector2d side = plane[(corner + 2) % 3] - start;
  const double squared_side = side.squaredNorm(), area = shape.area();
  return {1 / (2 * area), squared_side / (4 * area), area / squared_side,
          (plane[corner] - start).dot(side) / squared_side};
}

/// the balanced energy (see `Balanced_energy`) of the triangles around one vertex, as a function of its uv position p
/// alone.
///
/// With the Jacobian K, J = det(K) and E = |K|^2 times its area, a triangle contributes E (1 / J^2 + b). When qr is the
/// side opposite to p, J is linear in p, and E = c |p - foot|^2 + E0: c is the squared length of the side on the
/// surface over four times the area, and the foot divides qr as the height of the triangle does there.
class Vertex_star
{
public:
  /// \param to_rectangle what takes the unit square, where the positions lie, to the rectangle of the energy
  explicit Vertex_star(double balance, const Eigen::RowVector2d& to_rectangle = {1, 1})
    : m_balance(balance), m_to_rectangle(to_rectangle)
  {}

  /// forgets all triangles. Positions are taken relative to \p origin, which should be near: tiny triangles would lose
  /// their digits far from it.
  void clear(const Eigen::RowVector2d& origin)
  {
    m_corners.clear();
    m_origin = on_rectangle(origin);
  }

  /// adds a triangle of which the vertex is a corner; \p q and \p r are the uv positions of the next two corners
  void add(const Corner_shape& shape, const Eigen::RowVector2d& q, const Eigen::RowVector2d& r)
  {
    const Eigen::RowVector2d start = on_rectangle(q) - m_origin, side = on_rectangle(r - q);
    const Eigen::RowVector2d slope = shape.inverse_twice_area * Eigen::RowVector2d(-side.y(), side.x());
    m_corners.push_back({-start.dot(slope), shape.squared_side, shape.squared_height * side.squaredNorm(),
                         start + shape.foot * side, slope, 0});
  }

  /// the energy with the vertex at \p position; infinite when a triangle is not counter-clockwise
  double energy(const Eigen::RowVector2d& position) const { return energy_at(on_rectangle(position) - m_origin); }

  /// moves \p position by one step of Newton's method, of which the Hessian is made positive definite, to a lower
  /// energy, along the axes that are free. Returns false when it stays.
  bool improve(Eigen::RowVector2d& position, const std::array<bool, 2>& is_free)
  {
    const Eigen::RowVector2d p = on_rectangle(position) - m_origin;
    const Derivatives here = derivatives(p);
    const Eigen::RowVector2d step = newton_step(here, is_free);
    const double slope = here.gradient.dot(step);
    if(!(-slope > Minimizer_numbers::STAR_NEGLIGIBLE * here.energy))
      return false;
    double length = (std::min)(1., Minimizer_numbers::STAR_SAFETY * largest_step(step));
    for(int i = 0; i < Minimizer_numbers::MAXIMUM_STAR_HALVINGS; ++i, length /= 2) {
      const Eigen::RowVector2d moved = position + (length * step).cwiseQuotient(m_to_rectangle);
      if(energy(moved) <= here.energy + Minimizer_numbers::SUFFICIENT_DECREASE * length * slope) {
        position = moved;
        return true;
      }
    }
    return false;
  }

private:
  struct Corner
  {
    double determinant_at_origin, squared_side, least_dirichlet;
    Eigen::RowVector2d foot, determinant_slope;
    double inverse_determinant; // where the derivatives were taken

    double determinant(const Eigen::RowVector2d& p) const { return determinant_at_origin + determinant_slope.dot(p); }
    double dirichlet(const Eigen::RowVector2d& p) const
    {
      return squared_side * (p - foot).squaredNorm() + least_dirichlet;
    }
  };

  struct Derivatives
  {
    double energy;
    Eigen::RowVector2d gradient;
    double uu, uv, vv; // of the Hessian
  };

  Eigen::RowVector2d on_rectangle(const Eigen::RowVector2d& position) const
  {
    return position.cwiseProduct(m_to_rectangle);
  }

  // positions are on the rectangle, and relative to the origin, from here on

  double energy_at(const Eigen::RowVector2d& p) const
  {
    double energy = 0;
    for(const Corner& corner : m_corners) {
      const double J = corner.determinant(p);
      if(!(J > 0))
        return std::numeric_limits<double>::infinity();
      energy += corner.dirichlet(p) * (1 / (J * J) + m_balance);
    }
    return energy;
  }

  Derivatives derivatives(const Eigen::RowVector2d& p)
  {
    double energy = 0, by_u = 0, by_v = 0, uu = 0, uv = 0, vv = 0;
    for(Corner& corner : m_corners) {
      const double inverse = 1 / corner.determinant(p), E = corner.dirichlet(p);
      corner.inverse_determinant = inverse;
      const double weight = inverse * inverse + m_balance;
      const double first = -2 * inverse * inverse * inverse; // derivative of the weight by J
      const double second = -3 * first * inverse * E;        // and the next one, times E
      const Eigen::RowVector2d& s = corner.determinant_slope;
      const Eigen::RowVector2d e = 2 * corner.squared_side * (p - corner.foot); // gradient of E
      energy += E * weight;
      by_u += weight * e.x() + first * E * s.x();
      by_v += weight * e.y() + first * E * s.y();
      uu += 2 * weight * corner.squared_side + 2 * first * e.x() * s.x() + second * s.x() * s.x();
      uv += first * (e.x() * s.y() + e.y() * s.x()) + second * s.x() * s.y();
      vv += 2 * weight * corner.squared_side + 2 * first * e.y() * s.y() + second * s.y() * s.y();
    }
    return {energy, {by_u, by_v}, uu, uv, vv};
  }

  static Eigen::RowVector2d newton_step(const Derivatives& d, const std::array<bool, 2>& is_free)
  {
    if(!is_free[0] || !is_free[1])
      return {is_free[0] && d.uu > 0 ? -d.gradient.x() / d.uu : 0, is_free[1] && d.vv > 0 ? -d.gradient.y() / d.vv : 0};
    const double mean = (d.uu + d.vv) / 2, half = (d.uu - d.vv) / 2;
    const double radius = std::sqrt(half * half + d.uv * d.uv);
    const double least = mean - radius, largest = mean + radius;
    const double shift = least < Minimizer_numbers::LEAST_EIGENVALUE_RATIO * largest
                             ? Minimizer_numbers::EIGENVALUE_SHIFT * largest - least
                             : 0;
    const double uu = d.uu + shift, vv = d.vv + shift, determinant = uu * vv - d.uv * d.uv;
    return {(d.uv * d.gradient.y() - vv * d.gradient.x()) / determinant,
            (d.uv * d.gradient.x() - uu * d.gradient.y()) / determinant};
  }

  /// the length of the step, from where the derivatives were taken, at which the first triangle loses its area;
  /// infinite when none does
  double largest_step(const Eigen::RowVector2d& step) const
  {
    double loss = 0; // of the area of a triangle, relative, in the whole step
    for(const Corner& corner : m_corners)
      loss = (std::max)(loss, -corner.determinant_slope.dot(step) * corner.inverse_determinant);
    return 1 / loss;
  }

  double m_balance;
  Eigen::RowVector2d m_to_rectangle;
  Eigen::RowVector2d m_origin = Eigen::RowVector2d::Zero();
  std::vector<Corner> m_corners;
};

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ENERGY_VERTEX_STAR_H
