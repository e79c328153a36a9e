// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SAMPLING_FIT_COUNTS_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SAMPLING_FIT_COUNTS_H

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL_ext {
namespace internal {

/// a number of intervals between samples that is to be chosen: that of a segment of the border, and of its partner
struct Interval_count
{
  std::array<int, 2> sides; ///< of the square, on which the intervals lie; -1 as the second for a segment alone
  double ideal;             ///< positive
  int least;                ///< at least 1
};

/// chooses whole numbers near the ideal ones, so that every side of the square gets the intervals that it has.
///
/// Each number is rounded at first. Then, while a side lacks intervals or has too many, the cheapest chain of changes by
/// one mends it: a chain, for what is added to a segment is added to its partner, which may lie on another side.
class Count_fitting
{
public:
  explicit Count_fitting(const std::vector<Interval_count>& counts) : m_counts(counts)
  {
    for(const Interval_count& count : counts)
      m_chosen.push_back((std::max)(count.least, static_cast<int>(std::lround((std::min)(count.ideal, 1e6)))));
  }

  /// the numbers; nothing when there are none with these sums
  std::optional<std::vector<int>> operator()(const std::array<int, 4>& totals)
  {
    m_needs = totals;
    for(std::size_t c = 0; c < m_counts.size(); ++c)
      add_to_needs(c, -m_chosen[c]);
    while(m_needs != std::array<int, 4>{})
      if(!mend())
        return {};
    return m_chosen;
  }

  /// how far the numbers are from the ideal ones
  double cost() const
  {
    double sum = 0;
    for(std::size_t c = 0; c < m_counts.size(); ++c)
      sum += cost_of(c, m_chosen[c]);
    return sum;
  }

private:
  /// a side that must get one interval more, or less
  struct State
  {
    int side, sign;
  };

  /// a change of one number by one, after which another side may need the opposite
  struct Change
  {
    double cost = std::numeric_limits<double>::infinity();
    int count = -1;
  };

  static constexpr int SIDES = 4, LONGEST_CHAIN = 8; // no state twice

  static int index(State state) { return 2 * state.side + (state.sign > 0 ? 1 : 0); }

  void add_to_needs(std::size_t c, int amount)
  {
    for(int side : m_counts[c].sides)
      if(side >= 0)
        m_needs[side] += amount;
  }

  double cost_of(std::size_t c, int number) const
  {
    const double ideal = (std::max)(m_counts[c].ideal, 0.1);
    return (number - ideal) * (number - ideal) / ideal;
  }

  /// the cheapest change, by \p sign, of a number of side \p from that goes with side \p to; -1 for segments alone
  Change cheapest_change(int from, int to, int sign) const
  {
    Change best;
    for(std::size_t c = 0; c < m_counts.size(); ++c) {
      const auto& [a, b] = m_counts[c].sides;
      const bool fits = (a == from && b == to) || (a == to && b == from);
      if(!fits || m_chosen[c] + sign < m_counts[c].least)
        continue;
      const double cost = cost_of(c, m_chosen[c] + sign) - cost_of(c, m_chosen[c]);
      if(cost < best.cost)
        best = {cost, static_cast<int>(c)};
    }
    return best;
  }

  /// applies the cheapest chain that brings a side nearer to what it needs; returns whether there is one
  bool mend()
  {
    Change changes[SIDES][SIDES + 1][2];
    for(int from = 0; from < SIDES; ++from)
      for(int to = -1; to < SIDES; ++to)
        for(int sign : {-1, 1})
          changes[from][to + 1][sign > 0 ? 1 : 0] = cheapest_change(from, to, sign);
    Chain best;
    for(int side = 0; side < SIDES; ++side)
      if(m_needs[side] != 0) {
        const Chain chain = cheapest_chain({side, m_needs[side] > 0 ? 1 : -1}, changes);
        if(chain.cost < best.cost)
          best = chain;
      }
    for(const auto& [count, sign] : best.changes) {
      m_chosen[count] += sign;
      add_to_needs(static_cast<std::size_t>(count), -sign);
      if(m_chosen[count] < m_counts[count].least) // changed twice
        return false;
    }
    return !best.changes.empty();
  }

  struct Chain
  {
    double cost = std::numeric_limits<double>::infinity();
    std::vector<std::array<int, 2>> changes; // of which number, and by what
  };

  /// the cheapest chain from a state to the end: a segment alone, or a side that needs what is done to it
  template <class Changes>
  Chain cheapest_chain(State start, const Changes& changes) const
  {
    std::array<int, 4> needs = m_needs;
    needs[start.side] -= start.sign;
    std::vector<Chain> reached(2 * SIDES);
    reached[index(start)].cost = 0;
    Chain best;
    for(int length = 0; length < LONGEST_CHAIN; ++length) {
      std::vector<Chain> next(2 * SIDES);
      for(int side = 0; side < SIDES; ++side)
        for(int sign : {-1, 1}) {
          const Chain& chain = reached[index({side, sign})];
          for(int to = -1; to < SIDES && chain.cost < best.cost; ++to) {
            const Change& change = changes[side][to + 1][sign > 0 ? 1 : 0];
            const bool is_last = to < 0 || needs[to] * sign > 0;
            Chain& target = is_last ? best : next[index({to, -sign})];
            if(change.count >= 0 && chain.cost + change.cost < target.cost) {
              target = chain;
              target.cost += change.cost;
              target.changes.push_back({change.count, sign});
            }
          }
        }
      reached = std::move(next);
    }
    return best;
  }

  const std::vector<Interval_count>& m_counts;
  std::vector<int> m_chosen;
  std::array<int, 4> m_needs{};
};

} // namespace internal
} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SAMPLING_FIT_COUNTS_H
