// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_CUT_POOL_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_CUT_POOL_H

#include <CGAL_ext/Square_parameterization/Cut_report.h>
#include <CGAL_ext/Square_parameterization/internal/common/Deadline.h>
#include <CGAL_ext/Square_parameterization/internal/common/Thread_team.h>
#include <CGAL_ext/Square_parameterization/internal/cut/Cut_progress.h>
#include <CGAL_ext/Square_parameterization/internal/cut/initial_cut.h>
#include <CGAL_ext/Square_parameterization/internal/cut/reroute_cut.h>
#include <CGAL_ext/Square_parameterization/internal/cut/score_cut.h>

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// a cut, how it was made of another, and what it is worth
struct Scored_cut
{
  Cut cut;
  Cut_step::Kind kind;
  int terminal; ///< that it was changed for; -1 for none
  Cut_score score = {};
};

/// indicates whether the first has the lower score
inline bool is_better(const Scored_cut& a, const Scored_cut& b)
{
  return a.score.score < b.score.score;
}

/// puts a step of the decision into the report
inline void record(const Scored_cut& cut, Cut_report& report)
{
  report.history.push_back({cut.kind, cut.terminal, cut.score.score, cut.score.stretch, cut.score.length});
}

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
  return cut.terminals().size() > (surface.border_loops.empty() && surface.genus() == 0 ? 2u : 0u);
}

/// indicates whether the handles and holes make one cut much like another, and a terminal more or less nothing
inline bool has_many_loops(const Triangle_surface& surface, const Cut_numbers& numbers)
{
  return 2 * surface.genus() + static_cast<int>(surface.border_loops.size()) >= numbers.many_loops;
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

  /// makes cuts by `make(cut)`, concurrently, and scores them. Returns them without those that were extended or moved
  /// and are too long.
  template <class Make>
  std::vector<Scored_cut> operator()(std::vector<Scored_cut> cuts, const Make& make)
  {
    m_team(cuts.size(), [&](std::size_t i) { make(cuts[i]); });
    const auto is_too_long = [this](const Scored_cut& cut) {
      return (cut.kind == Cut_step::ADDED || cut.kind == Cut_step::MOVED) &&
             cut.cut.length(m_surface) > m_greatest_length;
    };
    cuts.erase(std::remove_if(cuts.begin(), cuts.end(), is_too_long), cuts.end());
    const std::size_t first = m_known.size();
    std::vector<std::size_t> places;
    for(const Scored_cut& cut : cuts) {
      const auto [place, is_new] = m_place_of.try_emplace(cut.cut.edges(), m_known.size());
      places.push_back(place->second);
      if(is_new)
        m_known.push_back(cut);
    }
    m_team(m_known.size() - first, [&](std::size_t i) {
      if(first + i == 0 || !has_passed(m_deadline)) // one of all cuts must have a score
        m_known[first + i].score = score_cut(m_surface, m_known[first + i].cut, m_scoring);
    });
    const long mapped_before = m_vertices_mapped;
    for(std::size_t i = first; i < m_known.size(); ++i)
      m_vertices_mapped += m_known[i].score.vertices;
    m_progress.advance(double(m_vertices_mapped - mapped_before));
    for(std::size_t i = 0; i < cuts.size(); ++i)
      cuts[i].score = m_known[places[i]].score;
    return cuts;
  }

  /// scores the cuts to begin with
  std::vector<Scored_cut> start(const std::vector<Cut>& cuts)
  {
    std::vector<Scored_cut> starts;
    for(const Cut& cut : cuts)
      starts.push_back({cut, Cut_step::INITIAL, -1});
    return (*this)(std::move(starts), [](Scored_cut&) {});
  }

  /// what all scores together have cost: time is all but proportional to it
  long vertices_mapped() const { return m_vertices_mapped; }

  /// indicates whether scores have cost \p work, in vertices mapped, or the deadline has passed
  bool is_exhausted(long work) const { return m_vertices_mapped >= work || has_passed(m_deadline); }

  /// what a score has cost. \pre there is one
  long vertices_per_score() const { return m_vertices_mapped / static_cast<long>(m_known.size()); }

  /// good cuts of different lengths, the shortest first: the best of each of `selected` equal ranges of length, unless
  /// its score is far from the best. The best alone when the deadline has passed.
  std::vector<Cut> selection() const
  {
    const int count = numbers().selected;
    const Scored_cut& best = *std::min_element(m_known.begin(), m_known.end(), is_better);
    if(has_passed(m_deadline))
      return {best.cut};
    double shortest = best.score.length, longest = shortest;
    std::vector<const Scored_cut*> good, best_of_range(count, nullptr);
    for(const Scored_cut& known : m_known)
      if(known.score.score <= numbers().far * best.score.score) {
        good.push_back(&known);
        shortest = (std::min)(shortest, known.score.length);
        longest = (std::max)(longest, known.score.length);
      }
    for(const Scored_cut* cut : good) {
      const double place = longest > shortest ? (cut->score.length - shortest) / (longest - shortest) : 0;
      const Scored_cut*& best_here = best_of_range[(std::min)(count - 1, static_cast<int>(place * count))];
      if(best_here == nullptr || is_better(*cut, *best_here))
        best_here = cut;
    }
    std::vector<Cut> cuts;
    for(const Scored_cut* cut : best_of_range)
      if(cut != nullptr)
        cuts.push_back(cut->cut);
    return cuts;
  }

private:
  const Triangle_surface& m_surface;
  Cut_score_options m_scoring;
  double m_greatest_length;
  Thread_team& m_team;
  const Deadline& m_deadline;
  Cut_progress& m_progress;
  std::vector<Scored_cut> m_known;                    // in the order in which they came
  std::map<std::vector<int>, std::size_t> m_place_of; // there, per edges of a cut
  long m_vertices_mapped = 0;
};

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_CUT_POOL_H
