// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_SWEEP_ORDER_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_SWEEP_ORDER_H

#include <CGAL_ext/Square_parameterization/internal/patch/Patch.h>
#include <CGAL_ext/Square_parameterization/internal/patch/Patch_division.h>

#include <algorithm>
#include <numeric>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// the order in which a sweep visits the vertices of a patch: in batches of vertices without edges between them, which
/// can be visited at the same time. Each block of the division, and each color of its separators, has the places of its
/// ranks.
///
/// Of two neighbors the one with the lower rank is still visited first, so that the map is that of a sweep in the order
/// of ranks. Where each vertex is a neighbor of the one before, as round the rings of a cone, batches have one vertex.
/// O(#V log #V + #E).
class Sweep_order
{
public:
  /// vertices of a batch, at most: enough to keep a processor busy that works ahead
  static constexpr int LARGEST_BATCH = 8;

  /// \pre the patch has its edges
  Sweep_order(const Patch& patch, const Patch_division& division)
    : m_vertices(division.order()), m_end_of_batch(m_vertices.size())
  {
    const std::vector<int> waves = waves_of(patch, division);
    for(int b = 0; b < division.number_of_blocks(); ++b) {
      const Patch_division::Range ranks = division.block(b);
      std::stable_sort(m_vertices.begin() + ranks.begin, m_vertices.begin() + ranks.end,
                       [&waves](int v, int w) { return waves[v] < waves[w]; });
      end_batches(ranks, waves);
    }
    for(const Patch_division::Range& color : division.colors())
      end_batches(color, waves);
  }

  int vertex(int place) const { return m_vertices[place]; }

  /// one after the last place of the batch
  int end_of_batch(int place) const { return m_end_of_batch[place]; }

private:
  /// per vertex of a block the number of the wave in which it may be visited: the one after those of all neighbors with
  /// lower ranks. 0 for separators, which have no neighbors in their colors.
  static std::vector<int> waves_of(const Patch& patch, const Patch_division& division)
  {
    const int end = division.separators().begin;
    // for each rank the higher ones of its neighbors
    std::vector<int> first(end + 1, 0);
    const auto for_edges_in_blocks = [&](const auto& visit) {
      for(const auto& [a, b] : patch.edges) {
        const auto [low, high] = std::minmax({division.rank(a), division.rank(b)});
        if(high < end)
          visit(low, high);
      }
    };
    for_edges_in_blocks([&](int low, int) { ++first[low + 1]; });
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<int> higher(first.back()), next(first.begin(), first.end() - 1);
    for_edges_in_blocks([&](int low, int high) { higher[next[low]++] = high; });

    std::vector<int> waves(patch.points.size(), 0);
    for(int rank = 0; rank < end; ++rank) {
      const int wave = waves[division.vertex(rank)];
      for(int i = first[rank]; i < first[rank + 1]; ++i) {
        int& of_neighbor = waves[division.vertex(higher[i])];
        of_neighbor = (std::max)(of_neighbor, wave + 1);
      }
    }
    return waves;
  }

  void end_batches(Patch_division::Range places, const std::vector<int>& waves)
  {
    for(int begin = places.begin, end; begin < places.end; begin = end) {
      end = begin + 1;
      while(end < places.end && end - begin < LARGEST_BATCH && waves[vertex(end)] == waves[vertex(begin)])
        ++end;
      std::fill(m_end_of_batch.begin() + begin, m_end_of_batch.begin() + end, end);
    }
  }

  std::vector<int> m_vertices;     // #V
  std::vector<int> m_end_of_batch; // #V: by place
};

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_SWEEP_ORDER_H
