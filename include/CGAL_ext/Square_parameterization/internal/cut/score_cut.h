// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_SCORE_CUT_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_SCORE_CUT_H

#include <CGAL_ext/Square_parameterization/Balanced_minimization.h>
#include <CGAL_ext/Square_parameterization/Cut_options.h>
#include <CGAL_ext/Square_parameterization/internal/border/border_curves.h>
#include <CGAL_ext/Square_parameterization/internal/border/corners_at_shares.h>
#include <CGAL_ext/Square_parameterization/internal/common/Deadline.h>
#include <CGAL_ext/Square_parameterization/internal/cut/Cut_numbers.h>
#include <CGAL_ext/Square_parameterization/internal/cut/open_disk.h>
#include <CGAL_ext/Square_parameterization/internal/energy/Balanced_energy.h>
#include <CGAL_ext/Square_parameterization/internal/energy/rectangle.h>
#include <CGAL_ext/Square_parameterization/internal/energy/stretch_kernel.h>
#include <CGAL_ext/Square_parameterization/internal/iteration/Stretch_iteration.h>
#include <CGAL_ext/Square_parameterization/internal/iteration/sparse_pattern.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/Balanced_minimizer.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/make_minimizer.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL_ext {
namespace internal {

/// how a cut is judged
struct Cut_score_options
{
  double balance = Seam_options().balance;              ///< of the energy that is minimised
  std::optional<double> aspect = Seam_options().aspect; ///< of the rectangle; none for the best
  bool moves_corners = Seam_options().moves_corners;    ///< after the search by which the last few cuts are judged
  Cut_numbers numbers = {};
  Deadline deadline = {}; ///< when it has passed, maps stay as they are
};

/// what a cut is worth: the lower both, the better
struct Cut_score
{
  double stretch = std::numeric_limits<double>::infinity(); ///< infinite when the cut surface has no one-to-one map
  double length = 0;                                        ///< in units of sqrt(area)
  long work = 0; ///< what it has cost, in vertices mapped: those of the opened surface, and more when maps are slow

  /// \param weight stretch that a cut of length sqrt(area) must save
  double at(double weight) const { return stretch + weight * length; }
};

/// shares of the border that a side of the rectangle may have: for a given one as long as it is, for the best one
/// several; the next side has what is left of a half
inline std::vector<double> shares_of_side(const std::optional<double>& aspect)
{
  if(aspect)
    return {*aspect / (1 + *aspect) / 2};
  return {0.05, 0.12, 0.19, 0.25};
}

/// borders with their corners spread evenly over the border: of a square over a quarter of it, of a rectangle, which
/// looks different after a quarter turn, over half of it
inline std::vector<Uv_coordinates> spread_borders(const Patch& patch, int count,
                                                  const std::optional<double>& aspect = 1)
{
  const Border_walk walk(patch.border_lengths, Walk::COUNTER_CLOCKWISE);
  std::vector<Uv_coordinates> borders;
  for(double side : shares_of_side(aspect))
    for(int i = 0; i < count; ++i) {
      const double start = (side == 0.25 ? 0.25 : 0.5) * i / count;
      if(const auto corners =
             corners_at_shares(patch.border_lengths, {start, start + side, start + 0.5, start + 0.5 + side}))
        borders.push_back(square_border(walk, *corners).uv);
    }
  if(borders.empty()) // a border of few vertices
    borders.push_back(square_border(walk, corners_of_candidate(walk, 0, Corner_rule::NEAREST)).uv);
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
  const Balanced_energy energy(patch, options.balance, options.aspect);
  Stretch_iteration::Workspace workspace;
  Minimized_map best;
  long work = 0;
  for(const Uv_coordinates& border : borders) {
    Minimized_map map = iteration.minimize(border, 1, workspace);
    work += options.numbers.start_work * patch.number_of_vertices() + map.work;
    if(map.uv.rows() > 0 && options.aspect != 1.)
      map.report.l2 = std::sqrt(stretch_energy(patch, on_rectangle(map.uv, energy.aspect(map.uv))));
    if(map.report.l2 < best.report.l2)
      best = std::move(map);
    if(best.uv.rows() == 0)
      break;
  }
  best.work = work;
  return best;
}

/// the map for a border from coarse to fine, which needs no quick start, and few steps however much a map is stretched
/// \param is_persistent goes by small steps of coarsening where large ones lead to no map
inline Minimized_map slow_map(const Patch& patch, const Uv_coordinates& border, const Cut_score_options& options,
                              bool is_persistent)
{
  Balanced_minimization minimization;
  minimization.balance = options.balance;
  minimization.aspect = options.aspect;
  minimization.search_tolerance = options.numbers.score_tolerance;
  minimization.maximum_iterations = static_cast<unsigned int>(options.numbers.score_steps);
  Minimized_map map = make_minimizer(patch, minimization, options.deadline)->make_worker()(border, nullptr);
  if(map.uv.rows() > 0 || !is_persistent || has_passed(options.deadline))
    return map;
  const long work = map.work;
  map = make_minimizer(patch, minimization, options.deadline, Coarsening::BY_EIGHTHS)->make_worker()(border, nullptr);
  map.work += work;
  return map;
}

/// scores a cut by the stretch that it leaves and by its length, in steps: what is known so far bounds the stretch from
/// above, and tells which of several cuts are worth the next one
class Cut_scoring
{
public:
  /// the map of a cheap iteration, for those of a few corners where that is best
  /// \param is_persistent takes more time for a map where there seems to be none
  Cut_scoring(const Triangle_surface& surface, const Cut& cut, const Cut_score_options& options, bool is_persistent)
    : m_options(options), m_is_persistent(is_persistent)
  {
    m_score.length = cut.length(surface) / std::sqrt(surface.area);
    m_score.work = surface.number_of_vertices();
    try {
      Patch patch = patch_of_cut(surface, cut);
      // serves the start, too, where the border is fixed
      patch.elimination_places = fill_reducing_order(patch.number_of_vertices(), patch.edges);
      m_patch = std::make_unique<const Patch>(std::move(patch));
      start();
    } catch(const Unmappable&) { // of this cut nothing is known but that it is not the best
      m_patch.reset();
    }
  }

