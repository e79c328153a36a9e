// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SURFACE_NUMBERED_TRIANGLES_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SURFACE_NUMBERED_TRIANGLES_H

#include <CGAL_ext/Square_parameterization/internal/patch/number_edges.h>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// triangles and their edges: what is left of a surface where neither its shape nor its neighborhoods are asked for
struct Numbered_triangles
{
  /// numbers the edges
  Numbered_triangles(int number_of_vertices_of, std::vector<std::array<int, 3>> triangles_of)
    : number_of_vertices(number_of_vertices_of),
      triangles(std::move(triangles_of)),
      numbering(number_edges(static_cast<std::size_t>(number_of_vertices), triangles))
  {}

  Numbered_triangles(int number_of_vertices_of, std::vector<std::array<int, 3>> triangles_of,
                     Edge_numbering numbering_of)
    : number_of_vertices(number_of_vertices_of), triangles(std::move(triangles_of)), numbering(std::move(numbering_of))
  {}

  int number_of_edges() const { return static_cast<int>(numbering.edges.size()); }

  bool is_border_edge(int e) const { return numbering.number_of_triangles[e] == 1; }

  /// the edges of the border, in their order
  std::vector<int> border_edges() const
  {
    std::vector<int> border;
    for(int e = 0; e < number_of_edges(); ++e)
      if(is_border_edge(e))
        border.push_back(e);
    return border;
  }

  int number_of_vertices;
  std::vector<std::array<int, 3>> triangles; ///< #F
  Edge_numbering numbering;
};

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SURFACE_NUMBERED_TRIANGLES_H
