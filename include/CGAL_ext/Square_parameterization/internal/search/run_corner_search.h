// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SEARCH_RUN_CORNER_SEARCH_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SEARCH_RUN_CORNER_SEARCH_H

#include <CGAL_ext/Square_parameterization/corner_searches.h>
#include <CGAL_ext/Square_parameterization/internal/search/Candidate_evaluation.h>

#include <utility>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// lets a strategy, which may be a user's, ask for candidates until it is done or the search is cancelled. Throws
/// `Unmappable` when it asks for one that does not exist, and when it asks for nothing.
/// \param problem what the strategy sees
/// \param has_asked tells whether something was mapped, settled for, or cancelled
inline void run_corner_search(const Corner_search& search, Corner_search_problem problem,
                              const std::function<bool()>& has_asked)
{
  if(problem.corner_distances)
    problem.corner_distances = [distances = std::move(problem.corner_distances),
                                candidates = problem.number_of_candidates](int candidate) {
      check_candidate(candidate, candidates);
      return distances(candidate);
    };
  try {
    search(problem);
  } catch(const Search_cancelled&) {
    return; // the best so far is delivered, and the report says so
  }
  if(!has_asked())
    throw Unmappable(CGAL::Surface_mesh_parameterization::ERROR_WRONG_PARAMETER,
                     "the corner search asked for no candidate");
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SEARCH_RUN_CORNER_SEARCH_H
