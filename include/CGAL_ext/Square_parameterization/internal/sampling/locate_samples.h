// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SAMPLING_LOCATE_SAMPLES_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SAMPLING_LOCATE_SAMPLES_H

#include <CGAL_ext/Square_parameterization/Grid_size.h>
#include <CGAL_ext/Square_parameterization/internal/common/Unmappable.h>
#include <CGAL_ext/Square_parameterization/internal/patch/exact_orientation.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// the place of a sample on the surface
struct Sample_location
{
  int face = -1;
  std::array<double, 3> weights{}; ///< barycentric coordinates, not negative, of sum 1
};

/// the coordinate of the `i`-th of `n` samples of a side of the square
inline double sample_coordinate(int i, int n)
{
  return static_cast<double>(i) / (n - 1);
}

/// a range of numbers, empty where the first is larger
struct Interval
{
  double low = std::numeric_limits<double>::infinity(), high = -std::numeric_limits<double>::infinity();

  void add(double x)
  {
    low = (std::min)(low, x);
    high = (std::max)(high, x);
  }
};

/// a triangle of the plane, counter-clockwise, to be asked which samples it contains
class Sampled_triangle
{
public:
  Sampled_triangle(const Uv_coordinates& uv, const std::array<int, 3>& t)
    : m_corners{Uv_point(uv.row(t[0])), Uv_point(uv.row(t[1])), Uv_point(uv.row(t[2]))}
  {}

  Interval v_range() const
  {
    Interval range;
    for(const Uv_point& p : m_corners)
      range.add(p.y());
    return range;
  }

  /// a range of u that holds the points of the triangle at height \p v, and little more
  Interval u_range(double v) const
  {
    Interval range;
    for(int k = 0; k < 3; ++k)
      add_side(m_corners[k], m_corners[(k + 1) % 3], v, range);
    return range;
  }

  /// the barycentric coordinates of \p p when the triangle, with its sides, contains it, exactly
  /// \return whether it does
  bool locate(const Uv_point& p, std::array<double, 3>& weights) const
  {
    double sum = 0;
    for(int k = 0; k < 3; ++k) {
      const Uv_point &a = m_corners[(k + 1) % 3], &b = m_corners[(k + 2) % 3];
      const int turn = orientation(a, b, p);
      if(turn < 0)
        return false;
      const Uv_point side = b - a, to_p = p - a;
      weights[k] = turn == 0 ? 0 : (std::max)(0., side.x() * to_p.y() - side.y() * to_p.x());
      sum += weights[k];
    }
    if(!(sum > 0)) { // all is lost in rounding: the triangle is smaller than that
      weights = {0, 0, 0};
      weights[nearest_corner(p)] = sum = 1;
    }
    for(double& weight : weights)
      weight /= sum;
    return true;
  }

private:
  /// adds the u of side `ab` at height \p v, with a margin for rounding: that of a side that is nearly level is large
  static void add_side(const Uv_point& a, const Uv_point& b, double v, Interval& range)
  {
    const auto [low_v, high_v] = std::minmax(a.y(), b.y());
    if(v < low_v || v > high_v)
      return;
    constexpr double ROUNDING = 8 * std::numeric_limits<double>::epsilon();
    const double rise = b.y() - a.y();
    const double share = rise != 0 ? (v - a.y()) / rise : 0, margin = rise != 0 ? ROUNDING / std::abs(rise) : 1;
    for(double s : {share - margin, share + margin})
      range.add(a.x() + (std::clamp)(s, 0., 1.) * (b.x() - a.x()));
  }

  int nearest_corner(const Uv_point& p) const
  {
    const auto distance = [&](int k) { return (m_corners[k] - p).squaredNorm(); };
    int nearest = 0;
    for(int k : {1, 2})
      if(distance(k) < distance(nearest))
        nearest = k;
    return nearest;
  }

  std::array<Uv_point, 3> m_corners;
};

/// the numbers of the samples of a side, of `n`, that may lie in a range: one more at an end does no harm
inline std::array<int, 2> samples_in(const Interval& range, int n)
{
  constexpr double ROUNDING = 1e-9; // in samples
  const double first = std::ceil(range.low * (n - 1) - ROUNDING), last = std::floor(range.high * (n - 1) + ROUNDING);
  return {static_cast<int>((std::clamp)(first, 0., 1. * n)), static_cast<int>((std::clamp)(last, -1., n - 1.))};
}

/// refuses a map that is not one-to-one
inline void check_map(const std::vector<std::array<int, 3>>& triangles, const Uv_coordinates& uv)
{
  for(std::size_t f = 0; f < triangles.size(); ++f)
    if(!is_counterclockwise(uv, triangles[f]))
      throw Unmappable(CGAL::Surface_mesh_parameterization::ERROR_NO_1_TO_1_MAPPING,
                       "the uv triangle of face " + std::to_string(f) + " is not counter-clockwise");
}

/// finds the face of every sample of a map onto the unit square, by exact arithmetic: of several faces that share a
/// side or a corner at a sample, the one of lowest number.
///
/// Throws `Unmappable` when a uv triangle is not counter-clockwise, or a sample lies in none.
/// \param triangles #F
/// \param uv #V by 2
/// \return `width` * `height` locations, row by row, from (0, 0) to (1, 0) and so on up to (1, 1)
///
/// Complexity: linear in the samples, the faces, and the rows of samples that each face meets.
inline std::vector<Sample_location> locate_samples(const std::vector<std::array<int, 3>>& triangles,
                                                   const Uv_coordinates& uv, const Grid_size& grid)
{
  check_map(triangles, uv);
  std::vector<Sample_location> locations(grid.number_of_samples());
  for(std::size_t f = 0; f < triangles.size(); ++f) {
    const Sampled_triangle triangle(uv, triangles[f]);
    const auto [first_row, last_row] = samples_in(triangle.v_range(), grid.height);
    for(int j = first_row; j <= last_row; ++j) {
      const double v = sample_coordinate(j, grid.height);
      const auto [first, last] = samples_in(triangle.u_range(v), grid.width);
      for(int i = first; i <= last; ++i) {
        Sample_location& location = locations[static_cast<std::size_t>(j) * grid.width + i];
        if(location.face < 0 && triangle.locate({sample_coordinate(i, grid.width), v}, location.weights))
          location.face = static_cast<int>(f);
      }
    }
  }
  for(std::size_t k = 0; k < locations.size(); ++k)
    if(locations[k].face < 0)
      throw Unmappable(CGAL::Surface_mesh_parameterization::ERROR_NO_1_TO_1_MAPPING,
                       "sample (" + std::to_string(k % grid.width) + ", " + std::to_string(k / grid.width) +
                           ") lies in no uv triangle: the map does not cover the unit square");
  return locations;
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SAMPLING_LOCATE_SAMPLES_H
