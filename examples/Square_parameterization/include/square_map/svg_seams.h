// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_SVG_SEAMS_H
#define SQUARE_MAP_SVG_SEAMS_H

#include "Map_border.h"
#include "report.h"
#include "svg_faces.h"

#include <array>
#include <ostream>
#include <string>

namespace square_map {

/// the name of the `k`-th seam: A to Z, then A1 and so on
inline std::string seam_name(std::size_t k)
{
  return static_cast<char>('A' + k % 26) + (k < 26 ? "" : std::to_string(k / 26));
}

/// a strip beside one side of the square, and the name of the seam where there is room for it
inline void write_strip(std::ostream& stream, const std::array<double, 2>& from, const std::array<double, 2>& to,
                        int side, std::size_t seam, const Svg_rectangle& domain)
{
  static const double outwards[4][2] = {{0, 1}, {1, 0}, {0, -1}, {-1, 0}}; // in the picture, where y grows downwards
  constexpr double DISTANCE = 5, TEXT_DISTANCE = 18;
  const double dx = outwards[side][0], dy = outwards[side][1];
  const double x1 = domain.x(from[0]), y1 = domain.y(from[1]), x2 = domain.x(to[0]), y2 = domain.y(to[1]);
  const std::string color = hexadecimal(seam_color(seam));
  stream << "<path d='M" << x1 + DISTANCE * dx << ' ' << y1 + DISTANCE * dy << 'L' << x2 + DISTANCE * dx << ' '
         << y2 + DISTANCE * dy << "' stroke='" << color << "' stroke-width='6'/>\n";
  if(std::abs(x2 - x1) + std::abs(y2 - y1) > 20)
    stream << "<text fill='" << color << "' text-anchor='middle' x='" << (x1 + x2) / 2 + TEXT_DISTANCE * dx << "' y='"
           << (y1 + y2) / 2 + TEXT_DISTANCE * dy + 4 << "'>" << seam_name(seam) << "</text>\n";
}

/// both sides of each seam in one color; a seam ends where others meet it, at the border, and at corners of the square
inline void write_seams(std::ostream& stream, const Flat_map& map, const Job& job, const Svg_rectangle& domain)
{
  stream << "<rect fill='none' stroke='#222' x='" << domain.left << "' y='" << domain.top << "' width='" << domain.width
         << "' height='" << domain.height << "'/>\n";
  const Map_border border(map, job);
  const auto place = [&](int position) {
    const int v = border.vertex(position);
    return std::array<double, 2>{map.uv(v, 0), map.uv(v, 1)};
  };
  for(const auto& [segment, seam] : border.seam_sides())
    write_strip(stream, place(segment.first), place(segment.first + segment.edges), segment.side, seam, domain);
}

/// the corners, with their vertices in the file
inline void write_corners(std::ostream& stream, const Flat_map& map, const Job& job, const Svg_rectangle& domain)
{
  const nlohmann::ordered_json names = input_corners(job.result.corners, job);
  for(int c = 0; c < 4; ++c) {
    const auto v = job.result.corners[c].idx();
    const bool is_left = map.uv(v, 0) < 0.5, is_low = map.uv(v, 1) < 0.5;
    const double x = domain.x(map.uv(v, 0)), y = domain.y(map.uv(v, 1));
    stream << "<circle cx='" << x << "' cy='" << y << "' r='5' fill='#222'/>\n";
    if(!names[c].is_null())
      write_text(stream, x + (is_left ? -8 : 8), y + (is_low ? 20 : -12), is_left ? "end" : "start",
                 std::to_string(names[c].get<std::size_t>()));
  }
}

} // namespace square_map

#endif // SQUARE_MAP_SVG_SEAMS_H
