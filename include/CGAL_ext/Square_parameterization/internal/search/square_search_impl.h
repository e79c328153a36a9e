// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SEARCH_SQUARE_SEARCH_IMPL_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SEARCH_SQUARE_SEARCH_IMPL_H

#include <CGAL_ext/Square_parameterization/internal/common/Deadline.h>
#include <CGAL_ext/Square_parameterization/internal/common/compiled_core.h>
#include <CGAL_ext/Square_parameterization/internal/search/Corner_evaluation.h>
#include <CGAL_ext/Square_parameterization/internal/search/Corner_moves.h>
#include <CGAL_ext/Square_parameterization/internal/search/run_corner_search.h>
#include <CGAL_ext/Square_parameterization/internal/search/square_search.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// the distance of every border vertex, in the order of the border loop, from the nearest corner, in half sides
inline std::vector<double> corner_distances(const Uv_coordinates& border_uv)
{
  std::vector<double> distances;
  // one coordinate is 0 or 1, the other tells the place on the side
  for(Eigen::Index k = 0; k < border_uv.rows(); ++k) {
    const double u = border_uv(k, 0), v = border_uv(k, 1);
    distances.push_back(2 * ((std::min)(u, 1 - u) + (std::min)(v, 1 - v)));
  }
  return distances;
}

/// one search for the corners of one patch: evaluates candidates, and sketches where the minimizer has them
class Square_search
{
public:
  Square_search(const Patch& patch, const Map_minimizer& minimizer, const Corner_search& search,
                const Square_search_options& options)
    : m_patch(patch),
      m_minimizer(minimizer),
      m_search(search),
      m_options(options),
      m_walk(patch.border_lengths, options.walk),
      m_number_of_candidates(search.candidate_set() == Candidate_set::FULL ? m_walk.size()
                                                                           : number_of_quarter_candidates(m_walk)),
      m_threads(number_of_search_threads(options.number_of_threads, patch.number_of_vertices())),
      m_evaluation(
          m_number_of_candidates, [this] { return for_candidates(m_minimizer.make_worker()); }, m_threads,
          options.visitor, [this](double share) { return may_continue(share, m_options.deadline); })
  {
    m_sketch_visitor.visitor = options.visitor;
    if(minimizer.has_sketches())
      m_sketches.emplace(
          m_number_of_candidates, [this] { return for_candidates(m_minimizer.make_sketching_worker()); }, m_threads,
          &m_sketch_visitor, [this](double) { return may_continue(0, m_sketch_deadline); });
  }

  Search_outcome operator()()
  {
    if(m_options.visitor != nullptr)
      m_options.visitor->start_search(static_cast<std::size_t>(m_number_of_candidates));
    run_corner_search(m_search, problem(), m_evaluation);
    if(m_evaluation.best_map().uv.rows() == 0 && m_sketches && has_passed(m_sketch_deadline))
      evaluate_best_sketch();
    m_evaluation.release_workers();
    Search_outcome outcome{m_evaluation.best_map(), m_evaluation.report()};
    if(outcome.report.best_candidate)
      outcome.report.corners = border_of(*outcome.report.best_candidate).corners;
    if(m_options.moves_corners && m_minimizer.has_rough_maps() && outcome.report.best_candidate &&
       !outcome.report.is_cancelled)
      move_corners(outcome);
    if(m_options.visitor != nullptr)
      m_options.visitor->start_minimization();
    outcome.map = m_minimizer.finish(std::move(outcome.map));
    complete(outcome);
    if(m_options.visitor != nullptr)
      m_options.visitor->end_search(outcome.report);
    return outcome;
  }

private:
  /// tells of sketches what others tell of evaluations
  struct Sketch_visitor : Search_visitor
  {
    void after_evaluation(const Search_report::Sample& sample) override
    {
      if(visitor != nullptr)
        visitor->after_sketch(sample);
    }

    Search_visitor* visitor = nullptr;
  };

  bool may_continue(double share, const Deadline& deadline) const
  {
    return !has_passed(deadline) && (!m_options.callback || m_options.callback(share));
  }

  /// when sketches have taken their share of the time, and the search has ended for it, the best of them tells which
  /// candidate is mapped
  void evaluate_best_sketch()
  {
    const std::optional<int> best = m_sketches->report().best_candidate;
    if(!best)
      return;
    try {
      m_evaluation({*best});
    } catch(const Search_cancelled&) { // there is no time left at all, or the callback wants no more
    }
  }

