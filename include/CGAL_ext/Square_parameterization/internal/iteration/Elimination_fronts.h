// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ITERATION_ELIMINATION_FRONTS_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ITERATION_ELIMINATION_FRONTS_H

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

/// a dense symmetric matrix of the multifrontal method: its first columns are eliminated, and what that does to the
/// others, its contribution, is added to its parent. Of both the lower triangle counts. Columns are padded to a multiple
/// of `TILE` rows, so that loops run over whole tiles.
struct Elimination_front
{
  static constexpr int TILE = 4;

  int first = 0;        ///< column of the reordered matrix that is eliminated first
  int width = 0;        ///< columns eliminated
  int height = 0;       ///< rows: those of the columns eliminated, then others, of fronts above
  int parent = -1;      ///< front, -1 for roots
  int first_child = -1; ///< front, -1 for leaves
  int next_sibling = -1;
  int first_entry = 0, end_entry = 0; ///< entries of the matrix in its columns, in `Elimination_fronts::entries()`
  std::size_t rows = 0;               ///< where its rows begin in `Elimination_fronts::rows()`
  std::size_t values = 0;             ///< where its eliminated columns begin in the factor
  std::size_t contribution = 0;       ///< where its contribution lies in the working memory

  int rows_of_parent() const { return height - width; } ///< rows, and columns, of the contribution
  int stride() const { return padded(height); }         ///< from column to column of the factor
  int contribution_stride() const { return padded(rows_of_parent()); }
  std::size_t factor_size() const { return std::size_t(width) * stride(); }
  std::size_t contribution_size() const { return std::size_t(rows_of_parent()) * contribution_stride(); }

private:
  static int padded(int rows) { return (rows + TILE - 1) / TILE * TILE; }
};

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
    make_parts();
    place_columns();
    place_contributions();
    borrow_rows();
  }

  const std::vector<Elimination_front>& fronts() const { return m_fronts; } ///< children before their parents
  const std::vector<int>& places() const { return m_places; }               ///< of the columns in the reordered matrix
  const std::vector<Entry>& entries() const { return m_entries; }           ///< of the matrix, front by front

  /// fronts that come together, children before their parents. All parts but the last are of whole subtrees, and can be
  /// worked on at a time; the last one, which may be all there is, has the fronts above them.
  const std::vector<std::vector<int>>& parts() const { return m_parts; }

  /// of the fronts, in each those that it eliminates first. From #columns on they stand for the rows of `borrowed()`: a
  /// part has its own copies of the rows that it shares with others.
  const std::vector<int>& rows() const { return m_rows; }

  /// rows of the last part, of which other parts have copies: the i-th copy is the row #columns + i
  const std::vector<int>& borrowed() const { return m_borrowed; }

  /// beside `rows()`, for those that a front does not eliminate: their numbers among the rows of its parent
  const std::vector<int>& rows_in_parent() const { return m_rows_in_parent; }

  std::size_t factor_size() const { return m_factor_size; }       ///< numbers, of all fronts
  std::size_t workspace_size() const { return m_workspace_size; } ///< numbers that hold the contributions

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
      for(int e = front.first_entry; e < front.end_entry; ++e)
        m_entries.push_back(
            {entries[e].number, (entries[e].column - front.first) * front.stride() + number_of_row[entries[e].row]});
      for_rows_of_children(front, [&](std::size_t i) { m_rows_in_parent[i] = number_of_row[m_rows[i]]; });
    }
  }

  /// calls `use(i)` for the places in `m_rows` of the rows that the children of a front do not eliminate
  template <class Use>
  void for_rows_of_children(const Elimination_front& front, const Use& use) const
  {
    for(int c = front.first_child; c >= 0; c = m_fronts[c].next_sibling)
      for(int i = m_fronts[c].width; i < m_fronts[c].height; ++i)
        use(m_fronts[c].rows + i);
  }

  /// divides the fronts, where there is enough to do for several threads
  void make_parts()
  {
    std::vector<std::size_t> work(m_fronts.size()); // of the front and all below it
    for(std::size_t f = 0; f < m_fronts.size(); ++f) {
      work[f] += m_fronts[f].factor_size();
      if(m_fronts[f].parent >= 0)
        work[m_fronts[f].parent] += work[f];
    }
    std::size_t whole = 0;
    for(const Elimination_front& front : m_fronts)
      whole += front.factor_size();
    const std::size_t largest = whole / NUMBER_OF_PARTS; // of a subtree
    std::vector<int> part, above;
    std::size_t work_of_part = 0;
    for(std::size_t f = 0; f < m_fronts.size(); ++f) {
      if(whole < LEAST_DIVIDED || work[f] > largest) {
        above.push_back(static_cast<int>(f));
        continue;
      }
      part.push_back(static_cast<int>(f));
      if(const int parent = m_fronts[f].parent; parent >= 0 && work[parent] <= largest)
        continue;
      work_of_part += work[f]; // a subtree is complete
      if(2 * work_of_part > largest) {
        m_parts.push_back(std::exchange(part, {}));
        work_of_part = 0;
      }
    }
    if(!part.empty())
      m_parts.push_back(std::move(part));
    m_parts.push_back(std::move(above));
  }

  /// lays the eliminated columns of the fronts one after the other, part by part. The last tile of rows that is read may
  /// reach beyond a column, and is not to reach what another part writes.
  void place_columns()
  {
    for(const std::vector<int>& part : m_parts) {
      for(int f : part) {
        m_fronts[f].values = m_factor_size;
        m_factor_size += m_fronts[f].factor_size();
      }
      m_factor_size += Elimination_front::TILE;
    }
  }

  /// lays the contributions of each part on two stacks of its own, of fronts of odd and of even depth: a front takes those
  /// of its children from the one, and puts its own on the other
  void place_contributions()
  {
    std::vector<int> stack_of(m_fronts.size(), 0), part_of(m_fronts.size(), 0);
    for(std::size_t f = m_fronts.size(); f-- > 0;)
      if(m_fronts[f].parent >= 0)
        stack_of[f] = 1 - stack_of[m_fronts[f].parent];
    for(std::size_t p = 0; p < m_parts.size(); ++p)
      for(int f : m_parts[p])
        part_of[f] = static_cast<int>(p);
    for(const std::vector<int>& part : m_parts) {
      std::array<std::size_t, 2> size{0, 0}, largest{0, 0};
      for(int f : part) {
        Elimination_front& front = m_fronts[f];
        const int stack = stack_of[f];
        front.contribution = size[stack];
        size[stack] += front.contribution_size();
        largest[stack] = (std::max)(largest[stack], size[stack]);
        for(int c = front.first_child; c >= 0; c = m_fronts[c].next_sibling)
          if(part_of[c] == part_of[f]) // those of other parts stay where they are
            size[1 - stack] = (std::min)(size[1 - stack], m_fronts[c].contribution);
      }
      for(int f : part)
        m_fronts[f].contribution += m_workspace_size + (stack_of[f] == 1 ? largest[0] : 0);
      m_workspace_size += largest[0] + largest[1];
    }
  }

  /// gives all parts but the last their own copies of rows that are eliminated in the last
  void borrow_rows()
  {
    const int n = static_cast<int>(m_places.size());
    std::vector<int> part_of_row(n), copy(n, -1);
    for(std::size_t p = 0; p < m_parts.size(); ++p)
      for(int f : m_parts[p])
        std::fill_n(part_of_row.begin() + m_fronts[f].first, m_fronts[f].width, static_cast<int>(p));
    for(int p = 0; p + 1 < static_cast<int>(m_parts.size()); ++p) {
      const int first_copy = n + static_cast<int>(m_borrowed.size());
      for(int f : m_parts[p])
        for(int i = m_fronts[f].width; i < m_fronts[f].height; ++i) {
          int& row = m_rows[m_fronts[f].rows + i];
          if(part_of_row[row] == p)
            continue;
          if(copy[row] < first_copy) {
            copy[row] = n + static_cast<int>(m_borrowed.size());
            m_borrowed.push_back(row);
          }
          row = copy[row];
        }
    }
  }

  /// subtrees of the fronts have at most such a part of the numbers of the factor, and parts about half as much or more.
  /// More: fronts above them, which are worked on one after the other, are larger than need be on few threads.
  static constexpr std::size_t NUMBER_OF_PARTS = 16;

  /// numbers of a factor that is divided, at least: one solution with it takes as long as some ten calls of threads
  static constexpr std::size_t LEAST_DIVIDED = 100000;

  std::vector<Elimination_front> m_fronts;
  std::vector<int> m_places;
  std::vector<int> m_rows, m_rows_in_parent;
  std::vector<std::vector<int>> m_parts;
  std::vector<int> m_borrowed;
  std::vector<Entry> m_entries;
  std::size_t m_factor_size = 0, m_workspace_size = 0;
};

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ITERATION_ELIMINATION_FRONTS_H
