// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COARSENING_COARSE_PATCH_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COARSENING_COARSE_PATCH_H

#include <CGAL_ext/Square_parameterization/internal/patch/Patch.h>

#include <algorithm>
#include <cstddef>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// a patch with fewer vertices, and how to get back
struct Coarse_patch
{
  /// a vertex that was taken out: collapsed into one of its neighbors. All are vertices of the fine patch.
  struct Removal
  {
    int vertex, target;
    std::vector<int> ring; ///< the neighbors of the vertex then, counter-clockwise; from the next to the previous
                           ///< border vertex when it is on the border
    std::vector<int> target_ring; ///< those of the target then, if both are on the border; else empty

    bool is_on_border() const { return !target_ring.empty(); }
  };

  /// vertices that can be put back at a time, each when those of earlier waves are: none is in the ring of another
  struct Waves
  {
    std::vector<int> removals;      ///< places in `removals`, wave by wave
    std::vector<std::size_t> first; ///< those of wave w are first[w], ..., first[w + 1] - 1

    std::size_t size() const { return first.size() - 1; }
  };

  Patch patch;
  std::vector<int> fine_vertex;  ///< per vertex of `patch`, the one of the fine patch
  std::vector<Removal> removals; ///< in the order in which they were made
  Waves waves;                   ///< of the removals
};

/// the waves in which removals can be undone
inline Coarse_patch::Waves waves_of(const std::vector<Coarse_patch::Removal>& removals, int number_of_fine_vertices)
{
  std::vector<int> wave(number_of_fine_vertices, -1); // that of a vertex which is not removed comes first
  Coarse_patch::Waves waves;
  for(std::size_t i = removals.size(); i-- > 0;) {
    int last = -1; // wave of the ring
    for(int w : removals[i].ring)
      last = (std::max)(last, wave[w]);
    wave[removals[i].vertex] = last + 1;
    if(waves.first.size() < static_cast<std::size_t>(last) + 3)
      waves.first.resize(last + 3, 0);
    ++waves.first[last + 2];
  }
  if(waves.first.empty())
    waves.first.assign(1, 0);
  for(std::size_t w = 1; w < waves.first.size(); ++w)
    waves.first[w] += waves.first[w - 1];
  waves.removals.resize(removals.size());
  std::vector<std::size_t> next(waves.first.begin(), waves.first.end() - 1);
  for(std::size_t i = removals.size(); i-- > 0;)
    waves.removals[next[wave[removals[i].vertex]]++] = static_cast<int>(i);
  return waves;
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COARSENING_COARSE_PATCH_H
