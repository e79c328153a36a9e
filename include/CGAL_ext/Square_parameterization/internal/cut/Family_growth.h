// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_FAMILY_GROWTH_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_FAMILY_GROWTH_H

#include <CGAL_ext/Square_parameterization/internal/common/Deadline.h>
#include <CGAL_ext/Square_parameterization/internal/common/Thread_team.h>
#include <CGAL_ext/Square_parameterization/internal/cut/Cut_history.h>
#include <CGAL_ext/Square_parameterization/internal/cut/Cut_pool.h>
#include <CGAL_ext/Square_parameterization/internal/cut/Cut_progress.h>
#include <CGAL_ext/Square_parameterization/internal/cut/grow_cut.h>
#include <CGAL_ext/Square_parameterization/internal/cut/lift_cut.h>
#include <CGAL_ext/Square_parameterization/internal/cut/number_of_loops.h>
#include <CGAL_ext/Square_parameterization/internal/cut/rerouted_initial_cuts.h>
#include <CGAL_ext/Square_parameterization/internal/cut/score_cut.h>
#include <CGAL_ext/Square_parameterization/internal/cut/short_cuts.h>
#include <CGAL_ext/Square_parameterization/internal/cut/simplified_copy.h>
#include <CGAL_ext/Square_parameterization/internal/cut/weights_of_family.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// what the scores of cuts that are carried over to a surface may cost, in vertices mapped
inline long work_of_decision(const Triangle_surface& surface, const Cut_numbers& numbers)
{
  return numbers.decision_work_per_vertex * surface.number_of_vertices();
}

/// a family of cuts of all lengths, grown on simple copies of a surface, and those of them that are good, scored on the surface
class Family_growth
{
public:
  /// shares of the time of the whole decision that have passed when its parts end: medians of fifteen surfaces
  static constexpr double GROWN_ON_SIMPLER_COPIES = 0.37, GROWN = 0.78;

  /// \param options of which the weight that is wanted, the greatest length and the deadline count
  /// \param history of what is met for that weight
  Family_growth(const Seam_options& options, const Cut_score_options& scoring, Thread_team& team,
                Cut_progress& progress, Cut_history& history)
    : m_weight(options.cut_weight),
      m_max_cut_length(options.max_cut_length),
      m_deadline(options.deadline),
      m_scoring(scoring),
      m_team(team),
      m_progress(progress),
      m_history(history)
  {}

  /// cuts that are grown on a simple copy, and of these good ones of different lengths, scored on the surface; on a small one
  /// cuts are grown themselves. What was grown on still simpler copies competes there, for growth ends in one of many local
  /// minima: copies that differ end in others.
  Cut_pool operator()(const Triangle_surface& surface)
  {
    const std::optional<Triangle_surface> copy =
        simplified_copy(surface, numbers().growth_faces, numbers(), m_deadline);
    const Triangle_surface& grown = copy ? *copy : surface;
    m_grows_on_surface = !copy;
    const std::vector<Scored_cut> starts = starts_on(grown, cuts_grown_on_simpler_copies(grown));
    m_progress.begin_part(GROWN, double(work_of_growth(grown) + (copy ? work_of_decision(surface, numbers()) : 0)));
    Cut_pool pool_of_grown = grown_pool_for_long(grown, starts);
    if(!copy)
      return pool_of_grown;
    Cut_pool pool = make_pool(surface, numbers_of_decision());
    pool.start(lifted(grown, pool_of_grown.selection(m_weight), surface), work_of_decision(surface, numbers()));
    return pool;
  }

private:
  const Cut_numbers& numbers() const { return m_scoring.numbers; }

  /// those for scores of cuts that are carried over: all are good ones, at whatever weight they are to be compared
  Cut_numbers numbers_of_decision() const
  {
    Cut_numbers result = numbers();
    result.score_tolerance = numbers().decision_tolerance;
    result.starts_scored_well = 1;
    return result;
  }

  Cut_pool make_pool(const Triangle_surface& surface, const Cut_numbers& numbers_of_scores)
  {
    Cut_score_options scoring = m_scoring;
    scoring.numbers = numbers_of_scores;
    if(m_grows_on_surface)
      scoring.numbers.times_work_without_map = numbers().times_work_without_map_of_small;
    return {surface, scoring, m_max_cut_length, m_team, m_deadline, m_progress};
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

  /// the cuts that growth begins with
  /// \param grown on simpler copies
  std::vector<Scored_cut> starts_on(const Triangle_surface& surface, std::vector<Scored_cut> grown = {})
  {
    std::vector<Scored_cut> cuts = without_scores(rerouted_initial_cuts(surface, numbers(), m_team));
    std::move(grown.begin(), grown.end(), std::back_inserter(cuts));
    if(surface.is_sphere() && m_weight > HEAVIEST_OF_FAMILY)
      for(Scored_cut& cut : without_scores(short_cuts(surface)))
        cuts.push_back(std::move(cut));
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
    const Cut_pool pool = grown_pool(surface, starts_on(surface), history);
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
    Cut_pool pool = make_pool(surface, numbers());
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

  const double m_weight;
  const double m_max_cut_length;
  const Deadline m_deadline;
  const Cut_score_options m_scoring;
  Thread_team& m_team;
  Cut_progress& m_progress;
  Cut_history& m_history;
  bool m_grows_on_surface = false; // there is no copy to grow on: the surface is small, nearly always
};

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_FAMILY_GROWTH_H
