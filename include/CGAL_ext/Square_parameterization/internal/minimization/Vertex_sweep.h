// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_VERTEX_SWEEP_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_VERTEX_SWEEP_H

#include <CGAL_ext/Square_parameterization/internal/common/ranges.h>
#include <CGAL_ext/Square_parameterization/internal/energy/Triangle_pair.h>
#include <CGAL_ext/Square_parameterization/internal/energy/Vertex_star.h>
#include <CGAL_ext/Square_parameterization/internal/energy/feasible_step.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/Sweep_order.h>
#include <CGAL_ext/Square_parameterization/internal/patch/Incident_corners.h>
#include <CGAL_ext/Square_parameterization/internal/patch/Patch_division.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// moves one vertex after the other to a lower balanced energy, the others fixed (Gauss-Seidel). Local errors of a map
/// vanish in a few sweeps; large ones, that need the mesh to move as a whole, do not.
///
/// The blocks of a divided patch are swept by the threads of the current team, and then its separators, color by color.
class Vertex_sweep
{
public:
  /// \param division of the patch, which must live as long
  Vertex_sweep(const Patch& patch, const Patch_division& division, double balance)
    : Vertex_sweep(patch, division, Incident_corners(patch), balance)
  {}

  /// visits every vertex once, as if in the order of the division; \p uv has no flips before nor after
  /// \param to_rectangle what takes the unit square to the rectangle of the energy
  void operator()(const Free_coordinates& is_free, const Eigen::RowVector2d& to_rectangle, Uv_coordinates& uv) const
  {
    const auto sweep = [&](Patch_division::Range places) { sweep_range(places, is_free, to_rectangle, uv); };
    Thread_team::current()(m_division.number_of_blocks(),
                           [&](std::size_t b) { sweep(m_division.block(static_cast<int>(b))); });
    for(const Patch_division::Range& color : m_division.colors())
      for_ranges(
          color.end - color.begin,
          [&](std::size_t begin, std::size_t end) {
            sweep({color.begin + static_cast<int>(begin), color.begin + static_cast<int>(end)});
          },
          SEPARATORS_AT_A_TIME);
  }

private:
  static constexpr std::size_t SEPARATORS_AT_A_TIME = 256;

  Vertex_sweep(const Patch& patch, const Patch_division& division, const Incident_corners& incident, double balance)
    : m_division(division), m_order(patch, division, incident), m_balance(balance), m_first(patch.points.size() + 1, 0)
  {
    const int n = patch.number_of_vertices();
    for(int place = 0; place < n; ++place)
      m_first[place + 1] = m_first[place] + (incident[m_order.vertex(place)].size() + 1) / 2;
    m_corners.reserve(m_first.back());
    for(int place = 0; place < n; ++place) {
      const Incident_corners::Range corners = incident[m_order.vertex(place)];
      for(int i = 0; i < corners.size(); i += 2)
        m_corners.push_back(corners_at(patch, corners.begin() + i, (std::min)(2, corners.size() - i)));
    }
  }

  void sweep_range(Patch_division::Range places, const Free_coordinates& is_free,
                   const Eigen::RowVector2d& to_rectangle, Uv_coordinates& uv) const
  {
    std::vector<Vertex_star> stars(Sweep_order::LARGEST_BATCH, Vertex_star(m_balance, to_rectangle));
    std::array<int, Sweep_order::LARGEST_BATCH> vertices;
    const auto may_move = [&is_free](int v) { return std::array<bool, 2>{is_free(v, 0), is_free(v, 1)}; };
    for(int place = places.begin, end; place < places.end; place = end) {
      end = (std::min)(m_order.end_of_batch(place), places.end);
      int moving = 0;
      for(int i = place; i < end; ++i) {
        const int v = m_order.vertex(i);
        if(!is_free(v, 0) && !is_free(v, 1))
          continue;
        set_star(i, uv, stars[moving]);
        stars[moving].take_derivatives_at_origin();
        vertices[moving++] = v;
      }
      for(int i = 0; i < moving; ++i)
        stars[i].find_step(may_move(vertices[i]));
      for(int i = 0; i < moving; ++i) {
        Eigen::RowVector2d p = uv.row(vertices[i]);
        if(stars[i].take_step(p))
          uv.row(vertices[i]) = p;
      }
    }
  }

  /// sets the star of the vertex at a place, with it at the origin
  void set_star(int place, const Uv_coordinates& uv, Vertex_star& star) const
  {
    const Corners* const corners = m_corners.data() + m_first[place];
    star.set(uv.row(m_order.vertex(place)), m_first[place + 1] - m_first[place], [corners, &uv](std::size_t i) {
      const auto& [shapes, q, r] = corners[i];
      return Triangle_pair(shapes, uv.row(q[0]), uv.row(q[1]), uv.row(r[0]), uv.row(r[1]));
    });
  }

  /// two corners at a vertex, or the last one twice
  struct Corners
  {
    Corner_pair shapes;
    std::array<int, 2> q, r; // the next two corners of the triangles
  };

  /// \param number of corners, 1 or 2
  static Corners corners_at(const Patch& patch, const Incident_corners::Corner* corners, int number)
  {
    Corners result;
    std::array<Corner_shape, 2> shapes{};
    for(int i = 0; i < 2; ++i) {
      const auto [f, k] = corners[(std::min)(i, number - 1)];
      result.q[i] = patch.triangles[f][(k + 1) % 3];
      result.r[i] = patch.triangles[f][(k + 2) % 3];
      shapes[i] = corner_shape(patch.shapes[f], k);
    }
    result.shapes = number == 1 ? Corner_pair::of_one(shapes[0]) : Corner_pair(shapes[0], shapes[1]);
    return result;
  }

  const Patch_division& m_division;
  Sweep_order m_order;
  double m_balance;
  std::vector<int> m_first;       // #V + 1: the corners at the vertex of place i are first[i], ..., first[i + 1] - 1
  std::vector<Corners> m_corners; // half of 3 #F, and half of those vertices that have an odd number
};

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_VERTEX_SWEEP_H
