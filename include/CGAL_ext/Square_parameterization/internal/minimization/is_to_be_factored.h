// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_IS_TO_BE_FACTORED_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_IS_TO_BE_FACTORED_H

#include <CGAL_ext/Square_parameterization/internal/common/Minimizer_numbers.h>
#include <CGAL_ext/Square_parameterization/internal/patch/Patch.h>

#include <algorithm>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// indicates whether all vertices are near the border, along edges: then a few vertices divide the patch wherever it is cut in
/// two (a planar graph of depth k has a treewidth below 3 k + 3), and its factors take linear time and memory
inline bool is_near_border(const Patch& patch)
{
  std::vector<int> distance(patch.points.size(), Minimizer_numbers::LARGEST_DEPTH_FACTORED + 1);
  for(int v : patch.border)
    distance[v] = 0;
  for(int reached = 0; reached < Minimizer_numbers::LARGEST_DEPTH_FACTORED; ++reached)
    for(const auto& [a, b] : patch.edges) {
      distance[a] = (std::min)(distance[a], distance[b] + 1);
      distance[b] = (std::min)(distance[b], distance[a] + 1);
    }
  return *std::max_element(distance.begin(), distance.end()) <= Minimizer_numbers::LARGEST_DEPTH_FACTORED;
}

/// indicates whether the matrices of a patch are factored, in linear time or nearly so
inline bool is_to_be_factored(const Patch& patch)
{
  return patch.number_of_vertices() <= Minimizer_numbers::LARGEST_FACTORED || is_near_border(patch);
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_IS_TO_BE_FACTORED_H
