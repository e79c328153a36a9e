// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ITERATION_EDGE_WEIGHTS_IMPL_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ITERATION_EDGE_WEIGHTS_IMPL_H

#include <CGAL_ext/Square_parameterization/internal/common/compiled_core.h>
#include <CGAL_ext/Square_parameterization/internal/iteration/edge_weights.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

CGAL_EXT_INLINE_FUNCTION Edge_weights checked(Edge_weights weights, const Patch& patch)
{
  namespace SMP = CGAL::Surface_mesh_parameterization;
  if(weights.values.size() != patch.edges.size())
    throw Unmappable(SMP::ERROR_WRONG_PARAMETER, "the base weights are for " + std::to_string(weights.values.size()) +
                                                     " edges; the surface has " + std::to_string(patch.edges.size()));
  if(weights.is_symmetric)
    for(std::size_t e = 0; e < weights.values.size(); ++e)
      if(weights.values[e][0] < weights.values[e][1] || weights.values[e][1] < weights.values[e][0])
        throw Unmappable(SMP::ERROR_WRONG_PARAMETER, "the base weights are said to be symmetric, but the two of edge " +
                                                         std::to_string(e) + " differ");
  return weights;
}

/// side vectors of a flat triangle: side k runs from corner k + 1 to corner k + 2, opposite to corner k
inline std::array<Eigen::Vector2d, 3> sides_of(const Flat_triangle& shape)
{
  return {Eigen::Vector2d(shape.x2 - shape.x1, shape.y2), Eigen::Vector2d(-shape.x2, -shape.y2),
          Eigen::Vector2d(shape.x1, 0)};
}

CGAL_EXT_INLINE_FUNCTION Edge_weights cotangent_weights(const Patch& patch)
{
  Edge_weights weights(patch, 0, true);
  for(int f = 0; f < patch.number_of_faces(); ++f) {
    const auto sides = sides_of(patch.shapes[f]);
    const double four_areas = 4 * patch.shapes[f].area();
    for(int k = 0; k < 3; ++k) {
      const double half_cotangent = -sides[(k + 1) % 3].dot(sides[(k + 2) % 3]) / four_areas;
      for(double& w : weights.values[patch.triangle_edges[f][k]])
        w += half_cotangent;
    }
  }
  return weights;
}

/// tangent of half the angle between the vectors \p a and \p b, without cancellation at either end
inline double tangent_of_half_angle(const Eigen::Vector2d& a, const Eigen::Vector2d& b, double cross)
{
  const double dot = a.dot(b), lengths = a.norm() * b.norm();
  return dot > 0 ? cross / (lengths + dot) : (lengths - dot) / cross;
}

CGAL_EXT_INLINE_FUNCTION Edge_weights mean_value_weights(const Patch& patch)
{
  Edge_weights weights(patch);
  for(int f = 0; f < patch.number_of_faces(); ++f) {
    const auto sides = sides_of(patch.shapes[f]);
    for(int k = 0; k < 3; ++k) { // the angle at corner k lies between sides k + 1 (reversed) and k + 2
      const Eigen::Vector2d &to_previous = -sides[(k + 1) % 3], &to_next = sides[(k + 2) % 3];
      const double tangent = tangent_of_half_angle(to_next, to_previous, 2 * patch.shapes[f].area());
      const int vertex = patch.triangles[f][k];
      weights.add(patch, patch.triangle_edges[f][(k + 1) % 3], vertex, tangent / to_previous.norm());
      weights.add(patch, patch.triangle_edges[f][(k + 2) % 3], vertex, tangent / to_next.norm());
    }
  }
  return weights;
}

/// a corner of the fan around a vertex: the spoke to the next neighbor and the angle between it and the spoke after
struct Fan_corner
{
  int spoke;     ///< edge of the patch
  double length; ///< of the spoke
  double angle;  ///< to the next spoke, counter-clockwise
};

