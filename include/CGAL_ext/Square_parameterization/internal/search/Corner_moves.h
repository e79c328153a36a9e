// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SEARCH_CORNER_MOVES_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SEARCH_CORNER_MOVES_H

#include <CGAL_ext/Square_parameterization/internal/border/border_curves.h>
#include <CGAL_ext/Square_parameterization/internal/border/corners_at_shares.h>
#include <CGAL_ext/Square_parameterization/internal/search/Corner_evaluation.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// searches four corners among all border vertices by pattern search: all four, opposite pairs (together and
/// against each other) and single ones move by as many vertices, to and fro, to the best of these places; the steps
/// halve where none is lower. Pure decisions over
/// the objectives; each choice of corners is evaluated once. Deterministic.
class Corner_moves
{
public:
  typedef Corner_choice Choice;

  /// the objectives of choices of corners, in their order; infinite for one without a map. They are moved from the
  /// choice, if it is not null: objectives that are larger than its one need only be near.
  typedef std::function<std::vector<double>(const std::vector<Corners>&, const Choice* near)> Objective_of;

  /// \param lengths #B, edge k joins border vertices k and k + 1
  /// \param is_exhausted asked before each step: `true` leaves the corners where they are. May be empty.
  /// \param least_step in border vertices; no step is shorter
  Corner_moves(std::vector<double> lengths, Objective_of objective_of, std::function<bool()> is_exhausted = {},
               int least_step = 1)
    : m_lengths(std::move(lengths)),
      m_objective_of(std::move(objective_of)),
      m_is_exhausted(std::move(is_exhausted)),
      m_least_step(least_step)
  {}

  /// the choices that a step compares
  static std::size_t number_of_moves() { return all_moves().size(); }

  /// takes over the objective of a choice that was evaluated otherwise
  void add(const Choice& known) { m_known[known.corners] = known.objective; }

  /// the number of choices that were evaluated
  std::size_t evaluations() const { return m_known.size(); }

  /// evaluates choices, and returns them from the best to the worst
  /// \param near what they are moved from; may be null
  std::vector<Choice> compare(const std::vector<Corners>& corners, const Choice* near = nullptr)
  {
    const std::set<Corners> distinct(corners.begin(), corners.end());
    std::vector<Corners> unknown;
    for(const Corners& choice : distinct)
      if(m_known.count(choice) == 0)
        unknown.push_back(choice);
    const std::vector<double> objectives = m_objective_of(unknown, near);
    for(std::size_t i = 0; i < unknown.size(); ++i)
      m_known[unknown[i]] = objectives[i];
    std::vector<Choice> choices;
    for(const Corners& choice : distinct)
      choices.push_back({choice, m_known.at(choice)});
    std::sort(choices.begin(), choices.end());
    return choices;
  }

  /// how thoroughly corners are moved
  enum Effort
  {
    ALL,   ///< all moves with every step: where the energy has many valleys
    LIKELY ///< all moves with the first step, the last, and wherever one of them led down; where none did, the steps
           ///< between only go where the parabolas through the three objectives to and fro have their lowest points
  };

  /// moves corners downhill
  /// \param first_step in border vertices; the least step where that is longer
  Choice descend(Corners corners, int first_step, Effort effort = ALL)
  {
    Choice best = compare({corners}).front();
    std::vector<Move> moves = all_moves();
    for(int step = (std::max)(m_least_step, first_step); step >= m_least_step && !is_exhausted();) {
      const std::vector<Choice> choices = compare(moved(best.corners, moves, step), &best);
      if(!choices.empty() && is_lower(choices.front(), best)) {
        best = choices.front();
        moves = all_moves();
        continue;
      }
      if(effort == LIKELY && moves.size() == all_moves().size())
        moves = moves_to_bottoms(best, step);
      step /= 2;
      if(step / 2 < m_least_step)
        moves = all_moves();
    }
    return best;
  }

  /// moves corners downhill from afar, with a first step of an eighth of the border: by likely moves on the square
  Choice descend_from_afar(const Corners& corners, bool is_square)
  {
    return descend(corners, size() / 8, is_square ? LIKELY : ALL);
  }

