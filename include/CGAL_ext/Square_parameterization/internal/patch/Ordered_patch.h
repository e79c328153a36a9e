// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PATCH_ORDERED_PATCH_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PATCH_ORDERED_PATCH_H

#include <CGAL_ext/Square_parameterization/internal/patch/Patch_division.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// a patch with its vertices in the order of their ranks, and its triangles block by block, where those that follow each
/// other in the list are neighbors on the surface. It has what minimizers need: no chords, no areas of vertices.
inline Patch in_order_of(const Patch_division& division, const Patch& patch)
{
  Patch result;
  result.points.reserve(patch.points.size());
  for(int v : division.order())
    result.points.push_back(patch.points[v]);
  const auto add_triangle = [&](int f) {
    const auto& [a, b, c] = patch.triangles[f];
    result.triangles.push_back({division.rank(a), division.rank(b), division.rank(c)});
    result.shapes.push_back(patch.shapes[f]);
  };
  result.triangles.reserve(patch.triangles.size());
  result.shapes.reserve(patch.triangles.size());
  for(int b = 0; b < division.number_of_blocks(); ++b)
    for(int i = division.triangles_of_block(b).begin; i < division.triangles_of_block(b).end; ++i)
      add_triangle(division.triangle(i));
  for(int f : division.joints())
    add_triangle(f);
  for(int v : patch.border)
    result.border.push_back(division.rank(v));
  result.edges.reserve(patch.edges.size());
  for(const auto& [a, b] : patch.edges) {
    const int i = division.rank(a), j = division.rank(b);
    result.edges.push_back({(std::min)(i, j), (std::max)(i, j)});
  }
  if(!patch.elimination_places.empty())
    for(int v : division.order())
      result.elimination_places.push_back(patch.elimination_places[v]);
  result.border_lengths = patch.border_lengths;
  result.least_height = patch.least_height;
  result.widened_height = patch.widened_height;
  result.rounding = patch.rounding;
  return result;
}

/// a patch in an order in which neighbors are near in memory, if it is large enough to be divided, else as it is given
class Ordered_patch
{
public:
  Ordered_patch(const Patch_division& division, const Patch& given)
    : m_given(given),
      m_ordered(division.is_divided() ? in_order_of(division, given) : Patch()),
      m_order(division.order()),
      m_division(division.is_divided() ? division.in_order() : division)
  {}

  Ordered_patch(const Ordered_patch&) = delete;
  Ordered_patch& operator=(const Ordered_patch&) = delete;

  /// the patch as it was given
  const Patch& given() const { return m_given; }

  /// the patch in order
  const Patch& operator*() const { return is_reordered() ? m_ordered : m_given; }
  const Patch* operator->() const { return &**this; }

  bool is_reordered() const { return m_division.is_divided(); }

  /// of the patch in order
  const Patch_division& division() const { return m_division; }

  /// per vertex of the patch in order, the given one
  const std::vector<int>& order() const { return m_order; }

  /// frees the edges of the patch in order, if they are not those of the given one
  void forget_edges() { m_ordered.edges = std::vector<std::array<int, 2>>(); } // `= {}` would keep the memory

  /// a map of the given patch (#V by 2) as one of the patch in order
  Uv_coordinates in_order(Uv_coordinates uv) const
  {
    if(!is_reordered())
      return uv;
    Uv_coordinates result(uv.rows(), 2);
    for(std::size_t i = 0; i < m_order.size(); ++i)
      result.row(i) = uv.row(m_order[i]);
    return result;
  }

  /// and back
  Uv_coordinates in_given_order(Uv_coordinates uv) const
  {
    if(!is_reordered())
      return uv;
    Uv_coordinates result(uv.rows(), 2);
    for(std::size_t i = 0; i < m_order.size(); ++i)
      result.row(m_order[i]) = uv.row(i);
    return result;
  }

private:
  const Patch& m_given;
  Patch m_ordered;
  std::vector<int> m_order;
  Patch_division m_division;
};

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PATCH_ORDERED_PATCH_H
