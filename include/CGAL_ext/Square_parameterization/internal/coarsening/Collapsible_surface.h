// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COARSENING_COLLAPSIBLE_SURFACE_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COARSENING_COLLAPSIBLE_SURFACE_H

#include <CGAL_ext/Square_parameterization/internal/coarsening/is_good_replacement.h>
#include <CGAL_ext/Square_parameterization/internal/common/Minimizer_numbers.h>
#include <CGAL_ext/Square_parameterization/internal/common/ranges.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// the triangles of a surface while vertices are collapsed into neighbors. Interior vertices far from each other may be
/// collapsed by several threads at a time: to collapse one reads the triangles round its neighbors, and changes what belongs to
/// itself and to its neighbors.
class Collapsible_surface
{
public:
  /// \param points of the vertices, which must live as long
  /// \param borders loops of vertices
  /// \param least_shape_kept, \param keeps_border see `Vertex_collapses`
  Collapsible_surface(const std::vector<Eigen::Vector3d>& points, std::vector<std::array<int, 3>> triangles,
                      const std::vector<std::vector<int>>& borders, std::optional<double> least_shape_kept,
                      bool keeps_border)
    : m_points(points),
      m_least_shape_kept(least_shape_kept),
      m_triangles(std::move(triangles)),
      m_is_alive(m_triangles.size(), true),
      m_star(points.size()),
      m_next(points.size(), -1),
      m_previous(points.size(), -1),
      m_is_removed(points.size(), false),
      m_is_target(points.size(), false)
  {
    find_stars();
    int border_vertices = 0;
    for(const std::vector<int>& border : borders) {
      border_vertices += static_cast<int>(border.size());
      for(std::size_t k = 0; k < border.size(); ++k)
        join(border[k], border[(k + 1) % border.size()]);
    }
    if(!keeps_border)
      m_removable_border_vertices = (std::max)(0, border_vertices - Minimizer_numbers::LEAST_BORDER);
  }

  bool is_removed(int v) const { return m_is_removed[v]; }

  /// the vertices that are left, ascending
  std::vector<int> vertices() const
  {
    std::vector<int> left;
    left.reserve(std::count(m_is_removed.begin(), m_is_removed.end(), false));
    for(std::size_t v = 0; v < m_is_removed.size(); ++v)
      if(!m_is_removed[v])
        left.push_back(static_cast<int>(v));
    return left;
  }

  /// #V, the place of each vertex among those that are left; -1 for one that is not
  std::vector<int> places() const
  {
    std::vector<int> places(m_is_removed.size(), -1);
    int place = 0;
    for(int v : vertices())
      places[v] = place++;
    return places;
  }

  /// the points of the vertices that are left
  std::vector<Eigen::Vector3d> points() const
  {
    std::vector<Eigen::Vector3d> left;
    const std::vector<int> of_vertices = vertices();
    left.reserve(of_vertices.size());
    for(int v : of_vertices)
      left.push_back(point(v));
    return left;
  }

  /// the triangles that are left, in their order
  /// \param place see `places()`
  std::vector<std::array<int, 3>> triangles(const std::vector<int>& place) const
  {
    std::vector<std::array<int, 3>> left;
    left.reserve(std::count(m_is_alive.begin(), m_is_alive.end(), true));
    for(std::size_t f = 0; f < m_triangles.size(); ++f)
      if(m_is_alive[f])
        left.push_back({place[m_triangles[f][0]], place[m_triangles[f][1]], place[m_triangles[f][2]]});
    return left;
  }

  bool is_border(int v) const { return m_next[v] >= 0; }
  std::size_t size_of_star(int v) const { return m_star[v].size(); }

  /// calls `visit(w)` for the neighbors into which a vertex may be collapsed
  template <class Visit>
  void for_each_target(int v, const Visit& visit) const
  {
    if(has_large_star(v))
      return;
    if(is_border(v)) {
      if(m_removable_border_vertices > 0) {
        visit(m_next[v]);
        visit(m_previous[v]);
      }
      return;
    }
    for(int f : m_star[v]) { // each neighbor is the next corner of one triangle
      const auto& t = m_triangles[f];
      const int w = t[0] == v ? t[1] : t[1] == v ? t[2] : t[0];
      if(!is_border(w))
        visit(w);
    }
  }

  /// the neighbors of a vertex, counter-clockwise; from the next to the previous border vertex on the border
  /// \param sides memory of the caller
  void find_ring(int v, std::vector<int>& ring, std::vector<std::pair<int, int>>& sides) const
  {
    sides.clear();
    for(int f : m_star[v]) {
      const auto& t = m_triangles[f];
      const int k = t[0] == v ? 0 : t[1] == v ? 1 : 2;
      sides.emplace_back(t[(k + 1) % 3], t[(k + 2) % 3]);
    }
    const int last = is_border(v) ? m_previous[v] : sides[0].first;
    ring.assign(1, is_border(v) ? m_next[v] : sides[0].first);
    do {
      const int w = ring.back();
      ring.push_back(
          std::find_if(sides.begin(), sides.end(), [w](const auto& side) { return side.first == w; })->second);
    } while(ring.back() != last);
    if(!is_border(v))
      ring.pop_back(); // the first again
  }

