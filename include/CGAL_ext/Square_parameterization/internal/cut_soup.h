// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_SOUP_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_SOUP_H

#include <CGAL_ext/Square_parameterization/internal/cut_to_disk.h>
#include <CGAL_ext/Square_parameterization/internal/surface_of_soup.h>

#include <vector>

namespace CGAL_ext {
namespace internal {

/// cuts a conditioned soup to a disk; see `cut_to_disk()`. Its vertices keep their order, copies follow.
/// Returns, per vertex, the vertex of the uncut soup.
inline std::vector<int> cut_soup(Surface_soup& soup, const std::vector<std::array<int, 2>>& seams,
                                 const Cut_options& options, Cut_report& report)
{
  const Triangle_surface surface = surface_of_soup(soup);
  Opened_triangles opened = cut_open(surface, cut_to_disk(surface, seams, options, report));
  for(std::size_t v = surface.points.size(); v < opened.originals.size(); ++v) {
    const Eigen::Vector3d original = soup.points[opened.originals[v]];
    soup.points.push_back(original);
  }
  for(std::size_t f = 0; f < soup.faces.size(); ++f)
    soup.faces[f].assign(opened.triangles[f].begin(), opened.triangles[f].end());
  return opened.originals;
}

} // namespace internal
} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_SOUP_H
