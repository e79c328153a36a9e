// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_CORNER_SEARCHES_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_CORNER_SEARCHES_H

#include <CGAL_ext/Square_parameterization/Corner_search_problem.h>

#include <functional>
#include <numeric>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL_ext {

/// \cond SKIP_IN_MANUAL
namespace internal {

template <class Search, class = void>
struct Has_ranges : std::false_type
{
};

template <class Search>
struct Has_ranges<Search, std::void_t<decltype(std::declval<const Search&>().is_valid())>> : std::true_type
{
};

/// what a search says of its numbers; one that says nothing has none
template <class Search>
bool is_valid_search(const Search& search)
{
  if constexpr(Has_ranges<Search>::value)
    return search.is_valid();
  else
    return true;
}

} // namespace internal
/// \endcond

/// \ingroup PkgSquareParameterizationSearches
///
/// evaluates all border vertices. Finds the optimum, with as many evaluations as there are border vertices.
/// \cgalModels `CornerSearch`
struct Brute_force_corner_search
{
  Candidate_set candidate_set() const { return Candidate_set::FULL; }

  void operator()(const Corner_search_problem& problem) const
  {
    std::vector<int> all(static_cast<std::size_t>(problem.number_of_candidates));
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
/// any model of `CornerSearch`, chosen at run time. It holds a copy of it.
/// \cgalModels `CornerSearch`
class Corner_search
{
public:
  /// \tparam Search must be a model of `CornerSearch`.
  template <class Search>
  Corner_search(const Search& search)
    : m_candidate_set(search.candidate_set()), m_is_valid(internal::is_valid_search(search)), m_search(search)
  {}

  /// indicates whether the numbers of the search are in their ranges; `true` for one without `is_valid()`
  bool is_valid() const { return m_is_valid; }

  Candidate_set candidate_set() const { return m_candidate_set; }

  /// indicates whether the search that it was made of is of that type
  template <class Search>
  bool is_of_type() const
  {
    return m_search.target<Search>() != nullptr;
  }

  void operator()(const Corner_search_problem& problem) const { m_search(problem); }

private:
  Candidate_set m_candidate_set;
  bool m_is_valid;
  std::function<void(const Corner_search_problem&)> m_search;
};

} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_CORNER_SEARCHES_H
