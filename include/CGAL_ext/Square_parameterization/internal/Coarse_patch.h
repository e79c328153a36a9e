// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COARSE_PATCH_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COARSE_PATCH_H

#include <CGAL_ext/Square_parameterization/internal/Patch.h>

#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL_ext {
namespace internal {

/// a patch with fewer interior vertices, and how to get back
struct Coarse_patch
{
  /// a vertex that was taken out, and its neighbors then, counter-clockwise; vertices of the fine patch
  struct Removal
  {
    int vertex;
    std::vector<int> ring;
  };

  Patch patch;
  std::vector<int> fine_vertex;  ///< per vertex of `patch`, the one of the fine patch
  std::vector<Removal> removals; ///< in the order in which they were made
};

/// makes coarse patches: collapses interior vertices into interior neighbors, short edges first, wherever the surface
/// stays a disk and, when it is to keep its shape, does not bend much and gets no sliver. The border and all positions
/// are kept.
class Patch_coarsener
{
public:
  /// \param least_shape_kept a triangle may be thin, but not below this share of the shape of the one that it replaces;
  ///        none when the surface need not keep its shape
  explicit Patch_coarsener(const Patch& fine, std::optional<double> least_shape_kept = 0.7)
    : m_fine(fine),
      m_least_shape_kept(least_shape_kept),
      m_triangles(fine.triangles),
      m_is_alive(fine.triangles.size(), true),
      m_star(fine.points.size()),
      m_is_border(fine.points.size(), false),
      m_is_removed(fine.points.size(), false),
      m_changes(fine.points.size(), 0)
  {
    for(int f = 0; f < fine.number_of_faces(); ++f)
      for(int v : fine.triangles[f])
        m_star[v].push_back(f);
    for(int v : fine.border)
      m_is_border[v] = true;
  }

  /// collapses until \p target vertices are left, or no vertex can go. To be called once.
  /// Throws `Unmappable` when the coarse patch is degenerate.
  Coarse_patch operator()(int target)
  {
    Coarse_patch coarse;
    for(int v = 0; v < m_fine.number_of_vertices(); ++v)
      push_collapses_of(v);
    int count = m_fine.number_of_vertices();
    std::vector<int> ring;
    while(count > target && !m_queue.empty()) {
      const Collapse collapse = m_queue.top();
      m_queue.pop();
      if(m_is_removed[collapse.from] || collapse.changes != m_changes[collapse.from])
        continue; // the neighborhood is not what it was: a newer entry follows
      find_ring(collapse.from, ring);
      if(!may_collapse(collapse.from, collapse.to, ring))
        continue;
      perform(collapse.from, collapse.to);
      --count;
      for(int w : ring) {
        ++m_changes[w];
        push_collapses_of(w);
      }
      coarse.removals.push_back({collapse.from, ring});
    }
    gather(coarse);
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

  void push_collapses_of(int v)
  {
    if(m_is_border[v])
      return;
    for(int f : m_star[v]) { // each neighbor is the next corner of one triangle
      const auto& t = m_triangles[f];
      const int w = t[0] == v ? t[1] : t[1] == v ? t[2] : t[0];
      if(!m_is_border[w])
        m_queue.push({(point(w) - point(v)).squaredNorm() * m_star[v].size(), v, w, m_changes[v]});
    }
  }

  /// the neighbors of an interior vertex, counter-clockwise
  void find_ring(int v, std::vector<int>& ring)
  {
    std::vector<std::pair<int, int>>& sides = m_sides;
    sides.clear();
    for(int f : m_star[v]) {
      const auto& t = m_triangles[f];
      const int k = t[0] == v ? 0 : t[1] == v ? 1 : 2;
      sides.emplace_back(t[(k + 1) % 3], t[(k + 2) % 3]);
    }
    ring.assign(1, sides[0].first);
    for(int next = sides[0].second; next != ring[0];) {
      ring.push_back(next);
      next = std::find_if(sides.begin(), sides.end(), [next](const auto& side) { return side.first == next; })->second;
    }
  }

  bool may_collapse(int from, int to, const std::vector<int>& ring) const
  {
    const std::size_t n = ring.size();
    const std::size_t place = std::find(ring.begin(), ring.end(), to) - ring.begin();
    const int before = ring[(place + n - 1) % n], after = ring[(place + 1) % n];
    // the two ends have no common neighbors but the two opposite corners, which keep three neighbors
    for(int f : m_star[to])
      for(int w : m_triangles[f])
        if(w != from && w != to && w != before && w != after && std::find(ring.begin(), ring.end(), w) != ring.end())
          return false;
    for(int w : {before, after})
      if(m_star[w].size() <= (m_is_border[w] ? 1u : 3u))
        return false;
    if(!m_least_shape_kept)
      return true;
    for(std::size_t i = 1; i + 1 < n; ++i)
      if(!is_good_replacement(from, to, ring[(place + i) % n], ring[(place + i + 1) % n]))
        return false;
    return true;
  }

  /// indicates whether triangle `to, a, b` looks the same way as `from, a, b` and is not much thinner
  bool is_good_replacement(int from, int to, int a, int b) const
  {
    constexpr double LEAST_COSINE = 0.5, LEAST_SHAPE = 0.15;
    const auto normal = [&](int v) { return Eigen::Vector3d((point(a) - point(v)).cross(point(b) - point(v))); };
    const auto shape = [&](int v, double twice_area) { // height over longest side
      return twice_area / (std::max)({(point(a) - point(v)).squaredNorm(), (point(b) - point(v)).squaredNorm(),
                                      (point(b) - point(a)).squaredNorm()});
    };
    const Eigen::Vector3d old_normal = normal(from), new_normal = normal(to);
    const double old_size = old_normal.norm(), new_size = new_normal.norm();
    if(!(new_normal.dot(old_normal) > LEAST_COSINE * new_size * old_size))
      return false;
    const double new_shape = shape(to, new_size);
    return new_shape > LEAST_SHAPE || new_shape > *m_least_shape_kept * shape(from, old_size);
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
    std::vector<int> border;
    for(int v : m_fine.border)
      border.push_back(place[v]);
    coarse.patch = make_patch(std::move(points), std::move(triangles), std::move(border));
  }

  const Patch& m_fine;
  std::optional<double> m_least_shape_kept;
  std::vector<std::array<int, 3>> m_triangles;
  std::vector<bool> m_is_alive;         // per triangle
  std::vector<std::vector<int>> m_star; // per vertex, its triangles
  std::vector<bool> m_is_border, m_is_removed;
  std::vector<std::pair<int, int>> m_sides; // memory of `find_ring()`
  std::vector<int> m_changes;               // per vertex, how often its neighborhood has changed
  std::priority_queue<Collapse, std::vector<Collapse>, std::greater<Collapse>> m_queue;
};

} // namespace internal
} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COARSE_PATCH_H
