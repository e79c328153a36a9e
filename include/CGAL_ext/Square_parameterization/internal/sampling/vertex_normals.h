// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SAMPLING_VERTEX_NORMALS_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SAMPLING_VERTEX_NORMALS_H

#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// a vector of length 1 in the direction of \p v; zero for one without a direction
inline Eigen::Vector3d unit_vector(const Eigen::Vector3d& v)
{
  const double largest = v.cwiseAbs().maxCoeff(); // no square overflows or vanishes
  return largest > 0 ? Eigen::Vector3d((v / largest).normalized()) : Eigen::Vector3d(0, 0, 0);
}

/// the unit normal of a triangle; zero for one without area
inline Eigen::Vector3d triangle_normal(const std::vector<Eigen::Vector3d>& points, const std::array<int, 3>& t)
{
  return unit_vector(unit_vector(points[t[1]] - points[t[0]]).cross(unit_vector(points[t[2]] - points[t[0]])));
}

/// unit normals of the vertices: means of those of their triangles, weighted by their angles, so that they do not depend
/// on how a face is split. CGAL's vertex normals see all triangles of a vertex from the front, for which they search
/// among triples; they take too long here.
/// \param points #V
/// \param triangles #F
/// \param originals #V, of each vertex the one whose normal it shares, such as that of which it is a copy; empty when all
///        have their own
/// \return #V, zero where the normals of the triangles cancel out
inline std::vector<Eigen::Vector3d> vertex_normals(const std::vector<Eigen::Vector3d>& points,
                                                   const std::vector<std::array<int, 3>>& triangles,
                                                   const std::vector<int>& originals = {})
{
  const auto original = [&originals](int v) { return originals.empty() ? v : originals[v]; };
  std::vector<Eigen::Vector3d> normals(points.size(), Eigen::Vector3d(0, 0, 0));
  for(const auto& t : triangles) {
    const Eigen::Vector3d normal = triangle_normal(points, t);
    for(int k = 0; k < 3; ++k) {
      const Eigen::Vector3d a = unit_vector(points[t[(k + 1) % 3]] - points[t[k]]);
      const Eigen::Vector3d b = unit_vector(points[t[(k + 2) % 3]] - points[t[k]]);
      normals[original(t[k])] += std::atan2(a.cross(b).norm(), a.dot(b)) * normal;
    }
  }
  for(Eigen::Vector3d& normal : normals)
    normal = unit_vector(normal);
  if(!originals.empty())
    for(std::size_t v = 0; v < normals.size(); ++v)
      normals[v] = Eigen::Vector3d(normals[originals[v]]);
  return normals;
}

/// the value at a sample of what is linear on each triangle
/// \param values #V
template <class Value>
Value interpolated(const std::vector<Value>& values, const std::array<int, 3>& t, const std::array<double, 3>& weights)
{
  return weights[0] * values[t[0]] + weights[1] * values[t[1]] + weights[2] * values[t[2]];
}

/// the unit normal at a sample: that of the triangle where the normals of its vertices cancel out
inline Eigen::Vector3d sample_normal(const std::vector<Eigen::Vector3d>& normals,
                                     const std::vector<Eigen::Vector3d>& points, const std::array<int, 3>& t,
                                     const std::array<double, 3>& weights)
{
  const Eigen::Vector3d normal = unit_vector(interpolated(normals, t, weights));
  return normal.isZero(0) ? triangle_normal(points, t) : normal;
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SAMPLING_VERTEX_NORMALS_H
