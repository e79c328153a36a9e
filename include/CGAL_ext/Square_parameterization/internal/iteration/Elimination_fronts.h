// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ITERATION_ELIMINATION_FRONTS_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ITERATION_ELIMINATION_FRONTS_H

#include <CGAL_ext/Square_parameterization/internal/iteration/Elimination_front.h>
#include <CGAL_ext/Square_parameterization/internal/iteration/Front_division.h>
#include <CGAL_ext/Square_parameterization/internal/iteration/elimination_tree.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// what the factorizations of all symmetric matrices of one pattern share: which columns are eliminated together, in
/// which order, and where each number goes.
///
/// Columns that have nearly the same rows make one front (a relaxed supernode), in which arithmetic reads no indices. The
/// method is that of Duff and Reid, ACM TOMS 9, 1983; Liu, SIAM Review 34, 1992, explains it, and the elimination tree.
/// Complexity: linear in the entries of the factor.
class Elimination_fronts
{
public:
  /// where an entry of the matrix goes
  struct Entry
  {
    int number; ///< of the entry, as the matrix stores it
    int place;  ///< among the numbers of the factor that belong to the front
  };

  /// \param upper the upper triangle of a matrix, compressed, its columns in an order of little fill
  template <class Number>
  explicit Elimination_fronts(const Eigen::SparseMatrix<Number>& upper)
  {
    const Column_tree tree = elimination_tree(upper);
    make_fronts(tree, merged_columns(tree));
    find_rows(upper);
    Front_division division(m_fronts);
    m_parts = std::move(division.parts());
    m_stages = std::move(division.stages());
    place_columns();
    place_contributions(division.part_of());
    copy_rows(division.part_of());
  }

  const std::vector<Elimination_front>& fronts() const { return m_fronts; } ///< children before their parents
  const std::vector<int>& places() const { return m_places; }               ///< of the columns in the reordered matrix
  const std::vector<Entry>& entries() const { return m_entries; }           ///< of the matrix, front by front

  /// the parts, those of a stage one after the other
  const std::vector<Front_part>& parts() const { return m_parts; }

  /// where the parts of each stage begin, and #parts
  const std::vector<int>& stages() const { return m_stages; }

  /// of the fronts, in each those that it eliminates first. From #columns on they are copies.
  const std::vector<int>& rows() const { return m_rows; }

  /// what the copies stand for, from the first on: rows, or copies, of the parent of the part that has them
  const std::vector<int>& originals() const { return m_originals; }

  /// beside `rows()`, for those that a front does not eliminate: their numbers among the rows of its parent
  const std::vector<int>& rows_in_parent() const { return m_rows_in_parent; }

  std::size_t factor_size() const { return m_factor_size; } ///< numbers, of all fronts

  /// numbers of the contributions that wait for their parents at a time
  std::size_t workspace_size() const { return m_workspace_size; }

  /// numbers of all contributions
  std::size_t kept_size() const { return m_kept_size; }

  /// per entry, as the matrix stores them, the front in whose columns it is
  std::vector<int> front_of_entries() const
  {
    std::vector<int> result(m_entries.size());
    for(std::size_t f = 0; f < m_fronts.size(); ++f)
      for(int e = m_fronts[f].first_entry; e < m_fronts[f].end_entry; ++e)
        result[m_entries[e].number] = static_cast<int>(f);
    return result;
  }

private:
  /// makes the fronts, each after all fronts below it, which come together, and numbers the columns in their order
  /// \param last the last column of the front of each column
  void make_fronts(const Column_tree& tree, const std::vector<int>& last)
  {
    const int n = static_cast<int>(last.size());
    std::vector<int> width(n, 0), first_child(n, -1), next_sibling(n, -1), front_of(n, -1), order;
    for(int j = 0; j < n; ++j)
      ++width[last[j]];
    std::vector<int> pending; // the last columns of fronts whose children come first
    for(int j = n - 1; j >= 0; --j)
      if(last[j] == j && tree.parent[j] < 0)
        pending.push_back(j);
      else if(last[j] == j)
        next_sibling[j] = std::exchange(first_child[last[tree.parent[j]]], j);
    while(!pending.empty()) {
      const int j = pending.back();
      if(first_child[j] >= 0) {
        pending.push_back(first_child[j]);
        first_child[j] = next_sibling[first_child[j]];
        continue;
      }
      pending.pop_back();
      front_of[j] = static_cast<int>(order.size());
      order.push_back(j);
    }
    m_fronts.resize(order.size());
    int first = 0;
    for(std::size_t f = 0; f < order.size(); ++f) {
      m_fronts[f].first = first;
      m_fronts[f].width = width[order[f]];
      first += m_fronts[f].width;
    }
    for(std::size_t f = order.size(); f-- > 0;)
      if(tree.parent[order[f]] >= 0) {
        m_fronts[f].parent = front_of[last[tree.parent[order[f]]]];
        m_fronts[f].next_sibling = std::exchange(m_fronts[m_fronts[f].parent].first_child, static_cast<int>(f));
      }
    std::vector<int> next;
    for(const Elimination_front& front : m_fronts)
      next.push_back(front.first);
    m_places.reserve(n);
    for(int j = 0; j < n; ++j)
      m_places.push_back(next[front_of[last[j]]]++);
  }

