// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_SWEEP_ORDER_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_SWEEP_ORDER_H

#include <CGAL_ext/Square_parameterization/internal/patch/Incident_corners.h>
#include <CGAL_ext/Square_parameterization/internal/patch/Patch.h>
#include <CGAL_ext/Square_parameterization/internal/patch/Patch_division.h>

#include <algorithm>
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
/// O(#V log #V + #F).
class Sweep_order
{
public:
  /// vertices of a batch, at most: enough to keep a processor busy that works ahead
  static constexpr int LARGEST_BATCH = 8;

  Sweep_order(const Patch& patch, const Patch_division& division, const Incident_corners& corners)
    : m_vertices(division.order()), m_end_of_batch(m_vertices.size())
  {
    const std::vector<int> waves = waves_of(patch, division, corners);
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
  static std::vector<int> waves_of(const Patch& patch, const Patch_division& division, const Incident_corners& corners)
  {
    std::vector<int> waves(patch.points.size(), 0);
    for(int rank = 0; rank < division.separators().begin; ++rank) {
      const int v = division.vertex(rank);
      for(const Incident_corners::Corner& corner : corners[v])
        for(int w : patch.triangles[corner.triangle])
          if(division.rank(w) < rank)
            waves[v] = (std::max)(waves[v], waves[w] + 1);
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
