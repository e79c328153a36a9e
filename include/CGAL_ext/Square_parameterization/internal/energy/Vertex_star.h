// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ENERGY_VERTEX_STAR_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ENERGY_VERTEX_STAR_H

#include <CGAL_ext/Square_parameterization/internal/common/Minimizer_numbers.h>
#include <CGAL_ext/Square_parameterization/internal/energy/Triangle_pair.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

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
    : m_balance(balance), m_to_rectangle(to_rectangle), m_is_square(to_rectangle.x() == 1 && to_rectangle.y() == 1)
  {}

  /// takes the triangles `pair(0)`, `pair(1)`, ... for those around the vertex.
  /// \param origin the position to which others are taken relative; it should be near: tiny triangles would lose their
  ///        digits far from it
  /// \param number_of_pairs the number of these
  /// \param pair returns a `Triangle_pair`
  template <class Pair>
  void set(const Eigen::RowVector2d& origin, std::size_t number_of_pairs, const Pair& pair)
  {
    if(m_corners.size() < number_of_pairs)
      m_corners.resize(number_of_pairs);
    m_origin = on_rectangle(origin);
    m_number_of_pairs = number_of_pairs;
    const double origin_u = m_origin.x(), origin_v = m_origin.y();
    Corners* corners = m_corners.data();
    for(std::size_t i = 0; i < number_of_pairs; ++i, ++corners) {
      const Triangle_pair triangles = pair(i);
      const Corner_pair& shapes = triangles.shapes;
      Numbers start_u = triangles.q_u, side_u = triangles.r_u - triangles.q_u;
      Numbers start_v = triangles.q_v, side_v = triangles.r_v - triangles.q_v;
      if(!m_is_square) {
        start_u *= m_to_rectangle.x(), side_u *= m_to_rectangle.x();
        start_v *= m_to_rectangle.y(), side_v *= m_to_rectangle.y();
      }
      start_u -= origin_u, start_v -= origin_v;
      const Numbers slope_u = -shapes.inverse_twice_area * side_v, slope_v = shapes.inverse_twice_area * side_u;
      corners->determinant_at_origin = -(start_u * slope_u + start_v * slope_v);
      corners->squared_side = shapes.squared_side;
      corners->least_dirichlet = shapes.squared_height * (side_u * side_u + side_v * side_v);
      corners->foot_u = start_u + shapes.foot * side_u;
      corners->foot_v = start_v + shapes.foot * side_v;
      corners->determinant_by_u = slope_u;
      corners->determinant_by_v = slope_v;
    }
  }

  /// the energy with the vertex at \p position; infinite, or not a number, when a triangle is not counter-clockwise
  double energy(const Eigen::RowVector2d& position) const { return energy_at(on_rectangle(position) - m_origin); }

  /// moves \p position by one step of Newton's method, of which the Hessian is made positive definite, to a lower
  /// energy, along the axes that are free. Returns false when it stays.
  bool improve(Eigen::RowVector2d& position, const std::array<bool, 2>& is_free)
  {
    const Eigen::RowVector2d p = on_rectangle(position) - m_origin;
    take_derivatives(p.x(), p.y());
    find_step(is_free);
    return take_step(position);
  }

  // What follows is the same in three parts, for a vertex at the origin. No part waits for a result of another star: a
  // processor that works ahead is busy with several stars when each part is done for all of them before the next.

  /// the derivatives at the origin
  void take_derivatives_at_origin() { take_derivatives(Origin(), Origin()); }

  /// the direction and the length of a step from where the derivatives were taken
  void find_step(const std::array<bool, 2>& is_free)
  {
    m_step = newton_step(m_here, is_free);
    m_slope = m_here.gradient.dot(m_step);
    m_length = (std::min)(1., Minimizer_numbers::STAR_SAFETY * largest_step(m_step));
  }

  /// moves \p position, where the derivatives were taken, by this step, or by less, to a lower energy; returns false
  /// when it stays
  bool take_step(Eigen::RowVector2d& position) const
  {
    if(!(-m_slope > Minimizer_numbers::STAR_NEGLIGIBLE * m_here.energy))
      return false;
    double length = m_length;
    for(int i = 0; i < Minimizer_numbers::MAXIMUM_STAR_HALVINGS; ++i, length /= 2) {
      Eigen::RowVector2d move = length * m_step;
      if(!m_is_square)
        move = move.cwiseQuotient(m_to_rectangle);
      const Eigen::RowVector2d moved = position + move;
      if(energy(moved) <= m_here.energy + Minimizer_numbers::SUFFICIENT_DECREASE * length * m_slope) {
        position = moved;
        return true;
      }
    }
    return false;
  }

