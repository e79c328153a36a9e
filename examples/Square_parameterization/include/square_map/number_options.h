// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_NUMBER_OPTIONS_H
#define SQUARE_MAP_NUMBER_OPTIONS_H

#include "option_values.h"
#include "parse_number.h"

#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>

namespace square_map {

/// the numbers that an option takes
struct Number_range
{
  double least, most;
  bool has_least;    ///< takes the least one itself
  bool is_whole;     ///< takes whole numbers alone
  const char* words; ///< the rest of the sentence that refuses others
};

inline const std::map<std::string, Number_range>& number_options()
{
  static const Number_range count{0, 1e6, true, true, "a whole number from 0 to 1000000"};
  static const std::map<std::string, Number_range> ranges{
      {"threads", count},
      {"patience", count},
      {"step", count},
      {"interval", count},
      {"seed", count},
      {"eta", {0, 1, false, false, "above 0 and at most 1"}},
      {"balance", {0, 1, true, false, "from 0 to 1"}},
      {"time-limit", {0, 1e9, false, false, "above 0 and at most 1e9 seconds"}},
      {"cut-weight", {0, (std::numeric_limits<double>::max)(), true, false, "a finite number, 0 or more"}},
      {"max-cut-length", {0, std::numeric_limits<double>::infinity(), true, false, "a number, 0 or more"}}};
  return ranges;
}

/// the number that an option was given, or a usage error that names those that it takes
inline double parse_number_option(const std::string& option, const std::string& text)
{
  const Number_range& range = number_options().at(option);
  const bool is_of_kind = !range.is_whole || parse_integer<std::int64_t>(text);
  const std::optional<double> number = is_of_kind ? parse_real(text) : std::nullopt;
  if(!number || !(range.has_least ? *number >= range.least : *number > range.least) || !(*number <= range.most))
    throw Usage_error("--" + option + " must be " + range.words + "; not '" + text + "'");
  return *number;
}

} // namespace square_map

#endif // SQUARE_MAP_NUMBER_OPTIONS_H
