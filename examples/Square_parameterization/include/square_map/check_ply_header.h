// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_CHECK_PLY_HEADER_H
#define SQUARE_MAP_CHECK_PLY_HEADER_H

#include <fstream>
#include <set>
#include <sstream>
#include <string>

namespace square_map {

/// says what in the header of a file CGAL's PLY reader would crash or hang on; empty when there is nothing, or no PLY.
/// The reader ignores properties of types it does not know, and counts through elements without properties.
inline std::string ply_header_fault(const std::string& path)
{
  static const std::set<std::string> coordinates{"x", "y", "z"};
  static const std::set<std::string> floating_types{"float", "double", "float32", "float64"};
  static const std::set<std::string> integral_types{"char", "uchar", "short", "ushort", "int",   "uint",
                                                    "int8", "uint8", "int16", "uint16", "int32", "uint32"};
  std::ifstream file(path, std::ios::binary);
  std::string signature, element;
  if(!(file >> signature) || signature != "ply")
    return "";
  bool has_properties = true; // the element
  for(std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string keyword, type, name;
    words >> keyword >> type >> name;
    if((keyword == "element" || keyword == "end_header") && !has_properties)
      return "its element '" + element + "' has no properties";
    if(keyword == "end_header")
      return "";
    if(keyword == "element") {
      element = type;
      has_properties = false;
    }
    if(keyword == "property") {
      if(element.empty())
        return "a property belongs to no element";
      has_properties = true;
      const bool is_list = type == "list";
      const std::string size_type = is_list ? name : "int";
      if(is_list) // the type of its entries comes before the name
        words >> type >> name;
      if(coordinates.count(name) != 0 && (is_list || floating_types.count(type) == 0))
        return "its coordinate " + name + " is not of type float or double";
      if(integral_types.count(size_type) == 0 || integral_types.count(type) + floating_types.count(type) == 0)
        return "its property '" + name + "' is of no type that PLY has";
    }
  }
  return "its header has no end";
}

} // namespace square_map

#endif // SQUARE_MAP_CHECK_PLY_HEADER_H
