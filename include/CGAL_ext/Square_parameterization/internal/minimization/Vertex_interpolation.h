// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_VERTEX_INTERPOLATION_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_VERTEX_INTERPOLATION_H

#include <CGAL_ext/Square_parameterization/internal/coarsening/Coarse_patch.h>
#include <CGAL_ext/Square_parameterization/internal/coarsening/mean_value_weights_in_ring.h>
#include <CGAL_ext/Square_parameterization/internal/common/ranges.h>

#include <cmath>
#include <cstddef>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// how vertices that a coarse patch lacks follow those that it has: each moves with the mean of the ring that it had when
/// it was taken out, with mean value weights; a border vertex with its neighbors on the border, by length. Vertices of
/// the ring that were taken out later follow others themselves.
class Vertex_interpolation
{
public:
  /// \param rank #V of the fine patch: the row of each vertex in `prolong()` and `restrict_to_coarse()`
  /// \param coarse_order #V of the coarse patch: the vertex of each row there
  Vertex_interpolation(const Patch& fine, const Coarse_patch& coarse, const std::vector<int>& rank,
                       const std::vector<int>& coarse_order)
    : m_first_of_wave(coarse.waves.first), m_first_follower(rank.size() + 1, 0), m_first(1, 0)
  {
    m_kept.reserve(coarse_order.size());
    for(int v : coarse_order)
      m_kept.push_back(rank[coarse.fine_vertex[v]]);
    m_removed.reserve(coarse.waves.removals.size());
    for(int i : coarse.waves.removals)
      m_removed.push_back(rank[coarse.removals[i].vertex]);
    find_neighbors(fine, coarse, rank);
    transpose();
  }

  /// sets \p fine (#V by 2) to what \p coarse (#V of the coarse patch by 2) becomes
  void prolong(const Uv_coordinates& coarse, Uv_coordinates& fine) const
  {
    for_ranges(m_kept.size(), [&](std::size_t begin, std::size_t end) {
      for(std::size_t v = begin; v < end; ++v)
        fine.row(m_kept[v]) = coarse.row(v);
    });
    for(std::size_t wave = 0; wave < number_of_waves(); ++wave)
      for_removed(wave, [&](std::size_t i) {
        Eigen::RowVector2d mean(0, 0);
        for(std::size_t k = m_first[i]; k < m_first[i + 1]; ++k)
          mean += double(m_neighbors[k].weight) * fine.row(m_neighbors[k].row);
        fine.row(m_removed[i]) = mean;
      });
  }

  /// the transposed of `prolong()`
  /// \param fine (#V by 2) is overwritten
  void restrict_to_coarse(Uv_coordinates& fine, Uv_coordinates& coarse) const
  {
    for(std::size_t wave = number_of_waves(); wave-- > 0;)
      for_removed(wave, [&](std::size_t i) { fine.row(m_removed[i]) = with_followers(fine, m_removed[i]); });
    coarse.resize(m_kept.size(), 2);
    for_ranges(m_kept.size(), [&](std::size_t begin, std::size_t end) {
      for(std::size_t v = begin; v < end; ++v)
        coarse.row(v) = with_followers(fine, m_kept[v]);
    });
  }

private:
  /// an entry of the matrix: single precision halves the memory, and `prolong()` and its transposed have the same weights
  struct Entry
  {
    int row;
    float weight;
  };

  static constexpr std::size_t REMOVED_AT_A_TIME = 1024; // most waves are short

  std::size_t number_of_waves() const { return m_first_of_wave.size() - 1; }

  /// calls `visit(i)` for the vertices of a wave, by their places in the list of the removed
  template <class Visit>
  void for_removed(std::size_t wave, const Visit& visit) const
  {
    const std::size_t first = m_first_of_wave[wave];
    for_ranges(
        m_first_of_wave[wave + 1] - first,
        [&](std::size_t begin, std::size_t end) {
          for(std::size_t i = first + begin; i < first + end; ++i)
            visit(i);
        },
        REMOVED_AT_A_TIME);
  }

