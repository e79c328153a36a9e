// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_READ_PLY_H
#define SQUARE_MAP_READ_PLY_H

#include <CGAL_ext/Square_parameterization/internal/soup/Surface_soup.h>

#include "Passed_over.h"
#include "Ply_values.h"
#include "Vertex_colors.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <iomanip>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace square_map {

// CGAL's reader takes half of the types of indices alone, and zero for a coordinate that is missing.

/// the place of a property of an element; as many as there are properties when it has none of that name
inline std::size_t ply_property_of(const Ply_element& element, const std::string& name)
{
  std::size_t k = 0;
  while(k < element.properties.size() && element.properties[k].name != name)
    ++k;
  return k;
}

/// the place of a list of one of these names, the first if there are several; as many as there are properties for none
inline std::size_t ply_list_of(const Ply_element& element, std::initializer_list<const char*> names)
{
  for(const char* name : names)
    if(const std::size_t k = ply_property_of(element, name);
       k < element.properties.size() && element.properties[k].is_list)
      return k;
  return element.properties.size();
}

/// the number of entries of a list
template <class Values>
std::size_t next_ply_size(Values& values, const Ply_property& property, const std::string& element, std::size_t index)
{
  const double size = values.next(property.size_type, element, index);
  if(!(size >= 0) || size > 4294967295. || size != std::floor(size))
    values.refuse(element + ' ' + std::to_string(index) + " has a list " + in_quotes(property.name) +
                  " whose number of entries is not a number from 0");
  return static_cast<std::size_t>(size);
}

/// passes over a property
template <class Values>
void skip_ply_property(Values& values, const Ply_property& property, const std::string& element, std::size_t index)
{
  const std::size_t count = property.is_list ? next_ply_size(values, property, element, index) : 1;
  values.skip(property.type, count, element, index);
}

/// per property of a vertex, which component of its color it is: 0, 1 or 2; -1 for none
inline std::vector<int> ply_color_components(const Ply_element& element)
{
  static const char* const names[] = {"red", "green", "blue"};
  std::vector<int> components(element.properties.size(), -1);
  for(int c = 0; c < 3; ++c)
    if(const std::size_t k = ply_property_of(element, names[c]);
       k < element.properties.size() && !element.properties[k].is_list)
      components[k] = c;
  return components;
}

/// the number that stands for a full color
inline double full_ply_color(Ply_type type)
{
  return type == Ply_type::FLOAT32 || type == Ply_type::FLOAT64 ? 1 : type == Ply_type::UINT16 ? 65535 : 255;
}

/// reads the points: the scalars x, y and z of each vertex, of any type
template <class Values>
void read_ply_points(Values& values, const Ply_element& element, CGAL_ext::internal::Surface_soup& soup,
                     Vertex_colors* colors)
{
  static const char* const names[] = {"x", "y", "z"};
  std::vector<int> axes(element.properties.size(), -1); // per property
  for(int axis = 0; axis < 3; ++axis) {
    const std::size_t k = ply_property_of(element, names[axis]);
    if(k == element.properties.size())
      throw Malformed_file(std::string("it has no coordinate ") + names[axis] + "; x, y and z were expected");
    if(element.properties[k].is_list)
      throw Malformed_file(std::string("its coordinate ") + names[axis] + " is a list; a number was expected");
    axes[k] = axis;
  }
  const std::vector<int> components =
      colors != nullptr ? ply_color_components(element) : std::vector<int>(element.properties.size(), -1);
  const bool has_colors = std::count_if(components.begin(), components.end(), [](int c) { return c >= 0; }) == 3;
  soup.points.reserve(std::min(element.count, values.bytes_left() / 3));
  for(std::size_t v = 0; v < element.count; ++v) {
    Eigen::Vector3d& p = soup.points.emplace_back();
    Eigen::Vector3d color(0, 0, 0);
    for(std::size_t k = 0; k < axes.size(); ++k)
      if(axes[k] >= 0)
        p[axes[k]] = values.next(element.properties[k].type, element.name, v);
      else if(components[k] >= 0)
        color[components[k]] =
            values.next(element.properties[k].type, element.name, v) / full_ply_color(element.properties[k].type);
      else
        skip_ply_property(values, element.properties[k], element.name, v);
    values.end_element(element.name, v);
    if(has_colors)
      colors->push_back(color);
  }
}

