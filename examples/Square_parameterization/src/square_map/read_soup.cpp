// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../../include/square_map/read_soup.h"
#include "../../include/square_map/Memory_limit.h"
#include "../../include/square_map/detect_format.h"
#include "../../include/square_map/read_bytes.h"
#include "../../include/square_map/read_ply.h"

#include <CGAL_ext/Square_parameterization/internal/common/Complaint.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace square_map {

// what a reader may allocate, in bytes; real files need a third of it
constexpr std::size_t MEMORY_TO_START_READING = 1 << 28, MEMORY_PER_BYTE = 64;

CGAL_ext::internal::Surface_soup parse_soup(std::string_view text, File_format format, Passed_over& passed_over,
                                            Vertex_colors* colors)
{
  const Memory_limit limit(MEMORY_TO_START_READING + MEMORY_PER_BYTE * text.size());
  switch(format) {
  case File_format::OFF:
    return read_off(text, passed_over, colors);
  case File_format::OBJ:
    return read_obj(text, passed_over, colors);
  case File_format::PLY:
    return read_ply(text, passed_over, colors);
  default:
    return read_stl(text, passed_over);
  }
}

void check_well_formed(const CGAL_ext::internal::Surface_soup& soup)
{
  using CGAL_ext::internal::NAMED_PLACES;
  std::size_t infinite = 0, short_faces = 0, out_of_range = 0;
  std::vector<std::string> infinite_places, short_places, out_of_range_places;
  const auto face_name = [](std::size_t f) { return "face " + std::to_string(f); };
  for(std::size_t v = 0; v < soup.points.size(); ++v)
    if(!soup.points[v].allFinite() && ++infinite <= NAMED_PLACES)
      infinite_places.push_back("vertex " + std::to_string(v));
  for(std::size_t f = 0; f < soup.faces.size(); ++f) {
    const auto& face = soup.faces[f];
    if(face.size() < 3 && ++short_faces <= NAMED_PLACES)
      short_places.push_back(face_name(f) + " has " + std::to_string(face.size()));
    const auto missing =
        std::find_if(face.begin(), face.end(), [&soup](std::size_t v) { return v >= soup.points.size(); });
    if(missing != face.end() && ++out_of_range <= NAMED_PLACES) // a negative number was read as a large one
      out_of_range_places.push_back(face_name(f) + " names vertex " +
                                    std::to_string(static_cast<std::ptrdiff_t>(*missing)) + " of " +
                                    std::to_string(soup.points.size()));
  }
  CGAL_ext::internal::Complaint complaint;
  complaint.add(infinite, "vertex has a coordinate that is not finite", "vertices have a coordinate that is not finite",
                infinite_places);
  complaint.add(short_faces, "face has fewer than three vertices", "faces have fewer than three vertices",
                short_places);
  complaint.add(out_of_range, "face names a vertex that does not exist", "faces name vertices that do not exist",
                out_of_range_places);
  if(!complaint.text().empty())
    throw Malformed_file(complaint.text());
}

CGAL_ext::internal::Surface_soup read_soup(const std::string& path, const std::string& format_name,
                                           Passed_over* passed_over, Vertex_colors* colors)
{
  Passed_over unused;
  std::string reader, hint; // in messages
  try {
    const File_bytes file = read_bytes(path);
    const std::string_view text = text_of_bytes(file.bytes);
    const File_format format =
        format_name.empty() ? format_of(path, file.is_stream, text) : file_formats().at(format_name);
    if(text.empty())
      throw Malformed_file("it is empty");
    reader = std::string(" as ") + name_of(format);
    hint = other_format(text, format);
    CGAL_ext::internal::Surface_soup soup =
        parse_soup(text, format, passed_over != nullptr ? *passed_over : unused, colors);
    if(soup.points.empty() && soup.faces.empty())
      throw Malformed_file("it has neither vertices nor faces");
    check_well_formed(soup);
    return soup;
  } catch(const Malformed_file& error) {
    throw Malformed_file("cannot read " + (path == "-" ? "standard input" : "'" + path + "'") + reader + ": " +
                         error.what() + hint);
  }
}

} // namespace square_map
