// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_REROUTE_CUT_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_REROUTE_CUT_H

#include <CGAL_ext/Square_parameterization/internal/Cut.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL_ext {
namespace internal {

/// shortens a cut path by path, and keeps its complement a disk.
///
/// Without one of its paths the complement is an annulus: the path went from one of its two border loops to the other,
/// and the shortest path between the loops takes its place. A loop runs along one side of the cut: which side an edge
/// leaves a vertex of the cut on is noted at its end, for a cut may pass a vertex several times. The loop of a terminal
/// at which the path alone ended is that vertex.
class Cut_rerouting
{
public:
  explicit Cut_rerouting(const Triangle_surface& surface)
    : m_surface(surface),
      m_marks(2 * surface.edges.size(), 0),
      m_distances(surface.points.size(), 0.),
      m_parents(surface.points.size(), -1),
      m_reached_at(surface.points.size(), 0),
      m_settled_at(surface.points.size(), 0)
  {}

  /// longest path first, until no path can be shortened
  void operator()(Cut& cut)
  {
    for(bool is_changed = true; is_changed;) {
      is_changed = false;
      for(const Path& path : paths_longest_first(cut)) {
        // other paths may have taken parts of this one away, or joined it
        const auto left = std::find_if(path.edges.begin(), path.edges.end(), [&](int e) { return cut.contains(e); });
        if(left != path.edges.end() && reroute(path_through(*left, cut), cut))
          is_changed = true;
      }
    }
  }

private:
  /// edges of the cut between two of its nodes
  struct Path
  {
    std::vector<int> edges; ///< in order
    int from, to;
    double length;
  };

  /// an edge that leaves a vertex of the cut and is not in the cut
  struct Exit
  {
    int edge, vertex;
  };

  /// the path of the cut that contains edge \p e
  Path path_through(int e, const Cut& cut) const
  {
    std::vector<int> backward;
    const int from = follow(e, m_surface.edges[e][0], cut, backward);
    Path path{{backward.rbegin(), backward.rend()}, from, m_surface.edges[e][1], 0};
    path.edges.push_back(e);
    path.to = follow(e, m_surface.edges[e][1], cut, path.edges);
    for(int edge : path.edges)
      path.length += m_surface.lengths[edge];
    return path;
  }

  /// walks on from edge \p e beyond its end \p v to the next node, which it returns; puts the edges into \p walked
  int follow(int e, int v, const Cut& cut, std::vector<int>& walked) const
  {
    while(!cut.is_node(m_surface, v)) {
      const auto& incident = m_surface.vertex_edges[v];
      e = *std::find_if(incident.begin(), incident.end(), [&](int next) { return next != e && cut.contains(next); });
      walked.push_back(e);
      v = m_surface.other_end(e, v);
    }
    return v;
  }

  /// the paths that may be changed
  std::vector<Path> paths_longest_first(const Cut& cut) const
  {
    std::vector<Path> paths;
    std::vector<bool> is_visited(m_surface.edges.size(), false);
    for(int e : cut.edges()) {
      if(is_visited[e] || cut.is_fixed(e))
        continue;
      paths.push_back(path_through(e, cut));
      for(int edge : paths.back().edges)
        is_visited[edge] = true;
    }
    std::stable_sort(paths.begin(), paths.end(), [](const Path& a, const Path& b) { return a.length > b.length; });
    return paths;
  }

  /// replaces the path by a shorter one; false when there is none
  bool reroute(const Path& path, Cut& cut)
  {
    constexpr double LEAST_GAIN = 1e-9; // relative: rounding does not count as shorter
    for(int e : path.edges)
      cut.erase(m_surface, e);
    const int first_mark = m_last_mark + 1, second_mark = m_last_mark + 2;
    m_last_mark = second_mark;
    std::vector<Exit> first_loop, second_loop;
    const bool is_first_point = mark_loop(path.from, path.edges.front(), first_mark, cut, first_loop);
    const bool is_second_point = mark_loop(path.to, path.edges.back(), second_mark, cut, second_loop);

    const bool starts_first = first_loop.size() <= second_loop.size();
    Search search{cut, starts_first ? second_mark : first_mark, path.length * (1 - LEAST_GAIN), -1, -1, {}};
    if(is_first_point)
      search.points.push_back(path.from);
    if(is_second_point)
      search.points.push_back(path.to);
    find_shortest(starts_first ? first_loop : second_loop, search);
    if(search.last_edge < 0) {
      for(int e : path.edges)
        cut.insert(m_surface, e);
      return false;
    }
    std::vector<int> shorter{search.last_edge};
    for(int v = search.last_vertex; !is_seam(v, search); v = m_surface.other_end(shorter.back(), v))
      shorter.push_back(m_parents[v]);
    for(int e : shorter)
      cut.insert(m_surface, e);
    return true;
  }

