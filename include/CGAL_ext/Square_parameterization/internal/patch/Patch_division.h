// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PATCH_PATCH_DIVISION_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PATCH_PATCH_DIVISION_H

#include <CGAL_ext/Square_parameterization/internal/common/Minimizer_numbers.h>
#include <CGAL_ext/Square_parameterization/internal/patch/Patch.h>
#include <CGAL_ext/Square_parameterization/internal/patch/vertices_along_curve.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// a large patch in blocks, of which each can be worked on by another thread: vertices that follow each other on a
/// curve that fills space, without the few separators between the blocks. No edge joins two blocks. The division does
/// not depend on the number of threads.
///
/// The rank of a vertex is its place in the order in which they are visited: block by block, and then the separators,
/// color by color. Separators of one color have no edges between them. A patch that is one block keeps its order.
class Patch_division
{
public:
  /// what ranks, or places in a list, belong together: begin, begin + 1, ..., end - 1
  struct Range
  {
    int begin, end;
  };

  /// \param vertices_per_block of a patch that has more than twice as many, before the separators are taken out; a
  ///        smaller one is one block
  explicit Patch_division(const Patch& patch, int vertices_per_block = Minimizer_numbers::VERTICES_PER_BLOCK)
    : Patch_division(patch,
                     is_large(patch, vertices_per_block) ? vertices_along_curve(patch.points) : std::vector<int>(),
                     vertices_per_block)
  {}

  /// \param curve #V: the vertices along the curve
  Patch_division(const Patch& patch, std::vector<int> curve,
                 int vertices_per_block = Minimizer_numbers::VERTICES_PER_BLOCK)
    : m_vertices_per_block(is_large(patch, vertices_per_block) ? vertices_per_block : patch.number_of_vertices())
  {
    if(patch.number_of_vertices() == m_vertices_per_block) {
      curve.resize(patch.points.size());
      std::iota(curve.begin(), curve.end(), 0);
    }
    // the places on the curve, which become ranks when the separators are known
    m_rank.resize(curve.size());
    for(std::size_t i = 0; i < curve.size(); ++i)
      m_rank[curve[i]] = static_cast<int>(i);
    const std::vector<int> colors = colors_of_separators(patch, curve);
    sort_triangles(patch, colors);
    rank_vertices(curve, colors);
  }

  /// indicates whether a patch is more than one block
  static bool is_large(const Patch& patch, int vertices_per_block = Minimizer_numbers::VERTICES_PER_BLOCK)
  {
    return patch.number_of_vertices() > 2 * vertices_per_block;
  }

  int number_of_blocks() const { return static_cast<int>(m_blocks.size()); }
  bool is_divided() const { return number_of_blocks() > 1; }

  /// the ranks of a block
  Range block(int b) const { return m_blocks[b]; }

  /// the ranks of the separators: those after the ranks of all blocks
  Range separators() const { return {m_blocks.back().end, static_cast<int>(m_order.size())}; }

  /// the ranks of each color
  const std::vector<Range>& colors() const { return m_colors; }

  /// the vertices by their ranks
  const std::vector<int>& order() const { return m_order; }

  /// this division, of the patch that `Ordered_patch` makes: there ranks are vertices, and the triangles of a block, and
  /// those with separators, follow each other
  Patch_division in_order() const
  {
    Patch_division result(*this);
    std::iota(result.m_rank.begin(), result.m_rank.end(), 0);
    result.m_order = result.m_rank;
    std::iota(result.m_triangles.begin(), result.m_triangles.end(), 0);
    std::iota(result.m_joints.begin(), result.m_joints.end(), static_cast<int>(m_triangles.size()));
    return result;
  }

  int rank(int v) const { return m_rank[v]; }
  const std::vector<int>& ranks() const { return m_rank; }

  /// the vertex with a rank
  int vertex(int rank) const { return m_order[rank]; }

  /// the places in the list of `triangle()` of those of which all corners belong to block \p b
  Range triangles_of_block(int b) const { return {m_first_triangle[b], m_first_triangle[b + 1]}; }
  int triangle(int place) const { return m_triangles[place]; }

  /// the triangles with separators
  const std::vector<int>& joints() const { return m_joints; }

private:
  static constexpr int NONE = -1;

