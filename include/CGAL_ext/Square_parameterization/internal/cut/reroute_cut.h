// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_REROUTE_CUT_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_REROUTE_CUT_H

#include <CGAL_ext/Square_parameterization/internal/cut/cut_paths.h>

#include <algorithm>
#include <array>
#include <functional>
#include <utility>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// shortens a cut path by path, and keeps its complement a disk.
///
/// Without one of its paths the complement is an annulus: the path went from one of its two border loops to the other,
/// and the shortest path between the loops takes its place. A loop runs along one side of the cut: which side an edge
/// leaves a vertex of the cut on is noted at its end, for a cut may pass a vertex several times. The loop of a terminal
/// at which the path alone ended is that vertex.
///
/// The two loops are walked in step, and only until the shorter one is complete: what leaves the cut elsewhere leaves
/// the other. With a hundred handles most paths have a short loop on one side, while the other is most of the cut.
class Cut_rerouting
{
public:
  /// \param is_allowed per vertex, whether shorter paths may pass it; empty for all of them
  Cut_rerouting(const Triangle_surface& surface, std::vector<bool> is_allowed)
    : m_surface(surface),
      m_is_allowed(std::move(is_allowed)),
      m_marks(2 * surface.edges.size(), 0),
      m_distances(surface.points.size(), 0.),
      m_parents(surface.points.size(), -1),
      m_reached_at(surface.points.size(), 0),
      m_settled_at(surface.points.size(), 0),
      m_changed_in(surface.points.size(), -1)
  {}

  /// sweeps until no path can be shortened. After a sweep over all paths come sweeps over those that meet what has
  /// changed; when these change nothing more, all are tried again, so that the last sweep is over all of them.
  void operator()(Cut& cut)
  {
    for(bool tries_all = true;;) {
      const bool is_changed = sweep(cut, tries_all);
      if(!is_changed && tries_all)
        return;
      tries_all = !is_changed;
    }
  }

private:
  typedef std::pair<double, int> Entry; // a distance, and the vertex that has it

  static constexpr double LEAST_GAIN = 1e-9; // relative: rounding does not count as shorter

  /// an edge that leaves a vertex of the cut and is not in the cut
  struct Exit
  {
    int edge, vertex;
  };

  /// a walk along one border loop of the annulus
  struct Loop
  {
    bool is_point;            ///< the loop is one vertex
    int first, last;          ///< halfedges along the loop; equal when the walk has come round
    std::vector<Exit>& exits; ///< met so far
  };

  /// tries to shorten paths, longest first; false when none was
  bool sweep(Cut& cut, bool tries_all)
  {
    bool is_changed = false;
    ++m_sweep;
    for(const Cut_path& path : paths_longest_first(m_surface, cut)) {
      if(!tries_all && !is_recent(path.from) && !is_recent(path.to))
        continue;
      // other paths may have taken parts of this one away, or joined it
      const auto left = std::find_if(path.edges.begin(), path.edges.end(), [&](int e) { return cut.contains(e); });
      if(left != path.edges.end() && reroute(path_through(m_surface, cut, *left), cut))
        is_changed = true;
    }
    return is_changed;
  }

  /// replaces the path by a shorter one; false when there is none
  bool reroute(const Cut_path& path, Cut& cut)
  {
    for(int e : path.edges)
      cut.erase(m_surface, e);
    std::array<Loop, 2> loops{begin_loop(path.from, path.edges.front(), cut, m_exits[0]),
                              begin_loop(path.to, path.edges.back(), cut, m_exits[1])};
    Search search{cut, path.length * (1 - LEAST_GAIN), -1, -1, {}};
    for(int i = 0; i < 2; ++i)
      if(loops[i].is_point)
        search.points.push_back(i == 0 ? path.from : path.to);
    find_shortest(shorter_loop(loops, cut), search);
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
    note_change(path.edges);
    note_change(shorter);
    return true;
  }

  void note_change(const std::vector<int>& edges)
  {
    for(int e : edges)
      for(int v : m_surface.edges[e])
        m_changed_in[v] = m_sweep;
  }

  /// indicates whether the cut has changed at a vertex in this sweep or the one before
  bool is_recent(int v) const { return m_changed_in[v] >= m_sweep - 1; }

  int& mark(int e, int v) { return m_marks[2 * e + (m_surface.edges[e][1] == v ? 1 : 0)]; }

  /// the halfedge of edge \p e that begins at \p v. \pre the edge is interior
  int leaving_halfedge(int e, int v) const
  {
    const int h = m_surface.edge_halfedges[e];
    return m_surface.origin(h) == v ? h : m_surface.opposites[h];
  }

