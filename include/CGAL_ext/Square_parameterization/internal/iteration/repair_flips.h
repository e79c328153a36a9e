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
    : m_triangles(triangles),
      m_uv(uv),
      m_star(uv.rows()),
      m_rings(uv.rows()),
      m_is_border(uv.rows(), false),
      m_is_bad(triangles.size()),
      m_is_found(uv.rows(), false)
  {
    for(std::size_t f = 0; f < triangles.size(); ++f) {
      for(int v : triangles[f])
        m_star[v].push_back(static_cast<int>(f));
      m_is_bad[f] = is_bad(static_cast<int>(f));
    }
    for(int v : border)
      m_is_border[v] = true;
  }

  /// in vertices visited by a sweep: each triangle that is looked at round a vertex takes as long as one of them; measured. Those
  /// of a large fan take more.
  long work() const { return m_work; }

  /// returns whether all triangles are counter-clockwise, by exact arithmetic
  bool operator()()
  {
    for(int sweep = 0; sweep < Minimizer_numbers::MAXIMUM_REPAIR_SWEEPS && !is_hopeless(sweep); ++sweep) {
      const std::vector<int> vertices = vertices_near_bad_triangles(sweep / Minimizer_numbers::REPAIR_SWEEPS_PER_RING);
      if(vertices.empty())
        return true;
      for(int v : vertices)
        if(!m_is_border[v]) {
          m_work += work_of_move(static_cast<long>(m_star[v].size()));
          move(v);
        }
    }
    return std::find(m_is_bad.begin(), m_is_bad.end(), true) == m_is_bad.end();
  }

private:
  /// each triangle is looked at, and its side cuts the kernel
  static long work_of_move(long triangles)
  {
    return triangles + triangles * triangles / Minimizer_numbers::TRIANGLES_OF_COSTLY_KERNEL;
  }

  /// indicates whether more triangles are bad than the sweeps that are left may repair; none is before the first ring moves
  bool is_hopeless(int sweep) const
  {
    const long left = Minimizer_numbers::MAXIMUM_REPAIR_SWEEPS - sweep;
    const double most = double(left) * Minimizer_numbers::most_repaired_in_sweep(m_triangles.size());
    return sweep >= Minimizer_numbers::REPAIR_SWEEPS_PER_RING &&
           double(std::count(m_is_bad.begin(), m_is_bad.end(), true)) > most;
  }

  /// a triangle whose computed area is not positive is of no use to those who minimise the stretch, whatever its exact
  /// area is
  bool is_bad(int f) const
  {
    return !(twice_uv_area(m_uv, m_triangles[f]) > 0) || !is_counterclockwise(m_uv, m_triangles[f]);
  }

  /// the vertices of the bad triangles and as many rings around them, ascending
  std::vector<int> vertices_near_bad_triangles(int rings)
  {
    std::vector<int> found;
    const auto add_vertices = [&](std::size_t f) {
      for(int v : m_triangles[f])
        if(!m_is_found[v]) {
          m_is_found[v] = true;
          found.push_back(v);
        }
    };
    for(std::size_t f = 0; f < m_triangles.size(); ++f)
      if(m_is_bad[f])
        add_vertices(f);
    std::size_t inner = 0;
    for(int ring = 0; ring < rings; ++ring)
      for(const std::size_t end = found.size(); inner < end; ++inner)
        for(int f : m_star[found[inner]])
          add_vertices(f);
    for(int v : found)
      m_is_found[v] = false;
    std::sort(found.begin(), found.end());
    return found;
  }

  /// the neighbors of an interior vertex, counter-clockwise
  const std::vector<int>& ring_of(int v)
  {
    std::vector<int>& ring = m_rings[v];
    if(!ring.empty())
      return ring;
    std::vector<std::pair<int, int>> sides;
    for(int f : m_star[v]) {
      const auto& t = m_triangles[f];
      const int k = t[0] == v ? 0 : t[1] == v ? 1 : 2;
      sides.emplace_back(t[(k + 1) % 3], t[(k + 2) % 3]);
    }
    int next = sides.front().first;
    std::sort(sides.begin(), sides.end());
    for(std::size_t i = 0; i < sides.size(); ++i) {
      ring.push_back(next);
      next = std::lower_bound(sides.begin(), sides.end(), std::pair(next, 0))->second;
    }
    return ring;
  }

  /// moves a vertex into the kernel of its ring, or to the mean of the ring while there is no kernel, unless more
  /// triangles are bad then
  void move(int v)
  {
    m_ring_uv.clear();
    for(int w : ring_of(v))
      m_ring_uv.push_back(m_uv.row(w));
    Eigen::RowVector2d mean(0, 0);
    for(const Eigen::RowVector2d& p : m_ring_uv)
      mean += p / m_ring_uv.size();
    const Eigen::RowVector2d position = m_uv.row(v);
    m_uv.row(v) = point_in_kernel(m_ring_uv, m_kernel).value_or(mean);
    long before = 0, after = 0;
    m_is_bad_now.clear();
    for(int f : m_star[v]) {
      m_is_bad_now.push_back(is_bad(f));
      before += m_is_bad[f];
      after += m_is_bad_now.back();
    }
    if(after > before)
      m_uv.row(v) = position;
    else
      for(std::size_t i = 0; i < m_is_bad_now.size(); ++i)
        m_is_bad[m_star[v][i]] = m_is_bad_now[i];
  }

  const std::vector<std::array<int, 3>>& m_triangles;
  Uv_coordinates& m_uv;
  std::vector<std::vector<int>> m_star;  // per vertex, its triangles
  std::vector<std::vector<int>> m_rings; // per vertex, its neighbors; empty until they are asked for
  std::vector<bool> m_is_border;
  std::vector<bool> m_is_bad;                // per triangle
  std::vector<bool> m_is_found;              // per vertex, while vertices are collected
  std::vector<Eigen::RowVector2d> m_ring_uv; // memory of `move()`
  Convex_polygon m_kernel;                   // the same
  std::vector<bool> m_is_bad_now;            // the same: per triangle of a star
  long m_work = 0;
};

/// see `Flip_repair`; returns whether the map of the patch is one-to-one afterwards
/// \param work what it costs is added to, in vertices visited
inline bool repair_flips(const Patch& patch, Uv_coordinates& uv, long& work)
{
  if(!uv.allFinite())
    return false;
  Flip_repair repair(patch.triangles, patch.border, uv);
  const bool is_repaired = repair();
  work += repair.work();
  return is_repaired;
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ITERATION_REPAIR_FLIPS_H
