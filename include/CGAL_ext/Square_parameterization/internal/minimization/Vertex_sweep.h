// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_VERTEX_SWEEP_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_VERTEX_SWEEP_H

#include <CGAL_ext/Square_parameterization/internal/common/ranges.h>
#include <CGAL_ext/Square_parameterization/internal/energy/Vertex_star.h>
#include <CGAL_ext/Square_parameterization/internal/energy/feasible_step.h>
#include <CGAL_ext/Square_parameterization/internal/patch/Patch_division.h>

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
    : m_division(division),
      m_balance(balance),
      m_first(patch.points.size() + 1, 0),
      m_corners(3 * patch.triangles.size())
  {
    for(const auto& t : patch.triangles)
      for(int v : t)
        ++m_first[division.rank(v) + 1];
    for(std::size_t i = 1; i < m_first.size(); ++i)
      m_first[i] += m_first[i - 1];
    std::vector<int> next(m_first.begin(), m_first.end() - 1);
    for(int f = 0; f < patch.number_of_faces(); ++f)
      for(int k = 0; k < 3; ++k) {
        const auto& t = patch.triangles[f];
        m_corners[next[division.rank(t[k])]++] = {t[(k + 1) % 3], t[(k + 2) % 3], corner_shape(patch.shapes[f], k)};
      }
  }

  /// visits every vertex once, in the order of the division; \p uv has no flips before nor after
  /// \param to_rectangle what takes the unit square to the rectangle of the energy
  void operator()(const Free_coordinates& is_free, const Eigen::RowVector2d& to_rectangle, Uv_coordinates& uv) const
  {
    const auto sweep = [&](Patch_division::Range ranks) { sweep_range(ranks, is_free, to_rectangle, uv); };
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

  void sweep_range(Patch_division::Range ranks, const Free_coordinates& is_free, const Eigen::RowVector2d& to_rectangle,
                   Uv_coordinates& uv) const
  {
    Vertex_star star(m_balance, to_rectangle);
    for(int rank = ranks.begin; rank < ranks.end; ++rank) {
      const int v = m_division.vertex(rank);
      if(!is_free(v, 0) && !is_free(v, 1))
        continue;
      star.clear(uv.row(v));
      for(int i = m_first[rank]; i < m_first[rank + 1]; ++i) {
        const Corner& corner = m_corners[i];
        star.add(corner.shape, uv.row(corner.q), uv.row(corner.r));
      }
      Eigen::RowVector2d p = uv.row(v);
      if(star.improve(p, {is_free(v, 0), is_free(v, 1)}))
        uv.row(v) = p;
    }
  }

  struct Corner
  {
    int q, r; // the next two corners of the triangle
    Corner_shape shape;
  };

  const Patch_division& m_division;
  double m_balance;
  std::vector<int> m_first;      // #V + 1: the corners at the vertex of rank i are first[i], ..., first[i + 1] - 1
  std::vector<Corner> m_corners; // 3 #F
};

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_VERTEX_SWEEP_H
