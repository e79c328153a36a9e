// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_SEARCH_CUT_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_SEARCH_CUT_H

#include <CGAL_ext/Square_parameterization/Cut_options.h>
#include <CGAL_ext/Square_parameterization/internal/cut/grow_cut.h>
#include <CGAL_ext/Square_parameterization/internal/cut/lift_cut.h>
#include <CGAL_ext/Square_parameterization/internal/cut/refine_cut.h>
#include <CGAL_ext/Square_parameterization/internal/cut/rerouted_initial_cuts.h>
#include <CGAL_ext/Square_parameterization/internal/search/Few_corners_search.h>
#include <CGAL_ext/Square_parameterization/internal/search/square_search.h>
#include <CGAL_ext/Square_parameterization/internal/surface/decimate_surface.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// a copy of about \p faces triangles, and more when there are many handles and holes; nothing when the surface has
/// hardly more, or cannot be simplified in time
inline std::optional<Triangle_surface> simplified_copy(const Triangle_surface& surface, int faces,
                                                       const Cut_numbers& numbers = {}, const Deadline& deadline = {})
{
  faces += numbers.faces_per_loop * (2 * surface.genus() + static_cast<int>(surface.border_loops.size()));
  if(surface.number_of_faces() <= numbers.least_reduction * faces)
    return std::nullopt;
  return decimate_surface(surface, faces, numbers.very_fine, numbers.still_fine, deadline);
}

/// the stretch of the opened surface when its corners are searched, among few, and its map is minimised as that to be
/// delivered, but not to its tolerance; infinite when there is no map
/// \param deadline when it has passed the best map so far tells
inline double searched_stretch(const Triangle_surface& surface, const Cut& cut, double balance,
                               double tolerance = Cut_numbers().judging_tolerance, const Deadline& deadline = {})
{
  Balanced_minimization minimization;
  minimization.balance = balance;
  minimization.tolerance = minimization.search_tolerance = tolerance;
  Square_search_options options;
  options.number_of_threads = 1;
  options.moves_corners = false; // it costs more than it tells about cuts
  options.deadline = deadline;
  try {
    const Patch patch = patch_of_cut(surface, cut);
    const auto minimizer = make_minimizer(patch, minimization, deadline);
    return search_square_map(patch, *minimizer, Few_corners_search(), options).map.report.l2;
  } catch(const Unmappable&) {
    return std::numeric_limits<double>::infinity();
  }
}

/// scores the cuts by their searched stretch
inline void judge(const Triangle_surface& surface, const Cut_score_options& scoring, Thread_team& team,
                  const Deadline& deadline, Cut_progress& progress, std::vector<Scored_cut>& cuts, Cut_report& report)
{
  team(cuts.size(), [&](std::size_t i) {
    Cut_score& score = cuts[i].score;
    score.stretch =
        searched_stretch(surface, cuts[i].cut, scoring.balance, scoring.numbers.judging_tolerance, deadline);
    score.score = scoring.score(score.stretch, score.length);
    cuts[i].kind = Cut_step::JUDGED;
    progress.advance(1);
  });
  for(const Scored_cut& cut : cuts)
    record(cut, report);
}

/// the shortest of the cuts whose score is at most by \p tolerance, relative, above the least
inline const Scored_cut& shortest_of_best(const std::vector<Scored_cut>& cuts, double tolerance)
{
  const Scored_cut* best = &*std::min_element(cuts.begin(), cuts.end(), is_better);
  const double limit = (1 + tolerance) * best->score.score;
  for(const Scored_cut& cut : cuts)
    if(cut.score.score <= limit && cut.score.length < best->score.length)
      best = &cut;
  return *best;
}

/// decides on a cut that leaves little stretch: cuts are grown on simple copies, and judged on finer ones
class Cut_decision
{
public:
  Cut_decision(const Seam_options& options, Thread_team& team, Cut_report& report, const Cut_numbers& numbers = {})
    : m_scoring{options.cut_weight, options.balance, numbers},
      m_max_cut_length(options.max_cut_length),
      m_deadline(options.deadline),
      m_progress(options.visitor),
      m_team(team),
      m_report(report)
  {}

  /// for a surface of any size: large ones are decided on by a simplified copy
  Cut operator()(const Triangle_surface& surface)
  {
    m_progress.begin_part(SIMPLIFIED, 1);
    Cut cut = decide_on_copy(surface);
    m_progress.begin_part(1, 1);
    return cut;
  }

private:
  // shares of the time of the whole decision that have passed when its parts end, and shares of the most work that a
  // part does until it ends early: medians of a dozen surfaces
  static constexpr double SIMPLIFIED = 0.05, GROWN = 0.26, GROWN_ON_SIMPLER_COPY = 0.4, POLISHED = 0.6, REFINED = 0.82;
  static constexpr double WORK_OF_GROWTH = 0.5, WORK_OF_POLISHING = 0.8, WORK_OF_REFINEMENT = 1.7;

