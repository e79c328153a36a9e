// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_PLY_HEADER_H
#define SQUARE_MAP_PLY_HEADER_H

#include "Text_scanner.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace square_map {

enum class Ply_type
{
  INT8,
  UINT8,
  INT16,
  UINT16,
  INT32,
  UINT32,
  FLOAT32,
  FLOAT64
};

struct Ply_property
{
  std::string name;
  Ply_type type; ///< of the value, or of the entries of a list
  bool is_list = false;
  Ply_type size_type = Ply_type::UINT8; ///< of the number of entries of a list
};

struct Ply_element
{
  std::string name;
  std::size_t count;
  std::vector<Ply_property> properties;
};

/// what the header of a PLY file says
struct Ply_header
{
  bool is_ascii = false, is_big_endian = false;
  std::vector<Ply_element> elements;
  std::size_t data = 0; ///< where the data begin
};

/// the type of a name in a header
inline Ply_type ply_type(std::string_view name, const Text_scanner& scanner, const std::string& property)
{
  static const std::map<std::string_view, Ply_type> types{
      {"char", Ply_type::INT8},      {"int8", Ply_type::INT8},       {"uchar", Ply_type::UINT8},
      {"uint8", Ply_type::UINT8},    {"short", Ply_type::INT16},     {"int16", Ply_type::INT16},
      {"ushort", Ply_type::UINT16},  {"uint16", Ply_type::UINT16},   {"int", Ply_type::INT32},
      {"int32", Ply_type::INT32},    {"uint", Ply_type::UINT32},     {"uint32", Ply_type::UINT32},
      {"float", Ply_type::FLOAT32},  {"float32", Ply_type::FLOAT32}, {"double", Ply_type::FLOAT64},
      {"float64", Ply_type::FLOAT64}};
  const auto found = types.find(name);
  if(found == types.end())
    scanner.refuse("its property " + in_quotes(property) + " is of no type that PLY has: " + in_quotes(name));
  return found->second;
}

/// reads what follows the word property
inline Ply_property read_ply_property(Text_scanner& scanner)
{
  const std::string_view first = scanner.next_word();
  const bool is_list = first == "list";
  const std::string_view size_type = is_list ? scanner.next_word() : "uchar",
                         type = is_list ? scanner.next_word() : first;
  const std::string name(scanner.next_word());
  if(name.empty())
    scanner.refuse(name, "the name of a property");
  const Ply_property property{name, ply_type(type, scanner, name), is_list, ply_type(size_type, scanner, name)};
  if(property.size_type == Ply_type::FLOAT32 || property.size_type == Ply_type::FLOAT64)
    scanner.refuse("its property " + in_quotes(name) + " is of no type that PLY has: a list counted in " +
                   in_quotes(size_type));
  return property;
}

/// reads what follows the word element
inline Ply_element read_ply_element(Text_scanner& scanner)
{
  const std::string name(scanner.next_word());
  const std::string_view word = scanner.next_word();
  const auto count = parse_integer<std::uint64_t>(word);
  if(!count)
    scanner.refuse(word, "the number of elements");
  return {name, static_cast<std::size_t>(*count), {}};
}

/// reads what follows the word format
inline void read_ply_format(Text_scanner& scanner, Ply_header& header)
{
  const std::string_view format = scanner.next_word(), version = scanner.next_word();
  header.is_ascii = format == "ascii";
  header.is_big_endian = format == "binary_big_endian";
  if(!header.is_ascii && !header.is_big_endian && format != "binary_little_endian")
    scanner.refuse(format, "ascii, binary_little_endian or binary_big_endian");
  if(version != "1.0")
    scanner.refuse(version, "version 1.0");
}

/// refuses two elements or properties of one name where it matters which is meant
inline void check_ply_header(const Ply_header& header)
{
  const auto refuse_repeated = [](const auto& all, const std::string& thing,
                                  std::initializer_list<const char*> needed) {
    for(const char* name : needed)
      if(std::count_if(all.begin(), all.end(), [name](const auto& one) { return one.name == name; }) > 1)
        throw Malformed_file("its header has two " + thing + " of the name " + in_quotes(name));
  };
  refuse_repeated(header.elements, "elements", {"vertex", "face"});
  for(const Ply_element& element : header.elements) {
    if(element.name == "vertex")
      refuse_repeated(element.properties, "properties", {"x", "y", "z", "red", "green", "blue"});
    if(element.name == "face")
      refuse_repeated(element.properties, "properties", {"vertex_indices", "vertex_index"});
  }
}

/// goes to the end of the last line of a header. Where all others end in a carriage return alone this one does, too: a
/// line feed behind it is the first byte of the data.
inline void skip_last_line(std::string_view text, Text_scanner& scanner)
{
  const bool has_line_feeds = text.substr(0, scanner.place()).find('\n') != std::string_view::npos;
  if(has_line_feeds)
    scanner.skip_line();
  else
    scanner.go_to(std::min(text.find_first_of("\r\n", scanner.place()), text.size()));
}

/// reads the header of a PLY file, line by line
inline Ply_header read_ply_header(std::string_view text)
{
  Text_scanner scanner(text);
  Ply_header header;
  bool has_format = false;
  if(const std::string_view word = scanner.next_word(); word != "ply")
    scanner.refuse(word, "ply");
  for(scanner.skip_line(); scanner.find_word(); scanner.skip_line()) {
    const std::string_view keyword = scanner.next_word();
    if(keyword == "end_header") {
      skip_last_line(text, scanner);
      header.data = std::min(scanner.place() + 1, text.size());
      if(!has_format)
        throw Malformed_file("its header does not name a format");
      check_ply_header(header);
      return header;
    }
    if(keyword == "format") {
      read_ply_format(scanner, header);
      has_format = true;
    } else if(keyword == "element")
      header.elements.push_back(read_ply_element(scanner));
    else if(keyword == "property") {
      if(header.elements.empty())
        scanner.refuse("a property belongs to no element");
      header.elements.back().properties.push_back(read_ply_property(scanner));
    } else if(keyword != "comment" && keyword != "obj_info")
      scanner.refuse(keyword, "a word of a PLY header");
  }
  throw Malformed_file("its header has no end");
}

} // namespace square_map

#endif // SQUARE_MAP_PLY_HEADER_H