  /// moves corners downhill, but only where another, rougher objective does not rise much; stops once smaller steps promise no
  /// gain, as on the border of a round surface
  Choice descend_where_likely(const Corners& corners, int first_step, Corner_moves& rough)
  {
    Choice best = compare({corners}).front();
    for(int step = (std::max)(m_least_step, first_step); step >= m_least_step && !is_exhausted();) {
      const Choice start = rough.compare({best.corners}).front();
      std::vector<Corners> likely;
      for(const Choice& choice : rough.compare(moved(best.corners, all_moves(), step), &start))
        if(choice.objective < (1 + LIKELY_RISE) * start.objective)
          likely.push_back(choice.corners);
      const std::vector<Choice> choices = compare(likely, &best);
      if(!choices.empty() && is_lower(choices.front(), best))
        best = choices.front();
      else if(promises_gain(best, step, rough, start))
        step /= 2;
      else
        break;
    }
    return best;
  }

  /// the best of choices that are spread over the border, to start from where the rectangle may be far from the square:
  /// the first and the third side have one of several shares of the border, the others what is left of a half
  std::vector<Choice> best_of_spread()
  {
    constexpr int ROTATIONS = 12; // over half of the border
    constexpr std::size_t BEST = 4;
    std::vector<Corners> spread;
    for(int i = 0; i < ROTATIONS; ++i)
      for(double share : {0.03, 0.07, 0.12, 0.18, 0.25, 0.32, 0.38, 0.43, 0.47}) {
        const double start = 0.5 * i / ROTATIONS;
        if(const auto corners = corners_at_shares(m_lengths, {start, start + share, start + 0.5, start + 0.5 + share}))
          spread.push_back(*corners);
      }
    std::vector<Choice> choices = compare(spread);
    choices.resize((std::min)(choices.size(), BEST));
    return choices;
  }

private:
  int size() const { return static_cast<int>(m_lengths.size()); }

  bool is_exhausted() const { return m_is_exhausted && m_is_exhausted(); }

  /// indicates whether a choice is worth a move
  static bool is_lower(const Choice& choice, const Choice& best)
  {
    return choice.objective < (1 - LEAST_GAIN) * best.objective;
  }

  /// how many steps each corner goes
  typedef std::array<int, 4> Move;

  /// a corner each, all, and opposite pairs, which go together or against each other; to and fro
  static const std::vector<Move>& all_moves()
  {
    static const std::vector<Move> moves{{1, 1, 1, 1},   {-1, -1, -1, -1}, {1, 0, 1, 0},  {-1, 0, -1, 0}, {0, 1, 0, 1},
                                         {0, -1, 0, -1}, {1, 0, -1, 0},    {-1, 0, 1, 0}, {0, 1, 0, -1},  {0, -1, 0, 1},
                                         {1, 0, 0, 0},   {-1, 0, 0, 0},    {0, 1, 0, 0},  {0, -1, 0, 0},  {0, 0, 1, 0},
                                         {0, 0, -1, 0},  {0, 0, 0, 1},     {0, 0, 0, -1}};
    return moves;
  }

  /// slope x + curvature x^2: what the objective rises by after x steps of a move, if it is a parabola
  struct Parabola
  {
    double slope, curvature;

    /// \param rise_to,rise_fro after one step, and after one step of the opposite move
    Parabola(double rise_to, double rise_fro) : slope((rise_to - rise_fro) / 2), curvature((rise_to + rise_fro) / 2) {}

    double bottom() const { return -slope / (2 * curvature); }

    /// indicates whether it falls by more than that between the two steps
    bool falls_between(double fall) const
    {
      return std::abs(slope) < 2 * curvature && slope * slope > 4 * curvature * fall;
    }
  };

  /// those on the side of which the parabola of a way to and fro is lowest, at some distance
  /// \pre all ways were tried with this step, and none led down
  std::vector<Move> moves_to_bottoms(const Choice& best, int step) const
  {
    std::vector<Move> result;
    for(std::size_t i = 0; i < all_moves().size(); i += 2) {
      const double bottom =
          Parabola(rise(best, all_moves()[i], step), rise(best, all_moves()[i + 1], step)).bottom(); // in steps
      if(bottom >= LEAST_OFFSET)
        result.push_back(all_moves()[i]);
      else if(bottom <= -LEAST_OFFSET)
        result.push_back(all_moves()[i + 1]);
    }
    return result;
  }

