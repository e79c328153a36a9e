// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ITERATION_SPARSE_PATTERN_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ITERATION_SPARSE_PATTERN_H

#include <CGAL_ext/Square_parameterization/internal/iteration/linear_solvers.h>
#include <CGAL_ext/Square_parameterization/internal/patch/Patch.h>

#include <Eigen/OrderingMethods>

#include <algorithm>
#include <array>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// the place of each node of a graph in an order that keeps the fill of a factorization low: minimum degree, which
/// takes nodes of equal degree as they are numbered. Numbered backwards, meshes, where vertices of subdivisions come
/// last, take a seventh less of arithmetic to factor, in the mean of 17.
/// \param edges pairs of nodes in 0, ..., \p number_of_nodes - 1
inline std::vector<int> fill_reducing_order(int number_of_nodes, const std::vector<std::array<int, 2>>& edges)
{
  const int last = number_of_nodes - 1;
  std::vector<Eigen::Triplet<double>> entries;
  for(int i = 0; i < number_of_nodes; ++i) // rows without a diagonal entry would all be ordered last
    entries.emplace_back(i, i, 1.);
  for(const auto& [i, j] : edges) {
    entries.emplace_back(last - i, last - j, 1.);
    entries.emplace_back(last - j, last - i, 1.);
  }
  Sparse_matrix adjacency(number_of_nodes, number_of_nodes);
  adjacency.setFromTriplets(entries.begin(), entries.end());
  Eigen::AMDOrdering<int>::PermutationType node_at;
  Eigen::AMDOrdering<int>()(adjacency, node_at);
  std::vector<int> place(number_of_nodes);
  for(int i = 0; i < number_of_nodes; ++i)
    place[last - node_at.indices()[i]] = i;
  return place;
}

/// the place of each vertex of a patch in its order of elimination, or in a new one where it has none
inline std::vector<int> elimination_places_of(const Patch& patch)
{
  return patch.elimination_places.empty() ? fill_reducing_order(patch.number_of_vertices(), patch.edges)
                                          : patch.elimination_places;
}

/// where the values of \p pattern hold the entry at \p row and \p column
/// \pre the pattern is compressed and has that entry
template <class Number>
int slot_of(const Eigen::SparseMatrix<Number>& pattern, int row, int column)
{
  const int* const rows = pattern.innerIndexPtr();
  const int *begin = rows + pattern.outerIndexPtr()[column], *end = rows + pattern.outerIndexPtr()[column + 1];
  return static_cast<int>(std::lower_bound(begin, end, row) - rows);
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ITERATION_SPARSE_PATTERN_H
