// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_SCORE_CUT_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_SCORE_CUT_H

#include <CGAL_ext/Square_parameterization/Balanced_minimization.h>
#include <CGAL_ext/Square_parameterization/Cut_options.h>
#include <CGAL_ext/Square_parameterization/internal/border/border_curves.h>
#include <CGAL_ext/Square_parameterization/internal/cut/Cut_numbers.h>
#include <CGAL_ext/Square_parameterization/internal/cut/open_disk.h>
#include <CGAL_ext/Square_parameterization/internal/iteration/Stretch_iteration.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/Balanced_minimizer.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/make_minimizer.h>

#include <limits>
#include <vector>

namespace CGAL_ext {
namespace internal {

/// how a cut is judged
struct Cut_score_options
{
  double cut_weight = Cut_options().cut_weight; ///< stretch that a cut of length sqrt(area) must save
  double balance = Seam_options().balance;      ///< of the energy that is minimised
  Cut_numbers numbers = {};

  double score(double stretch, double length) const { return stretch + cut_weight * length; }
};

/// what a cut is worth; the lower the better
struct Cut_score
{
  double score = std::numeric_limits<double>::infinity(); ///< infinite when the cut surface has no one-to-one map
  double stretch = std::numeric_limits<double>::infinity();
  double length = 0;    ///< in units of sqrt(area)
  bool is_slow = false; ///< the map that tells the stretch was made from coarse to fine
  long vertices = 0;    ///< of the opened surface that was mapped, several times when that was slow: what it has cost
};

/// candidates of the first quarter of the border, spread evenly by length
inline std::vector<int> spread_candidates(const Border_walk& walk, int count)
{
  std::vector<int> candidates;
  const int m = number_of_quarter_candidates(walk);
  double length = 0;
  for(int j = 0; j < m; ++j) {
    if(length >= static_cast<double>(candidates.size()) * walk.total_length() / 4 / count)
      candidates.push_back(j);
    length += walk.length(j);
  }
  return candidates;
}

/// borders with their corners at the candidates
inline std::vector<Uv_coordinates> spread_borders(const Patch& patch, int count)
{
  const Border_walk walk(patch.border_lengths, Walk::COUNTER_CLOCKWISE);
  std::vector<Uv_coordinates> borders;
  for(int candidate : spread_candidates(walk, count))
    borders.push_back(square_border(walk, corners_of_candidate(walk, candidate, Corner_rule::NEAREST)).uv);
  return borders;
}

/// the best of the maps that a cheap iteration makes for a few corners; none, without uv, when the first of them has
/// triangles that are too tiny for floating-point numbers
inline Minimized_map quick_start(const Patch& patch, const std::vector<Uv_coordinates>& borders,
                                 const Cut_score_options& options)
{
  Stretch_minimization start;
  start.maximum_iterations = static_cast<unsigned int>(options.numbers.start_iterations);
  const Stretch_iteration iteration(patch, start);
  Stretch_iteration::Workspace workspace;
  Minimized_map best;
  for(const Uv_coordinates& border : borders) {
    Minimized_map map = iteration.minimize(border, 1, workspace);
    if(map.report.l2 < best.report.l2)
      best = std::move(map);
    if(best.uv.rows() == 0)
      break;
  }
  return best;
}

/// the map for the corners of the start, which goes on with the balanced minimizer, for the steps that are allowed
inline Minimized_map quick_map(const Patch& patch, Minimized_map start, const Cut_score_options& options)
{
  Balanced_minimization balanced;
  balanced.balance = options.balance;
  balanced.maximum_iterations = static_cast<unsigned int>(options.numbers.score_steps);
  Balanced_minimizer::Workspace workspace;
  const Balanced_minimizer minimizer(patch, balanced);
  return minimizer.minimize({std::move(start.uv), {}, {}}, options.numbers.score_tolerance, workspace);
}

/// the map for a border from coarse to fine, which needs no quick start, and few steps however much a map is stretched
inline Minimized_map slow_map(const Patch& patch, const Uv_coordinates& border, const Cut_score_options& options)
{
  Balanced_minimization minimization;
  minimization.balance = options.balance;
  minimization.search_tolerance = options.numbers.score_tolerance;
  minimization.maximum_iterations = static_cast<unsigned int>(options.numbers.score_steps);
  return make_minimizer(patch, minimization)->make_worker()(border, nullptr);
}

/// a stretch that is all but the least for a few corners, and what it has cost. Of the corners a cheap iteration tells
/// which are mapped in earnest.
inline Cut_score stretch_score(const Patch& patch, const Cut_score_options& options)
{
  Cut_score score;
  const std::vector<Uv_coordinates> borders = spread_borders(patch, options.numbers.corner_candidates);
  Minimized_map start = quick_start(patch, borders, options);
  Uv_coordinates border = borders.front();
  score.is_slow = true;
  if(start.uv.rows() > 0) {
    border = border_coordinates(patch, start.uv);
    const double start_l2 = start.report.l2;
    const Minimization_report quick = quick_map(patch, std::move(start), options).report;
    score.stretch = (std::min)(start_l2, quick.l2);
    score.is_slow = quick.stop_reason == Stop_reason::MAXIMUM_ITERATIONS;
  }
  if(score.is_slow)
    score.stretch = (std::min)(score.stretch, slow_map(patch, border, options).report.l2);
  score.vertices = (score.is_slow ? options.numbers.slow_map_work : 1) * patch.number_of_vertices();
  return score;
}

/// scores a cut by the stretch that it leaves on the square and by its length
inline Cut_score score_cut(const Triangle_surface& surface, const Cut& cut, const Cut_score_options& options)
{
  Cut_score score;
  score.vertices = surface.number_of_vertices();
  try {
    score = stretch_score(patch_of_cut(surface, cut), options);
  } catch(const Unmappable&) { // of this cut nothing is known but that it is not the best
  }
  score.length = cut.length(surface) / std::sqrt(surface.area);
  score.score = options.score(score.stretch, score.length);
  return score;
}

} // namespace internal
} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_SCORE_CUT_H
