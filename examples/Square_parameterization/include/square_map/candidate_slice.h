// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_CANDIDATE_SLICE_H
#define SQUARE_MAP_CANDIDATE_SLICE_H

#include "option_values.h"
#include "parse_number.h"

#include <numeric>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace square_map {

/// some of the candidates that brute force evaluates, one after the other; both ends are among them
struct Candidate_slice
{
  int first = 0, last = 0;

  int size() const { return last - first + 1; }
  std::string name() const { return std::to_string(first) + ':' + std::to_string(last); }
};

/// reads FIRST:LAST
inline Candidate_slice parse_candidates(const std::string& text)
{
  const std::size_t colon = text.find(':');
  const auto number = [](std::string_view digits) { return parse_integer<int>(digits); };
  const std::optional<int> first = number(std::string_view(text).substr(0, colon));
  const std::optional<int> last =
      colon == std::string::npos ? std::nullopt : number(std::string_view(text).substr(colon + 1));
  if(!first || !last || *first < 0 || *last < *first)
    throw Usage_error("--candidates takes the numbers FIRST:LAST of the first and the last candidate, counted from 0; "
                      "not '" +
                      text + "'");
  return {*first, *last};
}

/// evaluates a slice of the candidates of brute force
struct Slice_corner_search
{
  CGAL_ext::Candidate_set set;
  Candidate_slice slice;

  CGAL_ext::Candidate_set candidate_set() const { return set; }

  void operator()(const CGAL_ext::Corner_search_problem& problem) const
  {
    if(slice.last >= problem.number_of_candidates)
      throw Usage_error("--candidates " + slice.name() + ": the candidates of this surface are 0 to " +
                        std::to_string(problem.number_of_candidates - 1));
    std::vector<int> candidates(static_cast<std::size_t>(slice.size()));
    std::iota(candidates.begin(), candidates.end(), slice.first);
    problem.objective_of(candidates);
  }
};

} // namespace square_map

#endif // SQUARE_MAP_CANDIDATE_SLICE_H
