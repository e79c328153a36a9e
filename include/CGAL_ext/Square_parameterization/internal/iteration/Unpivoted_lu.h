// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ITERATION_UNPIVOTED_LU_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ITERATION_UNPIVOTED_LU_H

#include <Eigen/SparseCore>

#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// factors matrices A = L U of one symmetric pattern along their diagonal: L has ones on its diagonal, and U has the
/// pattern of the transpose of L.
///
/// L and U are found like the factor of Davis' LDL (ACM TOMS 31, 2005), a row of L with a column of U at a time. On
/// grids of 40000 vertices this takes the time of Eigen's SparseLU, on smaller ones less, on larger ones more (2.7
/// times at 250000); and programs with SparseLU take 4 s and 300 MB more to compile. The interface is that of Eigen's
/// factorizations.
class Unpivoted_lu
{
public:
  using Matrix = Eigen::SparseMatrix<double>;
  using Columns = Eigen::Matrix<double, Eigen::Dynamic, 2>;

  /// finds the pattern of the factors. The pattern of \p matrix is symmetric, compressed, with its rows in order.
  void analyzePattern(const Matrix& matrix)
  {
    const int n = static_cast<int>(matrix.rows());
    const int *begin = matrix.outerIndexPtr(), *rows = matrix.innerIndexPtr();
    std::vector<std::size_t> count(n, 0); // entries of each column of L
    std::vector<int> visited_for(n, -1), next(begin, begin + n);
    m_parent.assign(n, -1);
    m_mirror.resize(matrix.nonZeros());
    for(int k = 0; k < n; ++k) {
      visited_for[k] = k;
      for(int p = begin[k]; p < begin[k + 1]; ++p) {
        m_mirror[p] = next[rows[p]]++;
        for(int i = rows[p]; i < k && visited_for[i] != k; i = m_parent[i]) {
          if(m_parent[i] < 0)
            m_parent[i] = k;
          visited_for[i] = k;
          ++count[i];
        }
      }
    }
    m_begin.assign(n + 1, 0);
    std::partial_sum(count.begin(), count.end(), m_begin.begin() + 1);
    m_rows.resize(m_begin[n]);
    m_values.resize(m_begin[n]);
    m_diagonal.resize(n);
  }

  /// computes the factors; fails when a pivot is zero or not finite
  /// \pre `analyzePattern()` was called with a matrix of the same pattern
  void factorize(const Matrix& matrix)
  {
    m_info = Eigen::NumericalIssue;
    const int n = static_cast<int>(matrix.rows());
    std::vector<int> visited_for(n, -1), path(n), pattern(n);
    std::vector<std::array<double, 2>> y(n, {0, 0}); // a row of L and a column of U, as far as they are computed
    std::vector<std::size_t> end(m_begin.begin(), m_begin.begin() + n);
    for(int k = 0; k < n; ++k) {
      const int first = scatter(matrix, k, y, visited_for, path, pattern);
      double pivot = y[k][0];
      y[k] = {0, 0};
      for(int j = first; j < n; ++j) {
        const int i = pattern[j];
        const double l = y[i][0] / m_diagonal[i], u = y[i][1];
        y[i] = {0, 0};
        for(std::size_t p = m_begin[i]; p < end[i]; ++p) {
          y[m_rows[p]][0] -= m_values[p][1] * l;
          y[m_rows[p]][1] -= m_values[p][0] * u;
        }
        pivot -= l * u;
        m_rows[end[i]] = k;
        m_values[end[i]++] = {l, u};
      }
      if(!std::isfinite(pivot) || pivot == 0)
        return;
      m_diagonal[k] = pivot;
    }
    m_info = Eigen::Success;
  }

  /// indicates whether the last `factorize()` succeeded
  Eigen::ComputationInfo info() const { return m_info; }

  /// the solution x of A x = \p b; call `factorize()` first
  Columns solve(const Columns& b) const
  {
    Columns x = b;
    const int n = static_cast<int>(m_diagonal.size());
    for(int i = 0; i < n; ++i)
      for(std::size_t p = m_begin[i]; p < m_begin[i + 1]; ++p)
        for(int axis = 0; axis < 2; ++axis)
          x(m_rows[p], axis) -= m_values[p][0] * x(i, axis);
    for(int i = n - 1; i >= 0; --i)
      for(int axis = 0; axis < 2; ++axis) {
        double sum = x(i, axis);
        for(std::size_t p = m_begin[i]; p < m_begin[i + 1]; ++p)
          sum -= m_values[p][1] * x(m_rows[p], axis);
        x(i, axis) = sum / m_diagonal[i];
      }
    return x;
  }

private:
  /// writes row k and column k of the matrix, up to the diagonal, into \p y. The columns of L that take part in their
  /// elimination are the ends of paths in the elimination tree; they fill \p pattern from the returned place on, each
  /// before its parent.
  int scatter(const Matrix& matrix, int k, std::vector<std::array<double, 2>>& y, std::vector<int>& visited_for,
              std::vector<int>& path, std::vector<int>& pattern) const
  {
    const int *begin = matrix.outerIndexPtr(), *rows = matrix.innerIndexPtr();
    int first = static_cast<int>(matrix.rows());
    visited_for[k] = k;
    for(int p = begin[k]; p < begin[k + 1] && rows[p] <= k; ++p) {
      y[rows[p]] = {matrix.valuePtr()[m_mirror[p]], matrix.valuePtr()[p]};
      int length = 0;
      for(int i = rows[p]; visited_for[i] != k; i = m_parent[i]) {
        visited_for[i] = k;
        path[length++] = i;
      }
      while(length > 0)
        pattern[--first] = path[--length];
    }
    return first;
  }

  std::vector<int> m_parent;                   // in the elimination tree, -1 for roots
  std::vector<int> m_mirror;                   // for the place of entry (i, j) in the matrix, that of (j, i)
  std::vector<std::size_t> m_begin;            // where each column of L, and row of U, begins
  std::vector<int> m_rows;                     // the rows of L, the columns of U
  std::vector<std::array<double, 2>> m_values; // of L and of U
  std::vector<double> m_diagonal;              // of U
  Eigen::ComputationInfo m_info = Eigen::InvalidInput;
};

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ITERATION_UNPIVOTED_LU_H
