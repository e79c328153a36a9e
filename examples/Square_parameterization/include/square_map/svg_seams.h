// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_SVG_SEAMS_H
#define SQUARE_MAP_SVG_SEAMS_H

#include "report.h"
#include "svg_faces.h"

#include <CGAL_ext/Square_parameterization/internal/sampling/Border_segments.h>
#include <CGAL_ext/Square_parameterization/internal/surface/make_disk_patch.h>

#include <array>
#include <ostream>
#include <string>
#include <vector>

namespace square_map {

/// the color of the `k`-th seam
inline Color seam_color(std::size_t k)
{
  // Okabe and Ito's, which color-blind readers tell apart, without yellow and black
  static const Color colors[] = {{213, 94, 0},    {0, 114, 178}, {0, 158, 115},
                                 {204, 121, 167}, {230, 159, 0}, {86, 180, 233}};
  return colors[k % std::size(colors)];
}

/// the name of the `k`-th seam: A to Z, then A1 and so on
inline std::string seam_name(std::size_t k)
{
  return static_cast<char>('A' + k % 26) + (k < 26 ? "" : std::to_string(k / 26));
}

/// a strip beside one side of the square, and the name of the seam where there is room for it
inline void write_strip(std::ostream& stream, const std::array<double, 2>& from, const std::array<double, 2>& to,
                        int side, std::size_t seam, const Svg_square& square)
{
  static const double outwards[4][2] = {{0, 1}, {1, 0}, {0, -1}, {-1, 0}}; // in the picture, where y grows downwards
  constexpr double DISTANCE = 5, TEXT_DISTANCE = 18;
  const double dx = outwards[side][0], dy = outwards[side][1];
  const double x1 = square.x(from[0]), y1 = square.y(from[1]), x2 = square.x(to[0]), y2 = square.y(to[1]);
  const std::string color = hexadecimal(seam_color(seam));
  stream << "<path d='M" << x1 + DISTANCE * dx << ' ' << y1 + DISTANCE * dy << 'L' << x2 + DISTANCE * dx << ' '
         << y2 + DISTANCE * dy << "' stroke='" << color << "' stroke-width='6'/>\n";
  if(std::abs(x2 - x1) + std::abs(y2 - y1) > 20)
    stream << "<text fill='" << color << "' text-anchor='middle' x='" << (x1 + x2) / 2 + TEXT_DISTANCE * dx << "' y='"
           << (y1 + y2) / 2 + TEXT_DISTANCE * dy + 4 << "'>" << seam_name(seam) << "</text>\n";
}

/// both sides of each seam in one color; a seam ends where others meet it, at the border, and at corners of the square
inline void write_seams(std::ostream& stream, const Flat_map& map, const Job& job, const Svg_square& square)
{
  using namespace CGAL_ext::internal;
  stream << "<rect fill='none' stroke='#222' x='" << square.left << "' y='" << square.top << "' width='" << square.size
         << "' height='" << square.size << "'/>\n";
  Surface_arrays arrays;
  arrays.points = map.points;
  arrays.triangles = map.triangles;
  const int first = static_cast<int>(job.result.corners[0].idx());
  const std::vector<int> border = border_from(first, arrays, number_edges(map.points.size(), map.triangles));
  std::vector<int> originals;
  Corners corners{};
  for(std::size_t k = 0; k < border.size(); ++k) {
    originals.push_back(map.originals[border[k]]);
    for(int c = 0; c < 4; ++c)
      if(static_cast<int>(job.result.corners[c].idx()) == border[k])
        corners[c] = static_cast<int>(k);
  }
  const auto place = [&](int position) {
    const int v = border[position % border.size()];
    return std::array<double, 2>{map.uv(v, 0), map.uv(v, 1)};
  };
  const auto segments = border_segments(partner_edges(originals), corners);
  std::size_t seam = 0;
  for(std::size_t s = 0; s < segments.size(); ++s)
    if(segments[s].partner > static_cast<int>(s)) {
      for(const Border_segment& side : {segments[s], segments[segments[s].partner]})
        write_strip(stream, place(side.first), place(side.first + side.edges), side.side, seam, square);
      ++seam;
    }
}

/// the corners, with their vertices in the file
inline void write_corners(std::ostream& stream, const Flat_map& map, const Job& job, const Svg_square& square)
{
  const nlohmann::ordered_json names = input_corners(job);
  for(int c = 0; c < 4; ++c) {
    const auto v = job.result.corners[c].idx();
    const bool is_left = map.uv(v, 0) < 0.5, is_low = map.uv(v, 1) < 0.5;
    const double x = square.x(map.uv(v, 0)), y = square.y(map.uv(v, 1));
    stream << "<circle cx='" << x << "' cy='" << y << "' r='5' fill='#222'/>\n";
    if(!names[c].is_null())
      write_text(stream, x + (is_left ? -8 : 8), y + (is_low ? 20 : -12), is_left ? "end" : "start",
                 std::to_string(names[c].get<std::size_t>()));
  }
}

} // namespace square_map

#endif // SQUARE_MAP_SVG_SEAMS_H
