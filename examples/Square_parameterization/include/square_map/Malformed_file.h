// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_MALFORMED_FILE_H
#define SQUARE_MAP_MALFORMED_FILE_H

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

namespace square_map {

/// a file that cannot be read, or whose content makes no sense
struct Malformed_file : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// a piece of a file for a message: in quotes, on one line, and short
inline std::string in_quotes(std::string_view piece)
{
  constexpr std::size_t LONGEST = 40;
  std::string text(piece.substr(0, LONGEST));
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < 32 || c > 126; }, '?');
  return "'" + text + (piece.size() > LONGEST ? "..." : "") + "'";
}

/// a number of things, in words: "1 face", "2 faces"
inline std::string counted(std::size_t count, const std::string& thing, const std::string& things)
{
  return std::to_string(count) + ' ' + (count == 1 ? thing : things);
}

} // namespace square_map

#endif // SQUARE_MAP_MALFORMED_FILE_H
