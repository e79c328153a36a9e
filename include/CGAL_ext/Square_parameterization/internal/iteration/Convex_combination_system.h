// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ITERATION_CONVEX_COMBINATION_SYSTEM_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ITERATION_CONVEX_COMBINATION_SYSTEM_H

#include <CGAL_ext/Square_parameterization/internal/iteration/edge_weights.h>
#include <CGAL_ext/Square_parameterization/internal/iteration/sparse_pattern.h>

#include <array>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// the linear system  sum_j w_ij s_j (p_j - p_i) = 0  for interior vertices i, border vertices fixed, where w are base
/// weights and s one positive factor per vertex (Floater 1997; the factors are those of Yoshizawa et al. 2004).
///
/// With symmetric base weights row i is multiplied by s_i: the matrix w_ij s_i s_j is symmetric positive definite, and
/// only its upper triangle is stored. The interior vertices are numbered in a fill-reducing order. The sparsity pattern
/// is found once; `assemble()` only writes values.
class Convex_combination_system
{
public:
  /// a matrix and the two right-hand sides, with the memory they occupy: one per thread
  struct Equations
  {
    Sparse_matrix matrix;
    Right_hand_sides right_hand_sides;
  };

  Convex_combination_system(const Patch& patch, Edge_weights weights)
    : m_patch(patch), m_weights(std::move(weights)), m_border_position(patch.points.size(), -1)
  {
    for(std::size_t k = 0; k < patch.border.size(); ++k)
      m_border_position[patch.border[k]] = static_cast<int>(k);
    number_interior_vertices();
    build_pattern();
  }

  bool is_symmetric() const { return m_weights.is_symmetric; }

  /// writes the equations for the factors \p s (#V) and the border \p border_uv (#B by 2)
  void assemble(const std::vector<double>& s, const Uv_coordinates& border_uv, Equations& equations) const
  {
    assemble(m_weights, s, border_uv, equations);
  }

  /// the same with other base weights. \pre they are symmetric where the own ones are
  void assemble(const Edge_weights& weights, const std::vector<double>& s, const Uv_coordinates& border_uv,
                Equations& equations) const
  {
    if(equations.matrix.nonZeros() == 0)
      equations.matrix = m_pattern;
    double* const values = equations.matrix.valuePtr();
    std::fill(values, values + equations.matrix.nonZeros(), 0.);
    equations.right_hand_sides.setZero(m_pattern.rows(), 2);
    for(std::size_t e = 0; e < m_patch.edges.size(); ++e) {
      const auto& [a, b] = m_patch.edges[e];
      const double scale_a = is_symmetric() ? s[a] : 1, scale_b = is_symmetric() ? s[b] : 1;
      add_neighbor(a, b, scale_a * weights.values[e][0] * s[b], m_slots[e][0], border_uv, equations);
      add_neighbor(b, a, scale_b * weights.values[e][1] * s[a], m_slots[e][1], border_uv, equations);
    }
  }

  /// writes the right hand sides alone, for factors of one
  void assemble(const Uv_coordinates& border_uv, Right_hand_sides& right_hand_sides) const
  {
    right_hand_sides.setZero(m_pattern.rows(), 2);
    for(std::size_t e = 0; e < m_patch.edges.size(); ++e) {
      const auto& [a, b] = m_patch.edges[e];
      if(m_row[a] >= 0 && m_row[b] < 0)
        right_hand_sides.row(m_row[a]) += m_weights.values[e][0] * border_uv.row(m_border_position[b]);
      else if(m_row[b] >= 0 && m_row[a] < 0)
        right_hand_sides.row(m_row[b]) += m_weights.values[e][1] * border_uv.row(m_border_position[a]);
    }
  }

