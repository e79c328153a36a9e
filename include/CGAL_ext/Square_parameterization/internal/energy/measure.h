// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ENERGY_MEASURE_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ENERGY_MEASURE_H

#include <CGAL_ext/Square_parameterization/Stretch_measures.h>
#include <CGAL_ext/Square_parameterization/internal/common/ranges.h>
#include <CGAL_ext/Square_parameterization/internal/energy/stretch_kernel.h>
#include <CGAL_ext/Square_parameterization/internal/patch/exact_orientation.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// a power of two that brings numbers of this size near 1, so that neither their products nor their quotients leave the range
/// of `double`: it rounds nothing
inline double scale_to_one(double largest)
{
  constexpr int MOST = 1000; // of the exponent: less than the largest
  return largest > 0 && std::isfinite(largest) ? std::ldexp(1., (std::clamp)(-std::ilogb(largest), -MOST, MOST)) : 1;
}

/// what `measure()` adds up over triangles
struct Stretch_sums
{
  double energy = 0, inverse_energy = 0, surface_area = 0, uv_area = 0, linf = 0;

  void add(const Triangle_stretch& stretch, double area)
  {
    surface_area += area;
    uv_area += stretch.uv_area;
    linf = (std::max)(linf, stretch.linf);
    if(area > 0) {
      energy += stretch.l2_squared * area;
      // s1^2 + s2^2 of the surface-to-plane map: that of its inverse, divided by the squared determinant
      const double determinant = area / stretch.uv_area;
      inverse_energy += stretch.l2_squared / (determinant * determinant) * area;
    }
  }

  Stretch_sums& operator+=(const Stretch_sums& other)
  {
    energy += other.energy;
    inverse_energy += other.inverse_energy;
    surface_area += other.surface_area;
    uv_area += other.uv_area;
    linf = (std::max)(linf, other.linf);
    return *this;
  }
};

/// measures a map given as flat arrays, in any unit of length; those whose squares are no numbers are scaled before, see
/// `scale_to_one()`. With the threads of the current team.
/// \param scale factors of u and v, by which the map is scaled; its triangles are flipped or not as they are without it
inline Stretch_measures measure(const std::vector<Flat_triangle>& shapes,
                                const std::vector<std::array<int, 3>>& triangles, const Uv_coordinates& uv,
                                const Eigen::RowVector2d& scale = Eigen::RowVector2d(1, 1))
{
  Stretch_measures result;
  result.flipped_faces = number_of_flipped_faces(triangles, uv);
  result.face_l2.resize(triangles.size());
  const auto sums_of_range = [&](std::size_t begin, std::size_t end) {
    Stretch_sums sums;
    for(std::size_t f = begin; f < end; ++f) {
      const Triangle_stretch stretch = triangle_stretch(shapes[f], uv, triangles[f], scale);
      result.face_l2[f] = std::sqrt(stretch.l2_squared);
      sums.add(stretch, shapes[f].area());
    }
    return sums;
  };
  const auto [energy, inverse_energy, surface_area, uv_area, linf] =
      sum_of_ranges(triangles.size(), Stretch_sums(), sums_of_range);
  result.uv_area = uv_area;
  const double to_unit = std::sqrt(uv_area / surface_area);
  result.l2 = std::sqrt(energy / surface_area) * to_unit;
  result.linf = linf * to_unit;
  for(double& l2 : result.face_l2)
    l2 *= to_unit;
  result.symmetric_dirichlet = (energy * to_unit * to_unit + inverse_energy / (to_unit * to_unit)) / (2 * surface_area);
  if(result.flipped_faces > 0 || !(surface_area > 0) || !(energy < std::numeric_limits<double>::infinity()))
    result.l2 = result.linf = result.symmetric_dirichlet = std::numeric_limits<double>::infinity();
  return result;
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ENERGY_MEASURE_H