  Cut decide_on_copy(const Triangle_surface& surface)
  {
    const std::optional<Triangle_surface> copy =
        simplified_copy(surface, numbers().decision_faces, numbers(), m_deadline);
    if(has_passed(m_deadline))
      return uncompared_cut(surface);
    m_report.decision_faces = copy ? copy->triangles.size() : surface.triangles.size();
    return copy ? lift_cut(*copy, decide(*copy, numbers().copy_tolerance), surface, numbers())
                : decide(surface, numbers().judging_tolerance);
  }

  /// a cut that is found at once, or none when the surface is a disk
  Cut uncompared_cut(const Triangle_surface& surface)
  {
    m_report.is_cancelled = true;
    Cut cut(surface);
    if(!surface.is_disk()) {
      initial_cut(surface, 0, cut);
      reroute_cut(surface, cut);
    }
    return cut;
  }

  const Cut_numbers& numbers() const { return m_scoring.numbers; }

  Cut_pool make_pool(const Triangle_surface& surface)
  {
    return {surface, m_scoring, m_max_cut_length, m_team, m_deadline, m_progress};
  }

  /// a quick score of a simple copy overrates the stretch, the more the shorter the cut: so good cuts of different
  /// lengths are scored again on the surface itself, the best of them refined, and the best few judged by a search of
  /// corners and the minimization of the map that is delivered; of a disk the empty cut, too. Where one cut is much
  /// like another the best is taken unjudged, and where maps are slow: its score is right to a few percent, and
  /// judging takes seconds.
  /// \param tolerance relative: of scores that differ by less the shortest cut wins
  Cut decide(const Triangle_surface& surface, double tolerance)
  {
    Cut_pool pool = make_pool(surface);
    const std::vector<Cut> grown = grown_cuts(surface);
    m_progress.begin_part(REFINED, WORK_OF_REFINEMENT * double(numbers().refinement_work));
    std::vector<Scored_cut> cuts = pool.start(grown);
    std::stable_sort(cuts.begin(), cuts.end(), is_better);
    const auto is_same = [](const Scored_cut& a, const Scored_cut& b) { return a.cut.edges() == b.cut.edges(); };
    cuts.erase(std::unique(cuts.begin(), cuts.end(), is_same), cuts.end());
    refine_cut(pool, cuts.front(), m_report);
    const bool is_unjudged = has_many_loops(surface, numbers()) || cuts.front().score.is_slow || has_passed(m_deadline);
    const std::size_t judged = is_unjudged ? 1 : static_cast<std::size_t>(numbers().judged);
    cuts.resize((std::min)(cuts.size(), judged), cuts.front());
    const auto is_empty = [](const Scored_cut& cut) { return cut.cut.edges().empty(); };
    if(surface.is_disk() && std::none_of(cuts.begin(), cuts.end(), is_empty)) // a cut that is not needed must pay
      cuts.push_back(pool.start({Cut(surface)}).front());
    m_progress.begin_part(1, double(cuts.size()));
    if(cuts.size() > 1)
      judge(surface, m_scoring, m_team, m_deadline, m_progress, cuts, m_report);
    const Scored_cut& best = shortest_of_best(cuts, tolerance);
    m_report.is_cancelled = has_passed(m_deadline);
    m_report.score = best.score.score;
    m_report.stretch = best.score.stretch;
    return best.cut;
  }

  /// good cuts of different lengths, found on a simple copy. What was grown on a still simpler one competes there, for
  /// growth ends in one of many local minima.
  std::vector<Cut> grown_cuts(const Triangle_surface& surface)
  {
    const std::optional<Triangle_surface> copy =
        simplified_copy(surface, numbers().growth_faces, numbers(), m_deadline);
    const Triangle_surface& grown = copy ? *copy : surface;
    Cut_pool pool = make_pool(grown);
    Cut_growth growth(pool, m_report);
    m_progress.begin_part(GROWN, WORK_OF_GROWTH * double(growth.most_work()));
    std::vector<Cut> cuts{growth.grow(rerouted_initial_cuts(grown, numbers(), m_team))};
    if(const auto simpler = simplified_copy(grown, numbers().simpler_growth_faces, numbers(), m_deadline)) {
      Cut_report ignored;
      Cut_pool simpler_pool = make_pool(*simpler);
      Cut_growth simpler_growth(simpler_pool, ignored);
      m_progress.begin_part(GROWN_ON_SIMPLER_COPY, WORK_OF_GROWTH * double(simpler_growth.most_work()));
      const Cut simple = simpler_growth.grow(rerouted_initial_cuts(*simpler, numbers(), m_team));
      cuts.push_back(lift_cut(*simpler, simple, grown, numbers()));
    }
    m_progress.begin_part(POLISHED, WORK_OF_POLISHING * double(growth.most_work() - pool.vertices_mapped()));
    growth.polish(cuts);
    cuts = pool.selection();
    if(copy)
      m_team(cuts.size(), [&](std::size_t i) { cuts[i] = lift_cut(grown, cuts[i], surface, numbers()); });
    return cuts;
  }

  Cut_score_options m_scoring;
  double m_max_cut_length;
  const Deadline m_deadline;
  Cut_progress m_progress;
  Thread_team& m_team;
  Cut_report& m_report;
};

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_SEARCH_CUT_H
