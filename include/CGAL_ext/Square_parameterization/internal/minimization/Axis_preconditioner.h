// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_AXIS_PRECONDITIONER_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_AXIS_PRECONDITIONER_H

#include <CGAL_ext/Square_parameterization/internal/iteration/Multifrontal_ldlt.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/Axis_matrix.h>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// the two matrices of `Axis_matrix`, factored at once, and several times as fast as one with two unknowns per vertex.
/// One symbolic analysis serves every border.
class Axis_preconditioner
{
public:
  /// the memory of one thread, for one patch
  struct Factors
  {
    Axis_matrix::Matrix matrix;
    Multifrontal_ldlt<Number_per_axis> of_axes;
    Axis_matrix::Vector right_hand_side, solution;
    std::vector<int> changed; // entries of the matrix
  };

  /// \param division see `Axis_matrix`
  explicit Axis_preconditioner(const Patch& patch, const Patch_division* division = nullptr)
    : m_matrix(patch, elimination_places_of(patch), division)
  {}

  /// factors the two matrices at \p uv; false when one of them is singular
  /// \param area_multiple see `Balanced_energy::hessian_blocks()`
  bool factorize(const Balanced_energy& energy, const Uv_coordinates& uv, const Free_coordinates& is_free,
                 Factors& factors, double area_multiple = Balanced_energy::AREA_MULTIPLE) const
  {
    if(factors.matrix.nonZeros() == 0) {
      factors.matrix = m_matrix.make();
      factors.of_axes.analyzePattern(factors.matrix);
    }
    m_matrix.set(energy, uv, is_free, factors.matrix, area_multiple);
    factors.of_axes.factorize(factors.matrix);
    return factors.of_axes.info() == Eigen::Success;
  }

  /// factors the two matrices of the last call with fewer coordinates that may move; false when one is singular
  bool factorize_fewer(const Free_coordinates& was_free, const Free_coordinates& is_free, Factors& factors) const
  {
    m_matrix.fix_more(was_free, is_free, factors.matrix, factors.changed);
    factors.of_axes.refactorize(factors.matrix, factors.changed);
    return factors.of_axes.info() == Eigen::Success;
  }

  /// replaces \p x, which is zero where coordinates may not move, by the solution of both systems
  void apply(Factors& factors, Uv_coordinates& x) const
  {
    factors.right_hand_side.resize(x.rows());
    for(int v = 0; v < x.rows(); ++v)
      factors.right_hand_side[m_matrix.rank(v)] = {x(v, 0), x(v, 1)};
    factors.solution = factors.of_axes.solve(factors.right_hand_side);
    for(int v = 0; v < x.rows(); ++v)
      for(int axis = 0; axis < 2; ++axis)
        x(v, axis) = factors.solution[m_matrix.rank(v)][axis];
  }

private:
  Axis_matrix m_matrix;
};

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_AXIS_PRECONDITIONER_H
