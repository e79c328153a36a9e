// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_TEST_MAPPED_PATCHES_H
#define CGAL_EXT_TEST_MAPPED_PATCHES_H

#include "make_patch_of.h"
#include "test_meshes.h"

#include <CGAL_ext/Square_parameterization/Stretch_minimization.h>
#include <CGAL_ext/Square_parameterization/internal/border/border_curves.h>
#include <CGAL_ext/Square_parameterization/internal/iteration/Stretch_iteration.h>

#include <Eigen/Geometry>

/// patches of several kinds
inline std::vector<CGAL_ext::internal::Patch> patches()
{
  return {make_patch_of(saddle(6)), make_patch_of(cone()), make_patch_of(noisy_height_field(6)),
          make_patch_of(long_strip(12))};
}

/// the border of a candidate
inline CGAL_ext::internal::Uv_coordinates border_of(const CGAL_ext::internal::Patch& patch, int candidate)
{
  using namespace CGAL_ext;
  using namespace CGAL_ext::internal;
  const Border_walk walk(patch.border_lengths, Walk::COUNTER_CLOCKWISE);
  return square_border(walk, corners_of_candidate(walk, candidate, Corner_rule::NEAREST)).uv;
}

/// a map without flips that is no minimum of anything: the one of uniform weights
inline CGAL_ext::internal::Uv_coordinates some_map(const CGAL_ext::internal::Patch& patch, int candidate = 1)
{
  using namespace CGAL_ext;
  using namespace CGAL_ext::internal;
  Stretch_minimization uniform;
  uniform.weights = Uniform_weights();
  uniform.maximum_iterations = 0;
  Stretch_iteration::Workspace workspace;
  return Stretch_iteration(patch, uniform).minimize(border_of(patch, candidate), 1, workspace).uv;
}

/// the energy by its definition: singular values s and t of the uv-to-3D map of each triangle, of which s^2 + t^2
/// is the sum of the squares of its entries, and s t what it makes of the unit of area
inline double energy_by_definition(const CGAL_ext::internal::Patch& patch, const CGAL_ext::internal::Uv_coordinates& uv,
                                   double balance)
{
  double energy = 0;
  for(const auto& [a, b, c] : patch.triangles) {
    Eigen::Matrix<double, 3, 2> surface;
    surface << patch.points[b] - patch.points[a], patch.points[c] - patch.points[a];
    Eigen::Matrix2d plane;
    plane << (uv.row(b) - uv.row(a)).transpose(), (uv.row(c) - uv.row(a)).transpose();
    const double area = surface.col(0).cross(surface.col(1)).norm() / 2;
    const Eigen::Matrix<double, 3, 2> inverse = surface * plane.inverse();
    const double sum_of_squares = inverse.squaredNorm(), product = inverse.col(0).cross(inverse.col(1)).norm();
    energy += area * sum_of_squares * (1 + balance / (product * product)); // 1/s^2 + 1/t^2 = (s^2 + t^2) / (s t)^2
  }
  return energy;
}

#endif // CGAL_EXT_TEST_MAPPED_PATCHES_H
