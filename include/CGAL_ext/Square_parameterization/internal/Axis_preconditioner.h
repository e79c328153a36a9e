// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_AXIS_PRECONDITIONER_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_AXIS_PRECONDITIONER_H

#include <CGAL_ext/Square_parameterization/internal/Balanced_energy.h>
#include <CGAL_ext/Square_parameterization/internal/feasible_step.h>
#include <CGAL_ext/Square_parameterization/internal/sparse_pattern.h>

#include <array>
#include <vector>

namespace CGAL_ext {
namespace internal {

/// the Hessian of the balanced energy without its mixed derivatives by an u and a v: two matrices with one unknown per
/// vertex each, which are factored several times as fast as one with two.
///
/// Coordinates that may not move have a unit row, so that one sparsity pattern and one symbolic analysis serve every
/// border.
class Axis_preconditioner
{
public:
  /// the memory of one thread
  struct Factors
  {
    Sparse_matrix matrix;
    std::array<Eigen::SimplicialLDLT<Sparse_matrix, Eigen::Upper, Eigen::NaturalOrdering<int>>, 2> of_axis;
    Eigen::VectorXd right_hand_side, solution;
    bool is_analyzed = false;
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
    std::array<std::vector<double>, 2> values{std::vector<double>(m_pattern.nonZeros(), 0.),
                                              std::vector<double>(m_pattern.nonZeros(), 0.)};
    for(int f = 0; f < m_patch.number_of_faces(); ++f) {
      const Balanced_energy::Hessian_blocks blocks = energy.hessian_blocks(f, uv);
      const auto& t = m_patch.triangles[f];
      for(int axis = 0; axis < 2; ++axis)
        for(int k = 0; k < 3; ++k) {
          const int next = (k + 1) % 3;
          if(!is_free(t[k], axis))
            continue;
          values[axis][m_slots[f][k]] += blocks.of_axis[axis](k, k);
          if(is_free(t[next], axis))
            values[axis][m_slots[f][3 + k]] += blocks.of_axis[axis](k, next);
        }
    }
    if(factors.matrix.nonZeros() == 0)
      factors.matrix = m_pattern;
    for(int axis = 0; axis < 2; ++axis) {
      std::copy(values[axis].begin(), values[axis].end(), factors.matrix.valuePtr());
      for(int v = 0; v < m_patch.number_of_vertices(); ++v)
        if(!is_free(v, axis))
          factors.matrix.valuePtr()[slot_of(m_pattern, m_rank[v], m_rank[v])] = 1;
      if(!factors.is_analyzed)
        factors.of_axis[axis].analyzePattern(factors.matrix);
      factors.of_axis[axis].factorize(factors.matrix);
      if(factors.of_axis[axis].info() != Eigen::Success)
        return false;
    }
    factors.is_analyzed = true;
    return true;
  }

  /// replaces \p x, which is zero where coordinates may not move, by the solution of both systems
  void apply(Factors& factors, Uv_coordinates& x) const
  {
    factors.right_hand_side.resize(x.rows());
    for(int axis = 0; axis < 2; ++axis) {
      for(int v = 0; v < x.rows(); ++v)
        factors.right_hand_side[m_rank[v]] = x(v, axis);
      factors.solution = factors.of_axis[axis].solve(factors.right_hand_side);
      for(int v = 0; v < x.rows(); ++v)
        x(v, axis) = factors.solution[m_rank[v]];
    }
  }

private:
  const Patch& m_patch;
  std::vector<int> m_rank; // #V: place in the elimination order
  Sparse_matrix m_pattern; // upper triangle
  std::vector<std::array<int, 6>>
      m_slots; // #F: where the entries (k, k), and then (k, k + 1), of a triangle are stored
};

} // namespace internal
} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_AXIS_PRECONDITIONER_H
