// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SOUP_CONDITION_SOUP_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SOUP_CONDITION_SOUP_H

#include <CGAL_ext/Square_parameterization/internal/soup/check_soup.h>

#include <optional>
#include <vector>

namespace CGAL_ext {
namespace internal {

/// what `condition_soup()` is to do
struct Conditioning_options
{
  Topology topology = Topology::DISK;
  /// keeps one connected component alone: 0 is that with most faces, the first of them when there are several. None:
  /// there must be one component.
  std::optional<std::size_t> component;
  bool triangulate = false; ///< splits polygons; they are refused otherwise
};

/// what `condition_soup()` changed
struct Conditioning_report
{
  std::size_t components = 1;            ///< how many there were
  std::size_t component = 0;             ///< the one that was kept
  std::size_t faces_dropped = 0;         ///< those of the other components
  std::size_t vertices_dropped = 0;      ///< isolated vertices and those of the other components
  std::size_t faces_reoriented = 0;      ///< faces that were turned round
  std::size_t polygons_triangulated = 0; ///< faces that were split
  std::size_t vertices_added = 0;     ///< inside large polygons, and those that no diagonal could split; they come last
  std::vector<std::size_t> new_index; ///< per vertex of the input; `DROPPED` for one without a face

  static constexpr std::size_t DROPPED = static_cast<std::size_t>(-1);
};

/// makes a soup one connected, manifold, oriented triangle surface: chooses a component and splits polygons where that
/// is asked for, turns faces round, and drops isolated vertices. Throws `Unmappable` with a sentence that counts what
/// is wrong and names the first places by their numbers in the given soup; with `ERROR_WRONG_PARAMETER` when there is
/// no such component.
///
/// Complexity: linear in the number of sides but for sorting those at each vertex and, where polygons are split,
/// quadratic in the size of each.
/// \pre every index of a face is that of a point, every coordinate is finite
Conditioning_report condition_soup(Surface_soup& soup, const Conditioning_options& options = {});

} // namespace internal
} // namespace CGAL_ext

#ifndef CGAL_EXT_COMPILED_CORE
#include <CGAL_ext/Square_parameterization/internal/soup/condition_soup_impl.h>
#endif

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SOUP_CONDITION_SOUP_H
