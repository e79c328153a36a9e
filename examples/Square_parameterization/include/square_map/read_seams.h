// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_READ_SEAMS_H
#define SQUARE_MAP_READ_SEAMS_H

#include <CGAL_ext/Square_parameterization/internal/soup/condition_soup.h>

#include "Text_scanner.h"
#include "read_bytes.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace square_map {

/// the vertex of the conditioned soup that a vertex of the file has become; `DROPPED` when there is none
inline std::size_t conditioned_vertex(std::size_t v, const CGAL_ext::internal::Conditioning_report& conditioning)
{
  return v < conditioning.new_index.size() ? conditioning.new_index[v]
                                           : CGAL_ext::internal::Conditioning_report::DROPPED;
}

/// an edge to cut along
struct File_seam
{
  std::array<std::size_t, 2> ends; ///< vertices of the conditioned soup
  std::string place;               ///< the line of the file, and the vertices that it names
};

/// reads seams: two vertex numbers a line; # begins a comment
inline std::vector<File_seam> parse_seams(std::string_view text,
                                          const CGAL_ext::internal::Conditioning_report& conditioning)
{
  std::vector<File_seam> seams;
  for(Text_scanner scanner(text, '#'); scanner.find_word();) {
    File_seam& seam = seams.emplace_back();
    seam.place = scanner.line_name() + ": the seam from vertex ";
    for(std::size_t& end : seam.ends) {
      const std::string_view word = scanner.next_word();
      const auto number = parse_integer<std::int64_t>(word);
      if(!number && is_whole_number(word))
        throw Malformed_file(scanner.line_name() + " names vertex " + in_quotes(word) + ", which no mapped face has");
      if(!number)
        throw Malformed_file(scanner.line_name() + " is not two vertex numbers");
      end = conditioned_vertex(static_cast<std::size_t>(*number), conditioning); // a negative number is a large one
      if(end == CGAL_ext::internal::Conditioning_report::DROPPED)
        throw Malformed_file(scanner.line_name() + " names vertex " + std::to_string(*number) +
                             ", which no mapped face has");
      seam.place += (&end == &seam.ends[0] ? "" : " to vertex ") + std::to_string(*number);
    }
    if(!scanner.is_line_end())
      throw Malformed_file(scanner.line_name() + " is not two vertex numbers");
  }
  return seams;
}

/// reads the seams of a file, not of a pipe: nobody may write to it; nor of standard input, which may be the surface
inline std::vector<File_seam> read_seams(const std::string& path,
                                         const CGAL_ext::internal::Conditioning_report& conditioning)
{
  std::string text;
  try {
    std::error_code error;
    if(std::filesystem::is_fifo(path, error))
      throw Malformed_file("it is a pipe; a file was expected");
    text = without_byte_order_mark(read_bytes(path == "-" ? "./-" : path).bytes);
  } catch(const Malformed_file& error) {
    throw Malformed_file("cannot read '" + path + "': " + error.what());
  }
  try {
    return parse_seams(text, conditioning);
  } catch(const Malformed_file& error) {
    throw Malformed_file("'" + path + "' is malformed: " + error.what());
  }
}

} // namespace square_map

#endif // SQUARE_MAP_READ_SEAMS_H