/// the index of a vertex in a face
template <class Values>
std::size_t next_ply_index(Values& values, Ply_type type, const std::string& element, std::size_t f,
                           std::size_t vertices)
{
  const double index = values.next(type, element, f);
  const std::string face = "face " + std::to_string(f);
  if(!std::isfinite(index) || index != std::floor(index))
    values.refuse(face + " has an index that is not a whole number");
  if(index < 0 || index >= static_cast<double>(vertices)) {
    std::ostringstream number;
    number << std::setprecision(17) << index;
    values.refuse(face + " names vertex " + number.str() + "; the file has " + counted(vertices, "vertex", "vertices") +
                  ", counted from 0");
  }
  return static_cast<std::size_t>(index);
}

/// reads the polygons: the list vertex_indices, or vertex_index, of each face
/// \param vertices how many there are, before or after the faces
template <class Values>
void read_ply_faces(Values& values, const Ply_element& element, std::size_t vertices,
                    CGAL_ext::internal::Surface_soup& soup)
{
  const std::size_t indices = ply_list_of(element, {"vertex_indices", "vertex_index"});
  if(indices == element.properties.size())
    throw Malformed_file("its faces have no list vertex_indices or vertex_index");
  soup.faces.reserve(std::min(element.count, values.bytes_left()));
  for(std::size_t f = 0; f < element.count; ++f) {
    std::vector<std::size_t>& face = soup.faces.emplace_back();
    for(std::size_t k = 0; k < element.properties.size(); ++k) {
      const Ply_property& property = element.properties[k];
      if(k != indices) {
        skip_ply_property(values, property, element.name, f);
        continue;
      }
      const std::size_t size = next_ply_size(values, property, element.name, f);
      face.reserve(std::min(size, values.bytes_left()));
      for(std::size_t i = 0; i < size; ++i)
        face.push_back(next_ply_index(values, property.type, element.name, f, vertices));
    }
    values.end_element(element.name, f);
  }
}

/// reads the data of a PLY file up to the last element that is needed. What follows the last one of the header is added to
/// \p passed_over.
template <class Values>
CGAL_ext::internal::Surface_soup read_ply_data(Values values, const Ply_header& header, Passed_over& passed_over,
                                               Vertex_colors* colors)
{
  CGAL_ext::internal::Surface_soup soup;
  const std::size_t vertices = std::find_if(header.elements.begin(), header.elements.end(), [](const auto& element) {
                                 return element.name == "vertex";
                               })->count; // it is there
  bool has_vertices = false, has_faces = false;
  for(const Ply_element& element : header.elements) {
    if(has_vertices && has_faces)
      return soup;
    if(element.name == "vertex") {
      read_ply_points(values, element, soup, colors);
      has_vertices = true;
    } else if(element.name == "face") {
      read_ply_faces(values, element, vertices, soup);
      has_faces = true;
    } else if(!element.properties.empty()) // else there is nothing of it
      for(std::size_t i = 0; i < element.count; ++i) {
        for(const Ply_property& property : element.properties)
          skip_ply_property(values, property, element.name, i);
        values.end_element(element.name, i);
      }
  }
  if(const Ply_element& last = header.elements.back(); last.count > 0)
    values.skip_rest(last.name + ' ' + std::to_string(last.count - 1), passed_over);
  return soup;
}

/// reads a PLY file: text or binary, with numbers of any type
/// \param colors receives the colors of the vertices, unless it is null
inline CGAL_ext::internal::Surface_soup read_ply(std::string_view text, Passed_over& passed_over,
                                                 Vertex_colors* colors = nullptr)
{
  const Ply_header header = read_ply_header(text);
  const auto has = [&header](const char* name, std::size_t least) {
    return std::any_of(header.elements.begin(), header.elements.end(), [name, least](const Ply_element& element) {
      return element.name == name && element.count >= least;
    });
  };
  if(!has("vertex", 0))
    throw Malformed_file("it has no element vertex");
  if(!has("face", 0) && !has("tristrips", 1))
    throw Malformed_file("it has no element face");
  if(has("tristrips", 1))
    throw Malformed_file("it has triangle strips, which are not read; an element face was expected");
  return header.is_ascii ? read_ply_data(Ply_text(text, header.data), header, passed_over, colors)
                         : read_ply_data(Ply_bytes(text, header), header, passed_over, colors);
}

} // namespace square_map

#endif // SQUARE_MAP_READ_PLY_H
