// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PATCH_NUMBER_EDGES_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PATCH_NUMBER_EDGES_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// the edges of a set of triangles
struct Edge_numbering
{
  std::vector<std::array<int, 2>> edges;          ///< #E, first index lower, sorted
  std::vector<std::array<int, 3>> triangle_edges; ///< #F, edge k is opposite to corner k
  std::vector<int> number_of_triangles;           ///< #E: 1 on the border, 2 inside, more where it is not manifold
};

/// numbers the edges of \p triangles, #F, between \p number_of_vertices vertices. Complexity: linear but for the sorting
/// of the edges at a vertex.
inline Edge_numbering number_edges(std::size_t number_of_vertices, const std::vector<std::array<int, 3>>& triangles)
{
  struct Side
  {
    int low, high, triangle, corner;
  };
  std::vector<int> first(number_of_vertices + 1, 0);
  for(const auto& t : triangles)
    for(int k = 0; k < 3; ++k)
      ++first[(std::min)(t[(k + 1) % 3], t[(k + 2) % 3]) + 1];
  for(std::size_t v = 1; v < first.size(); ++v)
    first[v] += first[v - 1];
  // bucket the sides by their lower vertex, then sort the small buckets
  std::vector<Side> sides(3 * triangles.size());
  std::vector<int> next(first.begin(), first.end() - 1);
  for(std::size_t f = 0; f < triangles.size(); ++f)
    for(int k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax(triangles[f][(k + 1) % 3], triangles[f][(k + 2) % 3]);
      sides[next[low]++] = {low, high, static_cast<int>(f), k};
    }

  Edge_numbering result;
  result.triangle_edges.resize(triangles.size());
  for(std::size_t v = 0; v < number_of_vertices; ++v) {
    const auto begin = sides.begin() + first[v], end = sides.begin() + first[v + 1];
    std::sort(begin, end, [](const Side& a, const Side& b) {
      return std::make_pair(a.high, a.triangle) < std::make_pair(b.high, b.triangle);
    });
    for(auto side = begin; side != end; ++side) {
      if(side == begin || (side - 1)->high != side->high) {
        result.edges.push_back({side->low, side->high});
        result.number_of_triangles.push_back(0);
      }
      ++result.number_of_triangles.back();
      result.triangle_edges[side->triangle][side->corner] = static_cast<int>(result.edges.size()) - 1;
    }
  }
  return result;
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PATCH_NUMBER_EDGES_H
