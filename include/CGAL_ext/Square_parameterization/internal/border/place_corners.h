// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_BORDER_PLACE_CORNERS_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_BORDER_PLACE_CORNERS_H

#include <CGAL_ext/Square_parameterization/internal/border/border_curves.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// positions in the border loop for four corners, each of which may be put at several places, as a vertex that a cut
/// has copied: distinct, in counter-clockwise order, and so that the shortest of the four sides is as long as possible
/// (ties: the first places). Nothing when no choice is in that order.
///
/// With `c` places per corner about `c`^3 operations.
/// \param lengths #B, edge k joins border vertices k and k + 1
/// \param places positions of each corner
inline std::optional<Corners> place_corners(const std::vector<double>& lengths,
                                            const std::array<std::vector<int>, 4>& places)
{
  struct Choice
  {
    double shortest_side;
    Corners corners;
  };
  const int n = static_cast<int>(lengths.size());
  std::vector<double> length_before(1, 0.); // of the border edges before a position
  std::partial_sum(lengths.begin(), lengths.end(), std::back_inserter(length_before));
  const auto length_between = [&](int from, int to) { // counter-clockwise
    return length_before[to] - length_before[from] + (to <= from ? length_before[n] : 0);
  };
  const auto steps_between = [n](int from, int to) { return (to - from + n) % n; };
  // of the choices of the corners before the k-th the best that a place for the k-th continues
  const auto continued = [&](const std::vector<Choice>& choices, int k, int place) {
    std::optional<Choice> best;
    for(const Choice& choice : choices) {
      const int first = choice.corners[0], previous = choice.corners[k - 1];
      if(steps_between(first, place) <= steps_between(first, previous))
        continue;
      const double side = (std::min)(choice.shortest_side, length_between(previous, place));
      if(!best || side > best->shortest_side) {
        best = Choice{side, choice.corners};
        best->corners[k] = place;
      }
    }
    return best;
  };
  std::optional<Choice> best;
  for(int first : places[0]) {
    std::vector<Choice> choices{{std::numeric_limits<double>::infinity(), {first}}}; // one per place of the last corner
    for(int k = 1; k < 4; ++k) {
      std::vector<Choice> longer;
      for(int place : places[k])
        if(const auto choice = continued(choices, k, place))
          longer.push_back(*choice);
      choices = std::move(longer);
    }
    for(Choice& choice : choices) {
      choice.shortest_side = (std::min)(choice.shortest_side, length_between(choice.corners[3], first));
      if(!best || choice.shortest_side > best->shortest_side)
        best = choice;
    }
  }
  return best ? std::optional<Corners>(best->corners) : std::nullopt;
}

/// the order, with the first corner first, in which corners that have no places in counter-clockwise order have some;
/// nothing when there is none
inline std::optional<std::array<int, 4>> counter_clockwise_order(const std::vector<double>& lengths,
                                                                 const std::array<std::vector<int>, 4>& places)
{
  std::array<int, 4> order{0, 1, 2, 3};
  do {
    if(place_corners(lengths, {places[order[0]], places[order[1]], places[order[2]], places[order[3]]}))
      return order;
  } while(std::next_permutation(order.begin() + 1, order.end()));
  return std::nullopt;
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_BORDER_PLACE_CORNERS_H
