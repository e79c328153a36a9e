// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_VERTEX_STAR_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_VERTEX_STAR_H

#include <CGAL_ext/Square_parameterization/internal/Patch.h>

#include <array>
#include <cmath>
#include <vector>

namespace CGAL_ext {
namespace internal {

/// what the energy of a triangle needs to know of its shape when one of its corners moves; all on the surface
struct Corner_shape
{
  double area;
  double squared_side;   ///< of the side opposite to the corner
  double squared_height; ///< over that side
  double foot;           ///< where the height divides the side: 0 at the next corner, 1 at the one after it
};

inline Corner_shape corner_shape(const Flat_triangle& shape, int corner)
{
  const std::array<Eigen::Vector2d, 3> plane{Eigen::Vector2d(0, 0), Eigen::Vector2d(shape.x1, 0),
                                             Eigen::Vector2d(shape.x2, shape.y2)};
  const Eigen::Vector2d& start = plane[(corner + 1) % 3];
  const Eigen::Vector2d side = plane[(corner + 2) % 3] - start;
  const double squared_side = side.squaredNorm(), twice_area = 2 * shape.area();
  return {shape.area(), squared_side, twice_area * twice_area / squared_side,
          (plane[corner] - start).dot(side) / squared_side};
}

/// the balanced energy (see `Balanced_energy`) of the triangles around one vertex, as a function of its uv position p
/// alone.
///
/// In a triangle with the opposite side from q to r, the determinant D is linear in p, and N = c |p - foot|^2 + N0: c is
/// the squared length of the side on the surface, and the foot divides qr as the height of the triangle does there.
class Vertex_star
{
public:
  explicit Vertex_star(double balance) : m_balance(balance) {}

  /// forgets all triangles. Positions are taken relative to \p origin, which should be near: tiny triangles would lose
  /// their digits far from it.
  void clear(const Eigen::RowVector2d& origin)
  {
    m_corners.clear();
    m_origin = origin;
  }

  /// adds a triangle of which the vertex is a corner; \p q and \p r are the uv positions of the next two corners
  void add(const Corner_shape& shape, const Eigen::RowVector2d& q, const Eigen::RowVector2d& r)
  {
    const Eigen::RowVector2d start = q - m_origin, side = r - q;
    m_corners.push_back({shape.area,
                         shape.squared_side,
                         start.x() * side.y() - start.y() * side.x(),
                         shape.squared_height * side.squaredNorm(),
                         start + shape.foot * side,
                         {-side.y(), side.x()}});
  }

  /// the energy with the vertex at \p position; infinite when a triangle is not counter-clockwise
  double energy(const Eigen::RowVector2d& position) const { return energy_at(position - m_origin); }

  /// moves \p position by one step of Newton's method, of which the Hessian is made positive definite, to a lower
  /// energy, along the axes that are free. Returns false when it stays.
  bool improve(Eigen::RowVector2d& position, const std::array<bool, 2>& is_free) const
  {
    constexpr double SAFETY = 0.8, SUFFICIENT_DECREASE = 1e-4, NEGLIGIBLE = 1e-12;
    constexpr int MAXIMUM_HALVINGS = 4;
    const Eigen::RowVector2d p = position - m_origin;
    const Derivatives here = derivatives(p);
    const Eigen::RowVector2d step = newton_step(here, is_free);
    const double slope = here.gradient.dot(step);
    if(!(-slope > NEGLIGIBLE * here.energy))
      return false;
    double length = (std::min)(1., SAFETY * largest_step(p, step));
    for(int i = 0; i < MAXIMUM_HALVINGS; ++i, length /= 2) {
      const Eigen::RowVector2d moved = position + length * step;
      if(energy(moved) <= here.energy + SUFFICIENT_DECREASE * length * slope) {
        position = moved;
        return true;
      }
    }
    return false;
  }

private:
  struct Corner
  {
    double area, squared_side, determinant_at_origin, least_norm;
    Eigen::RowVector2d foot, determinant_slope;

    double determinant(const Eigen::RowVector2d& p) const { return determinant_at_origin + determinant_slope.dot(p); }
    double norm(const Eigen::RowVector2d& p) const { return squared_side * (p - foot).squaredNorm() + least_norm; }
  };

  struct Derivatives
  {
    double energy = 0;
    Eigen::RowVector2d gradient = Eigen::RowVector2d::Zero();
    Eigen::Matrix2d hessian = Eigen::Matrix2d::Zero();
  };

  // positions are relative to the origin from here on

  double energy_at(const Eigen::RowVector2d& p) const
  {
    double energy = 0;
    for(const Corner& corner : m_corners) {
      const double D = corner.determinant(p);
      if(!(D > 0))
        return std::numeric_limits<double>::infinity();
      energy += corner.norm(p) * factor(corner, D);
    }
    return energy;
  }

  double factor(const Corner& corner, double determinant) const
  {
    return corner.area / (determinant * determinant) + m_balance / (4 * corner.area);
  }

  Derivatives derivatives(const Eigen::RowVector2d& p) const
  {
    Derivatives d;
    for(const Corner& corner : m_corners) {
      const double D = corner.determinant(p), N = corner.norm(p), weight = factor(corner, D);
      const Eigen::RowVector2d norm_slope = 2 * corner.squared_side * (p - corner.foot);
      const double first = -2 * corner.area / (D * D * D), second = -3 * first / D * N; // of the weight; times N
      const Eigen::RowVector2d& s = corner.determinant_slope;
      const Eigen::Matrix2d mixed = norm_slope.transpose() * s;
      d.energy += N * weight;
      d.gradient += weight * norm_slope + first * N * s;
      d.hessian += 2 * weight * corner.squared_side * Eigen::Matrix2d::Identity() +
                   first * (mixed + mixed.transpose()) + second * s.transpose() * s;
    }
    return d;
  }

  static Eigen::RowVector2d newton_step(const Derivatives& d, const std::array<bool, 2>& is_free)
  {
    constexpr double LEAST_RATIO = 1e-3, SHIFT = 0.05; // of the eigenvalues of the Hessian, to the larger one
    Eigen::Matrix2d H = d.hessian;
    if(!is_free[0] || !is_free[1]) {
      const int axis = is_free[0] ? 0 : 1;
      Eigen::RowVector2d step(0, 0);
      if(is_free[axis] && H(axis, axis) > 0)
        step[axis] = -d.gradient[axis] / H(axis, axis);
      return step;
    }
    const double mean = (H(0, 0) + H(1, 1)) / 2, half = (H(0, 0) - H(1, 1)) / 2;
    const double radius = std::sqrt(half * half + H(0, 1) * H(0, 1));
    const double least = mean - radius, largest = mean + radius;
    if(least < LEAST_RATIO * largest)
      H.diagonal().array() += SHIFT * largest - least;
    return {-(H(1, 1) * d.gradient.x() - H(0, 1) * d.gradient.y()) / H.determinant(),
            -(H(0, 0) * d.gradient.y() - H(0, 1) * d.gradient.x()) / H.determinant()};
  }

  /// the length of the step at which the first triangle loses its area
  double largest_step(const Eigen::RowVector2d& p, const Eigen::RowVector2d& step) const
  {
    double largest = std::numeric_limits<double>::infinity();
    for(const Corner& corner : m_corners) {
      const double change = corner.determinant_slope.dot(step);
      if(change < 0)
        largest = (std::min)(largest, -corner.determinant(p) / change);
    }
    return largest;
  }

  double m_balance;
  Eigen::RowVector2d m_origin = Eigen::RowVector2d::Zero();
  std::vector<Corner> m_corners;
};

} // namespace internal
} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_VERTEX_STAR_H
