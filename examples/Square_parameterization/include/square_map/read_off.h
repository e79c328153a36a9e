// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_READ_OFF_H
#define SQUARE_MAP_READ_OFF_H

#include <CGAL/IO/OFF.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace square_map {

/// the text of an OFF file, its header without the letters for texture coordinates, colors and normals: CGAL's reader
/// then takes three coordinates of a line and ignores what follows. With these letters it reads beyond a line that is
/// too short, and takes texture coordinates from anywhere. Binary files stay as they are: there the letters tell the
/// layout.
inline std::string without_attribute_letters(std::string text)
{
  static const char* const WHITE_SPACE = " \t\n\v\f\r";
  static const std::regex with_letters("(ST)?C?N?(4?n?(OFF|SKEL))");
  const auto next_word = [&text](std::size_t place) {
    place = text.find_first_not_of(WHITE_SPACE, place);
    while(place < text.size() && text[place] == '#')
      place = text.find_first_not_of(WHITE_SPACE, text.find('\n', place));
    return (std::min)(place, text.size());
  };
  const std::size_t begin = next_word(0);
  const auto end = std::find_if_not(text.begin() + begin, text.end(), [](unsigned char c) { return std::isalnum(c); });
  const std::string keyword(text.begin() + begin, end);
  std::smatch match;
  if(std::regex_match(keyword, match, with_letters) &&
     text.compare(next_word(begin + keyword.size()), 6, "BINARY") != 0)
    text.replace(begin, keyword.size(), match[2].str());
  return text;
}

/// reads points and polygons of an OFF file; false when it is malformed
template <class Points, class Polygons>
bool read_off(const std::string& path, Points& points, Polygons& polygons)
{
  std::ifstream file(path, std::ios::binary);
  std::istringstream text(
      without_attribute_letters({std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()}));
  return file && CGAL::IO::read_OFF(text, points, polygons, CGAL::parameters::verbose(false));
}

} // namespace square_map

#endif // SQUARE_MAP_READ_OFF_H