  /// indicates whether a vertex with this ring is on the rim of a large fan
  bool is_on_rim(const std::vector<int>& ring) const
  {
    return std::any_of(ring.begin(), ring.end(),
                       [this](int w) { return m_star[w].size() > Minimizer_numbers::LARGEST_FAN; });
  }

  /// indicates whether the surface remains what it is to be when a vertex is collapsed into another one of its ring
  bool may_collapse(int from, int to, const std::vector<int>& ring) const
  {
    const std::size_t n = ring.size();
    const std::size_t place = std::find(ring.begin(), ring.end(), to) - ring.begin();
    // the corners opposite to the edge: on the border only one
    const int before = is_border(from) && place == 0 ? to : ring[(place + n - 1) % n];
    const int after = is_border(from) && place + 1 == n ? to : ring[(place + 1) % n];
    if(is_border(from) && (m_removable_border_vertices == 0 || m_is_target[from] || m_is_target[to] ||
                           has_large_star(to) || has_border_vertex_inside(ring)))
      return false;
    // the opposite corners keep three neighbors, and the two ends have no other common neighbors
    for(int w : {before, after})
      if(w != to && m_star[w].size() <= (is_border(w) ? 1u : 3u))
        return false;
    for(int w : ring)
      if(w != to && w != before && w != after && are_neighbors(w, to))
        return false;
    return !m_least_shape_kept || keeps_shape(from, to, ring);
  }

  /// \pre `may_collapse()`
  void perform(int from, int to)
  {
    for(int f : m_star[from]) {
      auto& t = m_triangles[f];
      if(std::find(t.begin(), t.end(), to) == t.end()) {
        std::replace(t.begin(), t.end(), from, to);
        m_star[to].push_back(f);
        continue;
      }
      m_is_alive[f] = false;
      for(int w : t)
        if(w != from)
          m_star[w].erase(std::find(m_star[w].begin(), m_star[w].end(), f));
    }
    m_star[from].clear();
    m_is_removed[from] = true;
    if(is_border(from)) {
      m_is_target[to] = true;
      join(m_previous[from], m_next[from]);
      --m_removable_border_vertices;
    }
  }

private:
  /// finds the triangles of each vertex, ascending
  void find_stars()
  {
    std::vector<int> sizes(m_star.size(), 0);
    for(const auto& t : m_triangles)
      for(int v : t)
        ++sizes[v];
    for_ranges(m_star.size(), [&](std::size_t begin, std::size_t end) {
      for(std::size_t v = begin; v < end; ++v)
        m_star[v].reserve(sizes[v] + 2); // a collapse into the vertex adds two, mostly
    });
    for(std::size_t f = 0; f < m_triangles.size(); ++f)
      for(int v : m_triangles[f])
        m_star[v].push_back(static_cast<int>(f));
  }

  const Eigen::Vector3d& point(int v) const { return m_points[v]; }

  void join(int v, int next)
  {
    m_next[v] = next;
    m_previous[next] = v;
  }

  /// looks at the smaller of the two stars: one may be a fan of thousands
  bool are_neighbors(int v, int w) const
  {
    const auto [of_smaller, other] = m_star[v].size() < m_star[w].size() ? std::pair(v, w) : std::pair(w, v);
    return std::any_of(m_star[of_smaller].begin(), m_star[of_smaller].end(), [this, vertex = other](int f) {
      const auto& t = m_triangles[f];
      return t[0] == vertex || t[1] == vertex || t[2] == vertex;
    });
  }

  bool has_large_star(int v) const { return m_star[v].size() > Minimizer_numbers::LARGEST_STAR; }

  /// indicates whether a border vertex has chords, or only one triangle: the edge that would remain is a chord
  bool has_border_vertex_inside(const std::vector<int>& ring) const
  {
    return ring.size() < 3 || std::any_of(ring.begin() + 1, ring.end() - 1, [this](int w) { return is_border(w); });
  }

  bool keeps_shape(int from, int to, const std::vector<int>& ring) const
  {
    const std::size_t n = ring.size();
    for(std::size_t i = is_border(from) ? 1 : 0; i < n; ++i) {
      const int a = ring[(i + n - 1) % n], b = ring[i];
      if(a != to && b != to && !is_good_replacement(point(from), point(to), point(a), point(b), *m_least_shape_kept))
        return false;
    }
    return true;
  }

  const std::vector<Eigen::Vector3d>& m_points;
  std::optional<double> m_least_shape_kept;
  int m_removable_border_vertices = 0;
  std::vector<std::array<int, 3>> m_triangles;
  std::vector<char> m_is_alive;         // per triangle
  std::vector<std::vector<int>> m_star; // per vertex, its triangles
  std::vector<int> m_next, m_previous;  // per border vertex, its neighbors on the border; else -1
  std::vector<char> m_is_removed;
  std::vector<char> m_is_target; // of the removal of a border vertex: so that there is room to put that back
};

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COARSENING_COLLAPSIBLE_SURFACE_H
