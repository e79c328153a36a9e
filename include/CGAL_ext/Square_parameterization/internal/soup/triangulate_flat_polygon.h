// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SOUP_TRIANGULATE_FLAT_POLYGON_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SOUP_TRIANGULATE_FLAT_POLYGON_H

#include <CGAL_ext/Square_parameterization/internal/soup/Planar_triangulation.h>
#include <CGAL_ext/Square_parameterization/internal/soup/Polygon_plane.h>
#include <CGAL_ext/Square_parameterization/internal/soup/Polygon_quadtree.h>

#include <CGAL/Polygon_2_algorithms.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// points inside and outside of a polygon, of the order of its corners, dense where they are
inline Planar_triangulation::Points points_beside(const std::vector<Eigen::Vector2d>& corners)
{
  constexpr std::size_t CORNERS_OF_A_LEAF = 3; // with 1 there are twice as many points, and maps are hardly better
  constexpr std::size_t MOST_PER_CORNER =
      8; // more only where corners lie in tiny clusters: these are not resolved then
  std::vector<Eigen::Vector2d> points;
  std::size_t corners_of_a_leaf = CORNERS_OF_A_LEAF;
  do {
    points = Polygon_quadtree(corners, corners_of_a_leaf).free_centers();
    corners_of_a_leaf *= 4;
  } while(points.size() > MOST_PER_CORNER * corners.size());
  Planar_triangulation::Points result;
  for(const Eigen::Vector2d& p : points)
    result.emplace_back(p.x(), p.y());
  return result;
}

/// a polygon that was split into triangles, which are oriented as it is
struct Polygon_triangulation
{
  std::vector<Eigen::Vector3d> added;                    ///< points inside
  std::vector<Planar_triangulation::Triangle> triangles; ///< numbers of corners and, after these, of what was added
};

/// indicates whether a polygon has many corners, which lie in a plane, and products of whose coordinates do not overflow. Facets
/// of ordinary models have few, and get no vertices; coordinates in files have six digits and more.
inline bool is_flat_and_large(const std::vector<Eigen::Vector3d>& corners, const Polygon_plane& plane)
{
  constexpr std::size_t MANY = 50;
  constexpr double FLATNESS = 1e-5, LARGEST_COORDINATE = 1e100;
  const auto is_moderate = [](const Eigen::Vector3d& p) { return p.cwiseAbs().maxCoeff() <= LARGEST_COORDINATE; };
  return corners.size() >= MANY && std::all_of(corners.begin(), corners.end(), is_moderate) && plane.is_flat(FLATNESS);
}

/// splits a flat polygon of many corners into triangles of good shape, with points that are added inside; nothing when it is
/// none, or meets itself. Triangles between the corners alone are long and thin, and hundreds of them meet: of a star of 2000
/// corners whose radii alternate by a tenth they leave an L2 stretch of 47, with points inside it is 7; of a circle 1.07 and 1.03.
///
/// Complexity: n log n in the number of corners.
inline std::optional<Polygon_triangulation> triangulate_flat_polygon(const std::vector<Eigen::Vector3d>& corners,
                                                                     const Polygon_plane& plane)
{
  if(!is_flat_and_large(corners, plane))
    return std::nullopt;
  std::vector<Eigen::Vector2d> seen;
  Planar_triangulation::Points seen_corners;
  for(const Eigen::Vector3d& p : corners) {
    seen.push_back(plane.seen(p));
    seen_corners.emplace_back(seen.back().x(), seen.back().y());
  }
  if(!CGAL::is_simple_2(seen_corners.begin(), seen_corners.end()))
    return std::nullopt;
  const Planar_triangulation::Points beside = points_beside(seen);
  const Eigen::Vector3d origin = Polygon_plane::mean(corners);
  Polygon_triangulation result{{}, Planar_triangulation(seen_corners, beside).triangles()};
  std::vector<std::size_t> number(beside.size(), 0); // of the points that are inside, as they are met; 0 for the others
  for(Planar_triangulation::Triangle& triangle : result.triangles)
    for(std::size_t& v : triangle)
      if(v >= corners.size()) {
        const std::size_t i = v - corners.size();
        if(number[i] == 0) {
          number[i] = corners.size() + result.added.size();
          result.added.push_back(plane.point_seen_at({beside[i].x(), beside[i].y()}, origin));
        }
        v = number[i];
      }
  return result;
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SOUP_TRIANGULATE_FLAT_POLYGON_H
