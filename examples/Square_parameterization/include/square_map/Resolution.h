// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_RESOLUTION_H
#define SQUARE_MAP_RESOLUTION_H

#include "option_values.h"
#include "parse_number.h"

#include <CGAL_ext/Square_parameterization/Grid_size.h>

#include <optional>
#include <string>

namespace square_map {

constexpr int LARGEST_RESOLUTION = 16385; // 2^14 + 1

/// the size that "257" or "400x300" stands for. Throws `Usage_error`.
inline CGAL_ext::Grid_size parse_resolution(const std::string& text)
{
  const std::size_t cross = text.find('x');
  const std::string first = text.substr(0, cross), second = cross != std::string::npos ? text.substr(cross + 1) : first;
  const std::optional<int> width = parse_integer<int>(first), height = parse_integer<int>(second);
  const auto is_possible = [](const std::optional<int>& n) { return n && *n >= 2 && *n <= LARGEST_RESOLUTION; };
  if(!is_possible(width) || !is_possible(height))
    throw Usage_error("--resolution is one number of samples, as 257, or two, as 400x300, from 2 to " +
                      std::to_string(LARGEST_RESOLUTION) + "; not '" + text + "'");
  return {*width, *height};
}

/// the least square size 2^k + 1 that has four samples for each vertex, at least 65 and at most 4097 a side
inline CGAL_ext::Grid_size default_resolution(std::size_t vertices)
{
  int intervals = 64;
  while(intervals < 4096 && static_cast<std::size_t>(intervals + 1) * (intervals + 1) < 4 * vertices)
    intervals *= 2;
  return {intervals + 1, intervals + 1};
}

} // namespace square_map

#endif // SQUARE_MAP_RESOLUTION_H