  /// turns clockwise round the origin of halfedge \p h and notes the exits met, to the first edge of the cut or border,
  /// whose halfedge it returns; -1 when there is none at the vertex
  int pass_sector(int h, const Cut& cut, std::vector<Exit>& exits) const
  {
    const int first = h, v = m_surface.origin(h);
    while(m_surface.opposites[h] >= 0 && !cut.contains(m_surface.edge_of_halfedge[h])) {
      exits.push_back({m_surface.edge_of_halfedge[h], v});
      h = Triangle_surface::next(m_surface.opposites[h]);
      if(h == first)
        return -1;
    }
    return h;
  }

  /// the loop that passes \p v where edge \p e leaves, before the first step along it
  /// \param exits where those met are noted
  Loop begin_loop(int v, int e, const Cut& cut, std::vector<Exit>& exits) const
  {
    exits.clear();
    Loop loop{false, -1, -1, exits};
    loop.first = pass_sector(leaving_halfedge(e, v), cut, loop.exits);
    loop.is_point = loop.first < 0;
    if(!loop.is_point)
      loop.exits.clear(); // the walk comes by again
    return loop;
  }

  /// walks both loops until one is complete, and returns its exits
  const std::vector<Exit>& shorter_loop(std::array<Loop, 2>& loops, const Cut& cut) const
  {
    for(const Loop& loop : loops)
      if(loop.is_point)
        return loop.exits;
    while(true) {
      Loop& loop = loops[0].exits.size() <= loops[1].exits.size() ? loops[0] : loops[1];
      const int from = loop.last < 0 ? loop.first : loop.last;
      loop.last = pass_sector(Triangle_surface::next(from), cut, loop.exits);
      if(loop.last == loop.first)
        return loop.exits;
    }
  }

  /// the search for the shortest path to the exits of the other loop
  struct Search
  {
    const Cut& cut;
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

  /// Dijkstra's algorithm from the exits of one loop, through vertices that are not on the cut, to any other exit
  void find_shortest(const std::vector<Exit>& start, Search& search)
  {
    m_queue.clear();
    ++m_search_number;
    for(const Exit& exit : start)
      mark(exit.edge, exit.vertex) = m_search_number;
    const auto enter = [&](int from, int e, double length) {
      if(!(length < search.bound))
        return;
      const int v = m_surface.other_end(e, from);
      if(!m_is_allowed.empty() && !m_is_allowed[v])
        return;
      if(is_seam(v, search)) {
        // two points joined by one edge would leave a border of two vertices
        const bool is_whole_cut = search.points.size() == 2 && is_seam(from, search);
        if(mark(e, v) != m_search_number && !is_whole_cut) {
          search.bound = length;
          search.last_edge = e;
          search.last_vertex = from;
        }
      } else if(m_reached_at[v] != m_search_number || length < m_distances[v]) {
        m_reached_at[v] = m_search_number;
        m_distances[v] = length;
        m_parents[v] = e;
        m_queue.emplace_back(length, v);
        std::push_heap(m_queue.begin(), m_queue.end(), std::greater<Entry>());
      }
    };
    for(const Exit& exit : start)
      enter(exit.vertex, exit.edge, m_surface.lengths[exit.edge]);
    while(!m_queue.empty() && m_queue.front().first < search.bound) {
      const auto [distance, v] = m_queue.front();
      std::pop_heap(m_queue.begin(), m_queue.end(), std::greater<Entry>());
      m_queue.pop_back();
      if(m_settled_at[v] == m_search_number)
        continue;
      m_settled_at[v] = m_search_number;
      for(int e : m_surface.vertex_edges[v])
        enter(v, e, distance + m_surface.lengths[e]);
    }
  }

  const Triangle_surface& m_surface;
  std::vector<bool> m_is_allowed;  // #V, or empty
  std::vector<int> m_marks;        // 2 #E: the last search that began where edge e leaves its first or second end
  std::vector<double> m_distances; // #V
  std::vector<int> m_parents;      // #V
  std::vector<int> m_reached_at, m_settled_at; // #V, the search that came by last
  int m_search_number = 0;
  std::array<std::vector<Exit>, 2> m_exits; // of the two loops; kept from path to path, as the next
  std::vector<Entry> m_queue;               // a heap, the nearest first
  std::vector<int> m_changed_in;            // #V, the last sweep that changed the cut there
  int m_sweep = 0;
};

/// shortens the cut; see `Cut_rerouting`
inline void reroute_cut(const Triangle_surface& surface, Cut& cut, std::vector<bool> is_allowed = {})
{
  Cut_rerouting rerouting(surface, std::move(is_allowed));
  rerouting(cut);
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_REROUTE_CUT_H