/// the fans around all interior vertices, each in counter-clockwise order; the fans of border vertices are empty
inline std::vector<std::vector<Fan_corner>> interior_fans(const Patch& patch)
{
  struct Link
  {
    int from, to;
    Fan_corner corner;
  };
  std::vector<std::vector<Link>> links(patch.points.size());
  for(int f = 0; f < patch.number_of_faces(); ++f) {
    const auto sides = sides_of(patch.shapes[f]);
    for(int k = 0; k < 3; ++k) {
      const int next = (k + 1) % 3, previous = (k + 2) % 3;
      const double dot = -sides[next].dot(sides[previous]);
      links[patch.triangles[f][k]].push_back(
          {patch.triangles[f][next],
           patch.triangles[f][previous],
           {patch.triangle_edges[f][previous], sides[previous].norm(), std::atan2(2 * patch.shapes[f].area(), dot)}});
    }
  }
  for(int v : patch.border)
    links[v].clear();
  std::vector<std::vector<Fan_corner>> fans(patch.points.size());
  for(std::size_t v = 0; v < links.size(); ++v) {
    for(std::size_t i = 0; i < links[v].size(); ++i) {
      fans[v].push_back(links[v][i].corner);
      const auto is_next = [&](const Link& link) { return link.from == links[v][i].to; };
      const auto next = std::find_if(links[v].begin() + i + 1, links[v].end(), is_next);
      if(next != links[v].end())
        std::swap(links[v][i + 1], *next);
    }
  }
  return fans;
}

/// raises the weights of the spokes of a fan that are zero, or lost beside the others, to a small positive share of the
/// largest: without it a fan with a sector wider than pi could leave a neighbor out
inline void keep_positive(const Patch& patch, const std::vector<Fan_corner>& fan, int vertex, Edge_weights& weights)
{
  double largest = 0;
  const auto weight = [&](const Fan_corner& corner) -> double& {
    return weights.values[corner.spoke][patch.edges[corner.spoke][0] == vertex ? 0 : 1];
  };
  for(const Fan_corner& corner : fan)
    largest = (std::max)(largest, weight(corner));
  for(const Fan_corner& corner : fan)
    weight(corner) = largest > 0 ? (std::max)(weight(corner), 1e-6 * largest) : 1;
}

CGAL_EXT_INLINE_FUNCTION Edge_weights shape_preserving_weights(const Patch& patch, int distance_power)
{
  Edge_weights weights(patch);
  constexpr double ANGLE_TOLERANCE = 1e-9; // radians: a ray this close to a ring vertex meets it
  const std::vector<std::vector<Fan_corner>> fans = interior_fans(patch);
  std::vector<Eigen::Vector2d> ring;
  std::vector<double> directions;
  const auto cross = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); };
  for(std::size_t v = 0; v < fans.size(); ++v) {
    const std::vector<Fan_corner>& fan = fans[v];
    const std::size_t n = fan.size();
    double total_angle = 0;
    for(const Fan_corner& corner : fan)
      total_angle += corner.angle;
    ring.clear();
    directions.clear();
    double direction = 0;
    for(const Fan_corner& corner : fan) {
      directions.push_back(direction);
      ring.emplace_back(corner.length * std::cos(direction), corner.length * std::sin(direction));
      direction = static_cast<double>(direction + corner.angle * 2 * EIGEN_PI / total_angle);
    }
    for(std::size_t j = 0; j < n; ++j)
      for(const double side : {-ANGLE_TOLERANCE, ANGLE_TOLERANCE}) {
        const auto opposite = static_cast<double>(std::fmod(directions[j] + EIGEN_PI + side, 2 * EIGEN_PI));
        const std::size_t a = std::upper_bound(directions.begin(), directions.end(), opposite) - directions.begin() - 1;
        const std::size_t b = (a + 1) % n;
        // areas of the triangles that the centre makes with the sides of (j, a, b); a sector wider than pi can make one
        // negative: it is left out, which keeps the combination convex
        const double of_j = (std::max)(0., cross(ring[a], ring[b]));
        const double of_a = (std::max)(0., cross(ring[b], ring[j]));
        const double of_b = (std::max)(0., cross(ring[j], ring[a]));
        const double sum = of_j + of_a + of_b;
        const double inverse_distance = (ring[b] - ring[a]).norm() / of_j;
        if(!(of_j > 0) || !std::isfinite(inverse_distance))
          continue;
        const double share = std::pow(inverse_distance, distance_power) / sum;
        weights.add(patch, fan[j].spoke, static_cast<int>(v), share * of_j);
        weights.add(patch, fan[a].spoke, static_cast<int>(v), share * of_a);
        weights.add(patch, fan[b].spoke, static_cast<int>(v), share * of_b);
      }
    keep_positive(patch, fan, static_cast<int>(v), weights);
  }
  return weights;
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ITERATION_EDGE_WEIGHTS_IMPL_H
