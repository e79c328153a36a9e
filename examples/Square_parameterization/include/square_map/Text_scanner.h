// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_TEXT_SCANNER_H
#define SQUARE_MAP_TEXT_SCANNER_H

#include "Malformed_file.h"
#include "parse_number.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

namespace square_map {

/// the text without the three bytes that some programs put before UTF-8
inline std::string_view without_byte_order_mark(std::string_view text)
{
  return text.substr(0, 3) == "\xef\xbb\xbf" ? text.substr(3) : text;
}

/// The words of a text, line by line. Streams, and the readers of libraries that are built on them, take `3.7` as the
/// index 3 and `4x` as 4; here a word is what was expected from end to end, or refused with the number of its line.
class Text_scanner
{
public:
  /// \param text must live as long as the scanner
  /// \param comment the character that begins a comment, up to the end of its line, also within a word; 0 for none
  /// \param is_continued whether a line that ends in a backslash goes on in the next one
  explicit Text_scanner(std::string_view text, char comment = 0, bool is_continued = false)
    : m_text(text), m_comment(comment), m_is_continued(is_continued)
  {}

  /// the next word of this line; empty at its end
  std::string_view next_word()
  {
    skip_blanks();
    const std::size_t begin = m_place;
    while(m_place < m_text.size() && !is_blank(m_text[m_place]) && m_text[m_place] != '\r' && m_text[m_place] != '\n' &&
          !is_continuation() && !(m_comment != 0 && m_text[m_place] == m_comment))
      ++m_place;
    return m_text.substr(begin, m_place - begin);
  }

  /// goes to the next word, which may be on a later line; false at the end of the text
  bool find_word()
  {
    for(skip_blanks(); m_place < m_text.size(); skip_blanks()) {
      if(!is_line_break())
        return true;
      ++m_place;
      ++m_line;
    }
    return false;
  }

  /// the next word, which may be on a later line; empty at the end of the text
  std::string_view next_word_anywhere() { return find_word() ? next_word() : std::string_view(); }

  /// indicates whether no word is left on this line
  bool is_line_end()
  {
    skip_blanks();
    return m_place == m_text.size() || is_line_break();
  }

  /// passes over the rest of this line
  void skip_line()
  {
    while(!is_line_end())
      next_word();
  }

  /// passes over the rest of the text: how many lines with words there are
  std::size_t skip_lines()
  {
    std::size_t lines = 0;
    for(; find_word(); skip_line())
      ++lines;
    return lines;
  }

  std::size_t place() const { return m_place; }

  /// goes back to a place that `place()` gave, on the same line
  void go_back(std::size_t place) { m_place = place; }

  /// goes forward to a place
  void go_to(std::size_t place)
  {
    for(; m_place < place; ++m_place)
      if(is_line_break())
        ++m_line;
  }

  /// indicates whether nothing but blanks lies between a place and the line end before it
  bool is_first_of_line(std::size_t place) const
  {
    while(place > 0 && is_blank(m_text[place - 1]))
      --place;
    return place == 0 || m_text[place - 1] == '\n' || m_text[place - 1] == '\r';
  }

  std::size_t bytes_left() const { return m_text.size() - m_place; }

  /// "line 12", counted from 1
  std::string line_name() const { return "line " + std::to_string(m_line); }

  /// refuses the text: "line 12: " and the message
  [[noreturn]] void refuse(const std::string& message) const { throw Malformed_file(line_name() + ": " + message); }

  /// refuses a word: \p expected says what should have been in its place
  [[noreturn]] void refuse(std::string_view word, const std::string& expected) const
  {
    refuse(expected + " was expected, not " +
           (!word.empty()       ? in_quotes(word)
            : bytes_left() == 0 ? "the end of the file"
                                : "the end of the line"));
  }

  /// the next word of this line as a number; \p what names it in a message
  double next_real(const char* what = "a number")
  {
    const std::string_view word = next_word();
    const auto number = parse_real(word);
    if(!number)
      refuse(word, what);
    return *number;
  }

private:
  static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }

  /// the end of a line: also a carriage return alone, as old programs write it
  bool is_line_break() const
  {
    return m_text[m_place] == '\n' || (m_text[m_place] == '\r' && m_text.substr(m_place + 1, 1) != "\n");
  }

  /// a backslash that ends a line of a text whose lines may be continued, or the text; blanks may follow it
  bool is_continuation() const
  {
    if(!m_is_continued || m_text[m_place] != '\\')
      return false;
    const std::size_t next = m_text.find_first_not_of(" \t\v\f\r", m_place + 1);
    return next == std::string_view::npos || m_text[next] == '\n';
  }

  void skip_blanks()
  {
    while(m_place < m_text.size()) {
      if(is_blank(m_text[m_place]) || (m_text[m_place] == '\r' && !is_line_break()))
        ++m_place;
      else if(m_comment != 0 && m_text[m_place] == m_comment)
        while(m_place < m_text.size() && !is_line_break())
          ++m_place;
      else if(is_continuation()) {
        m_place = std::min(m_text.find('\n', m_place), m_text.size() - 1) + 1;
        ++m_line;
      } else
        return;
    }
  }

  std::string_view m_text;
  char m_comment;
  bool m_is_continued;
  std::size_t m_place = 0, m_line = 1;
};

} // namespace square_map

#endif // SQUARE_MAP_TEXT_SCANNER_H
