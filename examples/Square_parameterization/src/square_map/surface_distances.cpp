// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../../include/square_map/surface_distances.h"

#include <CGAL/AABB_tree.h>
#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>
#if __has_include(<CGAL/AABB_traits_3.h>)
#include <CGAL/AABB_traits_3.h>
#include <CGAL/AABB_triangle_primitive_3.h>
#else
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_triangle_primitive.h>
#endif
#include <CGAL/Simple_cartesian.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace square_map {

namespace {

typedef CGAL::Simple_cartesian<double> Kernel;
typedef std::vector<Kernel::Triangle_3>::const_iterator Triangle_iterator;
#if __has_include(<CGAL/AABB_traits_3.h>)
typedef CGAL::AABB_traits_3<Kernel, CGAL::AABB_triangle_primitive_3<Kernel, Triangle_iterator>> Tree_traits;
#else
typedef CGAL::AABB_traits<Kernel, CGAL::AABB_triangle_primitive<Kernel, Triangle_iterator>> Tree_traits;
#endif
typedef CGAL::AABB_tree<Tree_traits> Tree;

Kernel::Point_3 cgal_point(const Eigen::Vector3d& p)
{
  return {p.x(), p.y(), p.z()};
}

} // namespace

Surface_distance distance_to(const std::vector<Eigen::Vector3d>& other_points,
                             const std::vector<std::array<int, 3>>& other_triangles,
                             const std::vector<Eigen::Vector3d>& points,
                             const std::vector<std::array<int, 3>>& triangles)
{
  std::vector<Kernel::Triangle_3> others;
  for(const auto& [a, b, c] : other_triangles)
    others.emplace_back(cgal_point(other_points[a]), cgal_point(other_points[b]), cgal_point(other_points[c]));
  Tree tree(others.begin(), others.end());
  tree.accelerate_distance_queries();

  double sum = 0, area = 0, largest = 0;
  Kernel::Point_3 hint = others.front().vertex(0); // near the next point, for the points of a mesh are
  const auto squared_distance = [&](const Eigen::Vector3d& p) {
    hint = tree.closest_point(cgal_point(p), hint);
    const double squared = CGAL::squared_distance(cgal_point(p), hint);
    largest = (std::max)(largest, squared);
    return squared;
  };
  std::vector<double> at_vertices;
  for(const Eigen::Vector3d& p : points)
    at_vertices.push_back(squared_distance(p));
  for(const auto& [a, b, c] : triangles) {
    const double face_area = (points[b] - points[a]).cross(points[c] - points[a]).norm() / 2;
    const double centroid = squared_distance((points[a] + points[b] + points[c]) / 3);
    // exact for what is quadratic on the triangle and without its linear part: three quarters are the centroid's
    sum += face_area * (0.75 * centroid + (at_vertices[a] + at_vertices[b] + at_vertices[c]) / 12);
    area += face_area;
  }
  return {area > 0 ? std::sqrt(sum / area) : 0, std::sqrt(largest)};
}

} // namespace square_map
