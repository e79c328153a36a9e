// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_SEARCH_CUT_IMPL_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_SEARCH_CUT_IMPL_H

#include <CGAL_ext/Square_parameterization/internal/coarsening/coarsen_surface.h>
#include <CGAL_ext/Square_parameterization/internal/common/compiled_core.h>
#include <CGAL_ext/Square_parameterization/internal/cut/grow_cut.h>
#include <CGAL_ext/Square_parameterization/internal/cut/judge_cuts.h>
#include <CGAL_ext/Square_parameterization/internal/cut/lift_cut.h>
#include <CGAL_ext/Square_parameterization/internal/cut/refine_cut.h>
#include <CGAL_ext/Square_parameterization/internal/cut/rerouted_initial_cuts.h>
#include <CGAL_ext/Square_parameterization/internal/cut/search_cut.h>
#include <CGAL_ext/Square_parameterization/internal/surface/decimate_surface.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

CGAL_EXT_INLINE_FUNCTION std::optional<Triangle_surface>
simplified_copy(const Triangle_surface& surface, int faces, const Cut_numbers& numbers, const Deadline& deadline)
{
  faces += numbers.faces_per_loop * number_of_loops(surface);
  const auto is_hardly_less = [&](int count) { return surface.number_of_faces() <= numbers.least_reduction * count; };
  if(is_hardly_less(faces))
    return std::nullopt;
  std::optional<Triangle_surface> copy =
      surface.number_of_faces() > numbers.very_fine * faces
          ? decimate_surface(coarsen_surface(surface, static_cast<int>(numbers.still_fine * faces)), faces, deadline)
          : decimate_surface(surface, faces, deadline);
  if(copy && is_hardly_less(copy->number_of_faces())) // the topology, or the shape, allows no less
    copy.reset();
  return copy;
}

constexpr double HEAVIEST_OF_FAMILY = 0.2;
constexpr int FAMILY_WEIGHTS = 5; // each half of the one before

/// indicates whether a weight lies outside those of the family
inline bool is_outside_family(double weight)
{
  return weight > HEAVIEST_OF_FAMILY || weight < std::ldexp(HEAVIEST_OF_FAMILY, 1 - FAMILY_WEIGHTS);
}

/// the weights at which cuts are grown, the heaviest first: always the same, so that what is found does not depend on
/// the weight wanted; and that, where it lies outside
inline std::vector<double> weights_of_family(double wanted)
{
  std::vector<double> weights;
  for(int i = 0; i < FAMILY_WEIGHTS; ++i)
    weights.push_back(std::ldexp(HEAVIEST_OF_FAMILY, -i));
  if(wanted > weights.front())
    weights.insert(weights.begin(), wanted);
  if(wanted < weights.back())
    weights.push_back(wanted);
  return weights;
}

/// see `search_cut()`
class Cut_decision
{
public:
  Cut_decision(const Seam_options& options, Thread_team& team, Cut_report& report, const Cut_numbers& numbers)
    : m_options(options),
      m_weight(options.cut_weight),
      m_scoring{options.balance, options.aspect, options.moves_corners, numbers, options.deadline},
      m_max_cut_length(options.max_cut_length),
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
  // shares of the time of the whole decision that have passed when its parts end: medians of fifteen surfaces
  static constexpr double SIMPLIFIED = 0.04, GROWN_ON_SIMPLER_COPIES = 0.42, GROWN = 0.78, REFINED = 0.82;
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

  /// \param tolerance of the good scores
  Cut_pool make_pool(const Triangle_surface& surface, double tolerance)
  {
    Cut_score_options scoring = m_scoring;
    scoring.numbers.score_tolerance = tolerance;
    if(m_grows_on_surface)
      scoring.numbers.times_work_without_map = numbers().times_work_without_map_of_small;
    return {surface, scoring, m_max_cut_length, m_team, m_deadline, m_progress};
  }

