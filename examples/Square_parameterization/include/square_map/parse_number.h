// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_PARSE_NUMBER_H
#define SQUARE_MAP_PARSE_NUMBER_H

#include <charconv>
#include <cstdlib>
#include <new>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

namespace square_map {

/// the word without a plus sign before its number, which `std::from_chars` does not take
inline std::string_view without_plus(std::string_view word)
{
  return word.size() > 1 && word[0] == '+' && word[1] != '-' ? word.substr(1) : word;
}

/// the number that a word is from end to end; none for `1x`, `1,5` or an empty word. Numbers too large for a double are
/// infinite, numbers too small are zero or denormalized.
inline std::optional<double> parse_real(std::string_view word)
{
  const std::string_view digits = without_plus(word);
  const char* const end = digits.data() + digits.size();
  double x = 0;
  const auto [stop, error] = std::from_chars(digits.data(), end, x);
  if(error == std::errc::not_enough_memory)
    throw std::bad_alloc();
  if(stop != end || error == std::errc::invalid_argument)
    return {};
  if(error == std::errc::result_out_of_range) // too large or too small: only strtod() says which
    x = std::strtod(std::string(digits).c_str(), nullptr);
  return x;
}

/// the whole number that a word is from end to end; none for `3.7`, `4x`, or a number that does not fit
template <class Integer>
std::optional<Integer> parse_integer(std::string_view word)
{
  const std::string_view digits = without_plus(word);
  const char* const end = digits.data() + digits.size();
  Integer n = 0;
  const auto [stop, error] = std::from_chars(digits.data(), end, n);
  return stop == end && error == std::errc() ? std::optional<Integer>(n) : std::nullopt;
}

/// indicates whether a word is a whole number, if perhaps too large for any type
inline bool is_whole_number(std::string_view word)
{
  const std::string_view number = without_plus(word);
  const std::string_view digits = number.substr(number.substr(0, 1) == "-" ? 1 : 0);
  return !digits.empty() && digits.find_first_not_of("0123456789") == std::string_view::npos;
}

} // namespace square_map

#endif // SQUARE_MAP_PARSE_NUMBER_H
