// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SURFACE_DECIMATE_SURFACE_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SURFACE_DECIMATE_SURFACE_H

#include <CGAL_ext/Square_parameterization/internal/common/Deadline.h>
#include <CGAL_ext/Square_parameterization/internal/surface/Triangle_surface.h>

#include <optional>

namespace CGAL_ext {
namespace internal {

/// a simpler surface of the same topology with about \p faces triangles, or more where the topology needs them; nothing
/// when simplification spoils the surface, or the deadline has passed before it is done
std::optional<Triangle_surface> decimate_surface(const Triangle_surface& surface, int faces,
                                                 const Deadline& deadline = {});

} // namespace internal
} // namespace CGAL_ext

#ifndef CGAL_EXT_COMPILED_CORE
#include <CGAL_ext/Square_parameterization/internal/surface/decimate_surface_impl.h>
#endif

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SURFACE_DECIMATE_SURFACE_H
