// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_SURFACE_DISTANCES_H
#define SQUARE_MAP_SURFACE_DISTANCES_H

#include <Eigen/Core>

#include <array>
#include <vector>

namespace square_map {

/// how far one surface lies from another
struct Surface_distance
{
  double rms = 0;       ///< root of the area mean of the squared distance
  double hausdorff = 0; ///< the largest distance
};

/// the distances of one surface from another in space: of its vertices and of the centroids of its triangles, by CGAL's
/// tree of boxes. Complexity: about linear, times the logarithm of the other's triangles.
Surface_distance distance_to(const std::vector<Eigen::Vector3d>& other_points,
                             const std::vector<std::array<int, 3>>& other_triangles,
                             const std::vector<Eigen::Vector3d>& points,
                             const std::vector<std::array<int, 3>>& triangles);

} // namespace square_map

#endif // SQUARE_MAP_SURFACE_DISTANCES_H