  /// by length, of its neighbors on the border alone
  static std::vector<double> weights_on_border(const Patch& fine, int vertex, const Vertex_ring& ring)
  {
    std::vector<double> weights(ring.size(), 0.);
    weights.front() = (fine.points[ring.back()] - fine.points[vertex]).norm();
    weights.back() = (fine.points[ring.front()] - fine.points[vertex]).norm();
    return weights;
  }

  /// the neighbors that a vertex follows, by their rows, and how far
  static std::vector<Entry> neighbors_of(const Patch& fine, const Coarse_patch& coarse,
                                         const Coarse_patch::Removal& removal, const std::vector<int>& rank)
  {
    const Vertex_ring ring = coarse.ring(removal);
    const std::vector<double> weights = removal.is_on_border()
                                            ? weights_on_border(fine, removal.vertex, ring)
                                            : mean_value_weights_in_ring(fine.points, removal.vertex, ring);
    double sum = 0;
    for(double weight : weights)
      sum += weight;
    const bool is_sound = std::isfinite(sum) && sum > 0;
    std::vector<Entry> neighbors;
    for(std::size_t i = 0; i < ring.size(); ++i)
      if(!is_sound || weights[i] > 0)
        neighbors.push_back({rank[ring[i]], float(is_sound ? weights[i] / sum : 1 / double(ring.size()))});
    return neighbors;
  }

  void find_neighbors(const Patch& fine, const Coarse_patch& coarse, const std::vector<int>& rank)
  {
    const std::vector<int>& removals = coarse.waves.removals;
    std::vector<std::vector<Entry>> of_range((removals.size() + RANGE - 1) / RANGE);
    std::vector<std::size_t> numbers(removals.size());
    for_ranges(removals.size(), [&](std::size_t begin, std::size_t end) {
      for(std::size_t i = begin; i < end; ++i) {
        const std::vector<Entry> neighbors = neighbors_of(fine, coarse, coarse.removals[removals[i]], rank);
        of_range[begin / RANGE].insert(of_range[begin / RANGE].end(), neighbors.begin(), neighbors.end());
        numbers[i] = neighbors.size();
      }
    });
    m_first.reserve(numbers.size() + 1);
    for(std::size_t number : numbers)
      m_first.push_back(m_first.back() + number);
    m_neighbors.reserve(m_first.back());
    for(const std::vector<Entry>& neighbors : of_range)
      m_neighbors.insert(m_neighbors.end(), neighbors.begin(), neighbors.end());
  }

  /// lists for each row what follows it
  void transpose()
  {
    for(const Entry& neighbor : m_neighbors)
      ++m_first_follower[neighbor.row + 1];
    for(std::size_t row = 1; row < m_first_follower.size(); ++row)
      m_first_follower[row] += m_first_follower[row - 1];
    m_followers.resize(m_neighbors.size());
    std::vector<std::size_t> next(m_first_follower.begin(), m_first_follower.end() - 1);
    for(std::size_t i = 0; i < m_removed.size(); ++i)
      for(std::size_t k = m_first[i]; k < m_first[i + 1]; ++k)
        m_followers[next[m_neighbors[k].row]++] = {m_removed[i], m_neighbors[k].weight};
  }

  /// what a row of the fine patch has, and those that follow it have, by their weights
  Eigen::RowVector2d with_followers(const Uv_coordinates& fine, int row) const
  {
    Eigen::RowVector2d sum = fine.row(row);
    for(std::size_t k = m_first_follower[row]; k < m_first_follower[row + 1]; ++k)
      sum += double(m_followers[k].weight) * fine.row(m_followers[k].row);
    return sum;
  }

  // all vertices by their rows
  std::vector<int> m_kept;                   // per vertex of the coarse patch, the one of the fine patch
  std::vector<int> m_removed;                // vertices of the fine patch, wave by wave
  std::vector<std::size_t> m_first_of_wave;  // in this list
  std::vector<std::size_t> m_first_follower; // per row, in the list of followers
  std::vector<std::size_t> m_first; // the neighbors of the i-th of the removed: first[i], ..., first[i + 1] - 1
  std::vector<Entry> m_neighbors;   // which a vertex follows
  std::vector<Entry> m_followers;   // the transposed
};

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_VERTEX_INTERPOLATION_H
