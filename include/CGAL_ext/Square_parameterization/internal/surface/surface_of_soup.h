// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SURFACE_SURFACE_OF_SOUP_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SURFACE_SURFACE_OF_SOUP_H

#include <CGAL_ext/Square_parameterization/internal/patch/Patch.h>
#include <CGAL_ext/Square_parameterization/internal/soup/Surface_soup.h>
#include <CGAL_ext/Square_parameterization/internal/surface/Triangle_surface.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace CGAL_ext {
namespace internal {

/// the surface of a conditioned soup, scaled so that no square overflows.
/// Throws `Unmappable` when a coordinate is not finite, and when no face has an area.
inline Triangle_surface surface_of_soup(const Surface_soup& soup)
{
  std::vector<Eigen::Vector3d> points = soup.points;
  const double rounding = normalise_coordinates(points);
  std::vector<std::array<int, 3>> triangles;
  for(const auto& face : soup.faces)
    triangles.push_back({static_cast<int>(face[0]), static_cast<int>(face[1]), static_cast<int>(face[2])});
  const bool has_extent = std::any_of(triangles.begin(), triangles.end(), [&](const auto& t) {
    return flatten(points[t[0]], points[t[1]], points[t[2]], rounding).y2 > 0;
  });
  if(!has_extent)
    refuse_without_extent(triangles.size());
  return make_triangle_surface(std::move(points), std::move(triangles));
}

} // namespace internal
} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SURFACE_SURFACE_OF_SOUP_H
