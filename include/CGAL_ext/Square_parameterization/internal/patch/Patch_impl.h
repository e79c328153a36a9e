// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PATCH_PATCH_IMPL_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PATCH_PATCH_IMPL_H

#include <CGAL_ext/Square_parameterization/internal/common/compiled_core.h>
#include <CGAL_ext/Square_parameterization/internal/common/ranges.h>
#include <CGAL_ext/Square_parameterization/internal/patch/Patch.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

CGAL_EXT_INLINE_FUNCTION double normalise_coordinates(std::vector<Eigen::Vector3d>& points)
{
  check_finite(points, [](std::size_t v) { return v; });
  Eigen::AlignedBox3d box;
  for(const Eigen::Vector3d& p : points)
    box.extend(p);
  const Eigen::Vector3d center = box.min() / 2 + box.max() / 2;
  const double largest = (std::max)(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
  const double radius = (box.max() - center).cwiseAbs().maxCoeff();
  if(!(radius > 0))
    throw Unmappable(CGAL::Surface_mesh_parameterization::ERROR_NO_1_TO_1_MAPPING,
                     "the surface has no extent: all its vertices coincide");
  const int exponent = -std::ilogb(radius);
  for(Eigen::Vector3d& p : points)
    p = (p - center).unaryExpr([exponent](double x) { return std::ldexp(x, exponent); });
  return 2 * std::numeric_limits<double>::epsilon() * std::ldexp(largest, exponent);
}

/// sets the edges, and the chords, of a patch whose triangles and border are set
inline void set_edges(Edge_numbering numbering, Patch& patch)
{
  std::vector<bool> is_on_border(patch.points.size(), false);
  for(int v : patch.border)
    is_on_border[v] = true;
  patch.edges = std::move(numbering.edges);
  patch.triangle_edges = std::move(numbering.triangle_edges);
  patch.chords.clear();
  for(std::size_t e = 0; e < patch.edges.size(); ++e)
    if(numbering.number_of_triangles[e] == 2 && is_on_border[patch.edges[e][0]] && is_on_border[patch.edges[e][1]])
      patch.chords.push_back(patch.edges[e]);
}

CGAL_EXT_INLINE_FUNCTION std::vector<Flat_triangle> shapes_as_given(const Patch& patch)
{
  std::vector<Flat_triangle> shapes = patch.shapes;
  for(int f : patch.degenerate_faces) {
    const auto& [a, b, c] = patch.triangles[f];
    shapes[f] = flatten(patch.points[a], patch.points[b], patch.points[c], patch.rounding);
  }
  return shapes;
}

CGAL_EXT_INLINE_FUNCTION void refuse_without_extent()
{
  throw Unmappable(CGAL::Surface_mesh_parameterization::ERROR_NO_1_TO_1_MAPPING,
                   "the surface has no extent: none of its faces has an area that is more than the rounding of its "
                   "coordinates");
}

/// multiplies all lengths
inline void scale_patch(double scale, Patch& patch)
{
  for(Eigen::Vector3d& p : patch.points)
    p *= scale;
  for(Flat_triangle& shape : patch.shapes)
    shape = {shape.x1 * scale, shape.x2 * scale, shape.y2 * scale};
  patch.rounding *= scale;
  patch.least_height *= scale;
}

CGAL_EXT_INLINE_FUNCTION double widened_height(const Patch& patch)
{
  constexpr double SHARE_OF_BORDER_EDGE = 0.1;
  return (std::min)(LEAST_LENGTH, SHARE_OF_BORDER_EDGE * 4 / double(patch.border.size()));
}

/// fills the shapes and the degenerate faces of a patch whose points are normalised, and scales it to area 1
inline void measure_faces(Patch& patch)
{
  patch.shapes.resize(patch.triangles.size());
  for_ranges(patch.triangles.size(), [&patch](std::size_t begin, std::size_t end) {
    for(std::size_t f = begin; f < end; ++f) {
      const auto& [a, b, c] = patch.triangles[f];
      patch.shapes[f] = flatten(patch.points[a], patch.points[b], patch.points[c], patch.rounding);
    }
  });
  double area = 0;
  for(const Flat_triangle& shape : patch.shapes)
    area += shape.area();
  if(!(area > 0))
    refuse_without_extent();
  scale_patch(1 / std::sqrt(area), patch);
  patch.least_height = (std::max)(DEGENERATE_HEIGHT, patch.rounding);
  patch.widened_height = widened_height(patch);
  std::vector<char> is_degenerate(patch.triangles.size());
  for_ranges(patch.triangles.size(), [&](std::size_t begin, std::size_t end) {
    for(std::size_t f = begin; f < end; ++f) {
      const auto& [a, b, c] = patch.triangles[f];
      is_degenerate[f] = flatten(patch.points[a], patch.points[b], patch.points[c], patch.least_height).y2 == 0;
    }
  });
  for(int f = 0; f < patch.number_of_faces(); ++f)
    if(is_degenerate[f])
      patch.degenerate_faces.push_back(f);
  if(patch.degenerate_faces.empty())
    return;
  area = 1;
  for(int f : patch.degenerate_faces) {
    const auto& [a, b, c] = patch.triangles[f];
    area -= patch.shapes[f].area();
    patch.shapes[f] = widened(patch.points[a], patch.points[b], patch.points[c], patch.widened_height);
    area += patch.shapes[f].area();
  }
  scale_patch(1 / std::sqrt(area), patch);
}

CGAL_EXT_INLINE_FUNCTION std::vector<double> border_lengths(const Patch& patch)
{
  std::vector<double> lengths;
  for(std::size_t k = 0; k < patch.border.size(); ++k) {
    const int from = patch.border[k], to = patch.border[(k + 1) % patch.border.size()];
    const double length = (patch.points[to] - patch.points[from]).norm();
    lengths.push_back(length > patch.least_height ? length : LEAST_LENGTH);
  }
  return lengths;
}

CGAL_EXT_INLINE_FUNCTION Patch measured_patch(std::vector<Eigen::Vector3d> points,
                                              std::vector<std::array<int, 3>> triangles, std::vector<int> border)
{
  Patch patch;
  patch.points = std::move(points);
  patch.triangles = std::move(triangles);
  patch.border = std::move(border);
  patch.rounding = normalise_coordinates(patch.points);
  measure_faces(patch);
  patch.border_lengths = border_lengths(patch);
  return patch;
}

CGAL_EXT_INLINE_FUNCTION Patch make_patch(std::vector<Eigen::Vector3d> points,
                                          std::vector<std::array<int, 3>> triangles, std::vector<int> border,
                                          Edge_numbering numbering)
{
  namespace SMP = CGAL::Surface_mesh_parameterization;
  if(triangles.empty())
    throw Unmappable(SMP::ERROR_EMPTY_MESH, "the surface has no faces");
  if(border.size() < 4)
    throw Unmappable(SMP::ERROR_BORDER_TOO_SHORT,
                     "the border has " + std::to_string(border.size()) + " vertices; a square needs at least four");
  Patch patch = measured_patch(std::move(points), std::move(triangles), std::move(border));
  patch.vertex_areas.assign(patch.points.size(), 0.);
  for(int f = 0; f < patch.number_of_faces(); ++f)
    for(int v : patch.triangles[f])
      patch.vertex_areas[v] += patch.shapes[f].area();
  set_edges(std::move(numbering), patch);
  return patch;
}

CGAL_EXT_INLINE_FUNCTION Patch make_patch(std::vector<Eigen::Vector3d> points,
                                          std::vector<std::array<int, 3>> triangles, std::vector<int> border)
{
  Edge_numbering numbering = number_edges(points.size(), triangles);
  return make_patch(std::move(points), std::move(triangles), std::move(border), std::move(numbering));
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PATCH_PATCH_IMPL_H
