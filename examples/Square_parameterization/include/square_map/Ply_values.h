// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_PLY_VALUES_H
#define SQUARE_MAP_PLY_VALUES_H

#include "Byte_scanner.h"
#include "Passed_over.h"
#include "Ply_header.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace square_map {

/// the values of a PLY file in text. Each element begins on a new line.
class Ply_text
{
public:
  explicit Ply_text(std::string_view text, std::size_t begin) : m_scanner(text) { m_scanner.go_to(begin); }

  double next(Ply_type type, const std::string& element, std::size_t index)
  {
    const std::string_view word = next_word(element, index);
    const bool is_real = type == Ply_type::FLOAT32 || type == Ply_type::FLOAT64;
    const auto number = parse_real(word);
    if(!number || (!is_real && !is_integer(type, word)))
      m_scanner.refuse(word, "in " + element + ' ' + std::to_string(index) +
                                 (is_real                 ? " a number"
                                  : is_whole_number(word) ? " a number that its type can hold"
                                                          : " a whole number"));
    return type == Ply_type::FLOAT32 ? static_cast<double>(static_cast<float>(*number)) : *number; // as in binary
  }

  /// passes over values, whatever they are
  void skip(Ply_type, std::size_t count, const std::string& element, std::size_t index)
  {
    for(std::size_t k = 0; k < count; ++k)
      next_word(element, index);
  }

  void end_element(const std::string& element, std::size_t index)
  {
    if(!m_scanner.is_line_end())
      m_scanner.refuse(m_scanner.next_word(), "the end of " + element + ' ' + std::to_string(index));
  }

  /// passes over what is left
  void skip_rest(const std::string& last_element, Passed_over& passed_over)
  {
    pass_over_rest("lines", m_scanner.skip_lines(), last_element, passed_over);
  }

  std::size_t bytes_left() const { return m_scanner.bytes_left(); }

  /// refuses what was read last, with its line
  [[noreturn]] void refuse(const std::string& message) const { m_scanner.refuse(message); }

private:
  std::string_view next_word(const std::string& element, std::size_t index)
  {
    const std::string_view word = m_scanner.next_word_anywhere();
    if(word.empty())
      throw Malformed_file("it is incomplete: it ends in " + element + ' ' + std::to_string(index));
    return word;
  }

  /// indicates whether a word is a number that fits into a type of whole numbers
  static bool is_integer(Ply_type type, std::string_view word)
  {
    switch(type) {
    case Ply_type::INT8:
      return parse_integer<std::int8_t>(word).has_value();
    case Ply_type::UINT8:
      return parse_integer<std::uint8_t>(word).has_value();
    case Ply_type::INT16:
      return parse_integer<std::int16_t>(word).has_value();
    case Ply_type::UINT16:
      return parse_integer<std::uint16_t>(word).has_value();
    case Ply_type::INT32:
      return parse_integer<std::int32_t>(word).has_value();
    default:
      return parse_integer<std::uint32_t>(word).has_value();
    }
  }

  Text_scanner m_scanner;
};

/// the values of a binary PLY file
class Ply_bytes
{
public:
  Ply_bytes(std::string_view text, const Ply_header& header)
    : m_scanner(text.substr(header.data),
                header.is_big_endian ? boost::endian::order::big : boost::endian::order::little)
  {}

  double next(Ply_type type, const std::string& element, std::size_t index)
  {
    const char* const name = element.c_str();
    switch(type) {
    case Ply_type::INT8:
      return m_scanner.next<std::int8_t>(name, index);
    case Ply_type::UINT8:
      return m_scanner.next<std::uint8_t>(name, index);
    case Ply_type::INT16:
      return m_scanner.next<std::int16_t>(name, index);
    case Ply_type::UINT16:
      return m_scanner.next<std::uint16_t>(name, index);
    case Ply_type::INT32:
      return m_scanner.next<std::int32_t>(name, index);
    case Ply_type::UINT32:
      return m_scanner.next<std::uint32_t>(name, index);
    case Ply_type::FLOAT32:
      return m_scanner.next<float>(name, index);
    default:
      return m_scanner.next<double>(name, index);
    }
  }

  void skip(Ply_type type, std::size_t count, const std::string& element, std::size_t index)
  {
    static constexpr std::size_t sizes[] = {1, 1, 2, 2, 4, 4, 4, 8};
    // by parts: a product could overflow, which bytes left cannot
    const std::size_t size = sizes[static_cast<std::size_t>(type)];
    m_scanner.skip(count > bytes_left() ? bytes_left() + 1 : size * count, element.c_str(), index);
  }

  void end_element(const std::string&, std::size_t) {}

  void skip_rest(const std::string& last_element, Passed_over& passed_over)
  {
    pass_over_rest("bytes", m_scanner.bytes_left(), last_element, passed_over);
  }

  std::size_t bytes_left() const { return m_scanner.bytes_left(); }

  [[noreturn]] void refuse(const std::string& message) const { throw Malformed_file(message); }

private:
  Byte_scanner m_scanner;
};

} // namespace square_map

#endif // SQUARE_MAP_PLY_VALUES_H