  const Cut_score& score() const { return m_score; }

  /// goes on with the map until its energy decreases by less, relative
  void lower(double tolerance)
  {
    improve([&] { minimize(tolerance); });
  }

  /// goes on with the map until its stretch is all but the least for the corners; frees its memory
  void finish()
  {
    improve([&] {
      minimize(m_options.numbers.score_tolerance);
      if(m_map.report.stop_reason == Stop_reason::MAXIMUM_ITERATIONS)
        map_slowly();
    });
    free_memory();
  }

private:
  /// lowers the map, if there is one; where that fails, its stretch so far is what is known
  template <class Work>
  void improve(const Work& work)
  {
    if(m_map.uv.rows() == 0)
      return;
    try {
      work();
    } catch(const Unmappable&) {
      free_memory();
    }
  }

  void free_memory()
  {
    m_map = Minimized_map();
    m_minimizer.reset();
    m_patch.reset();
  }

  void start()
  {
    const std::vector<Uv_coordinates> borders =
        spread_borders(*m_patch, m_options.numbers.corner_candidates, m_options.aspect);
    m_map = quick_start(*m_patch, borders, m_options);
    m_border = borders.front();
    m_visited = m_map.work;
    count_work();
    if(m_map.uv.rows() == 0) {
      map_slowly();
      return;
    }
    m_border = border_coordinates(*m_patch, m_map.uv);
    m_score.stretch = m_map.report.l2;
    m_map.report = {};
  }

  std::unique_ptr<const Balanced_minimizer> make_balanced_minimizer() const
  {
    Balanced_minimization balanced;
    balanced.balance = m_options.balance;
    balanced.aspect = m_options.aspect;
    balanced.maximum_iterations = static_cast<unsigned int>(m_options.numbers.score_steps);
    return std::make_unique<const Balanced_minimizer>(*m_patch, balanced, m_options.deadline);
  }

  void minimize(double tolerance)
  {
    if(!m_minimizer) // four of ten cuts that compete never get here
      m_minimizer = make_balanced_minimizer();
    Balanced_minimizer::Workspace workspace;
    const long work_before = m_map.work;
    m_map = m_minimizer->minimize(std::move(m_map), tolerance, workspace);
    add(m_map, work_before);
  }

  void map_slowly() { add(slow_map(*m_patch, m_border, m_options, m_is_persistent), 0); }

  /// \param work_before of what the map has cost, the part that was added before
  void add(const Minimized_map& map, long work_before)
  {
    m_score.stretch = (std::min)(m_score.stretch, map.report.l2);
    m_visited += map.work - work_before;
    count_work();
  }

  void count_work()
  {
    m_score.work = (std::max)(long(m_patch->number_of_vertices()), m_visited / m_options.numbers.ordinary_work);
  }

  const Cut_score_options& m_options;
  const bool m_is_persistent;
  Cut_score m_score;
  std::unique_ptr<const Patch> m_patch;
  std::unique_ptr<const Balanced_minimizer> m_minimizer;
  Minimized_map m_map;
  Uv_coordinates m_border;
  long m_visited = 0; // vertices, by all maps
};

/// the score of one cut
inline Cut_score score_cut(const Triangle_surface& surface, const Cut& cut, const Cut_score_options& options)
{
  Cut_scoring scoring(surface, cut, options, true);
  scoring.lower(options.numbers.rough_score_tolerance);
  scoring.finish();
  return scoring.score();
}

} // namespace internal
} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_SCORE_CUT_H