  /// moves the four corners on their own on a rough map, from those of the search and, where the rectangle is not the
  /// square, from others; what comes out is compared on the patch itself
  void move_corners(Search_outcome& outcome)
  {
    const int first_step = static_cast<int>(m_patch.border.size()) / 8;
    Corner_evaluation rough_maps([this] { return m_minimizer.make_rough_worker(); }, m_patch, m_threads,
                                 m_options.visitor, may_go_on());
    Corner_evaluation maps([this] { return m_minimizer.make_worker(); }, m_patch, m_threads, m_options.visitor,
                           may_go_on());
    Corner_moves moves(m_patch.border_lengths, [&](const auto& choices) { return rough_maps(choices); });
    try {
      std::vector<Corners> starts{outcome.report.corners};
      if(outcome.map.aspect != 1)
        for(const Corner_moves::Choice& choice : moves.best_of_spread())
          starts.push_back(choice.corners);
      std::set<Corners> ends;
      for(const Corners& start : starts)
        ends.insert(moves.descend(start, first_step).corners);
      ends.erase(outcome.report.corners);
      maps({ends.begin(), ends.end()});
    } catch(const Search_cancelled&) {
      outcome.report.is_cancelled = true;
    }
    if(maps.best_map().report.objective < outcome.map.report.objective) {
      outcome.report.corners = maps.best_corners();
      outcome.report.has_moved_corners = true;
      outcome.map = maps.best_map();
    }
    outcome.report.corner_moves = moves.evaluations();
  }

  std::function<bool()> may_go_on() const
  {
    return [this] { return may_continue(1, m_options.deadline); };
  }

  Square_border border_of(int candidate) const
  {
    return square_border(m_walk, corners_of_candidate(m_walk, candidate, m_options.corner_rule));
  }

  Candidate_evaluation::Worker for_candidates(Map_minimizer::Worker map_for) const
  {
    return [this, map_for = std::move(map_for)](int candidate, const Uv_coordinates* warm_start) {
      return map_for(border_of(candidate).uv, warm_start);
    };
  }

  /// what the strategy sees
  Corner_search_problem problem()
  {
    Corner_search_problem problem;
    problem.number_of_candidates = m_number_of_candidates;
    problem.number_of_vertices = m_patch.number_of_vertices();
    problem.number_of_faces = m_patch.number_of_faces();
    problem.objective_of = [this](const std::vector<int>& candidates) { return m_evaluation(candidates); };
    problem.objective_from_neighbors = [this](const std::vector<int>& candidates) {
      return m_evaluation(candidates, true);
    };
    if(m_sketches)
      problem.sketched_objective_of = [this](const std::vector<int>& candidates) { return (*m_sketches)(candidates); };
    problem.work = [this] {
      const long work = m_evaluation.work() + (m_sketches ? m_sketches->work() : 0);
      return double(work) / m_patch.number_of_vertices();
    };
    problem.circle_stretch = [this] { return m_minimizer.circle_stretch(); };
    problem.corner_distances = [this](int candidate) { return corner_distances(border_of(candidate).uv); };
    return problem;
  }

  /// what the evaluation does not know: the sketches, the delivered map, and the corners
  void complete(Search_outcome& outcome) const
  {
    Search_report& report = outcome.report;
    if(m_sketches) {
      const Search_report sketching = m_sketches->report();
      report.sketches = sketching.evaluations;
      report.is_cancelled |= sketching.is_cancelled;
    }
    report.is_cancelled |= outcome.map.report.stop_reason == Stop_reason::DEADLINE;
    if(report.best_candidate)
      report.best_objective = outcome.map.report.objective;
  }

  const Patch& m_patch;
  const Map_minimizer& m_minimizer;
  const Corner_search& m_search;
  const Square_search_options& m_options;
  const Deadline m_sketch_deadline = part_way_to(m_options.deadline, 0.5);
  const Border_walk m_walk;
  const int m_number_of_candidates;
  const unsigned int m_threads;
  Candidate_evaluation m_evaluation;
  Sketch_visitor m_sketch_visitor;
  std::optional<Candidate_evaluation> m_sketches;
};

CGAL_EXT_INLINE_FUNCTION Search_outcome search_square_map(const Patch& patch, const Map_minimizer& minimizer,
                                                          const Corner_search& search,
                                                          const Square_search_options& options)
{
  check_corner_search(search);
  return Square_search(patch, minimizer, search, options)();
}

CGAL_EXT_INLINE_FUNCTION Search_outcome map_with_corners(const Patch& patch, const Map_minimizer& minimizer,
                                                         const Corners& corners)
{
  const Square_border border = square_border(Border_walk(patch.border_lengths, Walk::COUNTER_CLOCKWISE), corners);
  Search_outcome outcome{minimizer.finish(minimizer.make_worker()(border.uv, nullptr)), {}};
  outcome.report.is_cancelled = outcome.map.report.stop_reason == Stop_reason::DEADLINE;
  outcome.report.candidates = 1;
  outcome.report.evaluations = 1;
  outcome.report.best_objective = outcome.map.report.objective;
  if(outcome.map.uv.rows() > 0)
    outcome.report.best_candidate = corners[0];
  outcome.report.corners = border.corners;
  outcome.report.curve = {{corners[0], outcome.map.report.objective, outcome.map.report.l2}};
  return outcome;
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SEARCH_SQUARE_SEARCH_IMPL_H
