// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_GROW_CUT_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_GROW_CUT_H

#include <CGAL_ext/Square_parameterization/Cut_report.h>
#include <CGAL_ext/Square_parameterization/internal/candidate_terminals.h>
#include <CGAL_ext/Square_parameterization/internal/rerouted_initial_cuts.h>

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <vector>

namespace CGAL_ext {
namespace internal {

/// a cut and what it is worth
struct Scored_cut
{
  Cut cut;
  Cut_score score;
  int terminal; ///< that it was changed for last; -1 for none
};

/// the numbers of the growth
struct Cut_growth_options
{
  Cut_score_options scoring;
  double max_cut_length = std::numeric_limits<double>::infinity(); ///< in units of sqrt(area)
  int maximum_additions = 10;
  int patience = 3;   ///< additions in a row that may fail to lower the score
  int candidates = 5; ///< farthest points, and as many stretch maxima, for a terminal that is added or moved
  int rounds_of_moves = 2;
};

/// decides on a cut of one surface: terminals are added, dropped and moved while that pays. Every cut is scored once, and
/// those that compete concurrently: the decision is the same for any number of threads.
class Cut_growth
{
public:
  Cut_growth(const Triangle_surface& surface, const Cut_growth_options& options, Thread_team& team, Cut_report& report)
    : m_surface(surface), m_options(options), m_team(team), m_report(report)
  {}

  /// the best cut met on the way from the best of the initial cuts to long ones, and back
  Cut grow()
  {
    Scored_cut best = best_start(rerouted_initial_cuts(m_surface, m_team));
    Scored_cut overgrown = add_terminals(best);
    drop_terminals(std::move(overgrown), best);
    return best.cut;
  }

  /// the best of \p cuts with its terminals moved and without those that no longer pay
  Cut polish(std::vector<Cut> cuts)
  {
    Scored_cut best = best_start(std::move(cuts));
    move_terminals(best);
    drop_terminals(best, best);
    return best.cut;
  }

private:
  /// a cut to be judged and the terminal that it was changed for
  struct Trial
  {
    Cut cut;
    int terminal;
  };

  /// the scores of the cuts, in their order
  std::vector<Cut_score> scores(const std::vector<Trial>& trials)
  {
    std::vector<std::pair<const Cut*, Cut_score*>> missing;
    std::vector<const Cut_score*> places;
    for(const Trial& trial : trials) {
      const auto [place, is_new] = m_scores.try_emplace(trial.cut.edges());
      places.push_back(&place->second);
      if(is_new)
        missing.emplace_back(&trial.cut, &place->second);
    }
    m_team(missing.size(),
           [&](std::size_t i) { *missing[i].second = score_cut(m_surface, *missing[i].first, m_options.scoring); });
    std::vector<Cut_score> result;
    for(const Cut_score* place : places)
      result.push_back(*place);
    return result;
  }

  /// the best of the cuts (ties: the first)
  Scored_cut best_of(std::vector<Trial> trials)
  {
    const std::vector<Cut_score> all = scores(trials);
    const auto least = std::min_element(all.begin(), all.end(),
                                        [](const Cut_score& a, const Cut_score& b) { return a.score < b.score; });
    Trial& best = trials[least - all.begin()];
    return {std::move(best.cut), *least, best.terminal};
  }

  Scored_cut best_start(std::vector<Cut> cuts)
  {
    std::vector<Trial> trials;
    for(Cut& cut : cuts)
      trials.push_back({std::move(cut), -1});
    Scored_cut best = best_of(std::move(trials));
    record(Cut_step::INITIAL, best);
    return best;
  }

  void record(Cut_step::Kind kind, const Scored_cut& step)
  {
    m_report.history.push_back({kind, step.terminal, step.score.score, step.score.stretch, step.score.length});
  }

