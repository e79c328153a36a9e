// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_STEP_SAMPLING_CORNER_SEARCH_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_STEP_SAMPLING_CORNER_SEARCH_H

#include <CGAL_ext/Square_parameterization/internal/search/Candidate_ring.h>

namespace CGAL_ext {

/// \ingroup PkgSquareParameterizationSearches
///
/// evaluates every `step`-th candidate of the quarter, together; then, together, every candidate between the best
/// sample and the samples beside it on the ring (Dechvijankit et al., algorithm 1).
///
/// About \f$ m / s + 2 (s - 1) \f$ evaluations for \f$ m \f$ candidates and a step \f$ s \f$. Deterministic; finds the
/// optimum when the objective has one valley that is wider than the step.
/// \cgalModels `CornerSearch`
class Step_sampling_corner_search
{
public:
  /// takes the step of the paper, \f$ \max(2, \lfloor\sqrt{V m / F}\rfloor) \f$ with \f$ V \f$ vertices and
  /// \f$ F \f$ faces
  Step_sampling_corner_search() : Step_sampling_corner_search(0) {}

  /// \param step distance between samples, in candidates, 1 or more; 0 for the step of the paper
  explicit Step_sampling_corner_search(int step) : m_step(step) {}

  /// indicates whether the step is in its range. With one that is not, a search is refused with
  /// `ERROR_WRONG_PARAMETER`.
  bool is_valid() const { return m_step >= 0; }

  Candidate_set candidate_set() const { return Candidate_set::QUARTER; }

  void operator()(const Corner_search_problem& problem) const
  {
    internal::Candidate_ring ring(problem);
    const int step = m_step > 0 ? m_step : internal::sampling_step(problem);
    std::vector<int> samples;
    for(int candidate = 0; candidate < ring.size(); candidate += step)
      samples.push_back(candidate);
    ring.evaluate(samples);
    ring.evaluate_around_best();
  }

private:
  int m_step;
};

} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_STEP_SAMPLING_CORNER_SEARCH_H
