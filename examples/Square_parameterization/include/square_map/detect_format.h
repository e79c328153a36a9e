// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_DETECT_FORMAT_H
#define SQUARE_MAP_DETECT_FORMAT_H

#include "File_format.h"
#include "read_obj.h"
#include "read_off.h"
#include "read_stl.h"

#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace square_map {

/// the format that the first words of a text, or the size of a binary file, tell
inline std::optional<File_format> format_of_content(std::string_view text)
{
  if(has_size_of_binary_stl(text))
    return File_format::STL;
  Text_scanner scanner(text, '#');
  const std::string_view word = scanner.next_word_anywhere();
  if(word == "ply")
    return File_format::PLY;
  if(parse_off_keyword(word.substr(0, off_keyword_length(word))))
    return File_format::OFF;
  if(begins_with_solid(text))
    return File_format::STL;
  if(word == "v" || word == "f" || word == "fo" || unused_obj_lines().count(word) != 0)
    return File_format::OBJ;
  return {};
}

/// what a file is that begins as none of those that are read; empty when that is not known
inline std::string kind_of_other_file(std::string_view bytes)
{
  static const std::pair<std::string_view, const char*> kinds[] = {{"\x1f\x8b", "a file compressed by gzip"},
                                                                   {"PK\x03\x04", "a zip archive"},
                                                                   {"\xff\xfe", "text in UTF-16"},
                                                                   {"\xfe\xff", "text in UTF-16"},
                                                                   {"glTF", "binary glTF"},
                                                                   {"<", "XML or HTML"}};
  for(const auto& [beginning, kind] : kinds)
    if(bytes.substr(0, beginning.size()) == beginning)
      return kind;
  return "";
}

/// the format of a file without \p is_stream by its extension, of a stream without a known extension by its content
/// \throw Malformed_file with the reason alone
inline File_format format_of(const std::string& path, bool is_stream, std::string_view text)
{
  if(const auto format = format_of_extension(path))
    return *format;
  if(is_stream) {
    if(const auto format = format_of_content(text))
      return *format;
    const std::string kind = kind_of_other_file(text);
    throw Malformed_file(text.empty() ? "it is empty"
                         : !kind.empty()
                             ? "it begins as " + kind + "; OFF, OBJ, PLY or STL was expected"
                             : "it does not begin as an OFF, OBJ, PLY or STL file; --input-format names a format");
  }
  const std::string extension = extension_of(path);
  throw Malformed_file((extension.empty() ? "it has no extension" : "its extension '." + extension + "' is unknown") +
                       "; .off, .obj, .ply or .stl was expected, or --input-format");
}

/// the text without a byte order mark, which a binary STL file may begin with by chance
inline std::string_view text_of_bytes(std::string_view bytes)
{
  const std::string_view text = without_byte_order_mark(bytes);
  const bool has_zeros = bytes.substr(0, STL_HEADER_BYTES).find('\0') != std::string_view::npos;
  return has_size_of_binary_stl(bytes) || (has_zeros && !format_of_content(text)) ? bytes : text;
}

/// what to say after the reason why a file could not be read in a format: that it begins as one of another
inline std::string other_format(std::string_view text, File_format format)
{
  const std::optional<File_format> begun = format_of_content(text);
  const std::string other = !begun ? kind_of_other_file(text) : *begun != format ? name_of(*begun) : "";
  return other.empty() ? "" : "; it begins as " + other;
}

} // namespace square_map

#endif // SQUARE_MAP_DETECT_FORMAT_H