  /// indicates whether smaller steps may lead down: for some pair of opposite moves the parabola through the objectives here and
  /// after either move has a lowest point between them that is worth a move, or nothing is known of them. An objective that is
  /// not known is taken to be as much higher as the rougher one.
  /// \pre all moves were tried with this step, by the rougher objective at least, and none led down
  bool promises_gain(const Choice& best, int step, const Corner_moves& rough, const Choice& rough_best) const
  {
    const auto relative_rise = [&](const Move& move) {
      const bool is_known = m_known.count(after(best.corners, move, step)) > 0;
      const Choice& from = is_known ? best : rough_best;
      return (is_known ? *this : rough).rise(from, move, step) / from.objective;
    };
    for(std::size_t i = 0; i < all_moves().size(); i += 2) {
      const Parabola parabola(relative_rise(all_moves()[i]), relative_rise(all_moves()[i + 1]));
      const bool is_known = parabola.curvature < 1; // one of them has a map, and so has the best
      if(!is_known || parabola.falls_between(LEAST_GAIN))
        return true;
    }
    return false;
  }

  /// what a move costs; a lot where there is no such map
  double rise(const Choice& best, const Move& move, int step) const
  {
    const auto known = m_known.find(after(best.corners, move, step));
    const double objective = known == m_known.end() ? 2 * best.objective : known->second;
    return (std::min)(objective, 2 * best.objective) - best.objective;
  }

  Corners after(Corners corners, const Move& move, int step) const
  {
    for(int k = 0; k < 4; ++k)
      corners[k] = (corners[k] + (step * move[k]) % size() + size()) % size();
    return corners;
  }

  std::vector<Corners> moved(const Corners& corners, const std::vector<Move>& moves, int step) const
  {
    std::vector<Corners> result;
    for(const Move& move : moves)
      if(const Corners next = after(corners, move, step); are_corners_in_order(next, size()))
        result.push_back(next);
    return result;
  }

  static constexpr double LEAST_GAIN = 1e-5; // relative: with less, corners would creep along a border of thousands

  static constexpr double LEAST_OFFSET = 0.2; // of a lowest point, in steps: half a step of the next ones, nearly

  static constexpr double LIKELY_RISE = 5e-4; // of a rougher objective, relative

  std::vector<double> m_lengths;
  Objective_of m_objective_of;
  std::function<bool()> m_is_exhausted;
  int m_least_step;
  std::map<Corners, double> m_known;
};

/// the corners of candidates that are spread evenly over the quarter of the border, to start from: of sixteen, or of all
/// where there are fewer. Eight miss the best valley of some borders.
/// \param border_lengths #B, edge k joins border vertices k and k + 1
inline std::vector<Corners> corners_of_spread_candidates(const std::vector<double>& border_lengths)
{
  const Border_walk walk(border_lengths, Walk::COUNTER_CLOCKWISE);
  const int candidates = number_of_quarter_candidates(walk);
  const int count = (std::min)(16, candidates);
  std::vector<Corners> corners;
  for(int i = 0; i < count; ++i)
    corners.push_back(corners_of_candidate(walk, static_cast<int>(long(i) * candidates / count), Corner_rule::NEAREST));
  return corners;
}

/// moves of the corners of a patch that are compared by maps: these start from that of the choice that is moved, or from
/// \p first, which may be null. On rectangles that differ in their aspect maps come down slowly, and are not given up before.
inline Corner_moves moves_by_maps(const Patch& patch, Corner_evaluation& maps, std::function<bool()> is_exhausted,
                                  const Uv_coordinates* first = nullptr)
{
  const auto objective_of = [&maps, first](const std::vector<Corners>& choices, const Corner_choice* near) {
    if(near == nullptr)
      return maps(choices, {choices.size(), first});
    const bool is_square = maps.best_map().aspect == 1;
    return maps(choices, {choices.size(), maps.warm_start(near->corners)},
                is_square ? near->objective : std::numeric_limits<double>::infinity());
  };
  return {patch.border_lengths, objective_of, std::move(is_exhausted), maps.least_step()};
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SEARCH_CORNER_MOVES_H
