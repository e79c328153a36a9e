// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ITERATION_DENSE_COLUMNS_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ITERATION_DENSE_COLUMNS_H

#include <CGAL_ext/Square_parameterization/internal/iteration/Elimination_front.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

// what `Multifrontal_ldlt` does to a few columns of a front, which are stored column by column, `stride` numbers apart

namespace CGAL_ext {
namespace internal {

/// indicates whether a matrix can be divided by a number
inline bool is_pivot(double number)
{
  return std::isfinite(number) && number != 0;
}

/// calls `use` with a constant of a width, 1 to that of a tile: loops of so many turns are unrolled
template <class Use>
void for_width(int width, const Use& use)
{
  static_assert(Elimination_front::TILE == 4);
  switch(width) {
  case 1:
    return use(std::integral_constant<int, 1>());
  case 2:
    return use(std::integral_constant<int, 2>());
  case 3:
    return use(std::integral_constant<int, 3>());
  default:
    return use(std::integral_constant<int, 4>());
  }
}

/// subtracts from columns what others, that are eliminated, do to them:
/// x(i, k) -= sum over p of l(i, p) D(p) l(k, p)
/// \param l, l_stride the rows of \p pivots columns of L from that of the first column on, and what is between columns
/// \param diagonal of D
/// \param x, stride, height `WIDTH` columns, from their first row on
/// \param factors memory of the caller
template <int WIDTH, class Number>
void subtract_products(const Number* l, int l_stride, int pivots, const Number* diagonal, Number* x, int stride,
                       int height, std::vector<Number>& factors)
{
  // at once: of more the sums do not fit into the registers that all processors have
  constexpr int ROWS = Elimination_front::TILE * sizeof(double) / sizeof(Number);
  using Tile_column = Eigen::Array<Number, ROWS, 1>;
  factors.resize((std::max)(factors.size(), std::size_t(pivots) * WIDTH));
  for(int p = 0; p < pivots; ++p)
    for(int k = 0; k < WIDTH; ++k)
      factors[p * WIDTH + k] = diagonal[p] * l[std::size_t(p) * l_stride + k];
  for(int i = 0; i < height; i += ROWS) {
    Tile_column tile[WIDTH]; // stays in registers
    for(int k = 0; k < WIDTH; ++k)
      tile[k] = Eigen::Map<const Tile_column>(x + std::size_t(k) * stride + i);
    const Number* column = l + i;
    const Number* factor = factors.data();
    for(int p = 0; p < pivots; ++p, column += l_stride, factor += WIDTH)
      for(int k = 0; k < WIDTH; ++k)
        tile[k] -= Eigen::Map<const Tile_column>(column) * factor[k];
    for(int k = 0; k < WIDTH; ++k)
      Eigen::Map<Tile_column>(x + std::size_t(k) * stride + i) = tile[k];
  }
}

/// eliminates columns from which all before are subtracted; false when a pivot is zero or not finite
/// \param columns `WIDTH` columns, from the diagonal of the first on, of `height` rows
template <int WIDTH, class Number>
bool eliminate_columns(Number* columns, int stride, int height, Number* diagonal)
{
  std::array<Number, WIDTH> inverses;
  std::array<std::array<Number, WIDTH>, WIDTH> factors; // of a column, for those after it
  for(int k = 0; k < WIDTH; ++k) {
    const Number pivot = columns[k * stride + k];
    if(!is_pivot(pivot))
      return false;
    diagonal[k] = pivot;
    inverses[k] = Number(1) / pivot;
    for(int i = k + 1; i < WIDTH; ++i) {
      columns[k * stride + i] *= inverses[k];
      factors[k][i] = columns[k * stride + i] * pivot;
      for(int next = k + 1; next <= i; ++next)
        columns[next * stride + i] -= columns[k * stride + i] * factors[k][next];
    }
  }
  for(int i = WIDTH; i < height; ++i) { // row by row: its entries are read and written once
    std::array<Number, WIDTH> row;
    for(int k = 0; k < WIDTH; ++k)
      row[k] = columns[k * stride + i];
    for(int k = 0; k < WIDTH; ++k) {
      row[k] *= inverses[k];
      for(int next = k + 1; next < WIDTH; ++next)
        row[next] -= row[k] * factors[k][next];
    }
    for(int k = 0; k < WIDTH; ++k)
      columns[k * stride + i] = row[k];
  }
  return true;
}

/// what stands in one row of `COLUMNS` right hand sides, or of the solutions
template <class Number, int COLUMNS>
using Row_of_columns = Eigen::Array<Number, COLUMNS, 1>;

/// solves with columns of L
/// \param columns `WIDTH` columns of L, from the diagonal of the first on
/// \param x `height` rows
template <int WIDTH, class Number, int COLUMNS>
void solve_lower_columns(const Number* columns, int stride, int height, Row_of_columns<Number, COLUMNS>* x)
{
  using Row = Row_of_columns<Number, COLUMNS>;
  for(int k = 0; k < WIDTH; ++k)
    for(int i = k + 1; i < WIDTH; ++i)
      x[i] -= x[k] * columns[k * stride + i];
  std::array<Row, WIDTH> solved;
  std::copy_n(x, WIDTH, solved.begin());
  for(int i = WIDTH; i < height; ++i) {
    Row row = x[i];
    for(int k = 0; k < WIDTH; ++k)
      row -= solved[k] * columns[k * stride + i];
    x[i] = row;
  }
}

/// solves with D and rows of L^T
template <int WIDTH, class Number, int COLUMNS>
void solve_upper_columns(const Number* columns, int stride, int height, const Number* diagonal,
                         Row_of_columns<Number, COLUMNS>* x)
{
  using Row = Row_of_columns<Number, COLUMNS>;
  std::array<Row, WIDTH> sums;
  for(int k = 0; k < WIDTH; ++k)
    sums[k] = Row::Constant(Number(0));
  for(int i = WIDTH; i < height; ++i)
    for(int k = 0; k < WIDTH; ++k)
      sums[k] += x[i] * columns[k * stride + i];
  for(int k = WIDTH - 1; k >= 0; --k) {
    x[k] = x[k] / diagonal[k] - sums[k];
    for(int i = k + 1; i < WIDTH; ++i)
      x[k] -= x[i] * columns[k * stride + i];
  }
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ITERATION_DENSE_COLUMNS_H
