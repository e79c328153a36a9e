// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_TEST_ENERGY_BY_DEFINITION_H
#define CGAL_EXT_TEST_ENERGY_BY_DEFINITION_H

#include <CGAL_ext/Square_parameterization/internal/patch/Patch.h>

#include <Eigen/Geometry>
#include <Eigen/SVD>

/// the energy by its definition: singular values of the 3D-to-uv map of each triangle, found by Eigen's SVD
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
    // the Jacobian of the inverse map, plane to surface, has the inverse singular values
    Eigen::Matrix3d inverse = Eigen::Matrix3d::Zero(); // square, with a third singular value of zero: no QR to compile
    inverse.leftCols<2>() = surface * plane.inverse();
    const Eigen::JacobiSVD<Eigen::Matrix3d, Eigen::NoQRPreconditioner> svd(inverse);
    const Eigen::Vector3d all = svd.singularValues();
    const Eigen::Vector2d s(all[0], all[1]);
    energy += area * (s.squaredNorm() + balance * s.cwiseInverse().squaredNorm());
  }
  return energy;
}

#endif // CGAL_EXT_TEST_ENERGY_BY_DEFINITION_H
