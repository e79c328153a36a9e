// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COARSENING_PATCH_COARSENER_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COARSENING_PATCH_COARSENER_H

#include <CGAL_ext/Square_parameterization/internal/coarsening/Coarse_patch.h>
#include <CGAL_ext/Square_parameterization/internal/coarsening/is_good_replacement.h>
#include <CGAL_ext/Square_parameterization/internal/common/Minimizer_numbers.h>
#include <CGAL_ext/Square_parameterization/internal/common/ranges.h>

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <optional>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// makes coarse patches: collapses interior vertices into interior neighbors, short edges first, wherever the surface
/// stays a disk and, when it is to keep its shape, does not bend much and gets no sliver. All positions are kept, and
/// so is the border, unless border vertices may be collapsed into their neighbors on the border, too; no chord is made.
class Patch_coarsener
{
public:
  /// \param least_shape_kept a triangle may be thin, but not below this share of the shape of the one that it replaces;
  ///        none when the surface need not keep its shape
  /// \param keeps_border indicates whether border vertices stay
  /// \param most_waves in which vertices on the rims of large fans are put back
  explicit Patch_coarsener(const Patch& fine, std::optional<double> least_shape_kept = Minimizer_numbers::SHAPE_KEPT,
                           bool keeps_border = true, int most_waves = (std::numeric_limits<int>::max)())
    : m_fine(fine),
      m_least_shape_kept(least_shape_kept),
      m_removable_border_vertices(
          keeps_border ? 0 : (std::max)(0, static_cast<int>(fine.border.size()) - Minimizer_numbers::LEAST_BORDER)),
      m_triangles(fine.triangles),
      m_is_alive(fine.triangles.size(), true),
      m_star(fine.points.size()),
      m_next(fine.points.size(), -1),
      m_previous(fine.points.size(), -1),
      m_is_removed(fine.points.size(), false),
      m_is_target(fine.points.size(), false),
      m_most_waves(most_waves),
      m_waves(fine.points.size(), 0),
      m_changes(fine.points.size(), 0)
  {
    for(int f = 0; f < fine.number_of_faces(); ++f)
      for(int v : fine.triangles[f])
        m_star[v].push_back(f);
    for(std::size_t k = 0; k < fine.border.size(); ++k)
      join(fine.border[k], fine.border[(k + 1) % fine.border.size()]);
  }

  /// collapses until \p target vertices are left, or no vertex can go. To be called once.
  /// Throws `Unmappable` when the coarse patch is degenerate.
  Coarse_patch operator()(int target)
  {
    Coarse_patch coarse;
    enter_all();
    int count = m_fine.number_of_vertices();
    coarse.removals.reserve((std::max)(0, count - target));
    std::vector<int> ring, target_ring;
    while(count > target && !m_queue.empty()) {
      const Collapse collapse = m_queue.top();
      m_queue.pop();
      if(m_is_removed[collapse.from] || collapse.changes != m_changes[collapse.from])
        continue; // the neighborhood is not what it was: a newer entry follows
      find_ring(collapse.from, ring);
      if(m_waves[collapse.from] >= m_most_waves && is_on_rim(ring))
        continue;
      if(!may_collapse(collapse.from, collapse.to, ring)) {
        push_next(collapse);
        continue;
      }
      target_ring.clear();
      if(is_border(collapse.from))
        find_ring(collapse.to, target_ring);
      perform(collapse.from, collapse.to);
      --count;
      for(int w : ring) {
        m_waves[w] = (std::max)(m_waves[w], m_waves[collapse.from] + 1);
        ++m_changes[w];
        push_cheapest(w);
      }
      coarse.add_removal(collapse.from, collapse.to, ring, target_ring);
    }
    gather(coarse);
    coarse.waves = waves_of(coarse, m_fine.number_of_vertices());
    return coarse;
  }

private:
  struct Collapse
  {
    double cost;
    int from, to, changes;

    bool operator>(const Collapse& other) const
    {
      return std::tie(cost, from, to) > std::tie(other.cost, other.from, other.to);
    }
  };

  const Eigen::Vector3d& point(int v) const { return m_fine.points[v]; }

  bool is_border(int v) const { return m_next[v] >= 0; }

  void join(int v, int next)
  {
    m_next[v] = next;
    m_previous[next] = v;
  }

  /// indicates whether a vertex with this ring is on the rim of a large fan
  bool is_on_rim(const std::vector<int>& ring) const
  {
    return std::any_of(ring.begin(), ring.end(),
                       [this](int w) { return m_star[w].size() > Minimizer_numbers::LARGEST_FAN; });
  }

  bool has_large_star(int v) const { return m_star[v].size() > Minimizer_numbers::LARGEST_STAR; }

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

