// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_SEARCH_CUT_IMPL_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_SEARCH_CUT_IMPL_H

#include <CGAL_ext/Square_parameterization/internal/common/compiled_core.h>
#include <CGAL_ext/Square_parameterization/internal/cut/Family_growth.h>
#include <CGAL_ext/Square_parameterization/internal/cut/initial_cut.h>
#include <CGAL_ext/Square_parameterization/internal/cut/judge_cuts.h>
#include <CGAL_ext/Square_parameterization/internal/cut/lift_cut.h>
#include <CGAL_ext/Square_parameterization/internal/cut/number_of_loops.h>
#include <CGAL_ext/Square_parameterization/internal/cut/refine_cut.h>
#include <CGAL_ext/Square_parameterization/internal/cut/reroute_cut.h>
#include <CGAL_ext/Square_parameterization/internal/cut/search_cut.h>
#include <CGAL_ext/Square_parameterization/internal/cut/simplified_copy.h>
#include <CGAL_ext/Square_parameterization/internal/cut/weights_of_family.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// see `search_cut()`
class Cut_decision
{
public:
  Cut_decision(const Seam_options& options, Thread_team& team, Cut_report& report, const Cut_numbers& numbers)
    : m_options(options),
      m_weight(options.cut_weight),
      m_scoring{options.balance, options.aspect, options.moves_corners, numbers, options.deadline},
      m_deadline(options.deadline),
      m_progress(options.visitor),
      m_team(team),
      m_report(report),
      m_history(options.cut_weight)
  {}

  /// for a surface of any size: large ones are decided on by a simplified copy. Returns the best cut, and then a second
  /// one where it all but ties.
  std::vector<Decided_cut> operator()(const Triangle_surface& surface)
  {
    m_progress.begin_part(SIMPLIFIED, 1);
    std::vector<Decided_cut> cuts = decide_on_copy(surface);
    m_report.history = m_history.steps();
    m_progress.begin_part(1, 1);
    return cuts;
  }

private:
  // see `Family_growth`
  static constexpr double SIMPLIFIED = 0.06, REFINED = 0.82;
  static constexpr double DECIDED_ON_SQUARE = 0.2; // where the best rectangle is wanted

  std::vector<Decided_cut> decide_on_copy(const Triangle_surface& surface)
  {
    const std::optional<Triangle_surface> copy =
        simplified_copy(surface, numbers().decision_faces, numbers(), m_deadline);
    if(has_passed(m_deadline))
      return {{uncompared_cut(surface)}};
    m_report.decision_faces = copy ? copy->triangles.size() : surface.triangles.size();
    std::vector<Scored_cut> cuts = decide(copy ? *copy : surface);
    // a surface that was judged itself has no ties, and two maps of a large one take long
    if(!copy || surface.number_of_faces() > numbers().largest_mapped_twice)
      cuts = {Scored_cut(best_of(cuts, m_weight))};
    if(copy)
      m_team(cuts.size(), [&](std::size_t i) { // its length is known then, its stretch is not
        cuts[i].cut = lift_cut(*copy, cuts[i].cut, surface, numbers());
        cuts[i].score.length = cuts[i].cut.length(surface) / std::sqrt(surface.area);
      });
    return best_two(std::move(cuts));
  }

