// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COARSENING_COARSE_PATCH_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COARSENING_COARSE_PATCH_H

#include <CGAL_ext/Square_parameterization/internal/patch/Patch.h>

#include <vector>

namespace CGAL_ext {
namespace internal {

/// a patch with fewer vertices, and how to get back
struct Coarse_patch
{
  /// a vertex that was taken out: collapsed into one of its neighbors. All are vertices of the fine patch.
  struct Removal
  {
    int vertex, target;
    std::vector<int> ring; ///< the neighbors of the vertex then, counter-clockwise; from the next to the previous
                           ///< border vertex when it is on the border
    std::vector<int> target_ring; ///< those of the target then, if both are on the border; else empty

    bool is_on_border() const { return !target_ring.empty(); }
  };

  Patch patch;
  std::vector<int> fine_vertex;  ///< per vertex of `patch`, the one of the fine patch
  std::vector<Removal> removals; ///< in the order in which they were made
};

} // namespace internal
} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COARSENING_COARSE_PATCH_H
