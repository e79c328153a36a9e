// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SURFACE_MAKE_DISK_PATCH_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SURFACE_MAKE_DISK_PATCH_H

#include <CGAL_ext/Square_parameterization/internal/patch/Patch.h>
#include <CGAL_ext/Square_parameterization/internal/surface/Surface_arrays.h>

#include <array>
#include <cstddef>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// the border of a disk, counter-clockwise from \p start on. Throws `Unmappable` when that is not all of the border.
/// \param start -1 for a surface without border, which is none then
std::vector<int> border_from(int start, std::size_t number_of_vertices,
                             const std::vector<std::array<int, 3>>& triangles, const Edge_numbering& numbering);

/// makes a patch of one component of a mesh that is a disk; the border begins at vertex \p start.
///
/// Throws `Unmappable` when the component is not a disk, and as `make_patch()`.
Patch make_disk_patch(Surface_arrays mesh, int start);

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#ifndef CGAL_EXT_COMPILED_CORE
#include <CGAL_ext/Square_parameterization/internal/surface/make_disk_patch_impl.h>
#endif

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SURFACE_MAKE_DISK_PATCH_H
