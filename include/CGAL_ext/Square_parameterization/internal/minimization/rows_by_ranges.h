// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_ROWS_BY_RANGES_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_ROWS_BY_RANGES_H

#include <CGAL_ext/Square_parameterization/internal/common/ranges.h>
#include <CGAL_ext/Square_parameterization/internal/patch/Patch.h>

#include <cstddef>

namespace CGAL_ext {
namespace internal {

// arithmetic with one row per vertex, on the threads of the current team

/// \p target becomes what `expression(rows)` is in all its rows, where `rows(x)` are the rows of a matrix x that are
/// computed together
template <class Target, class Expression>
void set_rows(Target& target, Eigen::Index number_of_rows, const Expression& expression)
{
  target.resize(number_of_rows, target.cols());
  for_ranges(number_of_rows, [&](std::size_t begin, std::size_t end) {
    const auto rows = [begin, end](const auto& x) { return x.middleRows(begin, end - begin); };
    target.middleRows(begin, end - begin) = expression(rows);
  });
}

/// the scalar product
inline double dot(const Uv_coordinates& a, const Uv_coordinates& b)
{
  return sum_of_ranges(a.rows(), 0., [&](std::size_t begin, std::size_t end) {
    return a.middleRows(begin, end - begin).cwiseProduct(b.middleRows(begin, end - begin)).sum();
  });
}

} // namespace internal
} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_ROWS_BY_RANGES_H
