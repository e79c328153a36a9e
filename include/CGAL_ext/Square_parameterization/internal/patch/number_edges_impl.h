// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PATCH_NUMBER_EDGES_IMPL_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PATCH_NUMBER_EDGES_IMPL_H

#include <CGAL_ext/Square_parameterization/internal/common/compiled_core.h>
#include <CGAL_ext/Square_parameterization/internal/common/ranges.h>
#include <CGAL_ext/Square_parameterization/internal/patch/number_edges.h>

#include <algorithm>
#include <utility>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

CGAL_EXT_INLINE_FUNCTION Edge_numbering number_edges(std::size_t number_of_vertices,
                                                     const std::vector<std::array<int, 3>>& triangles)
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

  const auto is_first_of_edge = [&sides](int begin, int i) { return i == begin || sides[i - 1].high != sides[i].high; };
  std::vector<int> first_edge(number_of_vertices + 1, 0); // of those with this lower vertex
  for_ranges(number_of_vertices, [&](std::size_t range_begin, std::size_t range_end) {
    for(std::size_t v = range_begin; v < range_end; ++v) {
      std::sort(sides.begin() + first[v], sides.begin() + first[v + 1], [](const Side& a, const Side& b) {
        return std::make_pair(a.high, a.triangle) < std::make_pair(b.high, b.triangle);
      });
      for(int i = first[v]; i < first[v + 1]; ++i)
        first_edge[v + 1] += is_first_of_edge(first[v], i) ? 1 : 0;
    }
  });
  for(std::size_t v = 1; v < first_edge.size(); ++v)
    first_edge[v] += first_edge[v - 1];

  Edge_numbering result;
  result.edges.resize(first_edge.back());
  result.number_of_triangles.resize(first_edge.back(), 0);
  result.triangle_edges.resize(triangles.size());
  for_ranges(number_of_vertices, [&](std::size_t range_begin, std::size_t range_end) {
    for(std::size_t v = range_begin; v < range_end; ++v) {
      int edge = first_edge[v] - 1;
      for(int i = first[v]; i < first[v + 1]; ++i) {
        const Side& side = sides[i];
        if(is_first_of_edge(first[v], i))
          result.edges[++edge] = {side.low, side.high};
        ++result.number_of_triangles[edge];
        result.triangle_edges[side.triangle][side.corner] = edge;
      }
    }
  });
  return result;
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PATCH_NUMBER_EDGES_IMPL_H
