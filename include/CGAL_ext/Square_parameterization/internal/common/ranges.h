// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COMMON_RANGES_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COMMON_RANGES_H

#include <CGAL_ext/Square_parameterization/internal/common/Thread_team.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL_ext {
namespace internal {

/// elements, triangles or vertices, that one thread takes at a time: enough to be worth the microseconds that it takes
/// to share them out
constexpr std::size_t RANGE = 4096;

/// calls `visit(begin, end)` for ranges of [0, count[ that together are all of it, on the threads of the current team.
/// The ranges do not depend on the number of threads.
template <class Visit>
void for_ranges(std::size_t count, const Visit& visit, std::size_t range = RANGE)
{
  const std::size_t ranges = (count + range - 1) / range;
  Thread_team::current()(ranges, [&](std::size_t i) { visit(i * range, (std::min)(count, (i + 1) * range)); });
}

/// the sum of what `summand(begin, end)` returns for these ranges, in their order: the same for any number of threads
template <class Sum, class Summand>
Sum sum_of_ranges(std::size_t count, Sum zero, const Summand& summand)
{
  std::vector<Sum> sums((count + RANGE - 1) / RANGE, zero);
  for_ranges(count, [&](std::size_t begin, std::size_t end) { sums[begin / RANGE] = summand(begin, end); });
  if(sums.empty())
    return zero;
  Sum sum = sums[0];
  for(std::size_t i = 1; i < sums.size(); ++i)
    sum += sums[i];
  return sum;
}

} // namespace internal
} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COMMON_RANGES_H
