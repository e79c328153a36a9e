// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_GROW_CUT_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_GROW_CUT_H

#include <CGAL_ext/Square_parameterization/Cut_report.h>
#include <CGAL_ext/Square_parameterization/internal/initial_cut.h>
#include <CGAL_ext/Square_parameterization/internal/reroute_cut.h>
#include <CGAL_ext/Square_parameterization/internal/score_cut.h>

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
  int roots = 12; ///< trees tried on a closed surface with handles
};

/// vertices far from the seams, each far from those before it, too
inline std::vector<int> successive_farthest_points(const Triangle_surface& surface, const Cut& cut, int count)
{
  std::vector<int> sources = seam_vertices(surface, cut), farthest;
  while(static_cast<int>(farthest.size()) < count) {
    const int v = farthest_vertex(shortest_paths(surface, sources));
    if(std::find(sources.begin(), sources.end(), v) != sources.end())
      break; // no vertex is left
    farthest.push_back(v);
    sources.push_back(v);
  }
  return farthest;
}

/// the vertices away from the seams where the map of the opened surface onto the circle stretches most: local maxima,
/// highest first
inline std::vector<int> circle_stretch_maxima(const Triangle_surface& surface, const Cut& cut, int count)
{
  std::vector<double> sigma;
  try {
    const Patch patch = patch_of_cut(surface, cut);
    Stretch_minimization minimization;
    minimization.maximum_iterations = 5;
    const Stretch_iteration iteration = minimization.make_iteration(patch);
    Stretch_iteration::Workspace workspace;
    const Minimized_map map =
        iteration.minimize(circular_border(patch.border_lengths, std::sqrt(1 / EIGEN_PI)), 1, workspace);
    if(map.uv.rows() == 0)
      return {};
    stretch_energy(patch, map.uv, sigma);
  } catch(const Unmappable&) {
    return {};
  }
  const auto is_seam = [&](int v) { return cut.degree(v) > 0 || surface.is_border_vertex[v]; };
  std::vector<int> maxima;
  for(int v = 0; v < surface.number_of_vertices(); ++v) {
    const auto& incident = surface.vertex_edges[v];
    if(!is_seam(v) && std::none_of(incident.begin(), incident.end(), [&](int e) {
         const int w = surface.other_end(e, v);
         return !is_seam(w) && sigma[w] > sigma[v];
       }))
      maxima.push_back(v);
  }
  std::stable_sort(maxima.begin(), maxima.end(), [&sigma](int a, int b) { return sigma[a] > sigma[b]; });
  maxima.resize((std::min)(maxima.size(), static_cast<std::size_t>(count)));
  return maxima;
}

/// the cuts that growth may start from: one for each of several roots on a closed surface with handles, where the
/// shortest is often not the best; else one
inline std::vector<Cut> rerouted_initial_cuts(const Triangle_surface& surface, int roots)
{
  std::vector<Cut> cuts;
  std::vector<int> sources{0};
  const bool has_choice = surface.border_loops.empty() && surface.genus() > 0;
  for(int i = 0; i < (has_choice ? roots : 1); ++i) {
    cuts.emplace_back(surface);
    initial_cut(surface, sources.back(), cuts.back());
    reroute_cut(surface, cuts.back());
    sources.push_back(farthest_vertex(shortest_paths(surface, sources)));
  }
  return cuts;
}

/// decides on a cut of one surface: terminals are added, dropped and moved while that pays. Every cut is scored once.
class Cut_growth
{
public:
  Cut_growth(const Triangle_surface& surface, const Cut_growth_options& options, Cut_report& report)
    : m_surface(surface), m_options(options), m_report(report)
  {}

  /// the best cut met on the way from the best of \p starts to long cuts, and back
  Cut grow(std::vector<Cut> starts)
  {
    Scored_cut best = best_start(std::move(starts));
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

  Cut_score score(const Cut& cut)
  {
    const auto [place, is_new] = m_scores.try_emplace(cut.edges());
    if(is_new)
      place->second = score_cut(m_surface, cut, m_options.scoring);
    return place->second;
  }

  /// the best of the cuts; infinite when there is none
  Scored_cut best_of(std::vector<Trial> trials)
  {
    Scored_cut best{Cut(m_surface), {}, -1};
    for(Trial& trial : trials) {
      const Cut_score trial_score = score(trial.cut);
      if(&trial == &trials.front() || trial_score.score < best.score.score)
        best = {std::move(trial.cut), trial_score, trial.terminal};
    }
    return best;
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
  std::vector<Trial> extensions(const Cut& shorter, const std::vector<int>& terminals) const
  {
    std::vector<Trial> trials;
    for(int terminal : terminals) {
      Cut cut = shorter;
      connect_terminal(m_surface, terminal, cut);
      reroute_cut(m_surface, cut);
      if(cut.length(m_surface) <= m_options.max_cut_length * std::sqrt(m_surface.area))
        trials.push_back({std::move(cut), terminal});
    }
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
      std::vector<Trial> trials = extensions(current.cut, candidate_terminals(current.cut));
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

  std::vector<int> candidate_terminals(const Cut& cut) const
  {
    std::vector<int> candidates = successive_farthest_points(m_surface, cut, m_options.candidates);
    for(int v : circle_stretch_maxima(m_surface, cut, m_options.candidates))
      if(std::find(candidates.begin(), candidates.end(), v) == candidates.end())
        candidates.push_back(v);
    return candidates;
  }

  /// a sphere is not cut without two terminals
  std::size_t least_terminals() const { return m_surface.border_loops.empty() && m_surface.genus() == 0 ? 2 : 0; }

  /// the best of the cuts with one terminal less
  Scored_cut best_shorter(const Cut& cut)
  {
    std::vector<Trial> trials;
    for(int terminal : cut.terminals())
      trials.push_back({without(terminal, cut), terminal});
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
        std::vector<int> places = candidate_terminals(shorter);
        for(int e : m_surface.vertex_edges[terminal])
          places.push_back(m_surface.other_end(e, terminal));
        Scored_cut moved = best_of(extensions(shorter, places));
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
  Cut_report& m_report;
  std::map<std::vector<int>, Cut_score> m_scores; // per edges of a cut
};

} // namespace internal
} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_GROW_CUT_H