  /// the best of the cuts, and the next one if it all but ties
  std::vector<Decided_cut> best_two(std::vector<Scored_cut> cuts) const
  {
    std::stable_sort(cuts.begin(), cuts.end(), Is_better{m_weight});
    const double most = (1 + numbers().tie) * cuts.front().score.at(m_weight);
    std::vector<Decided_cut> result;
    for(const Scored_cut& cut : cuts) {
      const bool is_second = result.size() == 1 && cut.score.at(m_weight) <= most &&
                             cut.cut.edges() != result.front().cut.edges(); // two may become one on the surface
      if(result.empty() || is_second)
        result.push_back({cut.cut, cut.score.at(m_weight), cut.score.stretch});
    }
    return result;
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

  /// good cuts of different lengths are grown on simple copies, scored again on the surface itself, the best of them
  /// refined where that costs little, and the last few judged. Returns those that come near the best. Where the best rectangle is
  /// wanted, what is found so for the square competes.
  std::vector<Scored_cut> decide(const Triangle_surface& surface)
  {
    const bool is_best_rectangle = !m_scoring.aspect;
    const std::vector<Scored_cut> on_square = is_best_rectangle ? cuts_on_square(surface) : std::vector<Scored_cut>();
    Cut_pool pool = Family_growth(m_options, m_scoring, m_team, m_progress, m_history)(surface);
    const std::vector<double> weights = weights_of_family(m_weight);
    long refinement_work = 0;
    for(double weight : weights)
      refinement_work += work_of_refinement(surface, weight);
    m_progress.begin_part(REFINED, double(refinement_work));
    if(surface.is_disk()) // a cut that is not needed must pay
      pool.start(without_scores({Cut(surface)}), pool.work() + work_of_decision(surface, numbers()));
    for(double weight : weights) {
      Scored_cut cut = pool.best(weight);
      refine_cut(pool, weight, work_of_refinement(surface, weight), cut, m_history);
    }
    std::vector<Scored_cut> judged = judged_cuts(pool, weights, on_square);
    m_report.is_cancelled = has_passed(m_deadline);
    for(const Scored_cut* cut : front_of(judged))
      m_report.front.push_back({cut->score.length, cut->score.stretch});
    const double near = (1 + numbers().near_best) * best_of(judged, m_weight).score.at(m_weight);
    const auto is_far = [&](const Scored_cut& cut) { return !(cut.score.at(m_weight) <= near); };
    judged.erase(std::remove_if(judged.begin(), judged.end(), is_far), judged.end());
    return judged;
  }

  /// the cuts that come near the best on the square, with what they leave there: no less than on the best rectangle. Scores on
  /// that cost several times as much, so that growth meets fewer cuts: one in three closed surfaces would be left with a cut
  /// that is worse there, too.
  std::vector<Scored_cut> cuts_on_square(const Triangle_surface& surface)
  {
    m_progress.begin_part(DECIDED_ON_SQUARE, 1);
    Seam_options options = m_options;
    options.aspect = 1;
    options.deadline = part_way_to(m_deadline, 0.5);
    options.visitor = nullptr;
    Cut_report report;
    return Cut_decision(options, m_team, report, numbers()).decide(surface);
  }

  /// the cuts of the pool that are best at some weight of the family, and others, of which the best few are judged by searched
  /// corners where that is worth its time
  std::vector<Scored_cut> judged_cuts(const Cut_pool& pool, const std::vector<double>& weights,
                                      const std::vector<Scored_cut>& others)
  {
    std::vector<Scored_cut> cuts = pool.best_between(weights.front(), weights.back());
    cuts.insert(cuts.end(), others.begin(), others.end());
    if(cuts.empty()) // none has a map
      return {pool.best(m_weight)};
    const bool has_choice =
        cuts.size() > 1 && best_of(cuts, m_weight).score.stretch <= numbers().largest_judged_stretch;
    if(has_choice && !has_passed(m_deadline))
      judge_cuts(pool.surface(), m_weight, m_scoring, m_team, m_progress, cuts);
    return cuts;
  }

  /// what it may cost to refine a cut for a weight, in vertices mapped
  long work_of_refinement(const Triangle_surface& surface, double weight) const
  {
    if(is_outside_family(weight))
      return numbers().refinement_work_outside;
    return number_of_loops(surface) <= numbers().most_loops_refined ? numbers().refinement_work : 0;
  }

  const Seam_options m_options;
  const double m_weight;
  const Cut_score_options m_scoring;
  const Deadline m_deadline;
  Cut_progress m_progress;
  Thread_team& m_team;
  Cut_report& m_report;
  Cut_history m_history;
};

CGAL_EXT_INLINE_FUNCTION std::vector<Decided_cut> search_cut(const Triangle_surface& surface,
                                                             const Seam_options& options, Thread_team& team,
                                                             Cut_report& report, const Cut_numbers& numbers)
{
  const Thread_team::Scope scope(team);
  return Cut_decision(options, team, report, numbers)(surface);
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_SEARCH_CUT_IMPL_H
