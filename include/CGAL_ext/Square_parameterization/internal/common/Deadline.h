// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COMMON_DEADLINE_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COMMON_DEADLINE_H

#include <chrono>
#include <optional>

namespace CGAL_ext {
namespace internal {

/// the time at which work that can be left unfinished ends; none: never
using Deadline = std::optional<std::chrono::steady_clock::time_point>;

inline bool has_passed(const Deadline& deadline)
{
  return deadline && std::chrono::steady_clock::now() >= *deadline;
}

/// indicates whether there is time for as much again as was done since \p start
inline bool has_time_again(std::chrono::steady_clock::time_point start, const Deadline& deadline)
{
  const auto now = std::chrono::steady_clock::now();
  return !deadline || now + (now - start) < *deadline;
}

/// the deadline of the first of two parts of the work
/// \param share of the time that is left that the part has, in [0, 1]
inline Deadline part_way_to(const Deadline& deadline, double share)
{
  if(!deadline || has_passed(deadline)) // one long ago is too far away for the difference
    return deadline;
  typedef std::chrono::steady_clock Clock;
  const Clock::time_point now = Clock::now();
  return now + std::chrono::duration_cast<Clock::duration>(share * (*deadline - now));
}

} // namespace internal
} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COMMON_DEADLINE_H
