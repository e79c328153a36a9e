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
#include <optional>
#include <vector>

namespace CGAL_ext {
namespace internal {

/// a cut and what it is worth
struct Scored_cut
{
  Cut cut;
  Cut_score score;
};

/// the numbers of the growth
struct Cut_growth_options
{
  Cut_score_options scoring;
  double max_cut_length = std::numeric_limits<double>::infinity(); ///< in units of sqrt(area)
  int maximum_additions = 10;
  int patience = 3;        ///< additions in a row that may fail to lower the score
  int farthest_points = 3; ///< candidates of each kind, per addition
  int stretch_maxima = 3;
  int roots = 6; ///< trees tried on a closed surface with handles
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

/// decides on a cut: the best of the initial ones, then terminals are added and dropped while that pays
class Cut_growth
{
public:
  Cut_growth(const Triangle_surface& surface, const Cut_growth_options& options, Cut_report& report)
    : m_surface(surface), m_options(options), m_report(report)
  {}

  Scored_cut operator()()
  {
    std::optional<Scored_cut> best;
    for(const Cut& cut : rerouted_initial_cuts(m_surface, m_options.roots)) {
      const Scored_cut trial = scored(cut);
      if(!best || trial.score.score < best->score.score)
        best = trial;
    }
    record(Cut_step::INITIAL, -1, *best);
    add_terminals(*best);
    drop_terminals(*best);
    return *best;
  }

private:
  Scored_cut scored(const Cut& cut) const { return {cut, score_cut(m_surface, cut, m_options.scoring)}; }

  void record(Cut_step::Kind kind, int terminal, const Scored_cut& step)
  {
    m_report.history.push_back({kind, terminal, step.score.score, step.score.stretch, step.score.length});
  }

  /// adds, as long as patience lasts, the terminal that gives the least score; \p best becomes the best on the way
  void add_terminals(Scored_cut& best)
  {
    Scored_cut current = best;
    int failures = 0;
    for(int i = 0; i < m_options.maximum_additions && failures < m_options.patience; ++i) {
      std::optional<Scored_cut> grown;
      int terminal = -1;
      for(int candidate : candidate_terminals(current.cut)) {
        Cut cut = current.cut;
        connect_terminal(m_surface, candidate, cut);
        reroute_cut(m_surface, cut);
        if(cut.length(m_surface) > m_options.max_cut_length * std::sqrt(m_surface.area))
          continue;
        const Scored_cut trial = scored(cut);
        if(!grown || trial.score.score < grown->score.score) {
          grown = trial;
          terminal = candidate;
        }
      }
      if(!grown)
        return;
      current = *grown;
      record(Cut_step::ADDED, terminal, current);
      failures = current.score.score < best.score.score ? 0 : failures + 1;
      if(failures == 0)
        best = current;
    }
  }

  std::vector<int> candidate_terminals(const Cut& cut) const
  {
    std::vector<int> candidates = successive_farthest_points(m_surface, cut, m_options.farthest_points);
    for(int v : circle_stretch_maxima(m_surface, cut, m_options.stretch_maxima))
      if(std::find(candidates.begin(), candidates.end(), v) == candidates.end())
        candidates.push_back(v);
    return candidates;
  }

  /// drops, as long as the score falls, the terminal whose loss gives the least score
  void drop_terminals(Scored_cut& best)
  {
    // a sphere is not cut without two terminals
    const std::size_t needed = m_surface.border_loops.empty() && m_surface.genus() == 0 ? 2 : 0;
    while(best.cut.terminals().size() > needed) {
      std::optional<Scored_cut> lower;
      int dropped = -1;
      for(int terminal : best.cut.terminals()) {
        Cut cut = best.cut;
        cut.remove_terminal(terminal);
        prune(m_surface, cut);
        reroute_cut(m_surface, cut);
        const Scored_cut trial = scored(cut);
        if(trial.score.score < (lower ? lower->score.score : best.score.score)) {
          lower = trial;
          dropped = terminal;
        }
      }
      if(!lower)
        return;
      best = *lower;
      record(Cut_step::DROPPED, dropped, best);
    }
  }

  const Triangle_surface& m_surface;
  const Cut_growth_options& m_options;
  Cut_report& m_report;
};

} // namespace internal
} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_GROW_CUT_H
