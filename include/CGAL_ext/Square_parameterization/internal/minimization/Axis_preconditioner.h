// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_AXIS_PRECONDITIONER_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_AXIS_PRECONDITIONER_H

#include <CGAL_ext/Square_parameterization/internal/energy/Balanced_energy.h>
#include <CGAL_ext/Square_parameterization/internal/energy/feasible_step.h>
#include <CGAL_ext/Square_parameterization/internal/iteration/sparse_pattern.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/Number_per_axis.h>

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <array>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// the Hessian of the balanced energy without its mixed derivatives by an u and a v: two matrices with one unknown per
/// vertex each, factored at once, and several times as fast as one with two.
///
/// Coordinates that may not move have a unit row, so that one sparsity pattern and one symbolic analysis serve every
/// border.
class Axis_preconditioner
{
public:
  /// the memory of one thread, for one patch
  struct Factors
  {
    typedef Eigen::SparseMatrix<Number_per_axis> Matrix;
    typedef Eigen::Matrix<Number_per_axis, Eigen::Dynamic, 1> Vector;

    Matrix matrix;
    Eigen::SimplicialLDLT<Matrix, Eigen::Upper, Eigen::NaturalOrdering<int>> of_axes;
    Vector right_hand_side, solution;

    /// indicates whether one of the systems is singular; Eigen sees it where both are, in the same row
    bool is_singular() const
    {
      const auto diagonal = of_axes.vectorD();
      return std::any_of(diagonal.begin(), diagonal.end(),
                         [](const Number_per_axis& d) { return d[0] == 0 || d[1] == 0; });
    }
  };

  explicit Axis_preconditioner(const Patch& patch)
    : m_patch(patch), m_rank(fill_reducing_order(patch.number_of_vertices(), patch.edges))
  {
    const int n = patch.number_of_vertices();
    std::vector<Eigen::Triplet<double>> entries;
    for(int i = 0; i < n; ++i)
      entries.emplace_back(i, i, 1.);
    for(const auto& [a, b] : patch.edges)
      entries.emplace_back((std::min)(m_rank[a], m_rank[b]), (std::max)(m_rank[a], m_rank[b]), 1.);
    m_pattern.resize(n, n);
    m_pattern.setFromTriplets(entries.begin(), entries.end());
    m_pattern.makeCompressed();
    for(const auto& t : patch.triangles) {
      m_slots.emplace_back();
      for(int k = 0; k < 3; ++k) {
        const int i = m_rank[t[k]], j = m_rank[t[(k + 1) % 3]];
        m_slots.back()[k] = slot_of(m_pattern, i, i);
        m_slots.back()[3 + k] = slot_of(m_pattern, (std::min)(i, j), (std::max)(i, j));
      }
    }
  }

  /// factors the two matrices at \p uv; false when that fails
  bool factorize(const Balanced_energy& energy, const Uv_coordinates& uv, const Free_coordinates& is_free,
                 Factors& factors) const
  {
    if(factors.matrix.nonZeros() == 0) {
      factors.matrix = m_pattern.cast<Number_per_axis>();
      factors.of_axes.analyzePattern(factors.matrix);
    }
    set_entries(energy, uv, is_free, factors.matrix);
    factors.of_axes.factorize(factors.matrix);
    return !factors.is_singular();
  }

  /// replaces \p x, which is zero where coordinates may not move, by the solution of both systems
  void apply(Factors& factors, Uv_coordinates& x) const
  {
    factors.right_hand_side.resize(x.rows());
    for(int v = 0; v < x.rows(); ++v)
      factors.right_hand_side[m_rank[v]] = {x(v, 0), x(v, 1)};
    factors.solution = factors.of_axes.solve(factors.right_hand_side);
    for(int v = 0; v < x.rows(); ++v)
      for(int axis = 0; axis < 2; ++axis)
        x(v, axis) = factors.solution[m_rank[v]][axis];
  }

private:
  void set_entries(const Balanced_energy& energy, const Uv_coordinates& uv, const Free_coordinates& is_free,
                   Factors::Matrix& matrix) const
  {
    const Eigen::RowVector2d to_rectangle = energy.scale(uv);
    Number_per_axis* const values = matrix.valuePtr();
    std::fill_n(values, matrix.nonZeros(), Number_per_axis());
    for(int f = 0; f < m_patch.number_of_faces(); ++f) {
      const Balanced_energy::Hessian_blocks blocks = energy.hessian_blocks(f, uv, to_rectangle);
      const auto& t = m_patch.triangles[f];
      for(int axis = 0; axis < 2; ++axis)
        for(int k = 0; k < 3; ++k) {
          const int next = (k + 1) % 3;
          if(!is_free(t[k], axis))
            continue;
          values[m_slots[f][k]][axis] += blocks.of_axis[axis](k, k);
          if(is_free(t[next], axis))
            values[m_slots[f][3 + k]][axis] += blocks.of_axis[axis](k, next);
        }
    }
    for(int v = 0; v < m_patch.number_of_vertices(); ++v)
      for(int axis = 0; axis < 2; ++axis)
        if(!is_free(v, axis))
          values[slot_of(m_pattern, m_rank[v], m_rank[v])][axis] = 1;
  }

  const Patch& m_patch;
  std::vector<int> m_rank;                 // #V: place in the elimination order
  Sparse_matrix m_pattern;                 // upper triangle
  std::vector<std::array<int, 6>> m_slots; // #F: places of the entries (k, k), and then (k, k + 1), of a triangle
};

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_AXIS_PRECONDITIONER_H
