// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SURFACE_SURFACE_ARRAYS_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SURFACE_SURFACE_ARRAYS_H

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// a triangle mesh as flat arrays, with its vertices and faces in their order
struct Surface_arrays
{
  std::vector<Eigen::Vector3d> points;       ///< #V, as the mesh has them
  std::vector<std::array<int, 3>> triangles; ///< #F, as the mesh orients them
  std::vector<std::size_t> places;           ///< #V, in the order of the mesh; empty when no vertex is left out
  std::size_t border_sides = 0;              ///< number of sides of faces that the mesh has on a border

  /// the number by which a message names a vertex
  std::size_t place(int v) const { return places.empty() ? static_cast<std::size_t>(v) : places[v]; }
};

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SURFACE_SURFACE_ARRAYS_H
