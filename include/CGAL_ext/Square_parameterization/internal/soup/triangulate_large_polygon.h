// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SOUP_TRIANGULATE_LARGE_POLYGON_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SOUP_TRIANGULATE_LARGE_POLYGON_H

#include <CGAL_ext/Square_parameterization/internal/soup/Planar_triangulation.h>
#include <CGAL_ext/Square_parameterization/internal/soup/Polygon_plane.h>
#include <CGAL_ext/Square_parameterization/internal/soup/Polygon_quadtree.h>

#include <CGAL/Polygon_2_algorithms.h>

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <array>
#include <cmath>
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
  constexpr std::size_t MOST_PER_CORNER = 8;   // more where corners lie in tiny clusters: these stay whole then
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

/// the cotangent of the angle at a corner of a triangle in the plane, but none so large that others beside it are lost
inline double moderate_cotangent(const Planar_triangulation::Kernel::Point_2& corner,
                                 const Planar_triangulation::Kernel::Point_2& next,
                                 const Planar_triangulation::Kernel::Point_2& last)
{
  constexpr double LARGEST = 1e4;
  const auto a = next - corner, b = last - corner;
  const double across = std::abs(a.x() * b.y() - a.y() * b.x()), along = a.x() * b.x() + a.y() * b.y();
  return std::abs(along) < LARGEST * across ? along / across : along > 0 ? LARGEST : -LARGEST;
}

/// the heights of the points that were added, between those of the corners: a harmonic function, by cotangent weights, of
/// which the sum of the two at an edge is not negative in a Delaunay triangulation
/// \param points the corners, and then the points that were added
inline Eigen::VectorXd heights_between(const std::vector<Planar_triangulation::Triangle>& triangles,
                                       const Planar_triangulation::Points& points,
                                       const std::vector<double>& heights_of_corners)
{
  const std::size_t first = heights_of_corners.size();
  const auto row = [first](std::size_t v) { return static_cast<int>(v - first); };
  const auto size = static_cast<Eigen::Index>(points.size() - first);
  Eigen::VectorXd sums = Eigen::VectorXd::Zero(size); // over the corners round a point
  std::vector<Eigen::Triplet<double>> entries;
  for(const Planar_triangulation::Triangle& triangle : triangles)
    for(int k = 0; k < 3; ++k) {
      const std::array<std::size_t, 2> side{triangle[(k + 1) % 3], triangle[(k + 2) % 3]};
      const double weight = moderate_cotangent(points[triangle[k]], points[side[0]], points[side[1]]);
      for(int end = 0; end < 2; ++end)
        if(const std::size_t v = side[end], w = side[1 - end]; v >= first) {
          entries.emplace_back(row(v), row(v), weight);
          if(w < first)
            sums[row(v)] += weight * heights_of_corners[w];
          else
            entries.emplace_back(row(v), row(w), -weight);
        }
    }
  if(size == 0)
    return sums;
  Eigen::SparseMatrix<double> laplacian(size, size);
  laplacian.setFromTriplets(entries.begin(), entries.end());
  return Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(laplacian).solve(sums);
}

/// numbers the points that are inside after the corners, in the order in which the triangles have them, and returns them
/// \param beside points inside and outside, by whose numbers the triangles come and which they do not have in the end
inline Planar_triangulation::Points keep_points_inside(std::size_t corners, const Planar_triangulation::Points& beside,
                                                       std::vector<Planar_triangulation::Triangle>& triangles)
{
  Planar_triangulation::Points inside;
  std::vector<std::size_t> number(beside.size(), 0); // 0 of those that were not met
  for(Planar_triangulation::Triangle& triangle : triangles)
    for(std::size_t& v : triangle)
      if(v >= corners) {
        const std::size_t i = v - corners;
        if(number[i] == 0) {
          number[i] = corners + inside.size();
          inside.push_back(beside[i]);
        }
        v = number[i];
      }
  return inside;
}

/// indicates whether products of coordinates neither overflow nor vanish
inline bool has_moderate_size(const std::vector<Eigen::Vector3d>& points)
{
  double size = 0;
  for(const Eigen::Vector3d& p : points)
    size = (std::max)(size, p.cwiseAbs().maxCoeff());
  return size >= 1e-100 && size <= 1e100;
}

/// splits a polygon of many corners into triangles of good shape, with points that are added inside; nothing when it has few
/// corners, or meets itself as it is seen along its normal. The points lie in its plane, or, where the corners do not, on the
/// harmonic surface that they span.
///
/// Triangles between the corners alone are long and thin, and hundreds of them meet: of a star of 2000 corners whose radii
/// alternate by a twentieth they leave an L2 stretch of 27, with points inside it is 2.6; of a circle 1.07 and 1.03.
///
/// Complexity: n log n in the number of corners.
inline std::optional<Polygon_triangulation> triangulate_large_polygon(const std::vector<Eigen::Vector3d>& corners,
                                                                      const Polygon_plane& plane)
{
  constexpr std::size_t MANY = 50; // facets of ordinary models have fewer, and get no vertices
  if(corners.size() < MANY || !plane.has_normal() || !has_moderate_size(corners))
    return std::nullopt;
  std::vector<Eigen::Vector2d> seen;
  Planar_triangulation::Points seen_corners;
  std::vector<double> heights;
  for(const Eigen::Vector3d& p : corners) {
    seen.push_back(plane.seen(p));
    seen_corners.emplace_back(seen.back().x(), seen.back().y());
    heights.push_back(plane.height(p));
  }
  if(!CGAL::is_simple_2(seen_corners.begin(), seen_corners.end()))
    return std::nullopt;
  const Planar_triangulation::Points beside = points_beside(seen);
  Polygon_triangulation result{{}, Planar_triangulation(seen_corners, beside).triangles()};
  const Planar_triangulation::Points inside = keep_points_inside(corners.size(), beside, result.triangles);
  seen_corners.insert(seen_corners.end(), inside.begin(), inside.end());
  const Eigen::VectorXd heights_inside = heights_between(result.triangles, seen_corners, heights);
  if(!heights_inside.allFinite())
    return std::nullopt;
  for(std::size_t i = 0; i < inside.size(); ++i)
    result.added.push_back(plane.point({inside[i].x(), inside[i].y()}, heights_inside[static_cast<Eigen::Index>(i)]));
  return result;
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SOUP_TRIANGULATE_LARGE_POLYGON_H
