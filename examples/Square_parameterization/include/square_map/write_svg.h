// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_WRITE_SVG_H
#define SQUARE_MAP_WRITE_SVG_H

#include "Flat_map.h"
#include "svg_curve.h"
#include "svg_faces.h"
#include "svg_seams.h"

#include <ostream>
#include <string>

namespace square_map {

/// the numbers beside the colors
inline void write_legend(std::ostream& stream, const Stretch_colors& colors, const Svg_rectangle& frame)
{
  constexpr int X = 650, WIDTH = 22;
  const double step = frame.height / Stretch_colors::LEVELS;
  for(int level = 0; level < Stretch_colors::LEVELS; ++level)
    stream << "<rect x='" << X << "' y='" << frame.y(0) - (level + 1) * step << "' width='" << WIDTH << "' height='"
           << step + 0.5 << "' fill='" << hexadecimal(Stretch_colors::color(level)) << "'/>\n";
  constexpr int TICKS = 6;
  for(int k = 0; k <= TICKS; ++k) {
    const double share = static_cast<double>(k) / TICKS, y = frame.y(share);
    stream << "<path d='M" << X + WIDTH << ' ' << y << "h5' stroke='#222'/>";
    write_text(stream, X + WIDTH + 9, y + 4, "start", rounded(colors.stretch_at(share)));
  }
  write_text(stream, X, 26, "start", "L2 stretch of faces");
}

/// writes a picture of the map: the faces in the colors of their stretch, the corners with their vertices in the file,
/// both sides of each seam in one color outside the rectangle, and the curve of the objective over the candidates. 800
/// units wide; beyond 20000 faces these are a PNG picture, so that the file stays small.
inline void write_svg(std::ostream& stream, const Flat_map& map, const Job& job)
{
  constexpr Svg_rectangle frame{70, 62, 540, 540};
  const Svg_rectangle domain = rectangle_in(frame, job.result.aspect);
  const Stretch_colors colors(job.result.measures.face_l2);
  const bool shows_curve = has_curve(job.result.search);
  const int height = shows_curve ? 900 : 660;
  stream.precision(6);
  stream << "<?xml version='1.0' encoding='UTF-8'?>\n<svg xmlns='http://www.w3.org/2000/svg' "
            "xmlns:xlink='http://www.w3.org/1999/xlink' width='800' height='"
         << height << "' viewBox='0 0 800 " << height
         << "' font-family='sans-serif' font-size='13' fill='#222'>\n<rect width='800' height='" << height
         << "' fill='white'/>\n";
  write_text(stream, frame.left, 26, "start",
             counted(map.triangles.size(), "face", "faces") + ", L2 stretch " + rounded(job.result.measures.l2) +
                 ", largest stretch " + rounded(job.result.measures.linf));
  write_faces(stream, map, job.result.measures.face_l2, colors, domain);
  write_seams(stream, map, job, domain);
  write_corners(stream, map, job, domain);
  write_legend(stream, colors, frame);
  if(shows_curve)
    write_curve(stream, job);
  stream << "</svg>\n";
}

} // namespace square_map

#endif // SQUARE_MAP_WRITE_SVG_H
