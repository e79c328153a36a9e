// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ITERATION_EDGE_WEIGHTS_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ITERATION_EDGE_WEIGHTS_H

#include <CGAL_ext/Square_parameterization/internal/patch/Patch.h>

namespace CGAL_ext {
namespace internal {

using CGAL_ext::Edge_weights;

/// the weights that a policy, which may be a user's, returned for a disk. Throws `Unmappable` when they are not two for
/// each edge, or said to be symmetric and are not.
Edge_weights checked(Edge_weights weights, const Patch& patch);

/// half the cotangents of the angles opposite to an edge, summed: the harmonic weights of Eck et al. 1995
Edge_weights cotangent_weights(const Patch& patch);

/// (tan(alpha / 2) + tan(beta / 2)) / r, the mean value coordinates of Floater 2003
Edge_weights mean_value_weights(const Patch& patch);

/// shape-preserving weights of Floater 1997. The fan around a vertex is flattened with its angles scaled to sum to
/// 2 pi; for each neighbor the centre is written in barycentric coordinates of that neighbor and of the ring edge
/// opposite to it, and these are averaged, weighted by \p distance_power powers of the inverse distance from the centre
/// to the ring edge (0: Floater's plain mean; 2: the variant behind the published tables).
///
/// On regular meshes the ray opposite to a neighbor often meets a ring vertex, where two ring edges are as opposite as
/// each other but at different distances: both count half, so that the weights do not depend on rounding.
Edge_weights shape_preserving_weights(const Patch& patch, int distance_power);

} // namespace internal
} // namespace CGAL_ext

#ifndef CGAL_EXT_COMPILED_CORE
#include <CGAL_ext/Square_parameterization/internal/iteration/edge_weights_impl.h>
#endif

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ITERATION_EDGE_WEIGHTS_H
