// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PIPELINE_MAP_SURFACE_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PIPELINE_MAP_SURFACE_H

#include <CGAL_ext/Square_parameterization/Square_map_options.h>
#include <CGAL_ext/Square_parameterization/Square_map_result.h>
#include <CGAL_ext/Square_parameterization/internal/patch/Patch.h>
#include <CGAL_ext/Square_parameterization/internal/pipeline/Chosen_elements.h>
#include <CGAL_ext/Square_parameterization/internal/surface/Surface_arrays.h>
#include <CGAL_ext/Square_parameterization/internal/surface/Surface_edits.h>

#include <array>
#include <vector>

namespace CGAL_ext {
namespace internal {

/// a map of a surface, and what must be done to the mesh to have it there
struct Mapped_surface
{
  Surface_edits edits;
  std::vector<std::array<int, 3>> triangles; ///< #F of the disk
  Uv_coordinates uv;                         ///< #V of the disk by 2: vertices of the surface, copies, midpoints
  std::array<int, 4> corners{};              ///< vertices of the disk
};

/// maps a surface onto the unit square: decides on a cut, on border edges and chords to split, searches the corners, and
/// measures the map. All of it on arrays: no mesh is touched.
///
/// Throws `Unmappable` when there is no map; the report then tells what was found out before.
Mapped_surface map_surface(Surface_arrays mesh, const Chosen_elements& chosen, const Square_map_settings& settings,
                           Square_map_report& report);

} // namespace internal
} // namespace CGAL_ext

#ifndef CGAL_EXT_COMPILED_CORE
#include <CGAL_ext/Square_parameterization/internal/pipeline/map_surface_impl.h>
#endif

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PIPELINE_MAP_SURFACE_H
