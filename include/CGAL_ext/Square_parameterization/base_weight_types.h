// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_BASE_WEIGHT_TYPES_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_BASE_WEIGHT_TYPES_H

#include <Eigen/Core>

#include <array>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {

/// \ingroup PkgSquareParameterizationWeights
///
/// a triangle laid into its own plane, counter-clockwise, with corners (0, 0), (`x1`, 0) and (`x2`, `y2`);
/// `x1` and `y2` are positive
struct Flat_triangle
{
  double x1, x2, y2;

  /// in units of the area of the disk
  double area() const { return x1 * y2 / 2; }
};

/// \ingroup PkgSquareParameterizationWeights
///
/// a topological disk as flat arrays: what a model of `BaseWeights` is given, and the form in which everything below
/// the plug-ins sees a mesh. Vertices, triangles and edges are numbered from 0.
///
/// Lengths are scaled so that the area of the disk is 1, the area of the square it will be mapped to; the points are
/// moved and scaled, not turned. A face lower than 1e-8 over its longest side counts with the shape of one that is 1e-4
/// high (0.4 / B on a border of B > 4000 vertices), as short a border edge as 1e-4 long: take lengths and angles from
/// `shapes`, not from `points`, where weights must stay positive and finite.
struct Patch
{
  std::vector<Eigen::Vector3d> points;            ///< one per vertex
  std::vector<std::array<int, 3>> triangles;      ///< three vertices each, counter-clockwise
  std::vector<Flat_triangle> shapes;              ///< one per triangle, corner k is that of `triangles[f][k]`
  std::vector<int> border;                        ///< vertices, counter-clockwise in uv
  std::vector<double> border_lengths;             ///< one per border vertex, edge k joins border[k] and border[k + 1]
  std::vector<std::array<int, 2>> edges;          ///< two vertices each, the first lower, sorted
  std::vector<std::array<int, 3>> triangle_edges; ///< three edges per triangle, edge k is opposite to corner k
  /// \cond SKIP_IN_MANUAL
  std::vector<std::array<int, 2>> chords; ///< interior edges between two border vertices
  std::vector<double> vertex_areas;       ///< one per vertex, of the incident triangles
  std::vector<int> degenerate_faces;      ///< lower than `least_height`, ascending
  double least_height = 0;                ///< `DEGENERATE_HEIGHT`, or more where coordinates carry less information
  double widened_height = 0;              ///< the height over its longest side with which a degenerate face counts
  double rounding = 0;                    ///< length below which the points carry no information
  std::vector<int> elimination_places;    ///< one per vertex, in an order that keeps fill low; or empty
  /// \endcond

  /// as many as there are points
  int number_of_vertices() const { return static_cast<int>(points.size()); }

  /// as many as there are triangles
  int number_of_faces() const { return static_cast<int>(triangles.size()); }
};

/// \ingroup PkgSquareParameterizationWeights
///
/// two weights for every edge of a disk: what a model of `BaseWeights` returns. For the edge e = (a, b),
/// `values[e][0]` is the weight of b in the equation of a, and `values[e][1]` the weight of a in the equation of b; the
/// equations of border vertices are not solved, and their weights not read. Weights are dimensionless up to a factor
/// common to one vertex (to the whole disk if they are symmetric).
struct Edge_weights
{
  std::vector<std::array<double, 2>> values; ///< two per edge
  bool is_symmetric = false;                 ///< both weights of every edge are equal

  /// gives every edge both weights.
  /// \param patch the disk
  /// \param value of both weights of every edge, dimensionless
  /// \param symmetric whether the weights will be symmetric when they are set
  explicit Edge_weights(const Patch& patch, double value = 0, bool symmetric = false)
    : values(patch.edges.size(), {value, value}), is_symmetric(symmetric)
  {}

  /// adds to the weight that the other end of an edge has in the equation of a vertex.
  /// \param patch the disk
  /// \param edge number of the edge
  /// \param vertex one of its ends
  /// \param value what is added
  void add(const Patch& patch, int edge, int vertex, double value)
  {
    values[edge][patch.edges[edge][0] == vertex ? 0 : 1] += value;
  }
};

} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_BASE_WEIGHT_TYPES_H
