// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PATCH_PATCH_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PATCH_PATCH_H

#include <CGAL_ext/Square_parameterization/internal/common/Unmappable.h>
#include <CGAL_ext/Square_parameterization/internal/patch/Flat_triangle.h>
#include <CGAL_ext/Square_parameterization/internal/patch/number_edges.h>

#include <array>
#include <string>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// uv coordinates, #V by 2: row `v` is the image of vertex `v`
using Uv_coordinates = Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor>;

using CGAL_ext::Patch;

/// the rows of \p uv (#V by 2) for the border vertices: #B by 2
inline Uv_coordinates border_coordinates(const Patch& patch, const Uv_coordinates& uv)
{
  Uv_coordinates border(patch.border.size(), 2);
  for(std::size_t k = 0; k < patch.border.size(); ++k)
    border.row(k) = uv.row(patch.border[k]);
  return border;
}

/// refuses points with a coordinate that is not finite; `name(v)` is the number by which a message names a vertex
template <class Name>
void check_finite(const std::vector<Eigen::Vector3d>& points, Name name)
{
  for(std::size_t v = 0; v < points.size(); ++v)
    if(!points[v].allFinite())
      throw Unmappable(CGAL::Surface_mesh_parameterization::ERROR_WRONG_PARAMETER,
                       "vertex " + std::to_string(name(v)) + " has a coordinate that is not finite");
}

/// multiplies the points by a power of two so that the largest coordinate is near 1: exact, and no square overflows.
/// The points are moved to their centre first, so that a far origin costs no digits afterwards.
/// Returns the length, after scaling, below which the coordinates carry no information.
double normalise_coordinates(std::vector<Eigen::Vector3d>& points);

/// lays a triangle between points of the patch into the plane; see `widened()` for a degenerate one
inline Flat_triangle shape_between(const Patch& patch, int a, int b, int c)
{
  const Eigen::Vector3d &p = patch.points[a], &q = patch.points[b], &r = patch.points[c];
  const Flat_triangle shape = flatten(p, q, r, patch.least_height);
  return shape.y2 > 0 ? shape : widened(p, q, r, patch.widened_height);
}

/// the shapes of the faces as their points have them: some have no area
std::vector<Flat_triangle> shapes_as_given(const Patch& patch);

/// the surface has no shape that could be mapped. No count: faces may have been split
[[noreturn]] void refuse_without_extent();

/// the height over its longest side that a degenerate face is given: on a border of tens of thousands of vertices far less than
/// the length of its edges on the square, where neighbors would be torn by more
double widened_height(const Patch& patch);

/// the lengths of the border edges of a patch whose faces are measured; an edge shorter than `least_height` counts as
/// `LEAST_LENGTH`, for positions on a curve must be distinct
std::vector<double> border_lengths(const Patch& patch);

/// makes a patch without edges and areas of vertices, scaled to area 1. Throws `Unmappable` when a coordinate is not
/// finite, or all triangles are so thin that their size is lost in the rounding of the coordinates.
Patch measured_patch(std::vector<Eigen::Vector3d> points, std::vector<std::array<int, 3>> triangles,
                     std::vector<int> border);

/// makes a patch of a disk: \p points #V, \p triangles #F, consistently oriented, \p border its vertices
/// counter-clockwise. Every vertex must belong to a triangle.
///
/// Throws `Unmappable` when the border has fewer than four vertices, and as `measured_patch()`.
/// Complexity: linear but for the sorting of the edges at a vertex.
/// \param numbering of the edges of the triangles
Patch make_patch(std::vector<Eigen::Vector3d> points, std::vector<std::array<int, 3>> triangles,
                 std::vector<int> border, Edge_numbering numbering);

/// as above, and numbers the edges
Patch make_patch(std::vector<Eigen::Vector3d> points, std::vector<std::array<int, 3>> triangles,
                 std::vector<int> border);

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#ifndef CGAL_EXT_COMPILED_CORE
#include <CGAL_ext/Square_parameterization/internal/patch/Patch_impl.h>
#endif

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PATCH_PATCH_H
