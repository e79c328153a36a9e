// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COARSENING_VERTEX_COLLAPSES_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COARSENING_VERTEX_COLLAPSES_H

#include <CGAL_ext/Square_parameterization/internal/coarsening/Coarse_patch.h>
#include <CGAL_ext/Square_parameterization/internal/coarsening/Collapsible_surface.h>
#include <CGAL_ext/Square_parameterization/internal/common/Minimizer_numbers.h>
#include <CGAL_ext/Square_parameterization/internal/common/ranges.h>

#include <algorithm>
#include <array>
#include <cstddef>
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

/// waves in which vertices are put back, one after the other, at most. Vertices of one wave are not in each other's way; those
/// of a chain, of which each was in the ring of the next, make triangles thinner and thinner.
struct Most_waves
{
  int on_rims = (std::numeric_limits<int>::max)(); ///< of large fans
  int anywhere = (std::numeric_limits<int>::max)();
};

/// collapses interior vertices into interior neighbors, short edges first, wherever the topology stays what it is and the
/// surface, when it is to keep its shape, does not bend much and gets no sliver. All positions are kept, and so is the
/// border, unless border vertices may be collapsed into their neighbors on the border, too; no chord is made.
///
/// On large surfaces most of the vertices are collapsed in blocks, with the threads of the current team: in each those whose
/// neighbors are in the same block, up to a common cost. The blocks, and so what is left, do not depend on the number of
/// threads.
class Vertex_collapses
{
public:
  /// \param points of the vertices, which must live as long
  /// \param borders loops of vertices
  /// \param least_shape_kept a triangle may be thin, but not below this share of the shape of the one that it replaces;
  ///        none when the surface need not keep its shape
  /// \param keeps_border indicates whether border vertices stay; where they do not there is one border
  Vertex_collapses(const std::vector<Eigen::Vector3d>& points, std::vector<std::array<int, 3>> triangles,
                   const std::vector<std::vector<int>>& borders, std::optional<double> least_shape_kept,
                   bool keeps_border, const Most_waves& most_waves)
    : m_points(points),
      m_keeps_border(keeps_border),
      m_most_waves(most_waves),
      m_surface(points, std::move(triangles), borders, least_shape_kept, keeps_border),
      m_waves(points.size(), 0),
      m_changes(points.size(), 0)
  {}

  /// collapses until \p target vertices are left, or no vertex can go. To be called once.
  /// \param curve #V, vertices of which those that follow each other are near each other; none when there are to be no
  ///        blocks
  /// \param vertices_at_a_time of a block; a surface that has no more than twice as many is not divided
  /// \param coarse gets the removals
  void operator()(int target, const std::vector<int>& curve, int vertices_at_a_time, Coarse_patch& coarse)
  {
    const auto to_remove = [&] {
      return static_cast<int>(m_points.size()) - target - static_cast<int>(coarse.removals.size());
    };
    if(m_keeps_border && static_cast<int>(curve.size()) > 2 * vertices_at_a_time)
      for(const bool is_shifted : {false, true})
        collapse_in_blocks(curve, vertices_at_a_time, is_shifted ? vertices_at_a_time / 2 : 0, to_remove(), coarse);
    Run run; // of what is left
    run.queue = Queue(std::greater<Collapse>(), cheapest_collapses());
    collapse(run, to_remove());
    coarse.append_removals(std::move(run.made));
  }

  /// what is left
  const Collapsible_surface& surface() const { return m_surface; }

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
  typedef std::priority_queue<Collapse, std::vector<Collapse>, std::greater<Collapse>> Queue;

  /// what one thread collapses
  struct Run
  {
    Queue queue;
    Coarse_patch made; // its removals alone
    double largest_cost = std::numeric_limits<double>::infinity();
    int block = NO_BLOCK;                   // that has all the neighbors
    std::vector<int> ring, target_ring;     // memory
    std::vector<std::pair<int, int>> sides; // memory
  };
  static constexpr int NO_BLOCK = -1;

  /// collapses at most so many vertices
  void collapse(Run& run, int most)
  {
    while(static_cast<int>(run.made.removals.size()) < most && !run.queue.empty()) {
      const Collapse next = run.queue.top();
      if(next.cost > run.largest_cost)
        return;
      run.queue.pop();
      if(m_surface.is_removed(next.from) || next.changes != m_changes[next.from])
        continue; // the neighborhood is not what it was: a newer entry follows
      m_surface.find_ring(next.from, run.ring, run.sides);
      if(!is_in_block(run) || is_late(next.from, run.ring))
        continue;
      if(!m_surface.may_collapse(next.from, next.to, run.ring)) {
        push_next(run, next);
        continue;
      }
      run.target_ring.clear();
      if(m_surface.is_border(next.from))
        m_surface.find_ring(next.to, run.target_ring, run.sides);
      m_surface.perform(next.from, next.to);
      for(int w : run.ring) {
        m_waves[w] = (std::max)(m_waves[w], m_waves[next.from] + 1);
        ++m_changes[w];
        push_next(run, {-1, w, -1, 0});
      }
      run.made.add_removal(next.from, next.to, run.ring, run.target_ring);
    }
  }

