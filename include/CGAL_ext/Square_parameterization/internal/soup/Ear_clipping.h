// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SOUP_EAR_CLIPPING_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SOUP_EAR_CLIPPING_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// cuts ears off a polygon in space until a triangle is left: the one of the best shape first, of those that are convex
/// and contain no other vertex, seen along the normal of the polygon. When there is none, as for polygons that are flat
/// or meet themselves, the best of the others: triangles may then overlap, but they make a disk in any case.
///
/// CGAL's `triangulate_polygons()` does not know which diagonals are edges of other faces already, which would get a
/// third face, and leaves polygons that it cannot split: ours splits every one.
///
/// Complexity: quadratic in the number of vertices.
class Ear_clipping
{
public:
  /// \param corners of the polygon, at least three
  explicit Ear_clipping(const std::vector<Eigen::Vector3d>& corners) : m_shapes(corners)
  {
    const std::array<int, 2> axes = axes_across(normal());
    for(const Eigen::Vector3d& p : corners)
      m_plane.emplace_back(p[axes[0]], p[axes[1]]);
    for(std::size_t k = 0; k < corners.size(); ++k)
      m_rest.push_back(k);
    for(std::size_t i = 0; i < corners.size(); ++i)
      m_scores.push_back(score(i));
  }

  /// the corners that are left, in their order
  const std::vector<std::size_t>& rest() const { return m_rest; }

  /// cuts off the best ear, unless all are forbidden, and returns whether it did; then the ear is the last of the
  /// triangles. `is_forbidden(a, b)` tells of two corners whether they must not be joined.
  template <class Is_forbidden>
  bool clip(Is_forbidden is_forbidden)
  {
    std::size_t best = m_rest.size();
    for(std::size_t i = 0; i < m_rest.size(); ++i)
      if((best == m_rest.size() || m_scores[i] > m_scores[best]) && !is_forbidden(at(i + m_rest.size() - 1), at(i + 1)))
        best = i;
    if(best == m_rest.size())
      return false;
    m_triangles.push_back({at(best + m_rest.size() - 1), at(best), at(best + 1)});
    m_rest.erase(m_rest.begin() + static_cast<std::ptrdiff_t>(best));
    m_scores.erase(m_scores.begin() + static_cast<std::ptrdiff_t>(best));
    for(std::size_t i : {best + m_rest.size() - 1, best})
      m_scores[i % m_rest.size()] = score(i);
    return true;
  }

  /// the ears, as triples of corners
  const std::vector<std::array<std::size_t, 3>>& triangles() const { return m_triangles; }

private:
  typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;

  std::size_t at(std::size_t i) const { return m_rest[i % m_rest.size()]; }

  /// the normal of the polygon, or zero; makes the corners small on the way, so that no product overflows
  Eigen::Vector3d normal()
  {
    const Eigen::Vector3d origin = m_shapes.front();
    double size = 0;
    for(Eigen::Vector3d& p : m_shapes) {
      p = p / 2 - origin / 2;
      size = (std::max)(size, p.cwiseAbs().maxCoeff());
    }
    Eigen::Vector3d sum(0, 0, 0);
    for(Eigen::Vector3d& p : m_shapes)
      p = p.unaryExpr([size](double x) { return size > 0 ? x / size : 0; });
    for(std::size_t k = 0; k < m_shapes.size(); ++k)
      sum += m_shapes[k].cross(m_shapes[(k + 1) % m_shapes.size()]);
    return sum;
  }

  /// the coordinates that remain when the polygon is seen along the axis nearest to its normal, in such an order that
  /// it is counter-clockwise: no rounding, and what lies on a line stays there
  static std::array<int, 2> axes_across(const Eigen::Vector3d& normal)
  {
    int axis = 0;
    normal.cwiseAbs().maxCoeff(&axis);
    const int next = (axis + 1) % 3, last = (axis + 2) % 3;
    return normal[axis] < 0 ? std::array<int, 2>{last, next} : std::array<int, 2>{next, last};
  }

  /// how good an ear the i-th corner makes: in ]0, 1] by its shape, 1 when it is equilateral; at most -1 for one that
  /// is not convex, or not empty
  double score(std::size_t i) const
  {
    const std::size_t a = at(i + m_rest.size() - 1), b = at(i), c = at(i + 1);
    const Eigen::Vector3d ab = m_shapes[b] - m_shapes[a], bc = m_shapes[c] - m_shapes[b],
                          ca = m_shapes[a] - m_shapes[c];
    const double squares = ab.squaredNorm() + bc.squaredNorm() + ca.squaredNorm();
    const double shape = squares > 0 ? 2 * std::sqrt(3.) * ab.cross(bc).norm() / squares : 0;
    const bool is_convex = CGAL::orientation(m_plane[a], m_plane[b], m_plane[c]) == CGAL::LEFT_TURN;
    return is_convex && is_empty(a, b, c) ? shape : (is_convex ? shape : -shape) - 2;
  }

  /// indicates whether no other corner lies in the triangle or on it, but for those in the same place as one of its own
  bool is_empty(std::size_t a, std::size_t b, std::size_t c) const
  {
    const std::array<Kernel::Point_2, 3> triangle{m_plane[a], m_plane[b], m_plane[c]};
    return std::none_of(m_rest.begin(), m_rest.end(), [&](std::size_t k) {
      const Kernel::Point_2& p = m_plane[k];
      if(std::find(triangle.begin(), triangle.end(), p) != triangle.end())
        return false;
      for(int side = 0; side < 3; ++side)
        if(CGAL::orientation(triangle[side], triangle[(side + 1) % 3], p) == CGAL::RIGHT_TURN)
          return false;
      return true;
    });
  }

  std::vector<Eigen::Vector3d> m_shapes; // the corners, made small
  std::vector<Kernel::Point_2> m_plane;  // the corners as they are, seen along the normal
  std::vector<std::size_t> m_rest;
  std::vector<double> m_scores; // of the rest
  std::vector<std::array<std::size_t, 3>> m_triangles;
};

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SOUP_EAR_CLIPPING_H
