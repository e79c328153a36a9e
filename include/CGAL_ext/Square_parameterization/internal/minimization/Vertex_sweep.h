// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_VERTEX_SWEEP_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_VERTEX_SWEEP_H

#include <CGAL_ext/Square_parameterization/internal/energy/Vertex_star.h>
#include <CGAL_ext/Square_parameterization/internal/energy/feasible_step.h>

#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// moves one vertex after the other to a lower balanced energy, the others fixed (Gauss-Seidel). Local errors of a map
/// vanish in a few sweeps; large ones, that need the mesh to move as a whole, do not.
class Vertex_sweep
{
public:
  Vertex_sweep(const Patch& patch, double balance)
    : m_balance(balance), m_first(patch.points.size() + 1, 0), m_corners(3 * patch.triangles.size())
  {
    for(const auto& t : patch.triangles)
      for(int v : t)
        ++m_first[v + 1];
    for(std::size_t v = 1; v < m_first.size(); ++v)
      m_first[v] += m_first[v - 1];
    std::vector<int> next(m_first.begin(), m_first.end() - 1);
    for(int f = 0; f < patch.number_of_faces(); ++f)
      for(int k = 0; k < 3; ++k) {
        const auto& t = patch.triangles[f];
        m_corners[next[t[k]]++] = {t[(k + 1) % 3], t[(k + 2) % 3], corner_shape(patch.shapes[f], k)};
      }
  }

  /// visits every vertex once, in order; \p uv has no flips before nor after
  /// \param to_rectangle what takes the unit square to the rectangle of the energy
  void operator()(const Free_coordinates& is_free, const Eigen::RowVector2d& to_rectangle, Uv_coordinates& uv) const
  {
    Vertex_star star(m_balance, to_rectangle);
    for(Eigen::Index v = 0; v < uv.rows(); ++v) {
      if(!is_free(v, 0) && !is_free(v, 1))
        continue;
      star.clear(uv.row(v));
      for(int i = m_first[v]; i < m_first[v + 1]; ++i) {
        const Corner& corner = m_corners[i];
        star.add(corner.shape, uv.row(corner.q), uv.row(corner.r));
      }
      Eigen::RowVector2d p = uv.row(v);
      if(star.improve(p, {is_free(v, 0), is_free(v, 1)}))
        uv.row(v) = p;
    }
  }

private:
  struct Corner
  {
    int q, r; // the next two corners of the triangle
    Corner_shape shape;
  };

  double m_balance;
  std::vector<int> m_first;      // #V + 1: the corners at vertex v are first[v], ..., first[v + 1] - 1
  std::vector<Corner> m_corners; // 3 #F
};

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_VERTEX_SWEEP_H
