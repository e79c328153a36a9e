// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_SHORT_CUTS_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_SHORT_CUTS_H

#include <CGAL_ext/Square_parameterization/internal/cut/Cut.h>
#include <CGAL_ext/Square_parameterization/internal/cut/shortest_paths.h>

#include <algorithm>
#include <cstddef>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// the cut of a sphere along an edge of a vertex, and along that of its other edges which leads farthest away from there
inline Cut cut_across(const Triangle_surface& surface, int v, int edge)
{
  const int begin = surface.other_end(edge, v);
  const auto distance = [&](int e) {
    return e == edge ? -1 : (surface.points[surface.other_end(e, v)] - surface.points[begin]).squaredNorm();
  };
  const auto edges = surface.vertex_edges[v];
  const int opposite =
      *std::max_element(edges.begin(), edges.end(), [&](int a, int b) { return distance(a) < distance(b); });
  Cut cut(surface);
  for(int e : {edge, opposite}) {
    cut.insert(surface, e);
    cut.add_terminal(surface.other_end(e, v));
  }
  return cut;
}

/// cuts of a sphere of two edges each, up to three at each of six vertices far from each other: where length counts for more
/// than stretch, the best cut is short, and growth, which begins with a long one, seldom gets there
inline std::vector<Cut> short_cuts(const Triangle_surface& surface)
{
  constexpr std::size_t PLACES = 6, CUTS = 3;
  std::vector<int> places{0};
  while(places.size() < (std::min)(PLACES, surface.points.size()))
    places.push_back(farthest_vertex(shortest_paths(surface, places)));
  std::vector<Cut> cuts;
  for(int v : places) {
    const auto edges = surface.vertex_edges[v];
    const std::size_t degree = edges.end() - edges.begin();
    for(std::size_t i = 0; i < CUTS; ++i)
      cuts.push_back(cut_across(surface, v, edges.begin()[i * degree / CUTS]));
  }
  return cuts;
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_SHORT_CUTS_H
