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

/// two triangles that share the corner that moves: what is computed of one is computed of both by the same instructions
struct Corner_pair
{
  Corner_pair() = default;
  Corner_pair(const Corner_shape& a, const Corner_shape& b)
    : inverse_twice_area(a.inverse_twice_area, b.inverse_twice_area),
      squared_side(a.squared_side, b.squared_side),
      squared_height(a.squared_height, b.squared_height),
      foot(a.foot, b.foot)
  {}

  /// one triangle, which counts as two with half of the energy
  static Corner_pair of_one(Corner_shape shape)
  {
    shape.squared_side /= 2;
    shape.squared_height /= 2;
    return {shape, shape};
  }

  Eigen::Array2d inverse_twice_area, squared_side, squared_height, foot; // see `Corner_shape`
};

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
    add(Corner_pair::of_one(shape), {q, q}, {r, r});
  }

  /// adds two triangles
  void add(const Corner_pair& shapes, const std::array<Eigen::RowVector2d, 2>& q,
           const std::array<Eigen::RowVector2d, 2>& r)
  {
    const Numbers q_u(q[0].x(), q[1].x()), q_v(q[0].y(), q[1].y()), r_u(r[0].x(), r[1].x()), r_v(r[0].y(), r[1].y());
    const Numbers start_u = q_u * m_to_rectangle.x() - m_origin.x(), side_u = (r_u - q_u) * m_to_rectangle.x();
    const Numbers start_v = q_v * m_to_rectangle.y() - m_origin.y(), side_v = (r_v - q_v) * m_to_rectangle.y();
    const Numbers slope_u = -shapes.inverse_twice_area * side_v, slope_v = shapes.inverse_twice_area * side_u;
    m_corners.push_back({-(start_u * slope_u + start_v * slope_v), shapes.squared_side,
                         shapes.squared_height * (side_u * side_u + side_v * side_v), start_u + shapes.foot * side_u,
                         start_v + shapes.foot * side_v, slope_u, slope_v, Numbers(0, 0)});
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
  typedef Eigen::Array2d Numbers; // of two triangles

  struct Corners
  {
    Numbers determinant_at_origin, squared_side, least_dirichlet;
    Numbers foot_u, foot_v, determinant_by_u, determinant_by_v;
    Numbers inverse_determinant; // where the derivatives were taken

    Numbers determinant(const Eigen::RowVector2d& p) const
    {
      return determinant_at_origin + determinant_by_u * p.x() + determinant_by_v * p.y();
    }
    Numbers dirichlet(const Eigen::RowVector2d& p) const
    {
      const Numbers u = p.x() - foot_u, v = p.y() - foot_v;
      return squared_side * (u * u + v * v) + least_dirichlet;
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
    Numbers energy(0, 0);
    for(const Corners& corners : m_corners) {
      const Numbers J = corners.determinant(p);
      if(!(J > 0).all())
        return std::numeric_limits<double>::infinity();
      energy += corners.dirichlet(p) * (1 / (J * J) + m_balance);
    }
    return energy.sum();
  }

  Derivatives derivatives(const Eigen::RowVector2d& p)
  {
    Numbers energy(0, 0), by_u(0, 0), by_v(0, 0), uu(0, 0), uv(0, 0), vv(0, 0);
    for(Corners& corners : m_corners) {
      const Numbers inverse = 1 / corners.determinant(p), E = corners.dirichlet(p);
      corners.inverse_determinant = inverse;
      const Numbers weight = inverse * inverse + m_balance;
      const Numbers first = -2 * inverse * inverse * inverse; // derivative of the weight by J
      const Numbers second = -3 * first * inverse * E;        // and the next one, times E
      const Numbers &s_u = corners.determinant_by_u, &s_v = corners.determinant_by_v;
      const Numbers e_u = 2 * corners.squared_side * (p.x() - corners.foot_u); // gradient of E
      const Numbers e_v = 2 * corners.squared_side * (p.y() - corners.foot_v);
      energy += E * weight;
      by_u += weight * e_u + first * E * s_u;
      by_v += weight * e_v + first * E * s_v;
      uu += 2 * weight * corners.squared_side + 2 * first * e_u * s_u + second * s_u * s_u;
      uv += first * (e_u * s_v + e_v * s_u) + second * s_u * s_v;
      vv += 2 * weight * corners.squared_side + 2 * first * e_v * s_v + second * s_v * s_v;
    }
    return {energy.sum(), {by_u.sum(), by_v.sum()}, uu.sum(), uv.sum(), vv.sum()};
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
    for(const Corners& corners : m_corners)
      loss = loss.max(-(corners.determinant_by_u * step.x() + corners.determinant_by_v * step.y()) *
                      corners.inverse_determinant);
    return 1 / loss.maxCoeff();
  }

  double m_balance;
  Eigen::RowVector2d m_to_rectangle;
  Eigen::RowVector2d m_origin = Eigen::RowVector2d::Zero();
  std::vector<Corners> m_corners;
};

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ENERGY_VERTEX_STAR_H
