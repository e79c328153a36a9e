// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ITERATION_ELIMINATION_TREE_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ITERATION_ELIMINATION_TREE_H

#include <Eigen/SparseCore>

#include <numeric>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// the elimination tree of a matrix, and the sizes of the columns of its factor
struct Column_tree
{
  std::vector<int> parent;     ///< -1 for roots
  std::vector<int> rows_below; ///< below the diagonal of the factor
};

/// finds the elimination tree of a matrix of which the upper triangle is stored.
/// Davis, Direct Methods for Sparse Linear Systems, 2006, sections 4.1 and 4.3: the columns where a row of the factor has
/// an entry are those on the paths from its entries in the matrix up to its diagonal
template <class Number>
Column_tree elimination_tree(const Eigen::SparseMatrix<Number>& upper)
{
  const int n = static_cast<int>(upper.cols());
  Column_tree tree{std::vector<int>(n, -1), std::vector<int>(n, 0)};
  std::vector<int> visited_for(n, -1);
  for(int row = 0; row < n; ++row) {
    visited_for[row] = row;
    for(typename Eigen::SparseMatrix<Number>::InnerIterator entry(upper, row); entry; ++entry)
      for(int j = static_cast<int>(entry.row()); visited_for[j] != row; j = tree.parent[j]) {
        if(tree.parent[j] < 0)
          tree.parent[j] = row;
        visited_for[j] = row;
        ++tree.rows_below[j];
      }
  }
  return tree;
}

/// what a front costs, in multiplications: those of its elimination, its numbers in memory, and itself. The map of
/// three disks of 16000 to 26000 faces takes the same time with half or twice these constants.
inline double cost_of_front(double width, double height)
{
  constexpr double OF_NUMBER = 4, OF_FRONT = 1000;
  const auto squares_to = [](double n) { return n * (n + 1) * (2 * n + 1) / 6; };
  return (squares_to(height) - squares_to(height - width)) / 2 + OF_NUMBER * width * height + OF_FRONT;
}

/// merges columns into their parents: first where both have the same rows, then where one front costs less than two
/// (Ashcraft and Grimes, ACM TOMS 15, 1989), and no more for each of its columns than the lower one does: on strips, where column
/// follows column, a front would grow until one column more costs as much as a front of its own. Returns for each
/// column the last one of its front.
inline std::vector<int> merged_columns(const Column_tree& tree)
{
  struct Size
  {
    int width, height;
    double cost() const { return cost_of_front(width, height); }
  };
  const int n = static_cast<int>(tree.parent.size());
  std::vector<int> last(n);
  std::iota(last.begin(), last.end(), 0);
  std::vector<Size> sizes;
  for(int rows : tree.rows_below)
    sizes.push_back({1, 1 + rows});
  const auto merge = [&](const auto& is_worth_it) {
    for(int j = 0; j < n; ++j) {
      if(last[j] != j || tree.parent[j] < 0)
        continue;
      const int parent = last[tree.parent[j]];
      const Size both{sizes[j].width + sizes[parent].width, sizes[j].width + sizes[parent].height};
      if(is_worth_it(sizes[j], sizes[parent], both)) {
        sizes[parent] = both;
        last[j] = parent;
      }
    }
    for(int j = n - 1; j >= 0; --j)
      last[j] = last[last[j]];
  };
  merge([](const Size& child, const Size&, const Size& both) { return both.height == child.height; });
  merge([](const Size& child, const Size& parent, const Size& both) {
    return both.cost() <= child.cost() + parent.cost() && both.cost() * child.width <= child.cost() * both.width;
  });
  return last;
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ITERATION_ELIMINATION_TREE_H
