// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_CORNER_SEARCHES_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_CORNER_SEARCHES_H

#include <CGAL_ext/Square_parameterization/Corner_search_problem.h>

#include <functional>
#include <numeric>
#include <vector>

namespace CGAL_ext {

/// \ingroup PkgSquareParameterizationSearches
///
/// evaluates all border vertices. Finds the optimum, with as many evaluations as there are border vertices.
/// \cgalModels `CornerSearch`
struct Brute_force_corner_search
{
  Candidate_set candidate_set() const { return Candidate_set::FULL; }

  void operator()(const Corner_search_problem& problem) const
  {
    std::vector<int> all(problem.number_of_candidates);
    std::iota(all.begin(), all.end(), 0);
    problem.objective_of(all);
  }
};

/// \ingroup PkgSquareParameterizationSearches
///
/// evaluates the border vertices of the first quarter. Finds the optimum of these; since sides close at vertices, a
/// candidate of another quarter can be a little better.
/// \cgalModels `CornerSearch`
struct Quarter_brute_force_corner_search : Brute_force_corner_search
{
  Candidate_set candidate_set() const { return Candidate_set::QUARTER; }
};

/// \ingroup PkgSquareParameterizationSearches
///
/// evaluates the first candidate alone: no search
/// \cgalModels `CornerSearch`
struct First_candidate_corner_search
{
  Candidate_set candidate_set() const { return Candidate_set::QUARTER; }

  void operator()(const Corner_search_problem& problem) const { problem.objective_of({0}); }
};

/// \ingroup PkgSquareParameterizationSearches
///
/// any model of `CornerSearch`, chosen at run time
class Corner_search
{
public:
  template <class Search>
  Corner_search(const Search& search) : m_candidate_set(search.candidate_set()), m_search(search)
  {}

  Candidate_set candidate_set() const { return m_candidate_set; }

  void operator()(const Corner_search_problem& problem) const { m_search(problem); }

private:
  Candidate_set m_candidate_set;
  std::function<void(const Corner_search_problem&)> m_search;
};

} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_CORNER_SEARCHES_H
