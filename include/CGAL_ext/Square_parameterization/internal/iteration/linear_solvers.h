// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ITERATION_LINEAR_SOLVERS_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ITERATION_LINEAR_SOLVERS_H

#include <Eigen/SparseCore>

#include <functional>
#include <memory>

namespace CGAL_ext {
namespace internal {

using Sparse_matrix = Eigen::SparseMatrix<double>;
using Right_hand_sides = Eigen::Matrix<double, Eigen::Dynamic, 2>;

/// solves A X = B for matrices A that share one sparsity pattern, with two right-hand sides at a time.
/// After `factorize()` succeeded, `solve()` may be called from several threads.
class Linear_solver
{
public:
  virtual ~Linear_solver() = default;
  virtual bool factorize(const Sparse_matrix& matrix) = 0;
  virtual bool solve(const Right_hand_sides& right_hand_sides, Right_hand_sides& solution) const = 0;

  /// makes a solver for other matrices of the same pattern, which has what `factorize()` has found about it
  virtual std::unique_ptr<Linear_solver> make_another() const = 0;
};

/// makes a solver for symmetric positive definite matrices, given as their upper triangle, or for general matrices
using Linear_solver_factory = std::function<std::unique_ptr<Linear_solver>(bool is_symmetric)>;

/// makes a factorization that keeps its symbolic analysis: LDL^T for symmetric matrices, else LU, both
/// without pivots
std::unique_ptr<Linear_solver> make_direct_solver(bool is_symmetric);

} // namespace internal
} // namespace CGAL_ext

#ifndef CGAL_EXT_COMPILED_CORE
#include <CGAL_ext/Square_parameterization/internal/iteration/linear_solvers_impl.h>
#endif

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ITERATION_LINEAR_SOLVERS_H
