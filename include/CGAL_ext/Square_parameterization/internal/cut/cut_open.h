// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_CUT_OPEN_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_CUT_OPEN_H

#include <CGAL_ext/Square_parameterization/internal/common/Disjoint_sets.h>
#include <CGAL_ext/Square_parameterization/internal/cut/Cut.h>

#include <utility>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// triangles cut apart along seams. The first vertices are those of the uncut surface, in their order; copies follow.
struct Opened_triangles
{
  std::vector<std::array<int, 3>> triangles;
  std::vector<int> originals; ///< per vertex, the vertex of the uncut surface
};

/// cuts the surface open along \p is_seam (#E): every vertex is copied as often as its seams part its triangles. The
/// part with the first triangle keeps the vertex. Complexity: all but linear.
template <class Is_seam>
Opened_triangles cut_open(const Triangle_surface& surface, Is_seam is_seam)
{
  const int corners = 3 * surface.number_of_faces();
  Disjoint_sets parts(corners); // corners of one vertex that stay together
  for(int h = 0; h < corners; ++h) {
    const int opposite = surface.opposites[h];
    if(opposite < h || is_seam(surface.edge_of_halfedge[h]))
      continue;
    parts.union_set(h, Triangle_surface::next(opposite));
    parts.union_set(Triangle_surface::next(h), opposite);
  }
  Opened_triangles opened{surface.triangles, {}};
  for(int v = 0; v < surface.number_of_vertices(); ++v)
    opened.originals.push_back(v);
  std::vector<bool> is_taken(surface.points.size(), false);
  std::vector<int> vertex_of_part(corners, -1);
  for(int corner = 0; corner < corners; ++corner) {
    int& vertex = vertex_of_part[parts.find_set(corner)];
    const int original = surface.origin(corner);
    if(vertex < 0 && !is_taken[original]) {
      vertex = original;
      is_taken[original] = true;
    } else if(vertex < 0) {
      vertex = static_cast<int>(opened.originals.size());
      opened.originals.push_back(original);
    }
    opened.triangles[corner / 3][corner % 3] = vertex;
  }
  return opened;
}

/// cuts the surface open along a cut
inline Opened_triangles cut_open(const Triangle_surface& surface, const Cut& cut)
{
  return cut_open(surface, [&cut](int e) { return cut.contains(e); });
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_CUT_OPEN_H
