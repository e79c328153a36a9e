// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ENERGY_STRETCH_KERNEL_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ENERGY_STRETCH_KERNEL_H

#include <CGAL_ext/Square_parameterization/internal/common/ranges.h>
#include <CGAL_ext/Square_parameterization/internal/patch/Patch.h>
#include <CGAL_ext/Square_parameterization/internal/patch/exact_orientation.h>

#include <cmath>
#include <limits>
#include <vector>

// The texture stretch of Sander, Snyder, Gortler and Hoppe, "Texture mapping progressive meshes", SIGGRAPH 2001.

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// what the affine map from a uv triangle to its surface triangle does to lengths. All values are before normalisation
/// by the areas of the mesh.
struct Triangle_stretch
{
  double l2_squared; ///< (|Ss|^2 + |St|^2) / 2; infinite unless the uv triangle is counter-clockwise
  double linf;       ///< largest singular value of [Ss St]; infinite unless the uv triangle is counter-clockwise
  double uv_area;    ///< signed
};

/// twice the signed area of the uv triangle of the vertices \p t: positive when they are counter-clockwise
inline double twice_uv_area(const Uv_coordinates& uv, const std::array<int, 3>& t)
{
  const Eigen::RowVector2d a = uv.row(t[1]) - uv.row(t[0]), b = uv.row(t[2]) - uv.row(t[0]);
  return a.x() * b.y() - b.x() * a.y();
}

/// the affine map from a uv triangle to its surface triangle: [Ss St], in another frame
struct Inverse_differential
{
  Eigen::RowVector2d across, along; ///< not set unless the uv triangle is counter-clockwise
  double determinant;               ///< of the uv triangle: twice its signed area

  bool is_counter_clockwise() const { return determinant > 0; }
  double l2_squared() const { return (across.squaredNorm() + along.squaredNorm()) / 2; }
};

/// computes the differential of one triangle, of which twice the signed uv area is known.
///
/// With the surface edges a = (x1, 0), b = (x2, y2) and the uv edges da, db from the first corner,
/// D Ss = a tb - b ta and D St = b sa - a sb, so D^2 (|Ss|^2 + |St|^2) = |x1 db - x2 da|^2 + y2^2 |da|^2:
/// a sum of squares, exact for slivers where the expansion in scalar products cancels.
inline Inverse_differential inverse_differential(const Flat_triangle& shape, const Uv_coordinates& uv,
                                                 const std::array<int, 3>& t, double twice_area)
{
  const Eigen::RowVector2d da = uv.row(t[1]) - uv.row(t[0]), db = uv.row(t[2]) - uv.row(t[0]);
  Inverse_differential result;
  result.determinant = twice_area;
  if(result.is_counter_clockwise()) {
    result.across = (shape.x1 * db - shape.x2 * da) / result.determinant;
    result.along = shape.y2 * da / result.determinant;
  }
  return result;
}

/// L2(T)^2; infinite unless the uv triangle is counter-clockwise
inline double l2_squared(const Flat_triangle& shape, const Uv_coordinates& uv, const std::array<int, 3>& t)
{
  const Inverse_differential differential = inverse_differential(shape, uv, t, twice_uv_area(uv, t));
  return differential.is_counter_clockwise() ? differential.l2_squared() : std::numeric_limits<double>::infinity();
}

/// computes the stretch of one triangle, however thin it is in the plane
/// \param scale factors of u and v, of a map that is to be scaled: rounding its coordinates would flip thin triangles
inline Triangle_stretch triangle_stretch(const Flat_triangle& shape, const Uv_coordinates& uv,
                                         const std::array<int, 3>& t,
                                         const Eigen::RowVector2d& scale = Eigen::RowVector2d(1, 1))
{
  const double twice_area = accurate_twice_area(uv.row(t[0]), uv.row(t[1]), uv.row(t[2])) * scale.prod();
  Inverse_differential differential = inverse_differential(shape, uv, t, twice_area);
  const double uv_area = differential.determinant / 2;
  if(!differential.is_counter_clockwise())
    return {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(), uv_area};
  for(Eigen::RowVector2d* part : {&differential.across, &differential.along})
    *part = part->cwiseProduct(scale);
  const Eigen::RowVector2d &across = differential.across, &along = differential.along;
  // the largest singular value, as half the sum of two lengths: a root of a difference of squares would lose half the
  // digits near an isometry
  const double largest = (std::hypot(across.x() + along.y(), across.y() - along.x()) +
                          std::hypot(across.x() - along.y(), across.y() + along.x())) /
                         2;
  return {differential.l2_squared(), largest, uv_area};
}

/// sum over the triangles of L2(T)^2 times the surface area of T; infinite when a triangle is not counter-clockwise.
/// For a map onto the unit square it is the square of the L2 stretch, since the patch has area 1.
inline double stretch_energy(const Patch& patch, const Uv_coordinates& uv)
{
  return sum_of_ranges(patch.triangles.size(), 0., [&](std::size_t begin, std::size_t end) {
    double energy = 0;
    for(std::size_t f = begin; f < end; ++f)
      energy += l2_squared(patch.shapes[f], uv, patch.triangles[f]) * patch.shapes[f].area();
    return energy;
  });
}

/// as `stretch_energy()`, and sets \p sigma (#V) to the stretch of every vertex, the mean over its incident triangles:
/// sigma(v)^2 = sum L2(T)^2 A(T) / sum A(T)
inline double stretch_energy(const Patch& patch, const Uv_coordinates& uv, std::vector<double>& sigma)
{
  sigma.assign(patch.points.size(), 0.);
  double energy = 0;
  for(int f = 0; f < patch.number_of_faces(); ++f) {
    const double e = l2_squared(patch.shapes[f], uv, patch.triangles[f]) * patch.shapes[f].area();
    energy += e;
    for(int v : patch.triangles[f])
      sigma[v] += e;
  }
  for(std::size_t v = 0; v < sigma.size(); ++v)
    sigma[v] = std::sqrt(sigma[v] / patch.vertex_areas[v]);
  return energy;
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ENERGY_STRETCH_KERNEL_H
