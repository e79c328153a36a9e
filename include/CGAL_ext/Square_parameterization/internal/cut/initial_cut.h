// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_INITIAL_CUT_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_INITIAL_CUT_H

#include <CGAL_ext/Square_parameterization/internal/common/Disjoint_sets.h>
#include <CGAL_ext/Square_parameterization/internal/cut/shortest_paths.h>

#include <algorithm>
#include <numeric>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// leaves in the cut every interior edge that a tree of the faces does not cross, and prunes it.
///
/// The tree crosses edges of the largest weight first (Kruskal), and none of \p is_barrier nor any that is fixed: the
/// faces unfold along it to a disk, whatever the weights. \pre the faces stay connected without the barriers
inline void cut_beside_face_tree(const Triangle_surface& surface, const std::vector<double>& weights,
                                 const std::vector<bool>& is_barrier, Cut& cut)
{
  std::vector<int> order;
  for(int e = 0; e < surface.number_of_edges(); ++e)
    if(!surface.is_border_edge(e))
      order.push_back(e);
  std::stable_sort(order.begin(), order.end(), [&weights](int a, int b) { return weights[a] > weights[b]; });
  Disjoint_sets faces(surface.triangles.size());
  for(int e : order) {
    const int h = surface.edge_halfedges[e];
    const int f = h / 3, g = surface.opposites[h] / 3;
    if(!is_barrier[e] && !cut.is_fixed(e) && faces.find_set(f) != faces.find_set(g))
      faces.union_set(f, g);
    else
      cut.insert(surface, e);
  }
  prune(surface, cut);
}

/// per edge, the length of the shortest path from the sources to it, over it, and back
inline std::vector<double> lengths_through_edges(const Triangle_surface& surface, const Shortest_paths& paths)
{
  std::vector<double> lengths;
  for(int e = 0; e < surface.number_of_edges(); ++e)
    lengths.push_back(paths.distances[surface.edges[e][0]] + paths.distances[surface.edges[e][1]] + surface.lengths[e]);
  return lengths;
}

/// the connected pieces of the border and of the fixed edges of the cut
inline Vertex_groups seam_groups(const Triangle_surface& surface, const Cut& cut)
{
  Disjoint_sets pieces(surface.points.size());
  Vertex_groups groups{std::vector<int>(surface.points.size(), -1), {}};
  std::vector<bool> is_on_seam(surface.is_border_vertex);
  for(int e = 0; e < surface.number_of_edges(); ++e)
    if(surface.is_border_edge(e) || cut.is_fixed(e)) {
      pieces.union_set(surface.edges[e][0], surface.edges[e][1]);
      is_on_seam[surface.edges[e][0]] = is_on_seam[surface.edges[e][1]] = true;
    }
  for(int v = 0; v < surface.number_of_vertices(); ++v) {
    if(!is_on_seam[v])
      continue;
    int& group = groups.group_of[pieces.find_set(v)];
    if(group < 0) {
      group = static_cast<int>(groups.members.size());
      groups.members.emplace_back();
    }
    const int number = group; // `group` may be the entry of `v` itself
    groups.group_of[v] = number;
    groups.members[number].push_back(v);
  }
  return groups;
}

/// a vertex of the longest border loop, or of a fixed edge when there is no border; -1 when there is neither
inline int natural_root(const Triangle_surface& surface, const Cut& cut)
{
  double longest = -1;
  int root = -1;
  for(const auto& loop : surface.border_loops) {
    double length = 0;
    for(std::size_t k = 0; k < loop.size(); ++k)
      length += (surface.points[loop[(k + 1) % loop.size()]] - surface.points[loop[k]]).norm();
    if(length > longest) {
      longest = length;
      root = loop[0];
    }
  }
  for(int v = 0; root < 0 && v < surface.number_of_vertices(); ++v)
    if(cut.degree(v) > 0)
      root = v;
  return root;
}

/// cuts a sphere along a path between two vertices far from each other, of at least two edges: cut along one edge alone
/// it would have a border of two vertices. The fixed edges, if any, are begun with.
inline void cut_sphere(const Triangle_surface& surface, Cut& cut)
{
  std::vector<int> path_start = seam_vertices(surface, cut);
  if(path_start.empty()) {
    const int first = farthest_vertex(shortest_paths(surface, {0}));
    const Shortest_paths paths = shortest_paths(surface, {first});
    const int last = farthest_vertex(paths);
    insert_path(surface, paths, last, cut);
    cut.add_terminal(first);
    cut.add_terminal(last);
    path_start = {last};
  }
  if(cut.edges().size() >= 2)
    return;
  // one edge: go on from its end along the longest edge there
  const int end = path_start.back();
  int best = -1;
  for(int e : surface.vertex_edges[end])
    if(!cut.contains(e) && (best < 0 || surface.lengths[e] > surface.lengths[best]))
      best = e;
  cut.remove_terminal(end);
  cut.insert(surface, best);
  cut.add_terminal(surface.other_end(best, end));
}

/// cuts the surface to a disk: adds what is missing to the fixed edges of \p cut.
///
/// The cut consists of the edges that are neither in the cotree nor on the border, less the loose ends. The tree is
/// that of Dijkstra from \p root, with every border loop and every piece of fixed edges as one node: else equal
/// distances let the tree enter a hole twice. The cotree, of faces, is the heaviest that does not cross the tree, by
/// d(u) + d(v) + length: the cut then consists of the shortest loops through the root (Erickson and Whittlesey 2005).
/// \param root where the tree starts on a closed surface; a border or a fixed edge goes before it
/// \pre the fixed edges do not separate the surface
inline void initial_cut(const Triangle_surface& surface, int root, Cut& cut)
{
  const int natural = natural_root(surface, cut);
  const Shortest_paths paths = shortest_paths(surface, {natural >= 0 ? natural : root}, seam_groups(surface, cut));
  std::vector<bool> is_in_tree(surface.edges.size(), false);
  for(int e : paths.parent_edges)
    if(e >= 0)
      is_in_tree[e] = true;
  cut_beside_face_tree(surface, lengths_through_edges(surface, paths), is_in_tree, cut);
  if(surface.border_loops.empty() && cut.edges().size() < 2)
    cut_sphere(surface, cut);
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_INITIAL_CUT_H
