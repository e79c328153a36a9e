// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_SURFACE_DISTANCES_H
#define SQUARE_MAP_SURFACE_DISTANCES_H

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

namespace square_map {

/// how far one surface lies from another
struct Surface_distance
{
  double rms = 0;       ///< root of the area mean of the squared distance
  double hausdorff = 0; ///< the largest distance of a point that was asked
  std::size_t triangles_asked = 0;
};

/// a surface as flat arrays
struct Triangles
{
  const std::vector<Eigen::Vector3d>& points;
  const std::vector<std::array<int, 3>>& triangles;
};

/// how far a surface lies from another: the corners and the centroids of its triangles, by CGAL's tree of boxes. Of 100000
/// triangles and more every third is asked, of 200000 every fifth, and so on.
/// \param other the surface to which distances are taken; at least one triangle
/// \param number_of_threads 0 for all cores; the result is the same for any number
///
/// Complexity: about linear in the triangles, times the logarithm of the other's.
Surface_distance distance_to(const Triangles& other, const Triangles& surface, unsigned int number_of_threads);

} // namespace square_map

#endif // SQUARE_MAP_SURFACE_DISTANCES_H