  bool is_boundary(int e, const Cut& cut) const { return cut.contains(e) || m_surface.is_border_edge(e); }

  int& mark(int e, int v) { return m_marks[2 * e + (m_surface.edges[e][1] == v ? 1 : 0)]; }

  /// the halfedge of edge \p e that begins at \p v. \pre the edge is interior
  int leaving_halfedge(int e, int v) const
  {
    const int h = m_surface.edge_halfedges[e];
    return m_surface.origin(h) == v ? h : m_surface.opposites[h];
  }

  /// turns clockwise round the origin of halfedge \p h and marks the exits met, to the first edge of the cut or border,
  /// whose halfedge it returns; -1 when there is none at the vertex
  int mark_sector(int h, int number, const Cut& cut, std::vector<Exit>& exits)
  {
    const int first = h, v = m_surface.origin(h);
    while(!is_boundary(m_surface.edge_of_halfedge[h], cut)) {
      const int e = m_surface.edge_of_halfedge[h];
      mark(e, v) = number;
      exits.push_back({e, v});
      h = Triangle_surface::next(m_surface.opposites[h]);
      if(h == first)
        return -1;
    }
    return h;
  }

  /// marks the exits of the loop that passes \p v where edge \p e leaves; true when the loop is the vertex alone
  bool mark_loop(int v, int e, int number, const Cut& cut, std::vector<Exit>& exits)
  {
    const int first = mark_sector(leaving_halfedge(e, v), number, cut, exits);
    if(first < 0)
      return true;
    exits.clear(); // the walk comes by again
    int h = first;
    do
      h = mark_sector(Triangle_surface::next(h), number, cut, exits);
    while(h != first);
    return false;
  }

  /// the search for the shortest path to the exits of one loop
  struct Search
  {
    const Cut& cut;
    int goal;                ///< mark of the exits to reach
    double bound;            ///< length of the best path so far: longer ones do not count
    int last_edge;           ///< of the best path; -1 when there is none
    int last_vertex;         ///< where the last edge leaves from
    std::vector<int> points; ///< loops that are one vertex
  };

  bool is_seam(int v, const Search& search) const
  {
    return search.cut.degree(v) > 0 || m_surface.is_border_vertex[v] ||
           std::find(search.points.begin(), search.points.end(), v) != search.points.end();
  }

  /// Dijkstra's algorithm from the exits of one loop, through vertices that are not on the cut
  void find_shortest(const std::vector<Exit>& start, Search& search)
  {
    typedef std::pair<double, int> Entry;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    ++m_search_number;
    const auto enter = [&](int from, int e, double length) {
      if(!(length < search.bound))
        return;
      const int v = m_surface.other_end(e, from);
      if(is_seam(v, search)) {
        // two points joined by one edge would leave a border of two vertices
        const bool is_whole_cut = search.points.size() == 2 && is_seam(from, search);
        if(mark(e, v) == search.goal && !is_whole_cut) {
          search.bound = length;
          search.last_edge = e;
          search.last_vertex = from;
        }
      } else if(m_reached_at[v] != m_search_number || length < m_distances[v]) {
        m_reached_at[v] = m_search_number;
        m_distances[v] = length;
        m_parents[v] = e;
        queue.emplace(length, v);
      }
    };
    for(const Exit& exit : start)
      enter(exit.vertex, exit.edge, m_surface.lengths[exit.edge]);
    while(!queue.empty() && queue.top().first < search.bound) {
      const auto [distance, v] = queue.top();
      queue.pop();
      if(m_settled_at[v] == m_search_number)
        continue;
      m_settled_at[v] = m_search_number;
      for(int e : m_surface.vertex_edges[v])
        enter(v, e, distance + m_surface.lengths[e]);
    }
  }

  const Triangle_surface& m_surface;
  std::vector<int> m_marks; // 2 #E: the loop that edge e leaves its first or second end from; old ones do not matter
  int m_last_mark = 0;
  std::vector<double> m_distances;             // #V
  std::vector<int> m_parents;                  // #V
  std::vector<int> m_reached_at, m_settled_at; // #V, the search that came by last
  int m_search_number = 0;
};

/// shortens the cut; see `Cut_rerouting`
inline void reroute_cut(const Triangle_surface& surface, Cut& cut)
{
  Cut_rerouting rerouting(surface);
  rerouting(cut);
}

} // namespace internal
} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_REROUTE_CUT_H
