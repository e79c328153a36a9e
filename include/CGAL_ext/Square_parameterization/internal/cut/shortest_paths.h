// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_SHORTEST_PATHS_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_SHORTEST_PATHS_H

#include <CGAL_ext/Square_parameterization/internal/cut/Cut.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// lengths and last edges of shortest paths along the edges of a surface
struct Shortest_paths
{
  std::vector<double> distances; ///< #V
  std::vector<int> parent_edges; ///< #V, -1 where a path begins
};

/// groups of vertices each of which counts as one node: whoever reaches one of its vertices has reached all
struct Vertex_groups
{
  std::vector<int> group_of;             ///< #V, -1 for a vertex on its own; empty for no groups
  std::vector<std::vector<int>> members; ///< per group
};

/// Dijkstra's algorithm from \p sources to all vertices, or until \p is_goal holds for the vertex reached, which is
/// then put into \p reached. Ties: lowest vertex.
inline Shortest_paths shortest_paths(const Triangle_surface& surface, const std::vector<int>& sources,
                                     const Vertex_groups& groups = {},
                                     const std::function<bool(int)>& is_goal = nullptr, int* reached = nullptr)
{
  typedef std::pair<double, int> Entry;
  Shortest_paths paths{std::vector<double>(surface.points.size(), std::numeric_limits<double>::infinity()),
                       std::vector<int>(surface.points.size(), -1)};
  std::vector<bool> is_settled(surface.points.size(), false);
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  const auto enter = [&](int v, double distance, int edge) {
    if(distance < paths.distances[v]) {
      paths.distances[v] = distance;
      paths.parent_edges[v] = edge;
      queue.emplace(distance, v);
    }
  };
  const auto settle = [&](int v) {
    is_settled[v] = true;
    for(int e : surface.vertex_edges[v])
      enter(surface.other_end(e, v), paths.distances[v] + surface.lengths[e], e);
  };
  for(int v : sources)
    enter(v, 0, -1);
  while(!queue.empty()) {
    const auto [distance, v] = queue.top();
    queue.pop();
    if(is_settled[v])
      continue;
    if(is_goal && is_goal(v)) {
      *reached = v;
      break;
    }
    const int group = groups.group_of.empty() ? -1 : groups.group_of[v];
    if(group < 0) {
      settle(v);
      continue;
    }
    for(int member : groups.members[group]) {
      paths.distances[member] = distance;
      if(member != v)
        paths.parent_edges[member] = -1;
    }
    for(int member : groups.members[group])
      settle(member);
  }
  return paths;
}

/// the vertex farthest from the sources of \p paths; ties: lowest
inline int farthest_vertex(const Shortest_paths& paths)
{
  return static_cast<int>(std::max_element(paths.distances.begin(), paths.distances.end()) - paths.distances.begin());
}

/// puts the path that ends at \p v into the cut
inline void insert_path(const Triangle_surface& surface, const Shortest_paths& paths, int v, Cut& cut)
{
  while(paths.parent_edges[v] >= 0) {
    const int e = paths.parent_edges[v];
    cut.insert(surface, e);
    v = surface.other_end(e, v);
  }
}

/// every vertex of the cut and of the border
inline std::vector<int> seam_vertices(const Triangle_surface& surface, const Cut& cut)
{
  std::vector<int> result;
  for(int v = 0; v < surface.number_of_vertices(); ++v)
    if(cut.degree(v) > 0 || surface.is_border_vertex[v])
      result.push_back(v);
  return result;
}

/// makes \p terminal a vertex that the cut must reach, and joins it to the cut or the border by the shortest path.
/// The complement stays a disk: the path is a slit.
inline void connect_terminal(const Triangle_surface& surface, int terminal, Cut& cut)
{
  cut.add_terminal(terminal);
  int reached = terminal;
  const Shortest_paths paths = shortest_paths(
      surface, {terminal}, {}, [&](int v) { return cut.degree(v) > 0 || surface.is_border_vertex[v]; }, &reached);
  insert_path(surface, paths, reached, cut);
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_SHORTEST_PATHS_H
