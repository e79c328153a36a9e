// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ITERATION_FRONT_DIVISION_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ITERATION_FRONT_DIVISION_H

#include <CGAL_ext/Square_parameterization/internal/iteration/Elimination_front.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// fronts that one thread works on, children before their parents. Parts of one stage can be worked on at a time, when
/// those of the stages before have been: each has its own copies of the rows of fronts above it.
struct Front_part
{
  std::vector<int> fronts;
  int parent = -1;                  ///< the part of the fronts above it, of a later stage
  std::vector<int> children;        ///< parts
  int first_copy = 0, end_copy = 0; ///< numbers of its copies of rows
};

/// divides fronts, where there is enough to do for several threads: into small subtrees, some of them in one part, and the
/// fronts above them, which make a new part where parts meet. Does not depend on the number of threads.
class Front_division
{
public:
  /// \param fronts children before their parents
  explicit Front_division(const std::vector<Elimination_front>& fronts) : m_part_of(fronts.size(), NONE)
  {
    const std::vector<std::size_t> work = work_of_subtrees(fronts);
    std::size_t whole = 0;
    for(std::size_t f = 0; f < fronts.size(); ++f)
      whole += fronts[f].parent < 0 ? work[f] : 0;
    const std::size_t largest = whole < LEAST_DIVIDED ? 2 * whole : whole / LARGEST_SMALL_PART;
    for(std::size_t f = 0; f < fronts.size(); ++f)
      if(work[f] > largest)
        add_large(fronts, static_cast<int>(f));
    add_small(fronts, work, largest);
    for(Front_part& part : m_parts)
      std::sort(part.fronts.begin(), part.fronts.end());
    sort_parts();
  }

  /// the parts, those of a stage one after the other
  std::vector<Front_part>& parts() { return m_parts; }

  /// where the parts of each stage begin, and #parts
  std::vector<int>& stages() { return m_stages; }

  /// per front, its part
  const std::vector<int>& part_of() const { return m_part_of; }

private:
  static constexpr int NONE = -1;

  /// small subtrees have at most the 16th part of the numbers of the factor. More than 16: more copies of rows; less: parts that
  /// are not enough for all threads.
  static constexpr std::size_t LARGEST_SMALL_PART = 16;

  /// numbers of a factor that is divided, at least: one solution with it takes as long as some ten calls of threads
  static constexpr std::size_t LEAST_DIVIDED = 100000;

  /// numbers of the factor in each front and all below it
  static std::vector<std::size_t> work_of_subtrees(const std::vector<Elimination_front>& fronts)
  {
    std::vector<std::size_t> work(fronts.size(), 0);
    for(std::size_t f = 0; f < fronts.size(); ++f) {
      work[f] += fronts[f].factor_size();
      if(fronts[f].parent >= 0)
        work[fronts[f].parent] += work[f];
    }
    return work;
  }

  int add_part(int stage)
  {
    m_parts.emplace_back();
    m_stage.push_back(stage);
    return static_cast<int>(m_parts.size()) - 1;
  }

  void add(int front, int part)
  {
    m_part_of[front] = part;
    m_parts[part].fronts.push_back(front);
  }

  /// adds a front that is not in a small subtree: to the part below it, where there is only one
  void add_large(const std::vector<Elimination_front>& fronts, int front)
  {
    std::vector<int> below;
    int latest = 0;
    for(int c = fronts[front].first_child; c >= 0; c = fronts[c].next_sibling)
      if(m_part_of[c] != NONE) {
        below.push_back(m_part_of[c]);
        latest = (std::max)(latest, m_stage[below.back()]);
      }
    add(front, below.size() == 1 ? below[0] : add_part(latest + 1));
    for(int part : below)
      if(part != m_part_of[front])
        m_parts[part].parent = m_part_of[front];
  }

  /// adds the small subtrees, in parts below those that there are
  void add_small(const std::vector<Elimination_front>& fronts, const std::vector<std::size_t>& work,
                 std::size_t largest)
  {
    struct Open_part // takes more subtrees
    {
      int part = NONE;
      std::size_t work = 0;
    };
    std::vector<Open_part> open(m_parts.size() + 1); // below each part, and below none
    for(int f = static_cast<int>(fronts.size()) - 1; f >= 0; --f) {
      if(m_part_of[f] != NONE)
        continue;
      const int above = fronts[f].parent;
      if(above >= 0 && work[above] <= largest) {
        add(f, m_part_of[above]);
        continue;
      }
      const int parent = above < 0 ? NONE : m_part_of[above];
      Open_part& under = open[parent + 1];
      if(under.part == NONE || 2 * under.work > largest) {
        under = {add_part(0), 0};
        m_parts[under.part].parent = parent;
      }
      under.work += work[f];
      add(f, under.part);
    }
  }

  /// puts the parts in the order of their stages
  void sort_parts()
  {
    std::vector<int> order(m_parts.size()), number(m_parts.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [this](int p, int q) { return m_stage[p] < m_stage[q]; });
    std::vector<Front_part> sorted;
    for(std::size_t i = 0; i < order.size(); ++i) {
      number[order[i]] = static_cast<int>(i);
      if(i == 0 || m_stage[order[i]] != m_stage[order[i - 1]])
        m_stages.push_back(static_cast<int>(i));
      sorted.push_back(std::move(m_parts[order[i]]));
    }
    m_stages.push_back(static_cast<int>(order.size()));
    m_parts = std::move(sorted);
    for(int& part : m_part_of)
      part = number[part];
    for(std::size_t p = 0; p < m_parts.size(); ++p)
      if(int& parent = m_parts[p].parent; parent != NONE) {
        parent = number[parent];
        m_parts[parent].children.push_back(static_cast<int>(p));
      }
  }

  std::vector<Front_part> m_parts;
  std::vector<int> m_stages;
  std::vector<int> m_part_of; // per front
  std::vector<int> m_stage;   // per part, before they are sorted
};

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ITERATION_FRONT_DIVISION_H
