// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ITERATION_CGAL_LINEAR_SOLVER_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ITERATION_CGAL_LINEAR_SOLVER_H

#include <CGAL_ext/Square_parameterization/internal/iteration/linear_solvers.h>

#include <memory>
#include <mutex>
#include <utility>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// a solver object that a user gave. It is used by one thread at a time, and its copies are not used at all: those of
/// `CGAL::Eigen_solver_traits` share one factorization.
template <class SolverTraits>
class Given_solver
{
public:
  explicit Given_solver(SolverTraits solver) : m_solver(std::move(solver)) {}

  /// returns `use(solver)`
  template <class Use>
  bool lend(const Use& use)
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    return use(m_solver);
  }

private:
  SolverTraits m_solver;
  std::mutex m_mutex;
};

/// a linear solver of the package made of a model of CGAL's `SparseLinearAlgebraTraits_d`. The concept solves for one
/// right-hand side from a matrix given whole: nothing is reused between calls.
template <class SolverTraits>
class Cgal_linear_solver : public Linear_solver
{
public:
  /// \param is_upper_triangle the matrices are symmetric and only their upper triangle is stored
  /// \param given the solver to use; null: each call makes its own
  explicit Cgal_linear_solver(bool is_upper_triangle, std::shared_ptr<Given_solver<SolverTraits>> given = nullptr)
    : m_is_upper_triangle(is_upper_triangle), m_given(std::move(given))
  {}

  bool factorize(const Sparse_matrix& matrix) override
  {
    m_matrix = matrix;
    return true;
  }

  bool solve(const Right_hand_sides& right_hand_sides, Right_hand_sides& solution) const override
  {
    const auto solve_with = [&](SolverTraits& solver) { return solve_by(solver, right_hand_sides, solution); };
    if(m_given)
      return m_given->lend(solve_with);
    SolverTraits solver;
    return solve_with(solver);
  }

  std::unique_ptr<Linear_solver> make_another() const override
  {
    return std::make_unique<Cgal_linear_solver>(m_is_upper_triangle, m_given);
  }

private:
  bool solve_by(SolverTraits& solver, const Right_hand_sides& right_hand_sides, Right_hand_sides& solution) const
  {
    const int n = static_cast<int>(m_matrix.rows());
    typename SolverTraits::Matrix a(n, n);
    for(int column = 0; column < n; ++column)
      for(Sparse_matrix::InnerIterator entry(m_matrix, column); entry; ++entry) {
        const int row = static_cast<int>(entry.row());
        a.set_coef(row, column, entry.value(), true);
        if(m_is_upper_triangle && row != column)
          a.set_coef(column, row, entry.value(), true);
      }
    solution.resize(n, 2);
    for(int k = 0; k < 2; ++k) {
      typename SolverTraits::Vector b(n), x(n);
      for(int i = 0; i < n; ++i)
        b[i] = right_hand_sides(i, k);
      double determinant = 1;
      if(!solver.linear_solver(a, b, x, determinant))
        return false;
      for(int i = 0; i < n; ++i)
        solution(i, k) = x[i] / determinant;
    }
    return solution.allFinite();
  }

  bool m_is_upper_triangle;
  std::shared_ptr<Given_solver<SolverTraits>> m_given;
  Sparse_matrix m_matrix;
};

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ITERATION_CGAL_LINEAR_SOLVER_H