  /// the map (#V by 2) made of the interior \p solution and the border \p border_uv (#B by 2)
  void compose(const Right_hand_sides& solution, const Uv_coordinates& border_uv, Uv_coordinates& uv) const
  {
    uv.resize(m_patch.number_of_vertices(), 2);
    for(int v = 0; v < m_patch.number_of_vertices(); ++v) {
      if(m_row[v] >= 0)
        uv.row(v) = solution.row(m_row[v]);
      else
        uv.row(v) = border_uv.row(m_border_position[v]);
    }
  }

private:
  static constexpr int NO_SLOT = -1;

  void number_interior_vertices()
  {
    m_row.assign(m_patch.points.size(), -1);
    if(m_patch.elimination_places.empty())
      number_in_new_order();
    else
      number_in_order(m_patch.elimination_places);
  }

  void number_in_new_order()
  {
    int n = 0;
    for(std::size_t v = 0; v < m_row.size(); ++v)
      if(m_border_position[v] < 0)
        m_row[v] = n++;
    std::vector<std::array<int, 2>> interior_edges;
    for(const auto& [a, b] : m_patch.edges)
      if(m_row[a] >= 0 && m_row[b] >= 0)
        interior_edges.push_back({m_row[a], m_row[b]});
    const std::vector<int> place = fill_reducing_order(n, interior_edges);
    for(int& row : m_row)
      if(row >= 0)
        row = place[row];
  }

  /// \param places of all vertices
  void number_in_order(const std::vector<int>& places)
  {
    std::vector<int> vertices(places.size());
    for(std::size_t v = 0; v < places.size(); ++v)
      vertices[places[v]] = static_cast<int>(v);
    int n = 0;
    for(int v : vertices)
      if(m_border_position[v] < 0)
        m_row[v] = n++;
  }

  void build_pattern()
  {
    const int n = static_cast<int>(m_row.size() - m_patch.border.size());
    std::vector<Eigen::Triplet<double>> entries;
    for(int i = 0; i < n; ++i)
      entries.emplace_back(i, i, 1.);
    for(const auto& [a, b] : m_patch.edges)
      for(const auto& [i, j] : {std::make_pair(m_row[a], m_row[b]), std::make_pair(m_row[b], m_row[a])})
        if(is_stored(i, j))
          entries.emplace_back(i, j, 1.);
    m_pattern.resize(n, n);
    m_pattern.setFromTriplets(entries.begin(), entries.end());
    m_pattern.makeCompressed();
    for(const auto& [a, b] : m_patch.edges)
      m_slots.push_back({slot(m_row[a], m_row[b]), slot(m_row[b], m_row[a])});
    for(int i = 0; i < n; ++i)
      m_diagonal.push_back(slot(i, i));
  }

  bool is_stored(int i, int j) const { return i >= 0 && j >= 0 && (!is_symmetric() || i <= j); }

  int slot(int i, int j) const { return is_stored(i, j) ? slot_of(m_pattern, i, j) : NO_SLOT; }

  /// adds the term  weight (p_vertex - p_neighbor)  to the equation of `vertex`, if it has one
  void add_neighbor(int vertex, int neighbor, double weight, int slot, const Uv_coordinates& border_uv,
                    Equations& equations) const
  {
    const int row = m_row[vertex];
    if(row < 0)
      return;
    equations.matrix.valuePtr()[m_diagonal[row]] += weight;
    if(m_row[neighbor] < 0)
      equations.right_hand_sides.row(row) += weight * border_uv.row(m_border_position[neighbor]);
    else if(slot != NO_SLOT)
      equations.matrix.valuePtr()[slot] -= weight;
  }

  const Patch& m_patch;
  Edge_weights m_weights;
  std::vector<int> m_border_position; // #V, -1 inside
  std::vector<int> m_row;             // #V, -1 on the border
  Sparse_matrix m_pattern;
  std::vector<std::array<int, 2>> m_slots; // #E: where the entries (a, b) and (b, a) are stored
  std::vector<int> m_diagonal;             // one per interior vertex
};

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ITERATION_CONVEX_COMBINATION_SYSTEM_H