  bool is_in_block(const Run& run) const
  {
    return run.block == NO_BLOCK ||
           std::all_of(run.ring.begin(), run.ring.end(), [this, &run](int w) { return m_block_of[w] == run.block; });
  }

  /// indicates whether a vertex would be put back in too late a wave
  bool is_late(int v, const std::vector<int>& ring) const
  {
    return m_waves[v] >= m_most_waves.anywhere || (m_waves[v] >= m_most_waves.on_rims && m_surface.is_on_rim(ring));
  }

  /// collapses most of the vertices that are to be removed, in blocks of the curve
  /// \param size of a block, \param shift the first block has so many vertices less
  void collapse_in_blocks(const std::vector<int>& curve, int size, int shift, int to_remove, Coarse_patch& coarse)
  {
    m_block_of.resize(curve.size());
    for(std::size_t i = 0; i < curve.size(); ++i)
      m_block_of[curve[i]] = (static_cast<int>(i) + shift) / size;
    std::vector<Collapse> collapses = cheapest_collapses();
    const int most = static_cast<int>(Minimizer_numbers::SHARE_COARSENED_IN_BLOCKS * to_remove);
    if(most <= 0 || most >= static_cast<int>(collapses.size()))
      return; // nothing is to be removed, or hardly more can be
    const auto last = collapses.begin() + most;
    std::nth_element(collapses.begin(), last, collapses.end(),
                     [](const Collapse& a, const Collapse& b) { return b > a; });
    std::vector<std::vector<Collapse>> of_block(m_block_of[curve.back()] + 1);
    for(auto c = collapses.begin(); c != last; ++c)
      of_block[m_block_of[c->from]].push_back(*c);
    std::vector<Run> runs(of_block.size());
    Thread_team::current()(runs.size(), [&](std::size_t b) {
      const int most_of_block = static_cast<int>(of_block[b].size());
      runs[b].block = static_cast<int>(b);
      runs[b].largest_cost = last->cost;
      runs[b].queue = Queue(std::greater<Collapse>(), std::move(of_block[b]));
      collapse(runs[b], most_of_block);
      runs[b].queue = Queue();
    });
    for(Run& run : runs)
      coarse.append_removals(std::move(run.made));
  }

  /// the cheapest collapses of all vertices: which comes first does not depend on their order
  std::vector<Collapse> cheapest_collapses() const
  {
    std::vector<Collapse> collapses(m_points.size());
    for_ranges(collapses.size(), [&](std::size_t begin, std::size_t end) {
      for(std::size_t v = begin; v < end; ++v)
        collapses[v] = next_of({-1, static_cast<int>(v), -1, 0});
    });
    collapses.erase(std::remove_if(collapses.begin(), collapses.end(), [](const Collapse& c) { return c.to < 0; }),
                    collapses.end());
    return collapses;
  }

  /// enters the collapse of a vertex that comes after another one of it, first its cheapest; those that cost more wait until
  /// it turns out to be impossible
  void push_next(Run& run, const Collapse& previous) const
  {
    const Collapse next = next_of(previous);
    if(next.to >= 0)
      run.queue.push(next);
  }

  /// the collapse of a vertex that comes after another one of it; into -1 when there is none
  Collapse next_of(const Collapse& previous) const
  {
    const int from = previous.from;
    const double triangles = // the border has half stars
        (m_surface.is_border(from) ? 2. : 1.) * double(m_surface.size_of_star(from));
    Collapse next{std::numeric_limits<double>::infinity(), from, -1, m_changes[from]};
    m_surface.for_each_target(from, [&](int to) {
      const double cost = (m_points[to] - m_points[from]).squaredNorm() * triangles;
      const Collapse collapse{cost, from, to, m_changes[from]};
      if(collapse > previous && (next.to < 0 || next > collapse))
        next = collapse;
    });
    return next;
  }

  const std::vector<Eigen::Vector3d>& m_points;
  const bool m_keeps_border;
  const Most_waves m_most_waves;
  Collapsible_surface m_surface;
  std::vector<int> m_waves;    // per vertex, the waves in which others are put back after it, were it the next to go
  std::vector<int> m_changes;  // per vertex, how often its neighborhood has changed
  std::vector<int> m_block_of; // per vertex
};

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COARSENING_VERTEX_COLLAPSES_H
