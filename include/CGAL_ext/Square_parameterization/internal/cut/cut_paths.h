// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_CUT_PATHS_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_CUT_PATHS_H

#include <CGAL_ext/Square_parameterization/internal/cut/Cut.h>

#include <algorithm>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// edges of a cut between two of its nodes
struct Cut_path
{
  std::vector<int> edges; ///< in order
  int from, to;
  double length;
};

/// walks on from edge \p e of the cut beyond its end \p v to the next node, which it returns; puts the edges into
/// \p walked
inline int follow_cut(const Triangle_surface& surface, const Cut& cut, int e, int v, std::vector<int>& walked)
{
  while(!cut.is_node(surface, v)) {
    const auto incident = surface.vertex_edges[v];
    e = *std::find_if(incident.begin(), incident.end(), [&](int next) { return next != e && cut.contains(next); });
    walked.push_back(e);
    v = surface.other_end(e, v);
  }
  return v;
}

/// the path of the cut that contains edge \p e
inline Cut_path path_through(const Triangle_surface& surface, const Cut& cut, int e)
{
  std::vector<int> backward;
  const int from = follow_cut(surface, cut, e, surface.edges[e][0], backward);
  Cut_path path{{backward.rbegin(), backward.rend()}, from, surface.edges[e][1], 0};
  path.edges.push_back(e);
  path.to = follow_cut(surface, cut, e, surface.edges[e][1], path.edges);
  for(int edge : path.edges)
    path.length += surface.lengths[edge];
  return path;
}

/// the paths that may be changed
inline std::vector<Cut_path> paths_longest_first(const Triangle_surface& surface, const Cut& cut)
{
  std::vector<Cut_path> paths;
  std::vector<bool> is_visited(surface.edges.size(), false);
  for(int e : cut.edges()) {
    if(is_visited[e] || cut.is_fixed(e))
      continue;
    paths.push_back(path_through(surface, cut, e));
    for(int edge : paths.back().edges)
      is_visited[edge] = true;
  }
  std::stable_sort(paths.begin(), paths.end(),
                   [](const Cut_path& a, const Cut_path& b) { return a.length > b.length; });
  return paths;
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_CUT_PATHS_H
