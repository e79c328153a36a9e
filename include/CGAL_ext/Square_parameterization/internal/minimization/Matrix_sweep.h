// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_MATRIX_SWEEP_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_MATRIX_SWEEP_H

#include <CGAL_ext/Square_parameterization/internal/common/ranges.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/Axis_matrix.h>
#include <CGAL_ext/Square_parameterization/internal/patch/Patch_division.h>

#include <cstddef>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// sweeps of Gauss and Seidel over the equations of an `Axis_matrix`, of which the rows are the ranks of a division: the
/// blocks of the division at a time, on the threads of the current team, and then the separators. The result does not
/// depend on the number of threads.
///
/// Of the matrix there is the upper triangle: a column has the entries above its diagonal. Those in the columns of a
/// block are in rows of the same block; those of separators are in rows of blocks, and then in rows of separators.
class Matrix_sweep
{
public:
  typedef Axis_matrix::Matrix Matrix;

  /// \param pattern a matrix with the places of all entries
  /// \param division must live as long
  Matrix_sweep(const Patch_division& division, const Matrix& pattern) : m_division(division)
  {
    const int first_separator = division.separators().begin;
    std::vector<int> block_of(first_separator);
    for(int b = 0; b < division.number_of_blocks(); ++b)
      for(int i = division.block(b).begin; i < division.block(b).end; ++i)
        block_of[i] = b;
    m_first_crossing.assign(division.number_of_blocks() + 1, 0);
    const auto for_crossings = [&](const auto& visit) {
      for(int j = first_separator; j < division.separators().end; ++j) {
        int slot = pattern.outerIndexPtr()[j];
        for(; pattern.innerIndexPtr()[slot] < first_separator; ++slot)
          visit(Crossing{slot, pattern.innerIndexPtr()[slot], j});
        m_first_among_separators.push_back(slot);
      }
    };
    for_crossings([&](const Crossing& crossing) { ++m_first_crossing[block_of[crossing.row] + 1]; });
    m_first_among_separators.clear();
    for(std::size_t b = 1; b < m_first_crossing.size(); ++b)
      m_first_crossing[b] += m_first_crossing[b - 1];
    m_crossings.resize(m_first_crossing.back());
    std::vector<int> next(m_first_crossing.begin(), m_first_crossing.end() - 1);
    for_crossings([&](const Crossing& crossing) { m_crossings[next[block_of[crossing.row]]++] = crossing; });
  }

  static bool has_positive_diagonal(const Matrix& matrix)
  {
    for(Eigen::Index j = 0; j < matrix.cols(); ++j)
      if(const Number_per_axis d = diagonal(matrix, j); !(d[0] > 0 && d[1] > 0))
        return false;
    return true;
  }

  /// one sweep from zero for the right hand side \p x. The residual that it leaves comes from what is later in the order.
  void from_zero(const Matrix& matrix, const Uv_coordinates& x, Uv_coordinates& solution,
                 Uv_coordinates& residual) const
  {
    solution.resize(x.rows(), 2);
    residual.resize(x.rows(), 2);
    for_blocks([&](int b) {
      const auto [begin, end] = m_division.block(b);
      residual.middleRows(begin, end - begin).setZero();
      for(int j = begin; j < end; ++j)
        visit_from_zero(matrix, matrix.outerIndexPtr()[j], j, at(x, j), solution, residual);
    });
    const auto [first, end] = m_division.separators();
    residual.middleRows(first, end - first).setZero();
    for_separators([&](int j) {
      Number_per_axis here = at(x, j);
      for(int k = matrix.outerIndexPtr()[j]; k < first_among_separators(j); ++k)
        here -= matrix.valuePtr()[k] * at(solution, matrix.innerIndexPtr()[k]);
      put(here, j, solution);
    });
    for(int j = first; j < end; ++j)
      visit_from_zero(matrix, first_among_separators(j), j, at(solution, j), solution, residual);
    for_blocks([&](int b) { subtract_crossings(b, matrix, solution, residual); });
  }

  /// x becomes x - A y
  void subtract_product(const Matrix& matrix, const Uv_coordinates& y, Uv_coordinates& x) const
  {
    for_blocks([&](int b) {
      const auto [begin, end] = m_division.block(b);
      for(int j = begin; j < end; ++j)
        subtract_column(matrix, matrix.outerIndexPtr()[j], j, y, x);
      subtract_crossings(b, matrix, y, x);
    });
    for_separators([&](int j) {
      Number_per_axis here = at(x, j);
      for(int k = matrix.outerIndexPtr()[j]; k < first_among_separators(j); ++k)
        here -= matrix.valuePtr()[k] * at(y, matrix.innerIndexPtr()[k]);
      put(here, j, x);
    });
    for(int j = m_division.separators().begin; j < m_division.separators().end; ++j)
      subtract_column(matrix, first_among_separators(j), j, y, x);
  }

