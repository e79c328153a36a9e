// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_READ_BINARY_OFF_H
#define SQUARE_MAP_READ_BINARY_OFF_H

#include <CGAL_ext/Square_parameterization/internal/soup/Surface_soup.h>

#include "Byte_scanner.h"
#include "Passed_over.h"
#include "Vertex_colors.h"
#include "parse_number.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <regex>
#include <string>
#include <string_view>
#include <vector>

namespace square_map {

/// what the first words of an OFF file say
struct Off_header
{
  bool has_textures, has_colors, has_normals, is_homogeneous, has_dimension;
  bool has_edges;                ///< their number follows those of vertices and faces
  bool has_colors_first = false; ///< before the normals, in text
  std::size_t vertices = 0, faces = 0;
};

/// what the keyword of an OFF file says, also with the letters in the order of MeshLab, which writes colors before normals;
/// none when it is none
inline std::optional<Off_header> parse_off_keyword(std::string_view keyword)
{
  static const std::regex geomview("(ST)?(C?)(N?)(4?)(n?)(OFF|SKEL)"), meshlab("(N?)(C?)(ST)?OFF");
  std::cmatch match;
  const auto has = [&match](std::size_t k) { return match[k].length() > 0; };
  const auto matches = [&](const std::regex& pattern) {
    return keyword.size() <= 10 && std::regex_match(keyword.data(), keyword.data() + keyword.size(), match, pattern);
  };
  if(matches(geomview))
    return Off_header{has(1), has(2), has(3), has(4), has(5), match[6] == "OFF"};
  if(matches(meshlab))
    return Off_header{has(3), has(2), has(1), false, false, true, true};
  return {};
}

/// the length of the keyword with which a word begins: some collections of meshes put the first count behind it without a
/// blank
inline std::size_t off_keyword_length(std::string_view word)
{
  const std::size_t off = word.find("OFF"), end = off == std::string_view::npos ? word.size() : off + 3;
  return is_whole_number(word.substr(end)) ? end : word.size();
}

/// what is wrong with a dimension; empty for nothing
inline std::string dimension_complaint(std::size_t dimension)
{
  return dimension == 3 ? "" : "its vertices have dimension " + std::to_string(dimension) + "; 3 was expected";
}

/// how the colors of a binary OFF file are stored, on which the programs that write it do not agree
struct Off_colors
{
  std::size_t per_vertex;    ///< numbers, where vertices have colors
  bool are_counted_on_faces; ///< each face is followed by the number of its color components, and these
  bool is_guess;             ///< taken only when no byte is left over
};

/// the counts of a header, which may not be negative; \p what names them
inline std::size_t next_off_count(Byte_scanner& scanner, const std::string& what, std::size_t index)
{
  const auto count = scanner.next<std::int32_t>(what.c_str(), index);
  if(count < 0)
    throw Malformed_file(what + ' ' + std::to_string(index) + " has a negative count, " + std::to_string(count));
  return static_cast<std::size_t>(count);
}

constexpr std::size_t OFF_WORD = 4; // bytes of a number

/// reads the points of a binary OFF file, and their colors; passes over normals and texture coordinates
inline void read_binary_off_points(Byte_scanner& scanner, const Off_header& header, const Off_colors& colors,
                                   CGAL_ext::internal::Surface_soup& soup, Vertex_colors* vertex_colors)
{
  const std::size_t w = header.is_homogeneous ? 1 : 0;
  const std::size_t normals = header.has_normals ? 3 + w : 0, textures = header.has_textures ? 2 + w : 0;
  const bool reads_colors = header.has_colors && vertex_colors != nullptr;
  const std::size_t other_colors = header.has_colors ? colors.per_vertex - (reads_colors ? 3 : 0) : 0;
  soup.points.reserve(std::min(header.vertices, scanner.bytes_left() / (3 * OFF_WORD)));
  for(std::size_t v = 0; v < header.vertices; ++v) {
    const auto next = [&scanner, v] { return static_cast<double>(scanner.next<float>("vertex", v)); };
    const double x = next(), y = next(), z = next(), divisor = header.is_homogeneous ? next() : 1;
    soup.points.emplace_back(x / divisor, y / divisor, z / divisor);
    scanner.skip(OFF_WORD * normals, "vertex", v);
    if(reads_colors) {
      const double red = next(), green = next();
      vertex_colors->emplace_back(red, green, next());
    }
    scanner.skip(OFF_WORD * (other_colors + textures), "vertex", v);
  }
}

/// reads the face of a number, and passes over its colors
inline std::vector<std::size_t> next_binary_off_face(Byte_scanner& scanner, std::size_t f, const Off_header& header,
                                                     const Off_colors& colors)
{
  constexpr std::size_t MOST_COMPONENTS = 4;
  const std::string name = "face " + std::to_string(f);
  const std::size_t size = next_off_count(scanner, "face", f);
  if(size < 3 && colors.is_guess)
    throw Malformed_file(name + " has fewer than three vertices");
  std::vector<std::size_t> face;
  face.reserve(std::min(size, scanner.bytes_left() / OFF_WORD));
  for(std::size_t k = 0; k < size; ++k) {
    const auto index = scanner.next<std::int32_t>("face", f);
    if(index < 0 || static_cast<std::size_t>(index) >= header.vertices)
      throw Malformed_file(name + " names vertex " + std::to_string(index) + "; the file has " +
                           counted(header.vertices, "vertex", "vertices") + ", counted from 0");
    face.push_back(static_cast<std::size_t>(index));
  }
  const std::size_t components = colors.are_counted_on_faces ? next_off_count(scanner, "face", f) : 0;
  if(components > MOST_COMPONENTS)
    throw Malformed_file(name + " has " + std::to_string(components) + " color components; at most 4 were expected");
  scanner.skip(OFF_WORD * components, "face", f);
  return face;
}

/// reads the vertices and faces of a binary OFF file: big-endian numbers of four bytes
inline CGAL_ext::internal::Surface_soup read_binary_off(Byte_scanner scanner, const Off_header& header,
                                                        const Off_colors& colors, Passed_over& passed_over,
                                                        Vertex_colors* vertex_colors)
{
  CGAL_ext::internal::Surface_soup soup;
  if(vertex_colors != nullptr)
    vertex_colors->clear();
  read_binary_off_points(scanner, header, colors, soup, vertex_colors);
  soup.faces.reserve(std::min(header.faces, scanner.bytes_left() / OFF_WORD));
  for(std::size_t f = 0; f < header.faces; ++f)
    soup.faces.push_back(next_binary_off_face(scanner, f, header, colors));
  if(colors.is_guess && scanner.bytes_left() > 0)
    throw Malformed_file("bytes are left over after the last face");
  if(header.faces > 0)
    pass_over_rest("bytes", scanner.bytes_left(), "face " + std::to_string(header.faces - 1), passed_over);
  return soup;
}

/// reads what follows the line with the word BINARY. Geomview's format has four color components on a vertex, and the
/// number of color components after each face; where that makes no sense, the forms that other programs write are
/// tried: three components, and no number.
inline CGAL_ext::internal::Surface_soup read_binary_off(std::string_view bytes, Off_header header,
                                                        Passed_over& passed_over,
                                                        Vertex_colors* vertex_colors = nullptr)
{
  Byte_scanner scanner(bytes, boost::endian::order::big);
  if(header.has_dimension)
    if(const std::string complaint = dimension_complaint(next_off_count(scanner, "header number", 0));
       !complaint.empty())
      throw Malformed_file(complaint);
  header.vertices = next_off_count(scanner, "header number", 1);
  header.faces = next_off_count(scanner, "header number", 2);
  if(header.has_edges)
    scanner.next<std::int32_t>("header number", 3);
  std::optional<Malformed_file> first_error;
  for(const Off_colors& colors :
      {Off_colors{4, true, false}, Off_colors{3, true, true}, Off_colors{4, false, true}, Off_colors{3, false, true}})
    try {
      return read_binary_off(scanner, header, colors, passed_over, vertex_colors);
    } catch(const Malformed_file& error) {
      if(!first_error)
        first_error = error;
    }
  throw *first_error;
}

} // namespace square_map

#endif // SQUARE_MAP_READ_BINARY_OFF_H
