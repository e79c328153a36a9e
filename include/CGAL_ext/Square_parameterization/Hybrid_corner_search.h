// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_HYBRID_CORNER_SEARCH_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_HYBRID_CORNER_SEARCH_H

#include <CGAL_ext/Square_parameterization/circle_corner_searches.h>
#include <CGAL_ext/Square_parameterization/internal/search/Candidate_ring.h>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {

/// \ingroup PkgSquareParameterizationSearches
///
/// starts at the better of the two predictions from the circle, walks left and right on the ring with a constant
/// interval while the objective falls, both ways at the same time; then evaluates, together, every candidate between the
/// best and its evaluated neighbors (Dechvijankit et al., algorithm 2).
///
/// Usually about \f$ 4 + 2 (i - 1) \f$ evaluations for an interval \f$ i \f$, and one circular map. Deterministic;
/// finds the optimum when it lies in the valley of the start.
/// \cgalModels `CornerSearch`
class Hybrid_corner_search
{
public:
  /// takes the interval of the paper, \f$ \max(1, s - 1) \f$ with the step \f$ s \f$ of
  /// `Step_sampling_corner_search`
  Hybrid_corner_search() : Hybrid_corner_search(0) {}

  /// \param interval stride of the walks, in candidates, 1 or more; 0 for the interval of the paper
  explicit Hybrid_corner_search(int interval) : m_interval(interval) {}

  /// indicates whether the interval is in its range. With one that is not, a search is refused with
  /// `ERROR_WRONG_PARAMETER`.
  bool is_valid() const { return m_interval >= 0; }

  Candidate_set candidate_set() const { return Candidate_set::QUARTER; }

  void operator()(const Corner_search_problem& problem) const
  {
    internal::Candidate_ring ring(problem);
    const int interval = m_interval > 0 ? m_interval : (std::max)(1, internal::sampling_step(problem) - 1);
    const std::vector<double> circle_stretch = problem.circle_stretch();
    ring.evaluate({internal::single_highest_candidate(problem, circle_stretch),
                   internal::many_high_candidate(problem, circle_stretch)});
    walk_both_ways(ring, interval);
    ring.evaluate_around_best();
  }

private:
  /// goes on in each direction until the objective no longer falls there, or the ring is closed. A side where the worse
  /// prediction lies within the first stride is not walked: the objective does not fall there.
  static void walk_both_ways(internal::Candidate_ring& ring, int interval)
  {
    const int start = ring.best();
    bool is_walking[2] = {true, true};
    for(int distance = 1; distance < interval; ++distance) // the other prediction may bound a side already
      for(int side = 0; side < 2; ++side)
        if(ring.is_known(position(ring, start, distance, side, 1)))
          is_walking[side] = false;
    for(int steps = 1; (is_walking[0] || is_walking[1]) && 2 * steps * interval < ring.size() + interval; ++steps) {
      std::vector<int> batch;
      for(int side = 0; side < 2; ++side)
        if(is_walking[side])
          batch.push_back(position(ring, start, interval, side, steps));
      ring.evaluate(batch);
      for(int side = 0; side < 2; ++side)
        if(is_walking[side]) {
          const double before = ring.objective(position(ring, start, interval, side, steps - 1));
          const double here = ring.objective(position(ring, start, interval, side, steps));
          is_walking[side] = here < before || !std::isfinite(before); // out of a region without a map
        }
    }
  }

  static int position(const internal::Candidate_ring& ring, int start, int interval, int side, int steps)
  {
    return ring.at(start + (side == 0 ? -1L : 1L) * interval * steps);
  }

  int m_interval;
};

} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_HYBRID_CORNER_SEARCH_H
