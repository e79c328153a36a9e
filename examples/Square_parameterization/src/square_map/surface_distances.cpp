// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../../include/square_map/surface_distances.h"

#include <CGAL/AABB_tree.h>
#include <CGAL_ext/Square_parameterization/internal/common/Thread_team.h>

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
#include <cstddef>
#include <numeric>

namespace square_map {

namespace {

constexpr std::size_t MANY_TRIANGLES = 50000; // from twice as many on, some are asked

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

/// the squared distance of each point from the surface of a tree. The points of a mesh come near one another: the
/// nearest point of each is a hint for the next. Parts of fixed size make the result the same for any number of threads.
std::vector<double> squared_distances(const std::vector<Eigen::Vector3d>& points, const Tree& tree,
                                      CGAL_ext::internal::Thread_team& team)
{
  constexpr std::size_t PART = 4096;
  std::vector<double> distances(points.size());
  team((points.size() + PART - 1) / PART, [&](std::size_t part) {
    Kernel::Point_3 nearest = tree.any_reference_point_and_id().first;
    for(std::size_t k = part * PART; k < (std::min)((part + 1) * PART, points.size()); ++k) {
      nearest = tree.closest_point(cgal_point(points[k]), nearest);
      distances[k] = CGAL::squared_distance(cgal_point(points[k]), nearest);
    }
  });
  return distances;
}

} // namespace

Surface_distance distance_to(const Triangles& other, const Triangles& surface, unsigned int number_of_threads)
{
  std::vector<Kernel::Triangle_3> others;
  for(const auto& [a, b, c] : other.triangles)
    others.emplace_back(cgal_point(other.points[a]), cgal_point(other.points[b]), cgal_point(other.points[c]));
  Tree tree(others.begin(), others.end());
  tree.build();
  CGAL_ext::internal::Thread_team team(number_of_threads);
  const std::size_t stride = surface.triangles.size() / MANY_TRIANGLES | 1; // odd: a grid has two triangles a square
  std::vector<Eigen::Vector3d> points;                                      // three corners and the centroid of each
  std::vector<double> areas;
  for(std::size_t f = 0; f < surface.triangles.size(); f += stride) {
    const auto& [a, b, c] = surface.triangles[f];
    const Eigen::Vector3d &p = surface.points[a], &q = surface.points[b], &r = surface.points[c];
    points.insert(points.end(), {p, q, r, (p + q + r) / 3});
    areas.push_back((q - p).cross(r - p).norm() / 2);
  }
  const std::vector<double> squared = squared_distances(points, tree, team);

  double sum = 0;
  for(std::size_t k = 0; k < areas.size(); ++k) { // exact for polynomials of degree two
    const double *const corners = &squared[4 * k], centroid = corners[3];
    sum += areas[k] * ((corners[0] + corners[1] + corners[2]) / 12 + 0.75 * centroid);
  }
  const double area = std::accumulate(areas.begin(), areas.end(), 0.);
  const double largest = *std::max_element(squared.begin(), squared.end());
  return {area > 0 ? std::sqrt(sum / area) : 0, std::sqrt(largest), areas.size()};
}

} // namespace square_map