  /// while ranks are places on the curve
  int block_of(int v) const { return m_rank[v] / m_vertices_per_block; }

  /// the colors of the separators, NONE for others. Of two neighbors in different blocks the one in the later block is
  /// a separator.
  std::vector<int> colors_of_separators(const Patch& patch, const std::vector<int>& curve) const
  {
    const int UNCOLORED = patch.number_of_vertices();
    std::vector<int> colors(patch.points.size(), NONE);
    for(const auto& [a, b] : patch.edges)
      if(block_of(a) != block_of(b))
        colors[m_rank[a] < m_rank[b] ? b : a] = UNCOLORED;
    std::vector<std::array<int, 2>> edges; // between separators: the later on the curve, and the other
    for(const auto& [a, b] : patch.edges)
      if(colors[a] == UNCOLORED && colors[b] == UNCOLORED)
        edges.push_back({(std::max)(m_rank[a], m_rank[b]), (std::min)(m_rank[a], m_rank[b])});
    std::sort(edges.begin(), edges.end());
    std::vector<int> taken;
    auto edge = edges.begin();
    for(std::size_t i = 0; i < curve.size(); ++i) {
      int& color = colors[curve[i]];
      taken.clear();
      for(; edge != edges.end() && (*edge)[0] == static_cast<int>(i); ++edge)
        taken.push_back(colors[curve[(*edge)[1]]]);
      if(color == NONE)
        continue;
      for(color = 0; std::find(taken.begin(), taken.end(), color) != taken.end();)
        ++color;
    }
    return colors;
  }

  void rank_vertices(const std::vector<int>& curve, const std::vector<int>& colors)
  {
    const int n = static_cast<int>(colors.size());
    const auto append = [this](int v) {
      m_rank[v] = static_cast<int>(m_order.size());
      m_order.push_back(v);
    };
    int number_of_colors = 0;
    for(int begin = 0; begin < n; begin += m_vertices_per_block) {
      const int first = static_cast<int>(m_order.size());
      for(int i = begin; i < (std::min)(n, begin + m_vertices_per_block); ++i)
        if(colors[curve[i]] == NONE)
          append(curve[i]);
        else
          number_of_colors = (std::max)(number_of_colors, colors[curve[i]] + 1);
      m_blocks.push_back({first, static_cast<int>(m_order.size())});
    }
    for(int color = 0; color < number_of_colors; ++color) {
      const int first = static_cast<int>(m_order.size());
      for(int v : curve)
        if(colors[v] == color)
          append(v);
      m_colors.push_back({first, static_cast<int>(m_order.size())});
    }
  }

  void sort_triangles(const Patch& patch, const std::vector<int>& colors)
  {
    const auto is_separator = [&colors](int v) { return colors[v] != NONE; };
    m_first_triangle.assign((colors.size() + m_vertices_per_block - 1) / m_vertices_per_block + 1, 0);
    for(int f = 0; f < patch.number_of_faces(); ++f) {
      const auto& t = patch.triangles[f];
      if(std::any_of(t.begin(), t.end(), is_separator))
        m_joints.push_back(f);
      else
        ++m_first_triangle[block_of(t[0]) + 1];
    }
    for(std::size_t b = 1; b < m_first_triangle.size(); ++b)
      m_first_triangle[b] += m_first_triangle[b - 1];
    m_triangles.resize(m_first_triangle.back());
    std::vector<int> next(m_first_triangle.begin(), m_first_triangle.end() - 1);
    for(int f = 0; f < patch.number_of_faces(); ++f) {
      const auto& t = patch.triangles[f];
      if(std::none_of(t.begin(), t.end(), is_separator))
        m_triangles[next[block_of(t[0])]++] = f;
    }
  }

  int m_vertices_per_block;
  std::vector<int> m_rank, m_order;  // #V; each is the inverse of the other
  std::vector<Range> m_blocks;       // of ranks
  std::vector<Range> m_colors;       // of ranks
  std::vector<int> m_triangles;      // those without separators, by block
  std::vector<int> m_first_triangle; // #blocks + 1
  std::vector<int> m_joints;         // the others
};

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PATCH_PATCH_DIVISION_H