  /// good cuts of different lengths are grown on simple copies, scored again on the surface itself, the best of them
  /// refined where that costs little, and the last few judged. Returns those that come near the best. Where the best rectangle is
  /// wanted, what is found so for the square competes.
  std::vector<Scored_cut> decide(const Triangle_surface& surface)
  {
    const bool is_best_rectangle = !m_scoring.aspect;
    const std::vector<Scored_cut> on_square = is_best_rectangle ? cuts_on_square(surface) : std::vector<Scored_cut>();
    Cut_pool pool = pool_of_grown_cuts(surface);
    const std::vector<double> weights = weights_of_family(m_weight);
    long refinement_work = 0;
    for(double weight : weights)
      refinement_work += work_of_refinement(surface, weight);
    m_progress.begin_part(REFINED, double(refinement_work));
    if(surface.is_disk()) // a cut that is not needed must pay
      pool.start(without_scores({Cut(surface)}), pool.work() + work_of_decision(surface));
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

  /// the cuts of the pool that are best at some weight of the family, and others, judged by searched corners where that is worth
  /// its time
  std::vector<Scored_cut> judged_cuts(const Cut_pool& pool, const std::vector<double>& weights,
                                      const std::vector<Scored_cut>& others)
  {
    std::vector<Scored_cut> cuts = pool.best_between(weights.front(), weights.back());
    cuts.insert(cuts.end(), others.begin(), others.end());
    if(cuts.empty()) // none has a map
      return {pool.best(m_weight)};
    const bool has_choice =
        cuts.size() > 1 && best_of(cuts, m_weight).score.stretch <= numbers().largest_judged_stretch;
    if(has_choice && !has_passed(m_deadline)) {
      m_progress.begin_part(1, double(cuts.size()));
      judge_cuts(pool.surface(), m_weight, m_scoring, m_team, m_progress, cuts);
    }
    return cuts;
  }

  /// cuts that are grown on a simple copy, and of these good ones of different lengths, scored on the surface; on a small one
  /// cuts are grown themselves. What was grown on still simpler copies competes there, for growth ends in one of many local
  /// minima: copies that differ end in others.
  Cut_pool pool_of_grown_cuts(const Triangle_surface& surface)
  {
    const std::optional<Triangle_surface> copy =
        simplified_copy(surface, numbers().growth_faces, numbers(), m_deadline);
    const Triangle_surface& grown = copy ? *copy : surface;
    m_grows_on_surface = !copy;
    std::vector<Scored_cut> starts = without_scores(rerouted_initial_cuts(grown, numbers(), m_team));
    for(Scored_cut& cut : cuts_grown_on_simpler_copies(grown))
      starts.push_back(std::move(cut));
    m_progress.begin_part(GROWN, double(work_of_growth(grown) + (copy ? work_of_decision(surface) : 0)));
    Cut_pool pool_of_grown = grown_pool_for_long(grown, starts);
    if(!copy)
      return pool_of_grown;
    Cut_pool pool = make_pool(surface, numbers().decision_tolerance);
    pool.start(lifted(grown, pool_of_grown.selection(m_weight), surface), work_of_decision(surface));
    return pool;
  }

  /// cuts of different lengths that are grown on simpler copies of the surface, and carried over. Copies know nothing of each
  /// other, and are worked on concurrently: the few scores that compete on one would leave threads idle.
  std::vector<Scored_cut> cuts_grown_on_simpler_copies(const Triangle_surface& grown)
  {
    const std::vector<Triangle_surface> copies = simpler_copies(grown);
    long work = 0;
    for(const Triangle_surface& copy : copies)
      work += work_of_growth(copy);
    if(!copies.empty())
      m_progress.begin_part(GROWN_ON_SIMPLER_COPIES, double(work));
    struct Growth
    {
      std::vector<Scored_cut> cuts;
      Cut_history history;
    };
    std::vector<Growth> growths(copies.size(), {{}, Cut_history(m_weight)});
    m_team(copies.size(), [&](std::size_t i) {
      if(!has_passed(m_deadline))
        growths[i].cuts = lifted(copies[i], grow_family(copies[i], growths[i].history), grown);
    });
    std::vector<Scored_cut> cuts;
    for(Growth& growth : growths) {
      m_history.add(growth.history);
      std::move(growth.cuts.begin(), growth.cuts.end(), std::back_inserter(cuts));
    }
    return cuts;
  }

  /// copies of different numbers of faces: handles may keep some from getting simpler, and each is to be grown on once
  std::vector<Triangle_surface> simpler_copies(const Triangle_surface& grown)
  {
    std::vector<std::optional<Triangle_surface>> simplified(m_grows_on_surface ? numbers().simpler_copies_of_small
                                                                               : numbers().simpler_copies);
    m_team(simplified.size(), [&](std::size_t i) {
      simplified[i] = simplified_copy(grown, faces_of_simpler_copy(static_cast<int>(i)), numbers(), m_deadline);
    });
    std::set<int> sizes{grown.number_of_faces()};
    std::vector<Triangle_surface> copies;
    for(std::optional<Triangle_surface>& copy : simplified)
      if(copy && sizes.insert(copy->number_of_faces()).second)
        copies.push_back(std::move(*copy));
    return copies;
  }

  /// between the simplest and the one that is grown on at last
  int faces_of_simpler_copy(int i) const
  {
    const int simplest = numbers().simplest_growth_faces;
    return simplest + i * (numbers().growth_faces - simplest) / (numbers().simpler_copies + 1);
  }

  /// cuts of different lengths, none of which need be good
  std::vector<Scored_cut> grow_family(const Triangle_surface& surface, Cut_history& history)
  {
    const std::vector<Scored_cut> starts = without_scores(rerouted_initial_cuts(surface, numbers(), m_team));
    const Cut_pool pool = grown_pool(surface, starts, history);
    m_progress.advance(double((std::max)(0L, work_of_growth(surface) - pool.work()))); // which was not needed
    return pool.selection(m_weight);
  }

  /// all that are grown; where the best of them still leaves much stretch they grow for longer, on a surface so small that it may
  /// be for twice as long at least
  Cut_pool grown_pool_for_long(const Triangle_surface& surface, const std::vector<Scored_cut>& starts)
  {
    Cut_pool pool = grown_pool(surface, starts, m_history);
    const long work = work_of_growth(surface),
               long_work = (std::min)(numbers().times_growth_work * work, numbers().long_growth_work);
    if(pool.best(m_weight).score.stretch > numbers().large_stretch && !has_many_loops(surface, numbers()) &&
       long_work >= 2 * work)
      grow(pool, long_work, m_history);
    return pool;
  }

  Cut_pool grown_pool(const Triangle_surface& surface, const std::vector<Scored_cut>& starts, Cut_history& history)
  {
    Cut_pool pool = make_pool(surface, numbers().score_tolerance);
    const long most_work = work_of_growth(surface);
    pool.start(starts, (std::max)(most_work, growth_work_per_vertex() * surface.number_of_vertices()));
    grow(pool, most_work, history);
    return pool;
  }

  /// at each weight growth goes on with the best cut met at all
  /// \param most_work of the pool, in vertices mapped
  void grow(Cut_pool& pool, long most_work, Cut_history& history)
  {
    const std::vector<double> weights = weights_of_family(m_weight);
    for(std::size_t i = 0; i < weights.size(); ++i) {
      const long done = pool.work();
      Cut_growth(pool, weights[i], done + (most_work - done) / static_cast<long>(weights.size() - i), history)();
    }
  }

  /// the cuts carried over to a finer surface, with the scores that they have
  std::vector<Scored_cut> lifted(const Triangle_surface& simple, std::vector<Scored_cut> cuts,
                                 const Triangle_surface& surface)
  {
    m_team(cuts.size(), [&](std::size_t i) { cuts[i].cut = lift_cut(simple, cuts[i].cut, surface, numbers()); });
    return cuts;
  }

  /// what the scores of cuts that are carried over may cost, in vertices mapped
  long work_of_decision(const Triangle_surface& surface) const
  {
    return numbers().decision_work_per_vertex * surface.number_of_vertices();
  }

  /// what it may cost to refine a cut for a weight, in vertices mapped
  long work_of_refinement(const Triangle_surface& surface, double weight) const
  {
    if(is_outside_family(weight))
      return numbers().refinement_work_outside;
    return number_of_loops(surface) <= numbers().most_loops_refined ? numbers().refinement_work : 0;
  }

  /// vertices mapped
  long growth_work_per_vertex() const
  {
    return m_grows_on_surface ? numbers().growth_work_of_small : numbers().growth_work_per_vertex;
  }

  /// what growth may cost, in vertices mapped; it may end earlier
  long work_of_growth(const Triangle_surface& surface) const
  {
    const long by_size =
        (std::max)(numbers().least_growth_work, growth_work_per_vertex() * surface.number_of_vertices());
    return (std::min)(by_size,
                      has_many_loops(surface, numbers()) ? numbers().little_growth_work : numbers().growth_work);
  }

  const Seam_options m_options;
  const double m_weight;
  const Cut_score_options m_scoring;
  const double m_max_cut_length;
  const Deadline m_deadline;
  Cut_progress m_progress;
  Thread_team& m_team;
  Cut_report& m_report;
  Cut_history m_history;
  bool m_grows_on_surface = false; // there is no copy to grow on: the surface is small, nearly always
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
