// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PATCH_VERTICES_ALONG_CURVE_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PATCH_VERTICES_ALONG_CURVE_H

#include <CGAL_ext/Square_parameterization/internal/patch/Patch.h>

#include <CGAL/hilbert_sort.h>

#include <numeric>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// a model of CGAL's `SpatialSortingTraits_3` whose points are numbers of points
struct Numbered_points_traits
{
  typedef int Point_3;

  struct Less
  {
    const std::vector<Eigen::Vector3d>* points;
    int axis;

    bool operator()(int p, int q) const
    {
      const double a = (*points)[p][axis], b = (*points)[q][axis];
      return a < b || (a == b && p < q); // copies on the two sides of a seam
    }
  };
  typedef Less Less_x_3;
  typedef Less Less_y_3;
  typedef Less Less_z_3;

  Less less_x_3_object() const { return {points, 0}; }
  Less less_y_3_object() const { return {points, 1}; }
  Less less_z_3_object() const { return {points, 2}; }

  const std::vector<Eigen::Vector3d>* points;
};

/// the vertices along Hilbert's curve through space: what is near in the list is near on the surface, and consecutive
/// vertices are pieces with short borders
inline std::vector<int> vertices_along_curve(const std::vector<Eigen::Vector3d>& points)
{
  std::vector<int> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  CGAL::hilbert_sort(order.begin(), order.end(), Numbered_points_traits{&points}, CGAL::Hilbert_sort_median_policy());
  return order;
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PATCH_VERTICES_ALONG_CURVE_H
