// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_READ_OFF_H
#define SQUARE_MAP_READ_OFF_H

#include <CGAL_ext/Square_parameterization/internal/soup/Surface_soup.h>

#include "Passed_over.h"
#include "Text_scanner.h"
#include "read_binary_off.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace square_map {

// CGAL's reader takes 3.7 and numbers that overflow as some index, and binary files without colors alone.

/// reads the keyword, which may be missing
inline Off_header read_off_keyword(Text_scanner& scanner)
{
  const std::string_view word = scanner.next_word_anywhere();
  const std::size_t begin = scanner.place() - word.size();
  if(is_whole_number(word)) {
    scanner.go_back(begin);
    return *parse_off_keyword("OFF");
  }
  const std::size_t length = off_keyword_length(word);
  const std::optional<Off_header> header = parse_off_keyword(word.substr(0, length));
  if(!header)
    scanner.refuse(word, "OFF");
  scanner.go_back(begin + length);
  return *header;
}

/// reads the numbers of vertices and faces that follow the keyword. The number of edges is passed over; it may be
/// missing where the vertices begin on a line of their own.
inline void read_off_counts(Text_scanner& scanner, Off_header& header)
{
  const auto next_count = [&scanner](const char* what) {
    const std::string_view word = scanner.next_word_anywhere();
    const auto count = parse_integer<std::uint64_t>(word);
    if(!count)
      scanner.refuse(word, what);
    return static_cast<std::size_t>(*count);
  };
  if(header.has_dimension)
    if(const std::string complaint = dimension_complaint(next_count("the dimension")); !complaint.empty())
      scanner.refuse(complaint);
  header.vertices = next_count("the number of vertices");
  header.faces = next_count("the number of faces");
  if(!header.has_edges || (scanner.is_line_end() && !scanner.find_word()))
    return;
  const std::size_t place = scanner.place();
  const std::string_view edges = scanner.next_word();
  const bool is_alone = scanner.is_line_end();
  if(!is_alone && header.vertices > 0 && scanner.is_first_of_line(place)) // the first vertex
    scanner.go_back(place);
  else if(!parse_integer<std::int64_t>(edges))
    scanner.refuse(edges, "the number of edges");
}

/// goes to the row of a vertex or a face; refuses a file that ends before it
inline void find_off_row(Text_scanner& scanner, std::size_t row, std::size_t count, const char* thing,
                         const char* things)
{
  if(!scanner.find_word())
    throw Malformed_file("it is incomplete: it ends after " + std::to_string(row) + " of " +
                         counted(count, thing, things));
}

/// a component of a color: a number from 0 to 255 without a decimal point, or one from 0 to 1
inline double next_color_component(Text_scanner& scanner)
{
  const std::size_t place = scanner.place();
  const bool is_real = scanner.next_word().find_first_of(".e") != std::string_view::npos;
  scanner.go_back(place);
  return scanner.next_real("a component of a color") / (is_real ? 1 : 255);
}

/// the color of a vertex, after its coordinates and, unless colors come first, its normal
inline Eigen::Vector3d next_color(Text_scanner& scanner, const Off_header& header)
{
  const bool is_after_normal = header.has_normals && !header.has_colors_first;
  for(int k = 0; is_after_normal && k < (header.is_homogeneous ? 4 : 3); ++k)
    scanner.next_real("a coordinate of a normal");
  const double red = next_color_component(scanner), green = next_color_component(scanner);
  return {red, green, next_color_component(scanner)};
}

/// reads points, one a line; what follows the coordinates is passed over, but for colors that are asked for
inline void read_off_points(Text_scanner& scanner, const Off_header& header, CGAL_ext::internal::Surface_soup& soup,
                            Vertex_colors* colors)
{
  soup.points.reserve(std::min(header.vertices, scanner.bytes_left() / 6));
  for(std::size_t v = 0; v < header.vertices; ++v) {
    find_off_row(scanner, v, header.vertices, "vertex", "vertices");
    const double x = scanner.next_real("a coordinate"), y = scanner.next_real("a coordinate"),
                 z = scanner.next_real("a coordinate");
    const double w = header.is_homogeneous ? scanner.next_real("a homogeneous coordinate") : 1;
    soup.points.emplace_back(x / w, y / w, z / w);
    if(header.has_colors && colors != nullptr)
      colors->push_back(next_color(scanner, header));
    scanner.skip_line();
  }
}