  /// an entry of the lower triangle of the reordered matrix
  struct Lower_entry
  {
    int row, column, number;
  };

  /// the entries by columns, and sets where those of the fronts begin and end
  template <class Number>
  std::vector<Lower_entry> lower_entries(const Eigen::SparseMatrix<Number>& upper)
  {
    std::vector<Lower_entry> entries;
    entries.reserve(upper.nonZeros());
    std::vector<int> begin(upper.cols() + 1, 0);
    for(int k = 0; k < upper.cols(); ++k)
      for(typename Eigen::SparseMatrix<Number>::InnerIterator entry(upper, k); entry; ++entry) {
        const auto [column, row] = std::minmax(m_places[entry.row()], m_places[k]);
        entries.push_back({row, column, static_cast<int>(entries.size())});
        ++begin[column + 1];
      }
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    for(Elimination_front& front : m_fronts) {
      front.first_entry = begin[front.first];
      front.end_entry = begin[front.first + front.width];
    }
    std::vector<Lower_entry> sorted(entries.size());
    for(const Lower_entry& entry : entries)
      sorted[begin[entry.column]++] = entry;
    return sorted;
  }

  /// finds the rows of each front, from the entries of the matrix and the rows of its children, and the places of both
  template <class Number>
  void find_rows(const Eigen::SparseMatrix<Number>& upper)
  {
    const std::vector<Lower_entry> entries = lower_entries(upper);
    m_entries.reserve(entries.size());
    std::vector<int> number_of_row(upper.cols(), -1), used_in(upper.cols(), -1);
    for(std::size_t f = 0; f < m_fronts.size(); ++f) {
      Elimination_front& front = m_fronts[f];
      front.rows = m_rows.size();
      const auto use = [&](int row) {
        if(std::exchange(used_in[row], static_cast<int>(f)) != static_cast<int>(f))
          m_rows.push_back(row);
      };
      for(int j = 0; j < front.width; ++j)
        use(front.first + j);
      for(int e = front.first_entry; e < front.end_entry; ++e)
        use(entries[e].row);
      for_rows_of_children(front, [&](std::size_t i) { use(m_rows[i]); });
      std::sort(m_rows.begin() + front.rows + front.width, m_rows.end());
      m_rows_in_parent.resize(m_rows.size(), -1);
      front.height = static_cast<int>(m_rows.size() - front.rows);
      for(int i = 0; i < front.height; ++i)
        number_of_row[m_rows[front.rows + i]] = i;
      for(int e = front.first_entry; e < front.end_entry; ++e) {
        const auto& [row, column, number] = entries[e];
        m_entries.push_back({number, (column - front.first) * front.stride() + number_of_row[row]});
      }
      for_rows_of_children(front, [&](std::size_t i) { m_rows_in_parent[i] = number_of_row[m_rows[i]]; });
    }
    m_rows.shrink_to_fit();
    m_rows_in_parent.shrink_to_fit();
  }

  /// calls `use(i)` for the places in `m_rows` of the rows that the children of a front do not eliminate
  template <class Use>
  void for_rows_of_children(const Elimination_front& front, const Use& use) const
  {
    for(int c = front.first_child; c >= 0; c = m_fronts[c].next_sibling)
      for(int i = m_fronts[c].width; i < m_fronts[c].height; ++i)
        use(m_fronts[c].rows + i);
  }

