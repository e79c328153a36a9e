// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SOUP_EAR_CLIPPING_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SOUP_EAR_CLIPPING_H

#include <CGAL_ext/Square_parameterization/internal/soup/Planar_points.h>
#include <CGAL_ext/Square_parameterization/internal/soup/Polygon_plane.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <queue>
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
/// Complexity: n log n, and for each vertex what `Planar_points` takes to see whether an ear is empty.
class Ear_clipping
{
public:
  /// \param corners of the polygon, at least three
  /// \param plane of the polygon
  Ear_clipping(const std::vector<Eigen::Vector3d>& corners, const Polygon_plane& plane)
    : m_shapes(plane.small_corners()), m_plane(seen(plane, corners)), m_size(corners.size())
  {
    for(std::size_t k = 0; k < m_size; ++k) {
      m_next.push_back((k + 1) % m_size);
      m_previous.push_back((k + m_size - 1) % m_size);
    }
    m_changes.assign(m_size, 0);
    for(std::size_t k = 0; k < m_size; ++k)
      push(k);
  }

  /// the number of corners that are left
  std::size_t size() const { return m_size; }

  /// the corners that are left, in their order
  std::vector<std::size_t> rest() const
  {
    std::vector<std::size_t> corners;
    for(std::size_t k = 0; k < m_next.size(); ++k)
      if(m_changes[k] != CUT_OFF)
        corners.push_back(k);
    return corners;
  }

  /// cuts off the best ear, unless all are forbidden, and returns whether it did; then the ear is the last of the
  /// triangles. `is_forbidden(a, b)` tells of two corners whether they must not be joined; what is forbidden stays so.
  template <class Is_forbidden>
  bool clip(Is_forbidden is_forbidden)
  {
    while(!m_ears.empty()) {
      const Ear ear = m_ears.top();
      m_ears.pop();
      const std::size_t before = m_previous[ear.corner], after = m_next[ear.corner];
      if(ear.changes != m_changes[ear.corner] || is_forbidden(before, after))
        continue; // not what it was: another entry follows; or of no use until a neighbor changes
      m_triangles.push_back({before, ear.corner, after});
      m_next[before] = after;
      m_previous[after] = before;
      m_changes[ear.corner] = CUT_OFF;
      m_plane.remove(ear.corner);
      --m_size;
      for(std::size_t k : {before, after}) {
        ++m_changes[k];
        push(k);
      }
      return true;
    }
    return false;
  }

  /// the ears, as triples of corners
  const std::vector<std::array<std::size_t, 3>>& triangles() const { return m_triangles; }

private:
  static constexpr int CUT_OFF = -1;

  struct Ear
  {
    double score;
    std::size_t corner;
    int changes; ///< of the corner, when it was scored

    /// the best comes last; of equal ones the first corner
    bool operator<(const Ear& other) const
    {
      return score != other.score ? score < other.score : corner > other.corner;
    }
  };

  void push(std::size_t corner) { m_ears.push({score(corner), corner, m_changes[corner]}); }

  static std::vector<Planar_points::Point> seen(const Polygon_plane& plane, const std::vector<Eigen::Vector3d>& corners)
  {
    std::vector<Planar_points::Point> points;
    for(const Eigen::Vector3d& p : corners) {
      const Eigen::Vector2d place = plane.seen(p);
      points.emplace_back(place.x(), place.y());
    }
    return points;
  }

  /// how good an ear a corner makes: in ]0, 1] by its shape, 1 when it is equilateral; at most -1 for one that is not
  /// convex, or not empty
  double score(std::size_t corner) const
  {
    const std::size_t a = m_previous[corner], b = corner, c = m_next[corner];
    const Eigen::Vector3d ab = m_shapes[b] - m_shapes[a], bc = m_shapes[c] - m_shapes[b],
                          ca = m_shapes[a] - m_shapes[c];
    const double squares = ab.squaredNorm() + bc.squaredNorm() + ca.squaredNorm();
    const double shape = squares > 0 ? 2 * std::sqrt(3.) * ab.cross(bc).norm() / squares : 0;
    const bool is_convex = CGAL::orientation(m_plane[a], m_plane[b], m_plane[c]) == CGAL::LEFT_TURN;
    return is_convex && !m_plane.is_any_in({m_plane[a], m_plane[b], m_plane[c]}) ? shape
                                                                                 : (is_convex ? shape : -shape) - 2;
  }

  std::vector<Eigen::Vector3d> m_shapes; // the corners, made small
  Planar_points m_plane;                 // the corners as they are, seen along the normal
  std::size_t m_size;                    // of the rest
  std::vector<std::size_t> m_next, m_previous;
  std::vector<int> m_changes; // per corner, of its neighbors
  std::priority_queue<Ear> m_ears;
  std::vector<std::array<std::size_t, 3>> m_triangles;
};

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SOUP_EAR_CLIPPING_H
