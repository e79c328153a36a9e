// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_SIMPLIFIED_COPY_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_SIMPLIFIED_COPY_H

#include <CGAL_ext/Square_parameterization/internal/coarsening/coarsen_surface.h>
#include <CGAL_ext/Square_parameterization/internal/common/Deadline.h>
#include <CGAL_ext/Square_parameterization/internal/cut/Cut_numbers.h>
#include <CGAL_ext/Square_parameterization/internal/cut/number_of_loops.h>
#include <CGAL_ext/Square_parameterization/internal/surface/Triangle_surface.h>
#include <CGAL_ext/Square_parameterization/internal/surface/decimate_surface.h>

#include <optional>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// a copy of about \p faces triangles, and more when there are many handles and holes; nothing when the surface has
/// hardly more, or cannot be simplified in time
inline std::optional<Triangle_surface> simplified_copy(const Triangle_surface& surface, int faces,
                                                       const Cut_numbers& numbers = {}, const Deadline& deadline = {})
{
  faces += numbers.faces_per_loop * number_of_loops(surface);
  const auto is_hardly_less = [&](int count) { return surface.number_of_faces() <= numbers.least_reduction * count; };
  if(is_hardly_less(faces))
    return std::nullopt;
  std::optional<Triangle_surface> copy =
      surface.number_of_faces() > numbers.very_fine * faces
          ? decimate_surface(coarsen_surface(surface, static_cast<int>(numbers.still_fine * faces)), faces, deadline)
          : decimate_surface(surface, faces, deadline);
  if(copy && is_hardly_less(copy->number_of_faces())) // the topology, or the shape, allows no less
    copy.reset();
  return copy;
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_SIMPLIFIED_COPY_H
