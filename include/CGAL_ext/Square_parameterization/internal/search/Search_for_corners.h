// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SEARCH_SEARCH_FOR_CORNERS_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SEARCH_SEARCH_FOR_CORNERS_H

#include <CGAL_ext/Square_parameterization/Square_search_options.h>
#include <CGAL_ext/Square_parameterization/corner_searches.h>
#include <CGAL_ext/Square_parameterization/internal/border/border_curves.h>
#include <CGAL_ext/Square_parameterization/internal/common/Deadline.h>
#include <CGAL_ext/Square_parameterization/internal/common/Minimizer_numbers.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/Map_minimizer.h>
#include <CGAL_ext/Square_parameterization/internal/search/Candidate_evaluation.h>
#include <CGAL_ext/Square_parameterization/internal/search/Free_corners.h>
#include <CGAL_ext/Square_parameterization/internal/search/Search_outcome.h>
#include <CGAL_ext/Square_parameterization/internal/search/run_corner_search.h>
#include <CGAL_ext/Square_parameterization/internal/search/search_work.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
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

/// one search for the corners of one patch: what the strategy asks for is evaluated, candidates, sketches, and corners of
/// their own; then the corners move
class Search_for_corners
{
public:
  Search_for_corners(const Patch& patch, const Map_minimizer& minimizer, const Corner_search& search,
                     const Square_search_options& options, double work_factor)
    : m_patch(patch),
      m_minimizer(minimizer),
      m_search(search),
      m_options(options),
      m_work_factor(work_factor),
      m_walk(patch.border_lengths, options.walk),
      m_number_of_candidates(search.candidate_set() == Candidate_set::FULL ? m_walk.size()
                                                                           : number_of_quarter_candidates(m_walk)),
      m_evaluation(
          m_number_of_candidates, [this] { return for_candidates(m_minimizer.make_worker()); }, options.visitor,
          [this](double share) { return may_continue(share, m_options.deadline); },
          most_maps_at_once(patch.number_of_vertices())),
      m_corners(
          patch, minimizer, options.visitor, [this] { return may_continue(1, m_options.deadline); },
          // while nothing is mapped, time is left for that
          [this] { return may_continue(1, has_map() ? m_options.deadline : m_sketch_deadline); })
  {
    m_sketch_visitor.visitor = options.visitor;
    if(const std::optional<Coarse_maps> kind = kind_of_sketches())
      m_sketches.emplace(
          m_number_of_candidates,
          [this, kind] { return for_candidates(below_limit(m_minimizer.make_comparing_worker(*kind))); },
          &m_sketch_visitor, [this](double) { return may_continue(0, m_sketch_deadline); });
  }