  /// one sweep from zero in the other direction: x, a right hand side, becomes its result
  void back(const Matrix& matrix, Uv_coordinates& x) const
  {
    for(int j = m_division.separators().end; j-- > m_division.separators().begin;)
      visit_back(matrix, first_among_separators(j), j, x);
    for_blocks([&](int b) {
      subtract_crossings(b, matrix, x, x);
      const auto [begin, end] = m_division.block(b);
      for(int j = end; j-- > begin;)
        visit_back(matrix, matrix.outerIndexPtr()[j], j, x);
    });
  }

private:
  /// an entry in the row of a block and in the column of a separator
  struct Crossing
  {
    int slot, row, column;
  };

  static constexpr std::size_t SEPARATORS_AT_A_TIME = 1024;

  template <class Visit>
  void for_blocks(const Visit& visit) const
  {
    Thread_team::current()(m_division.number_of_blocks(), [&](std::size_t b) { visit(static_cast<int>(b)); });
  }

  template <class Visit>
  void for_separators(const Visit& visit) const
  {
    const auto [first, end] = m_division.separators();
    for_ranges(
        end - first,
        [&, first_separator = first](std::size_t range_begin, std::size_t range_end) {
          for(std::size_t i = range_begin; i < range_end; ++i)
            visit(first_separator + static_cast<int>(i));
        },
        SEPARATORS_AT_A_TIME);
  }

  int first_among_separators(int j) const { return m_first_among_separators[j - m_division.separators().begin]; }

  // the entries of a column of the upper triangle end with the one on the diagonal

  static const Number_per_axis& diagonal(const Matrix& matrix, Eigen::Index j)
  {
    return matrix.valuePtr()[matrix.outerIndexPtr()[j + 1] - 1];
  }

  /// calls `visit(i, a)` for the entries above the diagonal of column j, from place \p slot on
  template <class Visit>
  static void for_above_diagonal(const Matrix& matrix, int slot, int j, const Visit& visit)
  {
    for(int k = slot, end = matrix.outerIndexPtr()[j + 1] - 1; k < end; ++k)
      visit(matrix.innerIndexPtr()[k], matrix.valuePtr()[k]);
  }

  static Number_per_axis at(const Uv_coordinates& uv, Eigen::Index v) { return {uv(v, 0), uv(v, 1)}; }

  static void put(const Number_per_axis& p, Eigen::Index v, Uv_coordinates& uv)
  {
    uv(v, 0) = p[0];
    uv(v, 1) = p[1];
  }

  /// solves equation j, of which the right hand side is \p here without the entries before \p slot
  static void visit_from_zero(const Matrix& matrix, int slot, int j, Number_per_axis here, Uv_coordinates& solution,
                              Uv_coordinates& residual)
  {
    for_above_diagonal(matrix, slot, j, [&](int i, const Number_per_axis& a) { here -= a * at(solution, i); });
    here /= diagonal(matrix, j);
    put(here, j, solution);
    for_above_diagonal(matrix, slot, j,
                       [&](int i, const Number_per_axis& a) { put(at(residual, i) - a * here, i, residual); });
  }

  static void subtract_column(const Matrix& matrix, int slot, int j, const Uv_coordinates& y, Uv_coordinates& x)
  {
    const Number_per_axis here = at(y, j);
    Number_per_axis sum = diagonal(matrix, j) * here;
    for_above_diagonal(matrix, slot, j, [&](int i, const Number_per_axis& a) {
      sum += a * at(y, i);
      put(at(x, i) - a * here, i, x);
    });
    put(at(x, j) - sum, j, x);
  }

  static void visit_back(const Matrix& matrix, int slot, int j, Uv_coordinates& x)
  {
    const Number_per_axis here = at(x, j) / diagonal(matrix, j);
    put(here, j, x);
    for_above_diagonal(matrix, slot, j, [&](int i, const Number_per_axis& a) { put(at(x, i) - a * here, i, x); });
  }

  /// subtracts from the rows of a block what comes from separators
  void subtract_crossings(int b, const Matrix& matrix, const Uv_coordinates& y, Uv_coordinates& x) const
  {
    for(int i = m_first_crossing[b]; i < m_first_crossing[b + 1]; ++i) {
      const auto& [slot, row, column] = m_crossings[i];
      put(at(x, row) - matrix.valuePtr()[slot] * at(y, column), row, x);
    }
  }

  const Patch_division& m_division;
  std::vector<Crossing> m_crossings;         // block by block
  std::vector<int> m_first_crossing;         // #blocks + 1
  std::vector<int> m_first_among_separators; // per separator, the place of its first entry in the row of a separator
};

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_MATRIX_SWEEP_H
