// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SURFACE_MAKE_DISK_PATCH_IMPL_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SURFACE_MAKE_DISK_PATCH_IMPL_H

#include <CGAL_ext/Square_parameterization/internal/common/compiled_core.h>
#include <CGAL_ext/Square_parameterization/internal/surface/check_surface.h>
#include <CGAL_ext/Square_parameterization/internal/surface/make_disk_patch.h>

#include <cstddef>
#include <string>
#include <utility>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

CGAL_EXT_INLINE_FUNCTION std::vector<int> border_from(int start, std::size_t number_of_vertices,
                                                      const std::vector<std::array<int, 3>>& triangles,
                                                      const Edge_numbering& numbering)
{
  std::vector<int> next(number_of_vertices, -1);
  std::size_t border_edges = 0;
  for(std::size_t f = 0; f < triangles.size(); ++f)
    for(int k = 0; k < 3; ++k)
      if(numbering.number_of_triangles[numbering.triangle_edges[f][k]] == 1) {
        next[triangles[f][(k + 1) % 3]] = triangles[f][(k + 2) % 3];
        ++border_edges;
      }
  std::vector<int> border;
  for(int v = start; v >= 0 && (border.empty() || v != start) && border.size() <= border_edges; v = next[v])
    border.push_back(v);
  if(border.size() != border_edges)
    throw Unmappable(CGAL::Surface_mesh_parameterization::ERROR_NO_TOPOLOGICAL_DISC,
                     "the surface has more than one border, or visits a vertex twice on its border");
  return border;
}

CGAL_EXT_INLINE_FUNCTION Patch make_disk_patch(Surface_arrays mesh, int start)
{
  check_faces(mesh);
  Edge_numbering numbering = number_edges(mesh.points.size(), mesh.triangles);
  check_edges(mesh, numbering);
  std::vector<int> border = border_from(start, mesh.points.size(), mesh.triangles, numbering);
  const long euler =
      static_cast<long>(mesh.points.size() + mesh.triangles.size()) - static_cast<long>(numbering.edges.size());
  if(euler != 1)
    throw Unmappable(CGAL::Surface_mesh_parameterization::ERROR_NO_TOPOLOGICAL_DISC,
                     "the surface has Euler characteristic " + std::to_string(euler) + ", not 1");
  return make_patch(std::move(mesh.points), std::move(mesh.triangles), std::move(border), std::move(numbering));
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SURFACE_MAKE_DISK_PATCH_IMPL_H
