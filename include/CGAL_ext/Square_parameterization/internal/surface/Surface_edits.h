// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SURFACE_SURFACE_EDITS_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SURFACE_SURFACE_EDITS_H

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL_ext {
namespace internal {

/// what is to be done to a surface so that it can be mapped, decided on its arrays and applied to a mesh by
/// `apply_edits()`: first edges are cut open, then others are split at their midpoints. New vertices come last, in this
/// order.
struct Surface_edits
{
  std::vector<std::array<int, 2>> seams;  ///< the ends of the edges to cut along
  std::vector<std::array<int, 3>> opened; ///< #F, the triangles of the surface cut open; empty when there are no seams
  std::vector<int> copies;                ///< per vertex that cutting adds, the one that it is a copy of
  std::vector<std::array<int, 2>> splits; ///< the ends of the edges to split; each adds a vertex
  std::size_t border_splits = 0;          ///< how many of the splits, the first ones, are of border edges
};

} // namespace internal
} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SURFACE_SURFACE_EDITS_H
