// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The texture stretch of Sander et al. 2001 straight from its formulas, in extended precision: independent of the
// library, for the tests to compare with.

#ifndef CGAL_EXT_REFERENCE_STRETCH_H
#define CGAL_EXT_REFERENCE_STRETCH_H

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <vector>

/// the stretch of one triangle, not normalised
struct Reference_triangle
{
  long double l2_squared, linf, uv_area, surface_area;
};

inline Reference_triangle reference_triangle(const std::array<Eigen::Vector3d, 3>& q,
                                             const std::array<Eigen::Vector2d, 3>& p)
{
  typedef Eigen::Matrix<long double, 3, 1> Vector;
  // the stretch does not depend on the origin: in the first point nothing is lost by cancellation
  const Vector origin = q[0].cast<long double>(), q1 = Vector::Zero(), q2 = q[1].cast<long double>() - origin,
               q3 = q[2].cast<long double>() - origin;
  const long double s1 = p[0].x(), t1 = p[0].y(), s2 = p[1].x(), t2 = p[1].y(), s3 = p[2].x(), t3 = p[2].y();
  const long double area = ((s2 - s1) * (t3 - t1) - (s3 - s1) * (t2 - t1)) / 2;
  const Vector Ss = (q1 * (t2 - t3) + q2 * (t3 - t1) + q3 * (t1 - t2)) / (2 * area);
  const Vector St = (q1 * (s3 - s2) + q2 * (s1 - s3) + q3 * (s2 - s1)) / (2 * area);
  const long double a = Ss.dot(Ss), b = Ss.dot(St), c = St.dot(St);
  const long double largest = std::sqrt((a + c + std::sqrt((a - c) * (a - c) + 4 * b * b)) / 2);
  return {(a + c) / 2, largest, area, (q2 - q1).cross(q3 - q1).norm() / 2};
}

/// the stretch of a whole map
struct Reference_stretch
{
  double l2, linf;
  std::vector<double> vertex_l2; ///< not normalised by the areas of the mesh
};

inline Reference_stretch reference_stretch(const std::vector<Eigen::Vector3d>& points,
                                           const std::vector<std::array<int, 3>>& triangles,
                                           const std::vector<Eigen::Vector2d>& uv)
{
  long double energy = 0, linf = 0, uv_area = 0, surface_area = 0;
  std::vector<long double> sum(points.size(), 0.L), area(points.size(), 0.L);
  for(const auto& [a, b, c] : triangles) {
    const Reference_triangle t = reference_triangle({points[a], points[b], points[c]}, {uv[a], uv[b], uv[c]});
    energy += t.l2_squared * t.surface_area;
    linf = std::max(linf, t.linf);
    uv_area += t.uv_area;
    surface_area += t.surface_area;
    for(int v : {a, b, c}) {
      sum[v] += t.l2_squared * t.surface_area;
      area[v] += t.surface_area;
    }
  }
  const long double scale = std::sqrt(uv_area / surface_area);
  Reference_stretch result{double(std::sqrt(energy / surface_area) * scale), double(linf * scale), {}};
  for(std::size_t v = 0; v < points.size(); ++v)
    result.vertex_l2.push_back(double(std::sqrt(sum[v] / area[v])));
  return result;
}

/// the rows of a #V by 2 matrix as points
template <class Uv>
std::vector<Eigen::Vector2d> as_points(const Uv& uv)
{
  std::vector<Eigen::Vector2d> points;
  for(Eigen::Index v = 0; v < uv.rows(); ++v)
    points.emplace_back(uv(v, 0), uv(v, 1));
  return points;
}

#endif // CGAL_EXT_REFERENCE_STRETCH_H
