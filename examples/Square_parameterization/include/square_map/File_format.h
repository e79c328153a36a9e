// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_FILE_FORMAT_H
#define SQUARE_MAP_FILE_FORMAT_H

#include "read_obj.h"
#include "read_off.h"
#include "read_stl.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace square_map {

/// the formats that are read
enum class File_format
{
  OFF,
  OBJ,
  PLY,
  STL
};

/// the formats by their names on the command line, which are the extensions, too
inline const std::map<std::string, File_format>& file_formats()
{
  static const std::map<std::string, File_format> formats{
      {"off", File_format::OFF}, {"obj", File_format::OBJ}, {"ply", File_format::PLY}, {"stl", File_format::STL}};
  return formats;
}

/// the name of a format in a message
inline const char* name_of(File_format format)
{
  static const char* const names[] = {"OFF", "OBJ", "PLY", "STL"};
  return names[static_cast<int>(format)];
}

/// extension of the path in lower case, without the dot
inline std::string extension_of(const std::string& path)
{
  std::string extension = std::filesystem::path(path).extension().string();
  extension.erase(0, 1);
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

/// the format that the extension of a path names
inline std::optional<File_format> format_of_extension(const std::string& path)
{
  const auto found = file_formats().find(extension_of(path));
  return found != file_formats().end() ? std::optional<File_format>(found->second) : std::nullopt;
}

/// the format that the first words of a text, or the size of a binary file, tell
inline std::optional<File_format> format_of_content(std::string_view text)
{
  if(has_size_of_binary_stl(text))
    return File_format::STL;
  Text_scanner scanner(text, '#');
  const std::string_view word = scanner.next_word_anywhere();
  if(word == "ply")
    return File_format::PLY;
  if(parse_off_keyword(word))
    return File_format::OFF;
  if(begins_with_solid(text))
    return File_format::STL;
  if(word == "v" || word == "f" || unused_obj_lines().count(word) != 0)
    return File_format::OBJ;
  return {};
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
    throw Malformed_file(text.empty()
                             ? "it is empty"
                             : "it does not begin as an OFF, OBJ, PLY or STL file; --input-format names a format");
  }
  const std::string extension = extension_of(path);
  throw Malformed_file((extension.empty() ? "it has no extension" : "its extension '." + extension + "' is unknown") +
                       "; .off, .obj, .ply or .stl was expected, or --input-format");
}

} // namespace square_map

#endif // SQUARE_MAP_FILE_FORMAT_H
