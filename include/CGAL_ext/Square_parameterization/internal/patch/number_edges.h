// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PATCH_NUMBER_EDGES_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PATCH_NUMBER_EDGES_H

#include <array>
#include <cstddef>
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

/// numbers the edges of \p triangles, #F, between \p number_of_vertices vertices, with the threads of the current team.
/// Complexity: linear but for the sorting of the edges at a vertex.
Edge_numbering number_edges(std::size_t number_of_vertices, const std::vector<std::array<int, 3>>& triangles);

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#ifndef CGAL_EXT_COMPILED_CORE
#include <CGAL_ext/Square_parameterization/internal/patch/number_edges_impl.h>
#endif

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PATCH_NUMBER_EDGES_H
