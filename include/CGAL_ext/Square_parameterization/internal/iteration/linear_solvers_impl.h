// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ITERATION_LINEAR_SOLVERS_IMPL_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ITERATION_LINEAR_SOLVERS_IMPL_H

#include <CGAL_ext/Square_parameterization/internal/common/compiled_core.h>
#include <CGAL_ext/Square_parameterization/internal/iteration/Multifrontal_ldlt.h>
#include <CGAL_ext/Square_parameterization/internal/iteration/Unpivoted_lu.h>
#include <CGAL_ext/Square_parameterization/internal/iteration/linear_solvers.h>

#include <memory>

namespace CGAL_ext {
namespace internal {

/// a factorization with the interface of those of Eigen, whose symbolic analysis is done once, at the first matrix
template <class Factorization>
class Direct_solver : public Linear_solver
{
public:
  bool factorize(const Sparse_matrix& matrix) override
  {
    if(!m_analyzed)
      m_factorization.analyzePattern(matrix);
    m_analyzed = true;
    m_factorization.factorize(matrix);
    return m_factorization.info() == Eigen::Success;
  }

  bool solve(const Right_hand_sides& right_hand_sides, Right_hand_sides& solution) const override
  {
    solution = m_factorization.solve(right_hand_sides);
    return m_factorization.info() == Eigen::Success && solution.allFinite();
  }

  std::unique_ptr<Linear_solver> make_another() const override { return std::make_unique<Direct_solver>(*this); }

private:
  Factorization m_factorization;
  bool m_analyzed = false;
};

/// for symmetric positive definite matrices of which the upper triangle is stored. The rows come in a fill-reducing
/// order already (see `Convex_combination_system`), so that no factorization has to permute the matrix.
using Symmetric_solver = Direct_solver<Multifrontal_ldlt<double>>;

/// for matrices with a symmetric pattern, rows in a fill-reducing order already. A convex combination matrix is a
/// diagonally dominant M-matrix, for which elimination along the diagonal is stable: no pivot is looked for.
using General_solver = Direct_solver<Unpivoted_lu>;

CGAL_EXT_INLINE_FUNCTION std::unique_ptr<Linear_solver> make_direct_solver(bool is_symmetric)
{
  if(is_symmetric)
    return std::make_unique<Symmetric_solver>();
  return std::make_unique<General_solver>();
}

} // namespace internal
} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ITERATION_LINEAR_SOLVERS_IMPL_H
