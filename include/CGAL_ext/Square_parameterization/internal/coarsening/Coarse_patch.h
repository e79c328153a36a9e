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

/// the neighbors of a vertex, counter-clockwise; from the next to the previous border vertex when it is on the border. It
/// refers to a list that holds them.
class Vertex_ring
{
public:
  Vertex_ring(const int* begin, std::size_t size) : m_begin(begin), m_size(size) {}
  Vertex_ring(const std::vector<int>& ring) : Vertex_ring(ring.data(), ring.size()) {}

  std::size_t size() const { return m_size; }
  const int* begin() const { return m_begin; }
  const int* end() const { return m_begin + m_size; }
  int operator[](std::size_t i) const { return m_begin[i]; }
  int front() const { return m_begin[0]; }
  int back() const { return m_begin[m_size - 1]; }

private:
  const int* m_begin;
  std::size_t m_size;
};

/// a patch with fewer vertices, and how to get back
struct Coarse_patch
{
  /// a vertex that was taken out: collapsed into one of its neighbors. All are vertices of the fine patch.
  struct Removal
  {
    int vertex, target;
    std::size_t first;               ///< place of the rings in `rings`: that of the vertex, and then that of the target
    int ring_size, target_ring_size; ///< the latter is 0 unless both are on the border

    bool is_on_border() const { return target_ring_size > 0; }
  };

  /// vertices that can be put back at a time, each when those of earlier waves are: none is in the ring of another
  struct Waves
  {
    std::vector<int> removals;      ///< places in `removals`, wave by wave
    std::vector<std::size_t> first; ///< those of wave w are first[w], ..., first[w + 1] - 1

    std::size_t size() const { return first.size() - 1; }
  };

  /// a vertex of the border of the fine patch
  struct Fine_border_vertex
  {
    int stand_in; ///< place on the border of `patch` of the vertex, or of the one that it was collapsed into
    int removal;  ///< place in `removals`; -1 for a vertex that stays
  };

  Patch patch;
  std::vector<int> fine_vertex; ///< per vertex of `patch`, the one of the fine patch
  std::vector<int> fine_places; ///< per border vertex of `patch`, its place on the fine border; ascending
  std::vector<Fine_border_vertex> fine_border; ///< per border vertex of the fine patch
  std::vector<Removal> removals;               ///< in the order in which they were made
  std::vector<int> rings; ///< of all removals, in one list: a list for each would take twice the memory
  Waves waves;            ///< of the removals

  /// the ring of the vertex when it was taken out
  Vertex_ring ring(const Removal& removal) const
  {
    return {rings.data() + removal.first, std::size_t(removal.ring_size)};
  }

  /// the ring of the target then; empty unless both are on the border
  Vertex_ring target_ring(const Removal& removal) const
  {
    return {rings.data() + removal.first + removal.ring_size, std::size_t(removal.target_ring_size)};
  }

  /// \param target_ring empty unless both are on the border
  void add_removal(int vertex, int target, const std::vector<int>& ring, const std::vector<int>& target_ring)
  {
    removals.push_back(
        {vertex, target, rings.size(), static_cast<int>(ring.size()), static_cast<int>(target_ring.size())});
    rings.insert(rings.end(), ring.begin(), ring.end());
    rings.insert(rings.end(), target_ring.begin(), target_ring.end());
  }

  /// adds the removals of another one, which loses them
  void append_removals(Coarse_patch&& other)
  {
    if(removals.empty()) {
      removals = std::move(other.removals);
      rings = std::move(other.rings);
      return;
    }
    for(Removal removal : other.removals) {
      removal.first += rings.size();
      removals.push_back(removal);
    }
    rings.insert(rings.end(), other.rings.begin(), other.rings.end());
    other = Coarse_patch();
  }
};

/// the waves in which removals can be undone
inline Coarse_patch::Waves waves_of(const Coarse_patch& coarse, int number_of_fine_vertices)
{
  const std::vector<Coarse_patch::Removal>& removals = coarse.removals;
  std::vector<int> wave(number_of_fine_vertices, -1); // that of a vertex which is not removed comes first
  Coarse_patch::Waves waves;
  for(std::size_t i = removals.size(); i-- > 0;) {
    int last = -1; // wave of the ring
    for(int w : coarse.ring(removals[i]))
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

/// the vertices of a coarse patch in the order in which a curve visits them in the fine patch
inline std::vector<int> coarse_curve(const std::vector<int>& fine_curve, const Coarse_patch& coarse)
{
  std::vector<int> coarse_vertex(fine_curve.size(), -1);
  for(std::size_t v = 0; v < coarse.fine_vertex.size(); ++v)
    coarse_vertex[coarse.fine_vertex[v]] = static_cast<int>(v);
  std::vector<int> curve;
  for(int v : fine_curve)
    if(coarse_vertex[v] >= 0)
      curve.push_back(coarse_vertex[v]);
  return curve;
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COARSENING_COARSE_PATCH_H
