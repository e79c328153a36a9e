// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COARSENING_COARSEN_SURFACE_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COARSENING_COARSEN_SURFACE_H

#include <CGAL_ext/Square_parameterization/internal/coarsening/Vertex_collapses.h>
#include <CGAL_ext/Square_parameterization/internal/common/Minimizer_numbers.h>
#include <CGAL_ext/Square_parameterization/internal/patch/vertices_along_curve.h>
#include <CGAL_ext/Square_parameterization/internal/surface/Triangle_surface.h>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// a surface of the same topology with about \p faces triangles, or more where short edges cannot be collapsed without
/// slivers, by `Vertex_collapses`: its vertices are some of the given ones, all of the border among them. Takes a
/// fraction of the time of simplification by shape.
inline Triangle_surface coarsen_surface(const Triangle_surface& fine, int faces)
{
  Vertex_collapses collapses(fine.points, fine.triangles, fine.border_loops, Minimizer_numbers::SHAPE_KEPT, true,
                             Most_waves()); // any, for nothing is put back
  Coarse_patch removals;
  const int target = fine.number_of_vertices() - (fine.number_of_faces() - faces) / 2; // two go with each vertex
  collapses(target, vertices_along_curve(fine.points), Minimizer_numbers::VERTICES_COARSENED_AT_A_TIME, removals);
  const Collapsible_surface& left = collapses.surface();
  return make_triangle_surface(left.points(), left.triangles(left.places()));
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COARSENING_COARSEN_SURFACE_H
