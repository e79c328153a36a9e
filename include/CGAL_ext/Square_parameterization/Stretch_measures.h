// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_STRETCH_MEASURES_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_STRETCH_MEASURES_H

#include <cstddef>
#include <vector>

namespace CGAL_ext {

/// \ingroup PkgSquareParameterizationMetric
///
/// the stretch of a map from the plane to a triangle mesh (Sander et al.\ \cgalCite{cgal:ssgh-tmpm-01}), normalised so
/// that an isometry up to scale has stretch 1. All stretches are dimensionless and infinite when a uv triangle is not
/// counter-clockwise, or the surface has no area. (CGAL's `compute_L2_stretch()` is another quantity, a norm of area
/// ratios.)
struct Stretch_measures
{
  double l2 = 0;                  ///< root mean square of the stretch over all directions and over the surface
  double linf = 0;                ///< largest stretch of any direction anywhere
  double symmetric_dirichlet = 0; ///< area mean of (s1^2 + s2^2 + 1/s1^2 + 1/s2^2) / 4, s the singular values; least 1
  std::size_t flipped_faces = 0;  ///< number of uv triangles that are clockwise or flat, by exact arithmetic
  double uv_area = 0;             ///< sum of the signed areas of the uv triangles
  std::vector<double> face_l2;    ///< one per face, in the order of `faces(mesh)`
};

} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_STRETCH_MEASURES_H
