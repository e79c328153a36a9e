// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_AXIS_MATRIX_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_AXIS_MATRIX_H

#include <CGAL_ext/Square_parameterization/internal/common/ranges.h>
#include <CGAL_ext/Square_parameterization/internal/energy/Balanced_energy.h>
#include <CGAL_ext/Square_parameterization/internal/energy/feasible_step.h>
#include <CGAL_ext/Square_parameterization/internal/iteration/sparse_pattern.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/Number_per_axis.h>
#include <CGAL_ext/Square_parameterization/internal/patch/for_triangles.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// the Hessian of the balanced energy without its mixed derivatives by an u and a v: two matrices with one unknown per
/// vertex each, of which the upper triangles are kept.
///
/// Coordinates that may not move have a unit row, so that one sparsity pattern serves every border.
class Axis_matrix
{
public:
  typedef Eigen::SparseMatrix<Number_per_axis> Matrix;
  typedef Eigen::Matrix<Number_per_axis, Eigen::Dynamic, 1> Vector;

  /// \param rank #V: the row of each vertex
  /// \param division of the patch, which must live as long; null for none: then one thread computes the Hessian
  Axis_matrix(const Patch& patch, std::vector<int> rank, const Patch_division* division = nullptr)
    : m_patch(patch), m_rank(std::move(rank)), m_vertices(m_rank.size()), m_division(division)
  {
    const int n = patch.number_of_vertices();
    for(int v = 0; v < n; ++v)
      m_vertices[m_rank[v]] = v;
    std::vector<Eigen::Triplet<char>> entries;
    entries.reserve(n + patch.edges.size());
    for(int i = 0; i < n; ++i)
      entries.emplace_back(i, i, char(1));
    for(const auto& [a, b] : patch.edges)
      entries.emplace_back((std::min)(m_rank[a], m_rank[b]), (std::max)(m_rank[a], m_rank[b]), char(1));
    m_pattern.resize(n, n);
    m_pattern.setFromTriplets(entries.begin(), entries.end());
    m_pattern.makeCompressed();
    m_diagonal.reserve(n);
    for(int i : m_rank)
      m_diagonal.push_back(slot_of(m_pattern, i, i));
    m_sides.reserve(patch.triangles.size());
    for(const auto& t : patch.triangles) {
      m_sides.emplace_back();
      for(int k = 0; k < 3; ++k) {
        const int i = m_rank[t[k]], j = m_rank[t[(k + 1) % 3]];
        m_sides.back()[k] = slot_of(m_pattern, (std::min)(i, j), (std::max)(i, j));
      }
    }
  }

  const Patch& patch() const { return m_patch; }

  /// the row of vertex \p v
  int rank(int v) const { return m_rank[v]; }

  /// a matrix to be set, with all its places
  Matrix make() const { return m_pattern.cast<Number_per_axis>(); }

  /// sets a matrix to the Hessian at \p uv
  /// \param area_multiple see `Balanced_energy::hessian_blocks()`
  void set(const Balanced_energy& energy, const Uv_coordinates& uv, const Free_coordinates& is_free, Matrix& matrix,
           double area_multiple = Balanced_energy::AREA_MULTIPLE) const
  {
    const Eigen::RowVector2d to_rectangle = energy.scale(uv);
    Number_per_axis* const values = matrix.valuePtr();
    for_ranges(matrix.nonZeros(),
               [&](std::size_t begin, std::size_t end) { std::fill(values + begin, values + end, Number_per_axis()); });
    typedef Balanced_energy::Hessian_blocks Blocks;
    const auto blocks_of = [&](const std::array<int, 2>& faces) {
      return energy.hessian_blocks(faces, uv, to_rectangle, area_multiple);
    };
    const auto add = [&](std::size_t f, const Blocks& blocks, double) {
      const auto& t = m_patch.triangles[f];
      for(int k = 0; k < 3; ++k) {
        values[m_diagonal[t[k]]] += Number_per_axis(blocks.diagonal[k]);
        values[m_sides[f][k]] += Number_per_axis(blocks.sides[k]);
      }
    };
    double nothing = 0;
    if(m_division == nullptr || !m_division->is_divided())
      for_triangles<2>(
          0, m_patch.triangles.size(), [](std::size_t f) { return static_cast<int>(f); }, blocks_of,
          [&](std::size_t f, const Blocks& blocks) { add(f, blocks, nothing); });
    else
      for_divided_triangles<2>(*m_division, nothing, blocks_of, add);
    fix(is_free, matrix);
  }

  /// gives unit rows to the coordinates that may not move, in a matrix that was set
  void fix(const Free_coordinates& is_free, Matrix& matrix) const
  {
    for_ranges(m_vertices.size(), [&](std::size_t begin, std::size_t end) {
      for(std::size_t column = begin; column < end; ++column)
        for(Matrix::InnerIterator entry(matrix, static_cast<Eigen::Index>(column)); entry; ++entry) {
          const int v = m_vertices[entry.row()], w = m_vertices[column];
          for(int axis = 0; axis < 2; ++axis)
            if(!is_free(v, axis) || !is_free(w, axis))
              entry.valueRef()[axis] = v == w ? 1 : 0;
        }
    });
  }

  /// gives unit rows to the coordinates that may not move any more, in a matrix that was set or fixed
  /// \param changed is set to the numbers of the entries that this concerns, as the matrix stores them; some come twice
  void fix_more(const Free_coordinates& was_free, const Free_coordinates& is_free, Matrix& matrix,
                std::vector<int>& changed) const
  {
    Number_per_axis* const values = matrix.valuePtr();
    changed.clear();
    const auto set = [&](int entry, int axis, double value) {
      values[entry][axis] = value;
      changed.push_back(entry);
    };
    const auto stops = [&](int v, int axis) { return was_free(v, axis) && !is_free(v, axis); };
    std::vector<char> is_stopped(m_rank.size());
    for(int v = 0; v < static_cast<int>(is_stopped.size()); ++v)
      is_stopped[v] = stops(v, 0) || stops(v, 1);
    for(int f = 0; f < m_patch.number_of_faces(); ++f) {
      const auto& t = m_patch.triangles[f];
      if(!(is_stopped[t[0]] || is_stopped[t[1]] || is_stopped[t[2]]))
        continue;
      for(int k = 0; k < 3; ++k)
        for(int axis = 0; axis < 2; ++axis)
          if(stops(t[k], axis)) {
            set(m_diagonal[t[k]], axis, 1);
            set(m_sides[f][k], axis, 0);
            set(m_sides[f][(k + 2) % 3], axis, 0);
          }
    }
  }

private:
  const Patch& m_patch;
  std::vector<int> m_rank;     // #V: the row of each vertex
  std::vector<int> m_vertices; // #V: the vertex of each row
  const Patch_division* m_division;
  Eigen::SparseMatrix<char> m_pattern;     // upper triangle; its values are not read
  std::vector<int> m_diagonal;             // #V: places of the entries of vertices on the diagonal
  std::vector<std::array<int, 3>> m_sides; // #F: places of the entries (k, k + 1) of a triangle
};

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_AXIS_MATRIX_H
