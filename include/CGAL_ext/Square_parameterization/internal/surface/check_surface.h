// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SURFACE_CHECK_SURFACE_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SURFACE_CHECK_SURFACE_H

#include <CGAL_ext/Square_parameterization/internal/surface/Surface_arrays.h>
#include <CGAL_ext/Square_parameterization/internal/surface/Triangle_surface.h>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// refuses a mesh without faces, and faces that repeat a vertex
void check_faces(const Surface_arrays& mesh);

/// refuses two edges of the mesh between the same two vertices: more than two faces at them, or a border of two edges
void check_edges(const Surface_arrays& mesh, const Edge_numbering& numbering);

/// the surface of a mesh, scaled so that no square overflows.
///
/// Throws `Unmappable` when it is not one connected manifold surface, when a coordinate is not finite, and when no face
/// has an area. Messages count vertices in the order of the mesh.
Triangle_surface make_checked_surface(const Surface_arrays& mesh);

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#ifndef CGAL_EXT_COMPILED_CORE
#include <CGAL_ext/Square_parameterization/internal/surface/check_surface_impl.h>
#endif

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SURFACE_CHECK_SURFACE_H