/// reads polygons, one a line: the number of vertices, and their indices; colors behind them are passed over
inline void read_off_faces(Text_scanner& scanner, const Off_header& header, CGAL_ext::internal::Surface_soup& soup)
{
  soup.faces.reserve(std::min(header.faces, scanner.bytes_left() / 2));
  for(std::size_t f = 0; f < header.faces; ++f) {
    find_off_row(scanner, f, header.faces, "face", "faces");
    const std::string_view first = scanner.next_word();
    const auto size = parse_integer<std::uint32_t>(first);
    if(!size)
      scanner.refuse(first, "the number of vertices of face " + std::to_string(f));
    std::vector<std::size_t>& face = soup.faces.emplace_back();
    face.reserve(std::min<std::size_t>(*size, scanner.bytes_left() / 2));
    for(std::uint32_t k = 0; k < *size; ++k) {
      const std::string_view word = scanner.next_word();
      const auto index = parse_integer<std::uint64_t>(word);
      if(!index || *index >= header.vertices)
        scanner.refuse(word, "in face " + std::to_string(f) + " an index from 0 to " +
                                 std::to_string(static_cast<std::ptrdiff_t>(header.vertices) - 1));
      face.push_back(*index);
    }
    scanner.skip_line();
  }
}

/// indicates whether what follows the counts is hardly meant to be one point or face a line: the number of lines differs
/// by a tenth at least. Where a row is missing, or comes twice, numbers on any lines may make faces, too, but others.
inline bool has_numbers_on_any_lines(Text_scanner scanner, const Off_header& header)
{
  const double rows = double(header.vertices) + double(header.faces), lines = double(scanner.skip_lines());
  return std::abs(lines - rows) >= std::max(2., 0.1 * rows);
}

/// points and faces whose numbers follow each other on any lines; none when there are others, or too few
inline std::optional<CGAL_ext::internal::Surface_soup> read_off_numbers(Text_scanner scanner, const Off_header& header)
{
  CGAL_ext::internal::Surface_soup soup;
  for(std::size_t v = 0; v < header.vertices; ++v) {
    Eigen::Vector4d p(0, 0, 0, 1);
    for(int k = 0; k < (header.is_homogeneous ? 4 : 3); ++k) {
      const auto number = parse_real(scanner.next_word_anywhere());
      if(!number)
        return {};
      p[k] = *number;
    }
    soup.points.emplace_back(p.head<3>() / p[3]);
  }
  for(std::size_t f = 0; f < header.faces; ++f) {
    const auto size = parse_integer<std::uint32_t>(scanner.next_word_anywhere());
    if(!size || *size < 3)
      return {};
    std::vector<std::size_t>& face = soup.faces.emplace_back();
    for(std::uint32_t k = 0; k < *size; ++k) {
      const auto index = parse_integer<std::uint64_t>(scanner.next_word_anywhere());
      if(!index || *index >= header.vertices)
        return {};
      face.push_back(*index);
    }
  }
  return scanner.find_word() ? std::nullopt : std::make_optional(std::move(soup));
}

/// reads points and faces, one a line, or else on any lines
inline CGAL_ext::internal::Surface_soup read_off_rows(Text_scanner scanner, const Off_header& header,
                                                      Passed_over& passed_over, Vertex_colors* colors)
{
  const Text_scanner begin = scanner;
  try {
    CGAL_ext::internal::Surface_soup soup;
    read_off_points(scanner, header, soup, colors);
    read_off_faces(scanner, header, soup);
    if(header.faces > 0)
      pass_over_rest("lines", scanner.skip_lines(), "face " + std::to_string(header.faces - 1), passed_over);
    return soup;
  } catch(const Malformed_file&) {
    const bool has_more = header.has_textures || header.has_colors || header.has_normals;
    auto soup = has_more || !has_numbers_on_any_lines(begin, header) ? std::nullopt : read_off_numbers(begin, header);
    if(!soup)
      throw;
    return std::move(*soup);
  }
}

/// reads an OFF file: text or binary, with any of the letters for texture coordinates, colors, normals, homogeneous
/// coordinates and a dimension before its keyword. What follows the last face is added to
/// \p passed_over.
/// \param colors receives the colors of the vertices, unless it is null
inline CGAL_ext::internal::Surface_soup read_off(std::string_view text, Passed_over& passed_over,
                                                 Vertex_colors* colors = nullptr)
{
  Text_scanner scanner(text, '#');
  Off_header header = read_off_keyword(scanner);
  if(scanner.find_word()) {
    const std::size_t place = scanner.place();
    if(scanner.next_word() == "BINARY" && !header.has_colors_first)
      return read_binary_off(text.substr(std::min(text.find('\n', place), text.size() - 1) + 1), header, passed_over,
                             colors);
    scanner.go_back(place);
  }
  read_off_counts(scanner, header);
  return read_off_rows(scanner, header, passed_over, colors);
}

} // namespace square_map

#endif // SQUARE_MAP_READ_OFF_H