  Search_outcome operator()()
  {
    if(m_options.visitor != nullptr)
      m_options.visitor->start_search(static_cast<std::size_t>(m_number_of_candidates));
    ask(problem());
    if(m_sketches)
      m_sketches->release_workers();
    if(!has_map() && m_evaluation.is_untouched() && m_sketches && has_passed(m_sketch_deadline))
      m_settled_for = m_sketches->report().best_candidate; // the time for sketches ended before the search did
    const bool is_moved = move_corners();
    if(m_settled_for && !is_moved)
      map_settled_for();
    m_evaluation.release_workers();
    m_corners.release_workers();
    return best();
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

  /// the coarse maps by which candidates are compared: rough ones where corners move on sketches afterwards, but the patch is
  /// not so large that candidates are compared by these
  std::optional<Coarse_maps> kind_of_sketches() const
  {
    if(m_minimizer.has_sketches())
      return Coarse_maps::SKETCHES;
    const bool is_large = m_patch.number_of_vertices() > Minimizer_numbers::LARGEST_SKETCH;
    return is_large && is_refined_by_moves() && m_corners.has_cheap_rough_maps()
               ? std::optional(Coarse_maps::FIRST_MOVES)
               : std::nullopt;
  }

  bool has_rough_sketches() const { return m_sketches && !m_minimizer.has_sketches(); }

  bool is_refined_by_moves() const { return m_options.moves_corners && m_corners.move_on_sketches(); }

  bool has_map() const { return m_evaluation.best_map().uv.rows() > 0 || m_corners.best_map().uv.rows() > 0; }

  void ask(Corner_search_problem problem)
  {
    run_corner_search(m_search, std::move(problem), [this] {
      return m_settled_for || !m_evaluation.is_untouched() || m_corners.number_of_maps() > 0;
    });
  }

  /// maps the candidate that was settled for; when it has no map, sketches mislead, and the strategy is asked again
  void map_settled_for()
  {
    try {
      const Uv_coordinates* const sketch = sketch_of(*m_settled_for);
      if(sketch != nullptr)
        m_evaluation.set_warm_start(*m_settled_for, *sketch);
      m_evaluation({*m_settled_for}, sketch != nullptr);
    } catch(const Search_cancelled&) {
      return; // there is no time left at all, or the callback wants no more
    }
    if(has_map())
      return;
    m_settled_for.reset();
    ask(without_sketches_and_moves(problem()));
  }

  /// moves the corners from those of the best candidate; false when it may still be better than what comes out
  bool move_corners()
  {
    const Search_report report = m_evaluation.report();
    const std::optional<int> candidate = m_settled_for ? m_settled_for : report.best_candidate;
    if(!m_options.moves_corners || !m_corners.has_rough_maps() || !candidate || report.is_cancelled)
      return false;
    if(report.best_candidate && !(report.best_objective < Minimizer_numbers::HOPELESS_RESULT))
      return false; // rough maps of such a surface tell nothing
    if(!m_settled_for && m_corners.is_too_costly(m_evaluation.best_map()))
      return false;
    return !is_too_slow_to_move(report.evaluations) &&
           m_corners.move(border_of(*candidate).corners, sketch_of(*candidate));
  }

  /// indicates whether maps, and sketches by which candidates are compared in their place, cost too much for corners to move
  bool is_too_slow_to_move(std::size_t evaluations) const
  {
    if(!has_rough_sketches())
      return work() > MOST_WORK_TO_MOVE * double(evaluations + (m_sketches ? m_sketches->report().evaluations : 0));
    // the one map, most of the time; those of small meshes are soon made
    const int vertices = (std::max)(m_patch.number_of_vertices(), LEAST_VERTICES_OF_COSTLY_MAP);
    return double(m_evaluation.work()) > MOST_WORK_TO_MOVE * double(evaluations) * vertices;
  }

  /// null when there is none
  const Uv_coordinates* sketch_of(int candidate) const
  {
    return m_sketches ? m_sketches->warm_start(candidate) : nullptr;
  }

  /// of maps and sketches so far, in sweeps over the mesh
  /// \param most_vertices that a sweep of maps counts for
  double work(int most_vertices = (std::numeric_limits<int>::max)()) const
  {
    const int vertices = m_patch.number_of_vertices();
    const double of_sketches =
        m_sketches ? double(m_sketches->work()) / (std::min)(vertices, MOST_VERTICES_OF_SKETCH) : 0;
    return double(m_evaluation.work()) / (std::min)(vertices, most_vertices) + of_sketches;
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

  /// gives up sketches that will not be lower than the best one before the call
  Map_minimizer::Worker below_limit(Map_minimizer::Comparing_worker sketch_for) const
  {
    return
        [this, sketch_for = std::move(sketch_for)](const Uv_coordinates& border_uv, const Uv_coordinates* warm_start) {
          return sketch_for(border_uv, warm_start, m_sketch_limit);
        };
  }

  /// sketches start from those of their neighbors in earlier calls
  std::vector<double> sketch(const std::vector<int>& candidates)
  {
    constexpr double MARGIN = 5e-3; // by which a sketch may be told to stay above another one that it reaches
    const Minimized_map& best = m_sketches->best_map();
    const bool may_differ_in_aspect = has_rough_sketches() && best.aspect != 1; // such maps come down slowly
    m_sketch_limit = may_differ_in_aspect ? Map_minimizer::NO_LIMIT : (1 + MARGIN) * best.report.objective;
    return (*m_sketches)(candidates, true);
  }

  /// maps candidates, each from its sketch, if it has one, else from its neighbors
  std::vector<double> map_from_sketches(const std::vector<int>& candidates)
  {
    for(int candidate : candidates)
      if(sketch_of(candidate) != nullptr && m_evaluation.warm_start(candidate) == nullptr)
        m_evaluation.set_warm_start(candidate, *sketch_of(candidate));
    const std::vector<double> objectives = m_evaluation(candidates, true);
    for(std::size_t i = 0; i < candidates.size(); ++i)
      if(!std::isfinite(objectives[i]))
        m_evaluation.forget_warm_start(candidates[i]);
    return objectives;
  }

  /// what the strategy sees
  Corner_search_problem problem()
  {
    Corner_search_problem problem;
    problem.number_of_candidates = m_number_of_candidates;
    problem.number_of_vertices = m_patch.number_of_vertices();
    problem.number_of_faces = m_patch.number_of_faces();
    problem.border_lengths = m_patch.border_lengths;
    problem.objective_of = [this](const std::vector<int>& candidates) { return m_evaluation(candidates); };
    problem.objective_from_neighbors = [this](const std::vector<int>& candidates) {
      return has_rough_sketches() ? map_from_sketches(candidates) : m_evaluation(candidates, true);
    };
    problem.is_refined_by_moves = is_refined_by_moves();
    problem.objective_of_corners = [this](const std::vector<Corners>& choices) { return m_corners.map(choices); };
    if(m_corners.has_rough_maps())
      problem.rough_objective_of_corners = [this](const std::vector<Corners>& choices) {
        return m_corners.map_roughly(choices);
      };
    if(has_rough_sketches())
      problem.rough_objective_of = [this](const std::vector<int>& candidates) { return sketch(candidates); };
    else if(m_sketches) {
      problem.sketched_objective_of = [this](const std::vector<int>& candidates) { return sketch(candidates); };
      problem.settle_for = [this](int candidate) {
        check_candidate(candidate, m_number_of_candidates);
        m_settled_for = candidate;
      };
    }
    problem.work = [this] {
      m_heeds_work = true;
      return work(MOST_VERTICES_OF_MAP) / m_work_factor;
    };
    problem.circle_stretch = [this] { return m_minimizer.circle_stretch(); };
    problem.corner_distances = [this](int candidate) { return corner_distances(border_of(candidate).uv); };
    return problem;
  }

  static Corner_search_problem without_sketches_and_moves(Corner_search_problem problem)
  {
    problem.sketched_objective_of = {};
    problem.settle_for = {};
    problem.rough_objective_of = {};
    problem.is_refined_by_moves = false;
    return problem;
  }

  /// the best map so far, and how it was found
  Search_outcome best() const
  {
    const double visited = double(m_evaluation.work()) + (m_sketches ? double(m_sketches->work()) : 0);
    Search_outcome outcome{m_evaluation.best_map(), m_evaluation.report(), visited, m_heeds_work};
    Search_report& report = outcome.report;
    if(m_settled_for && !report.best_candidate && has_map())
      report.best_candidate = m_settled_for;
    if(report.best_candidate)
      report.corners = border_of(*report.best_candidate).corners;
    if(m_corners.best_map().report.objective < outcome.map.report.objective) {
      outcome.map = m_corners.best_map();
      report.corners = m_corners.best_corners();
      report.has_moved_corners = true;
    }
    report.is_cancelled |= m_corners.is_cancelled();
    report.corner_maps = m_corners.number_of_maps();
    report.corner_moves = m_corners.number_of_rough_maps();
    if(m_sketches) {
      const Search_report sketching = m_sketches->report();
      report.sketches = sketching.evaluations;
      report.sketched_curve = sketching.curve;
      report.is_cancelled |= sketching.is_cancelled;
    }
    return outcome;
  }

  const Patch& m_patch;
  const Map_minimizer& m_minimizer;
  const Corner_search& m_search;
  const Square_search_options& m_options;
  const double m_work_factor;
  bool m_heeds_work = false;
  const Deadline m_sketch_deadline = part_way_to(m_options.deadline, 0.5);
  const Border_walk m_walk;
  const int m_number_of_candidates;
  Candidate_evaluation m_evaluation;
  Sketch_visitor m_sketch_visitor;
  std::optional<Candidate_evaluation> m_sketches;
  double m_sketch_limit = std::numeric_limits<double>::infinity();
  Free_corners m_corners;
  std::optional<int> m_settled_for; // a candidate that is known by its sketch alone
};

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SEARCH_SEARCH_FOR_CORNERS_H
