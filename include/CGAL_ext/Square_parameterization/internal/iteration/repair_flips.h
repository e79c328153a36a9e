// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ITERATION_REPAIR_FLIPS_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ITERATION_REPAIR_FLIPS_H

#include <CGAL_ext/Square_parameterization/internal/common/Minimizer_numbers.h>
#include <CGAL_ext/Square_parameterization/internal/energy/stretch_kernel.h>
#include <CGAL_ext/Square_parameterization/internal/patch/exact_orientation.h>
#include <CGAL_ext/Square_parameterization/internal/patch/point_in_kernel.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// makes the few triangles of a map counter-clockwise that rounding has left flat or flipped: moves the vertices of the
/// triangles, and more and more of those around them, into the kernels of their rings. Border vertices stay.
class Flip_repair
{
public:
  /// \param triangles of a disk, #F
  /// \param border its border vertices
  Flip_repair(const std::vector<std::array<int, 3>>& triangles, const std::vector<int>& border, Uv_coordinates& uv)
    : m_triangles(triangles), m_uv(uv), m_star(uv.rows()), m_is_border(uv.rows(), false)
  {
    for(std::size_t f = 0; f < triangles.size(); ++f)
      for(int v : triangles[f])
        m_star[v].push_back(static_cast<int>(f));
    for(int v : border)
      m_is_border[v] = true;
  }

  /// returns whether all triangles are counter-clockwise, by exact arithmetic
  bool operator()()
  {
    for(int sweep = 0; sweep < Minimizer_numbers::MAXIMUM_REPAIR_SWEEPS; ++sweep) {
      const std::vector<int> vertices = vertices_near_bad_triangles(sweep / Minimizer_numbers::REPAIR_SWEEPS_PER_RING);
      if(vertices.empty())
        return true;
      for(int v : vertices)
        if(!m_is_border[v])
          move(v);
    }
    return vertices_near_bad_triangles(0).empty();
  }

private:
  /// a triangle whose computed area is not positive is of no use to those who minimise the stretch, whatever its exact
  /// area is
  bool is_bad(int f) const
  {
    return !(twice_uv_area(m_uv, m_triangles[f]) > 0) || !is_counterclockwise(m_uv, m_triangles[f]);
  }

  /// the vertices of the bad triangles and as many rings around them, ascending
  std::vector<int> vertices_near_bad_triangles(int rings) const
  {
    std::vector<int> vertices;
    for(std::size_t f = 0; f < m_triangles.size(); ++f)
      if(is_bad(static_cast<int>(f)))
        vertices.insert(vertices.end(), m_triangles[f].begin(), m_triangles[f].end());
    for(int ring = 0; ring <= rings; ++ring) {
      if(ring > 0) {
        const std::vector<int> inner = vertices;
        for(int v : inner)
          for(int f : m_star[v])
            vertices.insert(vertices.end(), m_triangles[f].begin(), m_triangles[f].end());
      }
      std::sort(vertices.begin(), vertices.end());
      vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    }
    return vertices;
  }

  /// the uv positions of the neighbors of an interior vertex, counter-clockwise
  std::vector<Eigen::RowVector2d> ring_of(int v) const
  {
    std::vector<std::pair<int, int>> sides;
    for(int f : m_star[v]) {
      const auto& t = m_triangles[f];
      const int k = t[0] == v ? 0 : t[1] == v ? 1 : 2;
      sides.emplace_back(t[(k + 1) % 3], t[(k + 2) % 3]);
    }
    std::vector<Eigen::RowVector2d> ring;
    int next = sides.front().first;
    for(std::size_t i = 0; i < sides.size(); ++i) {
      ring.push_back(m_uv.row(next));
      next = std::find_if(sides.begin(), sides.end(), [next](const auto& side) { return side.first == next; })->second;
    }
    return ring;
  }

  /// moves a vertex into the kernel of its ring, or to the mean of the ring while there is no kernel, unless more
  /// triangles are bad then
  void move(int v)
  {
    const auto bad_triangles = [&] {
      return std::count_if(m_star[v].begin(), m_star[v].end(), [this](int f) { return is_bad(f); });
    };
    const std::vector<Eigen::RowVector2d> ring = ring_of(v);
    Eigen::RowVector2d mean(0, 0);
    for(const Eigen::RowVector2d& p : ring)
      mean += p / ring.size();
    const auto before = bad_triangles();
    const Eigen::RowVector2d position = m_uv.row(v);
    m_uv.row(v) = point_in_kernel(ring).value_or(mean);
    if(bad_triangles() > before)
      m_uv.row(v) = position;
  }

  const std::vector<std::array<int, 3>>& m_triangles;
  Uv_coordinates& m_uv;
  std::vector<std::vector<int>> m_star; // per vertex, its triangles
  std::vector<bool> m_is_border;
};

/// see `Flip_repair`; returns whether the map of the patch is one-to-one afterwards
inline bool repair_flips(const Patch& patch, Uv_coordinates& uv)
{
  return uv.allFinite() && Flip_repair(patch.triangles, patch.border, uv)();
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ITERATION_REPAIR_FLIPS_H