private:
  typedef Eigen::Array2d Numbers; // of two triangles

  /// a coordinate that is known to be zero
  struct Origin
  {
    friend Numbers operator-(Origin, const Numbers& x) { return -x; }
  };

  struct Corners
  {
    Numbers determinant_at_origin, squared_side, least_dirichlet;
    Numbers foot_u, foot_v, determinant_by_u, determinant_by_v;
    Numbers inverse_determinant; // where the derivatives were taken
  };

  struct Derivatives
  {
    double energy;
    Eigen::RowVector2d gradient;
    double uu, uv, vv; // of the Hessian
  };

  Eigen::RowVector2d on_rectangle(const Eigen::RowVector2d& position) const
  {
    if(m_is_square)
      return position;
    return position.cwiseProduct(m_to_rectangle);
  }

  // positions are on the rectangle, and relative to the origin, from here on

  double energy_at(const Eigen::RowVector2d& p) const
  {
    Numbers energy(0, 0), least(1, 1);
    for(std::size_t i = 0; i < m_number_of_pairs; ++i) {
      const Corners& corners = m_corners[i];
      const Numbers J = determinant(corners, p.x(), p.y());
      least = least.min(J);
      energy += dirichlet(corners, p.x() - corners.foot_u, p.y() - corners.foot_v) * (1 / (J * J) + m_balance);
    }
    return least.minCoeff() > 0 ? energy.sum() : std::numeric_limits<double>::infinity();
  }

  static Numbers determinant(const Corners& corners, double u, double v)
  {
    return corners.determinant_at_origin + corners.determinant_by_u * u + corners.determinant_by_v * v;
  }
  static Numbers determinant(const Corners& corners, Origin, Origin) { return corners.determinant_at_origin; }

  /// \param to_u what leads from the foot to the vertex
  static Numbers dirichlet(const Corners& corners, const Numbers& to_u, const Numbers& to_v)
  {
    return corners.squared_side * (to_u * to_u + to_v * to_v) + corners.least_dirichlet;
  }

  /// \param u, v either numbers, or both the origin
  template <class Coordinate>
  void take_derivatives(Coordinate u, Coordinate v)
  {
    const double balance = m_balance;
    Numbers energy(0, 0), by_u(0, 0), by_v(0, 0), uu(0, 0), uv(0, 0), vv(0, 0);
    Corners* corners = m_corners.data();
    for(std::size_t i = m_number_of_pairs; i > 0; --i, ++corners) {
      const Numbers to_u = u - corners->foot_u, to_v = v - corners->foot_v;
      const Numbers s_u = corners->determinant_by_u, s_v = corners->determinant_by_v;
      const Numbers inverse = 1 / determinant(*corners, u, v), E = dirichlet(*corners, to_u, to_v);
      corners->inverse_determinant = inverse;
      const Numbers weight = inverse * inverse + balance;
      const Numbers first = -2 * inverse * inverse * inverse; // derivative of the weight by J
      const Numbers second = -3 * first * inverse * E;        // and the next one, times E
      const Numbers twice = 2 * corners->squared_side, e_u = twice * to_u, e_v = twice * to_v; // derivatives of E
      const Numbers E_by_J = first * E, curvature = weight * twice, second_u = second * s_u, second_v = second * s_v;
      energy += E * weight;
      by_u += weight * e_u + E_by_J * s_u;
      by_v += weight * e_v + E_by_J * s_v;
      uu += curvature + 2 * (first * e_u * s_u) + second_u * s_u;
      uv += first * (e_u * s_v + e_v * s_u) + second_u * s_v;
      vv += curvature + 2 * (first * e_v * s_v) + second_v * s_v;
    }
    m_here = {energy.sum(), {by_u.sum(), by_v.sum()}, uu.sum(), uv.sum(), vv.sum()};
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
    Numbers loss(0, 0); // of the area of triangles, relative, in the whole step
    for(std::size_t i = 0; i < m_number_of_pairs; ++i)
      loss = loss.max(-(m_corners[i].determinant_by_u * step.x() + m_corners[i].determinant_by_v * step.y()) *
                      m_corners[i].inverse_determinant);
    return 1 / loss.maxCoeff();
  }

  double m_balance;
  Eigen::RowVector2d m_to_rectangle;
  bool m_is_square;
  Eigen::RowVector2d m_origin = Eigen::RowVector2d::Zero();
  std::vector<Corners> m_corners; // the first of them, the others are memory
  std::size_t m_number_of_pairs = 0;
  Derivatives m_here{0, Eigen::RowVector2d::Zero(), 0, 0, 0};
  Eigen::RowVector2d m_step = Eigen::RowVector2d::Zero(); // on the rectangle
  double m_slope = 0, m_length = 0;
};

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ENERGY_VERTEX_STAR_H