  /// enters the cheapest collapses of all vertices, with the threads of the current team: which comes first does not
  /// depend on the order in which they are entered
  void enter_all()
  {
    std::vector<Collapse> collapses(m_fine.points.size());
    for_ranges(collapses.size(), [&](std::size_t begin, std::size_t end) {
      for(std::size_t v = begin; v < end; ++v)
        collapses[v] = next_of({-1, static_cast<int>(v), -1, 0});
    });
    collapses.erase(std::remove_if(collapses.begin(), collapses.end(), [](const Collapse& c) { return c.to < 0; }),
                    collapses.end());
    m_queue = decltype(m_queue)(std::greater<Collapse>(), std::move(collapses));
  }

  /// enters the cheapest collapse of a vertex; those that cost more wait until it turns out to be impossible
  void push_cheapest(int from) { push_next({-1, from, -1, 0}); }

  /// enters the collapse of a vertex that comes after another one of it
  void push_next(const Collapse& previous)
  {
    const Collapse next = next_of(previous);
    if(next.to >= 0)
      m_queue.push(next);
  }

  /// the collapse of a vertex that comes after another one of it; into -1 when there is none
  Collapse next_of(const Collapse& previous) const
  {
    const int from = previous.from;
    const double triangles = (is_border(from) ? 2. : 1.) * double(m_star[from].size()); // the border has half stars
    Collapse next{std::numeric_limits<double>::infinity(), from, -1, m_changes[from]};
    for_each_target(from, [&](int to) {
      const Collapse collapse{(point(to) - point(from)).squaredNorm() * triangles, from, to, m_changes[from]};
      if(collapse > previous && (next.to < 0 || next > collapse))
        next = collapse;
    });
    return next;
  }

  /// the neighbors of a vertex, counter-clockwise; from the next to the previous border vertex on the border
  void find_ring(int v, std::vector<int>& ring)
  {
    std::vector<std::pair<int, int>>& sides = m_sides;
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
    // the two ends have no common neighbors but the opposite corners, which keep three neighbors
    for(int f : m_star[to])
      for(int w : m_triangles[f])
        if(w != from && w != to && w != before && w != after && std::find(ring.begin(), ring.end(), w) != ring.end())
          return false;
    for(int w : {before, after})
      if(w != to && m_star[w].size() <= (is_border(w) ? 1u : 3u))
        return false;
    return !m_least_shape_kept || keeps_shape(from, to, ring);
  }

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

  void gather(Coarse_patch& coarse) const
  {
    std::vector<int> place(m_fine.points.size(), -1);
    std::vector<Eigen::Vector3d> points;
    for(int v = 0; v < m_fine.number_of_vertices(); ++v)
      if(!m_is_removed[v]) {
        place[v] = static_cast<int>(points.size());
        points.push_back(point(v));
        coarse.fine_vertex.push_back(v);
      }
    std::vector<std::array<int, 3>> triangles;
    for(std::size_t f = 0; f < m_triangles.size(); ++f)
      if(m_is_alive[f])
        triangles.push_back({place[m_triangles[f][0]], place[m_triangles[f][1]], place[m_triangles[f][2]]});
    coarse.patch = make_patch(std::move(points), std::move(triangles), gather_border(place, coarse));
  }

  /// the border of the coarse patch; tells the patch of the fine one
  /// \param place of the vertices that are left, in the coarse patch
  std::vector<int> gather_border(const std::vector<int>& place, Coarse_patch& coarse) const
  {
    std::vector<int> border, place_on_border(m_fine.points.size(), -1), removal(m_fine.points.size(), -1);
    for(std::size_t k = 0; k < m_fine.border.size(); ++k)
      if(const int v = m_fine.border[k]; !m_is_removed[v]) {
        place_on_border[v] = static_cast<int>(border.size());
        border.push_back(place[v]);
        coarse.fine_places.push_back(static_cast<int>(k));
      }
    for(std::size_t i = 0; i < coarse.removals.size(); ++i)
      removal[coarse.removals[i].vertex] = static_cast<int>(i);
    for(int v : m_fine.border) // what it was collapsed into is left: a target stays
      coarse.fine_border.push_back(
          {place_on_border[removal[v] < 0 ? v : coarse.removals[removal[v]].target], removal[v]});
    return border;
  }

  const Patch& m_fine;
  std::optional<double> m_least_shape_kept;
  int m_removable_border_vertices;
  std::vector<std::array<int, 3>> m_triangles;
  std::vector<bool> m_is_alive;         // per triangle
  std::vector<std::vector<int>> m_star; // per vertex, its triangles
  std::vector<int> m_next, m_previous;  // per border vertex, its neighbors on the border; else -1
  std::vector<bool> m_is_removed;
  std::vector<bool> m_is_target; // of the removal of a border vertex: so that there is room to put that back
  const int m_most_waves;
  std::vector<int> m_waves; // per vertex, the waves in which others are put back after it, were it the next to go
  std::vector<std::pair<int, int>> m_sides; // memory of `find_ring()`
  std::vector<int> m_changes;               // per vertex, how often its neighborhood has changed
  std::priority_queue<Collapse, std::vector<Collapse>, std::greater<Collapse>> m_queue;
};

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COARSENING_PATCH_COARSENER_H