  /// the cuts that reach one terminal more, of those that are not too long
  std::vector<Trial> extensions(const Cut& shorter, const std::vector<int>& terminals)
  {
    std::vector<Trial> trials(terminals.size(), {shorter, -1});
    m_team(terminals.size(), [&](std::size_t i) {
      trials[i].terminal = terminals[i];
      connect_terminal(m_surface, terminals[i], trials[i].cut);
      reroute_cut(m_surface, trials[i].cut);
    });
    const double limit = m_options.max_cut_length * std::sqrt(m_surface.area);
    trials.erase(std::remove_if(trials.begin(), trials.end(),
                                [&](const Trial& trial) { return trial.cut.length(m_surface) > limit; }),
                 trials.end());
    return trials;
  }

  /// the cut without one of its terminals
  Cut without(int terminal, Cut cut) const
  {
    cut.remove_terminal(terminal);
    prune(m_surface, cut);
    reroute_cut(m_surface, cut);
    return cut;
  }

  /// adds, as long as patience lasts, the terminal that gives the least score; \p best becomes the best on the way.
  /// Returns the last.
  Scored_cut add_terminals(Scored_cut& best)
  {
    Scored_cut current = best;
    int failures = 0;
    for(int i = 0; i < m_options.maximum_additions && failures < m_options.patience; ++i) {
      std::vector<Trial> trials =
          extensions(current.cut, candidate_terminals(m_surface, current.cut, m_options.candidates));
      if(trials.empty())
        break;
      current = best_of(std::move(trials));
      record(Cut_step::ADDED, current);
      failures = current.score.score < best.score.score ? 0 : failures + 1;
      if(failures == 0)
        best = current;
    }
    return current;
  }

  /// a sphere is not cut without two terminals
  std::size_t least_terminals() const { return m_surface.border_loops.empty() && m_surface.genus() == 0 ? 2 : 0; }

  /// the best of the cuts with one terminal less
  Scored_cut best_shorter(const Cut& cut)
  {
    std::vector<Trial> trials;
    for(int terminal : cut.terminals())
      trials.push_back({cut, terminal});
    m_team(trials.size(),
           [&](std::size_t i) { trials[i].cut = without(trials[i].terminal, std::move(trials[i].cut)); });
    return best_of(std::move(trials));
  }

  /// drops, as long as patience lasts, the terminal whose loss gives the least score; \p best becomes the best on the
  /// way
  void drop_terminals(Scored_cut current, Scored_cut& best)
  {
    int failures = 0;
    while(current.cut.terminals().size() > least_terminals() && failures < m_options.patience) {
      current = best_shorter(current.cut);
      record(Cut_step::DROPPED, current);
      failures = current.score.score < best.score.score ? 0 : failures + 1;
      if(failures == 0)
        best = current;
    }
  }

  /// lets each terminal in turn give way to a better one, as long as the score falls
  void move_terminals(Scored_cut& best)
  {
    bool is_changed = true;
    for(int round = 0; round < m_options.rounds_of_moves && is_changed; ++round) {
      is_changed = false;
      for(int terminal : std::vector<int>(best.cut.terminals())) {
        if(best.cut.terminals().size() <= least_terminals())
          return;
        const Cut shorter = without(terminal, best.cut);
        std::vector<int> places = candidate_terminals(m_surface, shorter, m_options.candidates);
        for(int e : m_surface.vertex_edges[terminal])
          places.push_back(m_surface.other_end(e, terminal));
        std::vector<Trial> trials = extensions(shorter, places);
        if(trials.empty())
          continue;
        Scored_cut moved = best_of(std::move(trials));
        if(moved.score.score < best.score.score) {
          best = std::move(moved);
          record(Cut_step::MOVED, best);
          is_changed = true;
        }
      }
    }
  }

  const Triangle_surface& m_surface;
  const Cut_growth_options& m_options;
  Thread_team& m_team;
  Cut_report& m_report;
  std::map<std::vector<int>, Cut_score> m_scores; // per edges of a cut
};

} // namespace internal
} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_GROW_CUT_H
