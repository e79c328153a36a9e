// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_READ_OBJ_H
#define SQUARE_MAP_READ_OBJ_H

#include <CGAL_ext/Square_parameterization/internal/soup/Surface_soup.h>

#include "Passed_over.h"
#include "Text_scanner.h"
#include "Vertex_colors.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace square_map {

/// what lines of a Wavefront OBJ file are that do not make the surface, by their keywords. The rest of such a line is
/// not looked at.
inline const std::map<std::string_view, const char*>& unused_obj_lines()
{
  static const std::map<std::string_view, const char*> lines = [] {
    std::map<std::string_view, const char*> result{
        {"vt", "texture coordinates"}, {"vn", "normals"}, {"p", "points"}, {"l", "polylines"}, {"o", "objects"}};
    for(const char* keyword : {"g", "s", "mg"})
      result.emplace(keyword, "groups");
    for(const char* keyword : {"mtllib", "usemtl", "maplib", "usemap"})
      result.emplace(keyword, "materials");
    for(const char* keyword :
        {"vp",   "cstype", "deg", "bmat", "step", "curv", "curv2", "surf", "parm", "trim",  "hole",
         "scrv", "sp",     "end", "con",  "bzp",  "bsp",  "cdc",   "cdp",  "res",  "ctech", "stech"})
      result.emplace(keyword, "free-form lines");
    for(const char* keyword :
        {"bevel", "c_interp", "d_interp", "lod", "shadow_obj", "trace_obj", "call", "csh", "unset"})
      result.emplace(keyword, "display and command lines");
    return result;
  }();
  return lines;
}

/// The faces and points of a Wavefront OBJ file. tinyobjloader takes `f 1 3 4x`, and all other words that begin with a
/// number, as CGAL's reader does, which moreover does not know all kinds of lines.
class Obj_reader
{
public:
  /// \param text must live as long as the reader
  /// \param colors receives the colors of the vertices, unless it is null or a vertex has none
  explicit Obj_reader(std::string_view text, Vertex_colors* colors = nullptr)
    : m_scanner(text, '#', true), m_colors(colors)
  {}

  /// reads all lines; what is not used is counted in \p passed_over. An object without faces is refused, for a file that is
  /// cut off looks like it.
  CGAL_ext::internal::Surface_soup read(Passed_over& passed_over)
  {
    while(m_scanner.find_word()) {
      const std::string_view keyword = m_scanner.next_word();
      if(keyword == "v")
        read_point(passed_over);
      else if(keyword == "f" || keyword == "fo")
        read_face();
      else {
        ++passed_over[kind_of_unused_line(keyword)];
        m_scanner.skip_line();
      }
    }
    if(m_highest > m_soup.points.size())
      throw Malformed_file(m_line_of_highest + ": a face names vertex " + std::to_string(m_highest) +
                           "; the file has " + counted(m_soup.points.size(), "vertex", "vertices") +
                           ", counted from 1");
    if(m_first_not_finite)
      throw Malformed_file(*m_first_not_finite);
    if(m_soup.faces.empty())
      throw Malformed_file("it has " + counted(m_soup.points.size(), "vertex", "vertices") + " and no faces" +
                           (m_unknown_kind.empty() ? "" : ", but " + m_unknown_kind));
    if(m_colors != nullptr && m_colors->size() != m_soup.points.size())
      m_colors->clear();
    return std::move(m_soup);
  }

private:
  std::string kind_of_unused_line(std::string_view keyword)
  {
    const auto found = unused_obj_lines().find(keyword);
    if(found != unused_obj_lines().end())
      return found->second;
    if(keyword.size() > 1 && (keyword[0] == 'v' || keyword[0] == 'f') &&
       keyword.find_first_not_of("0123456789+-./", 1) == std::string_view::npos)
      m_scanner.refuse(keyword, "a blank after v or f");
    if(m_unknown_kind.empty())
      m_unknown_kind = "lines of unknown kinds, the first of them " + m_scanner.line_name();
    return m_unknown_kind;
  }

