// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ITERATION_ELIMINATION_FRONT_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ITERATION_ELIMINATION_FRONT_H

#include <cstddef>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// a dense symmetric matrix of the multifrontal method: its first columns are eliminated, and what that does to the
/// others, its contribution, is added to its parent. Of both the lower triangle counts. Columns are padded to a multiple
/// of `TILE` rows, so that loops run over whole tiles.
struct Elimination_front
{
  static constexpr int TILE = 4;

  int first = 0;        ///< column of the reordered matrix that is eliminated first
  int width = 0;        ///< columns eliminated
  int height = 0;       ///< rows: those of the columns eliminated, then others, of fronts above
  int parent = -1;      ///< front, -1 for roots
  int first_child = -1; ///< front, -1 for leaves
  int next_sibling = -1;
  int first_entry = 0, end_entry = 0; ///< entries of the matrix in its columns, in `Elimination_fronts::entries()`
  std::size_t rows = 0;               ///< where its rows begin in `Elimination_fronts::rows()`
  std::size_t values = 0;             ///< where its eliminated columns begin in the factor
  std::size_t contribution = 0;       ///< where its contribution lies in the working memory, until its parent has it
  std::size_t kept_contribution = 0;  ///< the same where all contributions are kept

  int rows_of_parent() const { return height - width; } ///< rows, and columns, of the contribution
  int stride() const { return padded(height); }         ///< from column to column of the factor
  int contribution_stride() const { return padded(rows_of_parent()); }
  std::size_t factor_size() const { return std::size_t(width) * stride(); }
  std::size_t contribution_size() const { return std::size_t(rows_of_parent()) * contribution_stride(); }

private:
  static int padded(int rows) { return (rows + TILE - 1) / TILE * TILE; }
};

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ITERATION_ELIMINATION_FRONT_H
