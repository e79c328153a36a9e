// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_CHECK_PLY_HEADER_H
#define SQUARE_MAP_CHECK_PLY_HEADER_H

#include <fstream>
#include <set>
#include <sstream>
#include <string>

namespace square_map {

/// says what in the header of a file CGAL's PLY reader would crash or hang on; empty when there is nothing, or no PLY
inline std::string ply_header_fault(const std::string& path)
{
  static const std::set<std::string> coordinates{"x", "y", "z"};
  static const std::set<std::string> floating_types{"float", "double", "float32", "float64"};
  std::ifstream file(path, std::ios::binary);
  std::string signature, element;
  if(!(file >> signature) || signature != "ply")
    return "";
  bool has_properties = true; // the element
  for(std::string line, keyword; keyword != "end_header" && std::getline(file, line);) {
    std::istringstream words(line);
    std::string type, name;
    words >> keyword >> type >> name;
    if((keyword == "element" || keyword == "end_header") && !has_properties)
      return "its element '" + element + "' has no properties";
    if(keyword == "element") {
      element = type;
      has_properties = false;
    }
    if(keyword == "property") {
      if(element.empty())
        return "a property belongs to no element";
      has_properties = true;
      if(type == "list") // the name comes after the types of the list
        words >> name >> name;
      if(coordinates.count(name) != 0 && floating_types.count(type) == 0)
        return "its coordinate " + name + " is not of type float or double";
    }
  }
  return "";
}

} // namespace square_map

#endif // SQUARE_MAP_CHECK_PLY_HEADER_H