  /// coordinates, and what may follow them: a weight, a color, or both
  void read_point(Passed_over& passed_over)
  {
    constexpr std::size_t MOST_NUMBERS = 7;
    const double x = m_scanner.next_real("a coordinate"), y = m_scanner.next_real("a coordinate"),
                 z = m_scanner.next_real("a coordinate");
    m_soup.points.emplace_back(x, y, z);
    if(!m_first_not_finite && !m_soup.points.back().allFinite())
      m_first_not_finite = m_scanner.line_name() + ": vertex " + std::to_string(m_soup.points.size()) +
                           ", counted from 1, has a coordinate that is not finite";
    std::size_t numbers = 3;
    Eigen::Vector3d last(0, 0, 0); // numbers of the line: those of the color
    for(; !m_scanner.is_line_end(); ++numbers)
      last = {last[1], last[2], m_scanner.next_real("a weight or a color")};
    if(numbers > MOST_NUMBERS)
      m_scanner.refuse("a vertex has " + std::to_string(numbers) + " numbers; at most 7 were expected");
    if(numbers >= 6 && m_colors != nullptr)
      m_colors->push_back(last);
    else if(numbers > 3)
      ++passed_over[numbers == 4 ? "weights" : "colors"];
  }

  void read_face()
  {
    std::vector<std::size_t>& face = m_soup.faces.emplace_back();
    while(!m_scanner.is_line_end())
      face.push_back(point_of_corner(m_scanner.next_word()));
    if(face.size() < 3)
      m_scanner.refuse("a face has " + counted(face.size(), "corner", "corners") + "; at least three were expected");
  }

  /// the point that a corner names: `v`, `v/vt`, `v//vn` or `v/vt/vn`
  std::size_t point_of_corner(std::string_view word)
  {
    const auto refuse = [this, word] { m_scanner.refuse(word, "a corner of a face, such as 1, 1/2, 1//3 or 1/2/3,"); };
    const std::size_t slash = word.find('/');
    const std::string_view number = word.substr(0, slash);
    const auto index = parse_integer<std::int64_t>(number);
    if(!index && is_whole_number(number))
      m_scanner.refuse("a face names vertex " + in_quotes(number) + ", which no file has");
    if(!index)
      refuse();
    for(std::size_t place = slash, slashes = 0; place != std::string_view::npos;) {
      const std::size_t next = word.find('/', place + 1);
      const std::string_view attribute =
          word.substr(place + 1, next == std::string_view::npos ? next : next - place - 1);
      if(++slashes > 2 || (!attribute.empty() && parse_integer<std::int64_t>(attribute).value_or(0) == 0))
        refuse();
      place = next;
    }
    return point_of_index(*index);
  }

  /// the point of an index, which counts from 1 at the first vertex, or back from -1 at the last one so far
  std::size_t point_of_index(std::int64_t index)
  {
    const std::size_t count = m_soup.points.size();
    if(index == 0 || index < -static_cast<std::int64_t>(count))
      m_scanner.refuse("a face names vertex " + std::to_string(index) + "; " +
                       (index == 0 ? "vertices are counted from 1"
                                   : "there are " + counted(count, "vertex", "vertices") + " before it"));
    if(index < 0)
      return count - static_cast<std::size_t>(-index);
    const auto number = static_cast<std::size_t>(index);
    if(number > count && number > m_highest) { // it may still follow
      m_highest = number;
      m_line_of_highest = m_scanner.line_name();
    }
    return number - 1;
  }

  Text_scanner m_scanner;
  Vertex_colors* m_colors;
  CGAL_ext::internal::Surface_soup m_soup;
  std::size_t m_highest = 0; ///< of the vertices that were named before they came, counted from 1
  std::string m_line_of_highest, m_unknown_kind;
  std::optional<std::string> m_first_not_finite; ///< the complaint about the first vertex that is not
};

/// reads an OBJ file
/// \param colors receives the colors of the vertices, unless it is null
inline CGAL_ext::internal::Surface_soup read_obj(std::string_view text, Passed_over& passed_over,
                                                 Vertex_colors* colors = nullptr)
{
  return Obj_reader(text, colors).read(passed_over);
}

} // namespace square_map

#endif // SQUARE_MAP_READ_OBJ_H
