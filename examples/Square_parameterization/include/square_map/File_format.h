// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_FILE_FORMAT_H
#define SQUARE_MAP_FILE_FORMAT_H

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>
#include <optional>
#include <string>

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

} // namespace square_map

#endif // SQUARE_MAP_FILE_FORMAT_H
