// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_PASSED_OVER_H
#define SQUARE_MAP_PASSED_OVER_H

#include <cstddef>
#include <map>
#include <string>

namespace square_map {

/// what of a file was not used: how many of which things, in words such as "texture coordinates"
typedef std::map<std::string, std::size_t> Passed_over;

/// adds what follows after the last element, "face 7" for example, that the header of a file gives: readers of all kinds
/// leave it, and so do we, but not in silence
/// \param things "lines" or "bytes"
inline void pass_over_rest(const std::string& things, std::size_t count, const std::string& last,
                           Passed_over& passed_over)
{
  if(count > 0)
    passed_over[things + " after " + last + ", the last by its header"] = count;
}

/// "texture coordinates (8), groups (1)"
inline std::string listed(const Passed_over& passed_over)
{
  std::string text;
  for(const auto& [things, count] : passed_over)
    text += (text.empty() ? "" : ", ") + things + " (" + std::to_string(count) + ')';
  return text;
}

} // namespace square_map

#endif // SQUARE_MAP_PASSED_OVER_H