  /// lays the eliminated columns of the fronts one after the other, part by part. The last tile of rows that is read may
  /// reach beyond a column, and is not to reach what another part writes.
  void place_columns()
  {
    for(const Front_part& part : m_parts) {
      for(int f : part.fronts) {
        m_fronts[f].values = m_factor_size;
        m_factor_size += m_fronts[f].factor_size();
      }
      m_factor_size += Elimination_front::TILE;
    }
  }

  /// lays the contributions of each part on two stacks of its own, of fronts of odd and of even depth: a front takes those
  /// of its children from the one, and puts its own on the other. Where all are kept they lie one after the other.
  void place_contributions(const std::vector<int>& part_of)
  {
    for(Elimination_front& front : m_fronts) {
      front.kept_contribution = m_kept_size;
      m_kept_size += front.contribution_size();
    }
    std::vector<int> stack_of(m_fronts.size(), 0);
    for(std::size_t f = m_fronts.size(); f-- > 0;)
      if(m_fronts[f].parent >= 0)
        stack_of[f] = 1 - stack_of[m_fronts[f].parent];
    for(const Front_part& part : m_parts) {
      std::array<std::size_t, 2> size{0, 0}, largest{0, 0};
      for(int f : part.fronts) {
        Elimination_front& front = m_fronts[f];
        const int stack = stack_of[f];
        front.contribution = size[stack];
        size[stack] += front.contribution_size();
        largest[stack] = (std::max)(largest[stack], size[stack]);
        for(int c = front.first_child; c >= 0; c = m_fronts[c].next_sibling)
          if(part_of[c] == part_of[f]) // those of other parts stay where they are
            size[1 - stack] = (std::min)(size[1 - stack], m_fronts[c].contribution);
      }
      for(int f : part.fronts)
        m_fronts[f].contribution += m_workspace_size + (stack_of[f] == 1 ? largest[0] : 0);
      m_workspace_size += largest[0] + largest[1];
    }
  }

  /// gives each part its own copies of the rows that are eliminated in other parts
  void copy_rows(const std::vector<int>& part_of)
  {
    const int n = static_cast<int>(m_places.size());
    std::vector<int> part_of_row(n), copy(n);
    std::vector<std::vector<int>> copied(m_parts.size()); // ascending
    for(std::size_t f = 0; f < m_fronts.size(); ++f)
      std::fill_n(part_of_row.begin() + m_fronts[f].first, m_fronts[f].width, part_of[f]);
    for(std::size_t p = m_parts.size(); p-- > 0;) { // parents first
      Front_part& part = m_parts[p];
      const auto for_rows_of_others = [&](const auto& visit) {
        for(int f : part.fronts)
          for(int i = m_fronts[f].width; i < m_fronts[f].height; ++i)
            if(int& row = m_rows[m_fronts[f].rows + i]; part_of_row[row] != static_cast<int>(p))
              visit(row);
      };
      std::vector<int>& rows = copied[p];
      for_rows_of_others([&rows](int row) { rows.push_back(row); });
      std::sort(rows.begin(), rows.end());
      rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
      part.first_copy = n + static_cast<int>(m_originals.size());
      for(std::size_t i = 0; i < rows.size(); ++i) {
        copy[rows[i]] = part.first_copy + static_cast<int>(i);
        m_originals.push_back(part_of_row[rows[i]] == part.parent
                                  ? rows[i]
                                  : copy_in(m_parts[part.parent], copied[part.parent], rows[i]));
      }
      part.end_copy = n + static_cast<int>(m_originals.size());
      for_rows_of_others([&copy](int& row) { row = copy[row]; });
    }
  }

  /// the copy of a row that a part has
  /// \param copied the rows of which it has copies
  static int copy_in(const Front_part& part, const std::vector<int>& copied, int row)
  {
    return part.first_copy + static_cast<int>(std::lower_bound(copied.begin(), copied.end(), row) - copied.begin());
  }

  std::vector<Elimination_front> m_fronts;
  std::vector<int> m_places;
  std::vector<int> m_rows, m_rows_in_parent;
  std::vector<Front_part> m_parts;
  std::vector<int> m_stages, m_originals;
  std::vector<Entry> m_entries;
  std::size_t m_factor_size = 0, m_workspace_size = 0, m_kept_size = 0;
};

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ITERATION_ELIMINATION_FRONTS_H
