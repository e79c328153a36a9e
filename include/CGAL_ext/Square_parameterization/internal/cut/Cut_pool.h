// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_CUT_POOL_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_CUT_POOL_H

#include <CGAL_ext/Square_parameterization/internal/common/Deadline.h>
#include <CGAL_ext/Square_parameterization/internal/common/Thread_team.h>
#include <CGAL_ext/Square_parameterization/internal/cut/Cut_progress.h>
#include <CGAL_ext/Square_parameterization/internal/cut/Scored_cut.h>
#include <CGAL_ext/Square_parameterization/internal/cut/initial_cut.h>
#include <CGAL_ext/Square_parameterization/internal/cut/reroute_cut.h>
#include <CGAL_ext/Square_parameterization/internal/cut/score_cut.h>
#include <CGAL_ext/Square_parameterization/internal/cut/weights_of_family.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// the cut extended to one terminal more
inline void extend_cut(const Triangle_surface& surface, int terminal, Cut& cut)
{
  connect_terminal(surface, terminal, cut);
  reroute_cut(surface, cut);
}

/// the cut freed from one of its terminals
inline void free_cut(const Triangle_surface& surface, int terminal, Cut& cut)
{
  cut.remove_terminal(terminal);
  prune(surface, cut);
  reroute_cut(surface, cut);
}

/// indicates whether a terminal may go: a sphere is not cut without two
inline bool may_be_freed(const Triangle_surface& surface, const Cut& cut)
{
  return cut.terminals().size() > (surface.is_sphere() ? 2u : 0u);
}

/// all cuts of one surface that were scored. None is scored twice; those that compete are scored concurrently, and the
/// result is the same for any number of threads.
class Cut_pool
{
public:
  /// \param max_cut_length in units of sqrt(area)
  Cut_pool(const Triangle_surface& surface, const Cut_score_options& scoring, double max_cut_length, Thread_team& team,
           const Deadline& deadline, Cut_progress& progress)
    : m_surface(surface),
      m_scoring(scoring),
      m_greatest_length(max_cut_length * std::sqrt(surface.area)),
      m_team(team),
      m_deadline(deadline),
      m_progress(progress)
  {}

  const Triangle_surface& surface() const { return m_surface; }
  const Cut_numbers& numbers() const { return m_scoring.numbers; }

  /// makes cuts by `make(cut)`, concurrently, and scores them: the better they are at \p weight, the better. Returns
  /// them without those that were extended or moved and are too long.
  template <class Make>
  std::vector<Scored_cut> operator()(std::vector<Scored_cut> cuts, double weight, const Make& make)
  {
    m_team(cuts.size(), [&](std::size_t i) { make(cuts[i]); });
    const auto is_too_long = [this](const Scored_cut& cut) {
      return (cut.kind == Cut_step::ADDED || cut.kind == Cut_step::MOVED) &&
             cut.cut.length(m_surface) > m_greatest_length;
    };
    cuts.erase(std::remove_if(cuts.begin(), cuts.end(), is_too_long), cuts.end());
    return score(std::move(cuts), weight,
                 {{std::size_t(numbers().mapped), numbers().first_score_tolerance},
                  {std::size_t(numbers().mapped_roughly), numbers().rough_score_tolerance}},
                 std::size_t(numbers().scored_well));
  }

  /// scores cuts to begin with, all of them roughly and the best well: the first, which tells what a score costs, and as many
  /// more as there is work for. No more at a time than are known, since some cost ten times what the first has cost. Where the
  /// deadline passes before that, the others keep the scores that they have, which may be those on a simpler copy.
  void start(const std::vector<Scored_cut>& cuts, long work)
  {
    std::size_t next = 0, end = 1;
    while(next < (std::min)(end, cuts.size())) {
      std::vector<Scored_cut> starts;
      for(; next < (std::min)(end, cuts.size()); ++next)
        starts.push_back(cuts[next]);
      const std::size_t number = starts.size();
      const double well = std::ceil(numbers().starts_scored_well * double(number));
      score(std::move(starts), MIDDLE_OF_FAMILY, {{number, numbers().rough_score_tolerance}}, std::size_t(well));
      const long left = (std::max)(0L, most_work(work) - m_work);
      end = has_passed(m_deadline) ? cuts.size()
                                   : next + (std::min)(next, static_cast<std::size_t>(left / work_per_score()));
    }
  }

  /// what all scores together have cost, by which time is limited: a cut that competes counts for a map at least
  long work() const { return m_work; }

  /// indicates whether scores cost more than \p work, in vertices mapped, together with the \p next ones, or the deadline
  /// has passed. While no cut has a map the work is some times as much.
  bool is_exhausted(long work, long next = 1) const
  {
    return m_work + next > most_work(work) || has_passed(m_deadline);
  }

  /// what a score has cost. \pre there is one
  long work_per_score() const { return (std::max)(1L, m_work / static_cast<long>(m_known.size())); }

  /// the best of all at a weight. \pre there is one
  const Scored_cut& best(double weight) const { return best_of(m_known, weight); }

  /// those that are best at some weight between two, the shortest first
  std::vector<Scored_cut> best_between(double heaviest, double lightest) const
  {
    const double shortest = best(heaviest).score.length, longest = best(lightest).score.length;
    std::vector<Scored_cut> cuts;
    for(const Scored_cut* cut : front_of(m_known))
      if(cut->score.length >= shortest && cut->score.length <= longest)
        cuts.push_back(*cut);
    return cuts;
  }

