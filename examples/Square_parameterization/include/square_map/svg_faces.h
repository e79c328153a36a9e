// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_SVG_FACES_H
#define SQUARE_MAP_SVG_FACES_H

#include "Flat_map.h"
#include "Geometry_image.h"
#include "Stretch_colors.h"
#include "base64.h"

#include <algorithm>
#include <cmath>
#include <ostream>
#include <string>
#include <vector>

namespace square_map {

constexpr std::size_t MOST_FACES_AS_PATHS = 20000;

/// where the unit square, as the rectangle that it stands for, lies in a picture
struct Svg_rectangle
{
  double left, top, width, height;

  double x(double u) const { return left + u * width; }
  double y(double v) const { return top + (1 - v) * height; }
};

/// the largest rectangle in the middle of another
/// \param aspect its width over its height
inline Svg_rectangle rectangle_in(const Svg_rectangle& frame, double aspect)
{
  const double width = (std::min)(frame.width, frame.height * aspect), height = width / aspect;
  return {frame.left + (frame.width - width) / 2, frame.top + (frame.height - height) / 2, width, height};
}

/// a number with few significant digits
inline std::string rounded(double x, int digits = 3)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.*g", digits, x);
  return text;
}

inline void write_text(std::ostream& stream, double x, double y, const char* anchor, const std::string& words)
{
  stream << "<text x='" << x << "' y='" << y << "' text-anchor='" << anchor << "'>" << words << "</text>\n";
}

/// the faces as paths, one for each color; in whole units of a fiftieth
inline void write_faces_as_paths(std::ostream& stream, const Flat_map& map, const std::vector<int>& levels,
                                 const Svg_rectangle& domain)
{
  constexpr double UNITS = 50;
  const auto unit = [&](int v, int axis) {
    return std::lround(map.uv(v, axis) * (axis == 0 ? domain.width : domain.height) * UNITS);
  };
  std::vector<std::string> paths(Stretch_colors::LEVELS);
  for(std::size_t f = 0; f < map.triangles.size(); ++f) {
    const auto& [a, b, c] = map.triangles[f];
    const auto step = [&](int from, int to) {
      const long du = unit(to, 0) - unit(from, 0), dv = unit(to, 1) - unit(from, 1);
      return std::to_string(du) + (dv < 0 ? "" : " ") + std::to_string(dv);
    };
    paths[levels[f]] +=
        'M' + std::to_string(unit(a, 0)) + ' ' + std::to_string(unit(a, 1)) + 'l' + step(a, b) + ' ' + step(b, c) + 'z';
  }
  // a thin stroke closes the gaps that programs leave between neighbors
  stream << "<g transform='translate(" << domain.left << ' ' << domain.y(0) << ") scale(" << 1 / UNITS << ' '
         << -1 / UNITS << ")' stroke-width='25' stroke-linejoin='round'>\n";
  for(int level = 0; level < Stretch_colors::LEVELS; ++level)
    if(!paths[level].empty()) {
      const std::string color = hexadecimal(Stretch_colors::color(level));
      stream << "<path fill='" << color << "' stroke='" << color << "' d='" << paths[level] << "'/>\n";
    }
  stream << "</g>\n";
}

/// the faces as a picture, two pixels for each unit
inline void write_faces_as_picture(std::ostream& stream, const Flat_map& map, const std::vector<int>& levels,
                                   const Svg_rectangle& domain)
{
  const auto pixels = [](double units) { return (std::max)(2, static_cast<int>(2 * units)); };
  const CGAL_ext::Grid_size size{pixels(domain.width), pixels(domain.height)};
  const auto locations = CGAL_ext::internal::locate_samples(map.triangles, map.uv, size);
  const std::string png = png_file(picture_of_samples<std::uint8_t>(
      size, [&](std::size_t s) { return Stretch_colors::color(levels[locations[s].face]); }));
  stream << "<image x='" << domain.left << "' y='" << domain.top << "' width='" << domain.width << "' height='"
         << domain.height << "' preserveAspectRatio='none' xlink:href='data:image/png;base64," << base64(png)
         << "'/>\n";
}

inline void write_faces(std::ostream& stream, const Flat_map& map, const std::vector<double>& face_stretch,
                        const Stretch_colors& colors, const Svg_rectangle& domain)
{
  std::vector<int> levels;
  for(double stretch : face_stretch)
    levels.push_back(colors.level(stretch));
  if(map.triangles.size() <= MOST_FACES_AS_PATHS)
    write_faces_as_paths(stream, map, levels, domain);
  else
    write_faces_as_picture(stream, map, levels, domain);
}

} // namespace square_map

#endif // SQUARE_MAP_SVG_FACES_H
