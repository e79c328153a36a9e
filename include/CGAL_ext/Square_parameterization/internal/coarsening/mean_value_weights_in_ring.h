// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COARSENING_MEAN_VALUE_WEIGHTS_IN_RING_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COARSENING_MEAN_VALUE_WEIGHTS_IN_RING_H

#include <CGAL_ext/Square_parameterization/internal/coarsening/Coarse_patch.h>

#include <cstddef>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// the mean value coordinates (Floater 2003) of an interior vertex in its ring on the surface, one per vertex of the ring,
/// positive, of unit 1 / length: only their proportions matter. Not finite where the ring is degenerate.
/// \param points #V
inline std::vector<double> mean_value_weights_in_ring(const std::vector<Eigen::Vector3d>& points, int vertex,
                                                      const Vertex_ring& ring)
{
  std::vector<double> weights(ring.size(), 0.);
  for(std::size_t i = 0; i < ring.size(); ++i) {
    const std::size_t next = (i + 1) % ring.size();
    const Eigen::Vector3d a = points[ring[i]] - points[vertex], b = points[ring[next]] - points[vertex];
    const double half_tangent = a.cross(b).norm() / (a.norm() * b.norm() + a.dot(b));
    weights[i] += half_tangent / a.norm();
    weights[next] += half_tangent / b.norm();
  }
  return weights;
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COARSENING_MEAN_VALUE_WEIGHTS_IN_RING_H