  /// good cuts of different lengths, the shortest first: of each of `selected` equal ranges of length that which lies
  /// least above the front, unless it lies far above. Before them comes the best at \p weight where that lies outside the
  /// family; one may come twice. That alone when the deadline has passed. With their scores here, and none of what these have
  /// cost.
  std::vector<Scored_cut> selection(double weight) const
  {
    const std::vector<const Scored_cut*> best_cuts = front_of(m_known);
    if(has_passed(m_deadline) || best_cuts.empty())
      return {as_start(best(weight))};
    const double shortest = best_cuts.front()->score.length, longest = best_cuts.back()->score.length;
    struct Good_cut
    {
      double excess;
      const Scored_cut* cut;
    };
    std::vector<Good_cut> best_of_range(numbers().selected, {numbers().far, nullptr});
    for(const Scored_cut& known : m_known) {
      if(known.score.length < shortest || known.score.length > longest)
        continue;
      const double place = longest > shortest ? (known.score.length - shortest) / (longest - shortest) : 0;
      const double excess = known.score.stretch / stretch_of_front(best_cuts, known.score.length) - 1;
      Good_cut& best_here =
          best_of_range[(std::min)(numbers().selected - 1, static_cast<int>(place * numbers().selected))];
      if(excess < best_here.excess)
        best_here = {excess, &known};
    }
    std::vector<Scored_cut> cuts;
    if(is_outside_family(weight))
      cuts.push_back(as_start(best(weight)));
    for(const Good_cut& good : best_of_range)
      if(good.cut != nullptr)
        cuts.push_back(as_start(*good.cut));
    return cuts;
  }

private:
  /// the cut to begin with on a finer surface, where its score has cost nothing yet
  static Scored_cut as_start(const Scored_cut& known)
  {
    Scored_cut start{known.cut, Cut_step::INITIAL, -1, known.score};
    start.score.work = 0;
    return start;
  }

  /// indicates whether one of the cuts has a one-to-one map
  bool has_map() const
  {
    return std::any_of(m_known.begin(), m_known.end(),
                       [](const Scored_cut& known) { return std::isfinite(known.score.stretch); });
  }

  long most_work(long work) const { return has_map() ? work : numbers().times_work_without_map * work; }

  /// how many cuts are mapped, and to which tolerance
  struct Stage
  {
    std::size_t number;
    double tolerance;
  };

  /// scores those of the cuts that are not known yet, see `score_in_stages()`
  std::vector<Scored_cut> score(std::vector<Scored_cut> cuts, double weight, const std::vector<Stage>& stages,
                                std::size_t number_well)
  {
    std::vector<std::size_t> places;
    std::vector<Scored_cut> unknown;
    for(const Scored_cut& cut : cuts) {
      const auto [place, is_new] = m_place_of.try_emplace(cut.cut.edges(), m_known.size() + unknown.size());
      places.push_back(place->second);
      if(is_new)
        unknown.push_back(cut);
    }
    score_in_stages(unknown, weight, stages, number_well);
    long work = 0;
    for(Scored_cut& cut : unknown) {
      work += cut.score.work;
      m_known.push_back(std::move(cut));
    }
    m_work += work;
    m_progress.advance(double(work));
    for(std::size_t i = 0; i < cuts.size(); ++i)
      cuts[i].score = m_known[places[i]].score;
    return cuts;
  }

  /// scores cuts concurrently: all by a cheap iteration, in each stage the best so far at a weight by a better map, and the
  /// best \p number_well of the last stage well
  void score_in_stages(std::vector<Scored_cut>& cuts, double weight, const std::vector<Stage>& stages,
                       std::size_t number_well)
  {
    std::vector<std::optional<Cut_scoring>> scorings(cuts.size());
    std::vector<std::size_t> chosen(cuts.size());
    std::iota(chosen.begin(), chosen.end(), 0);
    const auto must_be_scored = [&](std::size_t c) { // one of all cuts must have a score, be it that on a simpler copy
      return m_known.size() + c == 0 && !std::isfinite(cuts[c].score.stretch);
    };
    const auto for_chosen = [&](const auto& improve) {
      m_team(chosen.size(), [&](std::size_t i) {
        const std::size_t c = chosen[i];
        if(has_passed(m_deadline) && !must_be_scored(c))
          return;
        improve(c);
        cuts[c].score = scorings[c]->score();
      });
    };
    const auto keep_best = [&](std::size_t number) {
      std::stable_sort(chosen.begin(), chosen.end(),
                       [&](std::size_t a, std::size_t b) { return Is_better{weight}(cuts[a], cuts[b]); });
      chosen.resize((std::min)(chosen.size(), number));
    };
    const bool is_persistent = m_known.empty(); // where the first cut has no map, others hardly ever do
    for_chosen([&](std::size_t c) { scorings[c].emplace(m_surface, cuts[c].cut, m_scoring, is_persistent); });
    for(const Stage& stage : stages) {
      keep_best(stage.number);
      for_chosen([&](std::size_t c) { scorings[c]->lower(stage.tolerance); });
    }
    keep_best(number_well);
    for_chosen([&](std::size_t c) { scorings[c]->finish(); });
  }

  const Triangle_surface& m_surface;
  Cut_score_options m_scoring;
  double m_greatest_length;
  Thread_team& m_team;
  const Deadline m_deadline;
  Cut_progress& m_progress;
  std::vector<Scored_cut> m_known;                    // in the order in which they came
  std::map<std::vector<int>, std::size_t> m_place_of; // there, per edges of a cut
  long m_work = 0;
};

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_CUT_POOL_H
