// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_STRETCH_COLORS_H
#define SQUARE_MAP_STRETCH_COLORS_H

#include "pictures.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <string>
#include <vector>

namespace square_map {

/// colors of the stretch of faces: the same ratio of two stretches is the same distance on a scale that the eye takes as
/// even (viridis of matplotlib)
class Stretch_colors
{
public:
  static constexpr int LEVELS = 64;

  /// the scale reaches from the stretch that one face in a hundred is below to the one that one in a hundred is above
  explicit Stretch_colors(std::vector<double> face_stretch)
  {
    const auto percentile = [&face_stretch](std::size_t percent) {
      const auto place = face_stretch.begin() + static_cast<std::ptrdiff_t>((face_stretch.size() - 1) * percent / 100);
      std::nth_element(face_stretch.begin(), place, face_stretch.end());
      return *place;
    };
    m_low = (std::max)(percentile(1), 1e-3);
    m_high = (std::min)(percentile(99), 1e9);
    if(!(m_high > 1.02 * m_low)) { // all are alike
      m_low /= 1.01;
      m_high = 1.0201 * m_low;
    }
  }

  /// the stretch at a share of the scale
  double stretch_at(double share) const { return m_low * std::pow(m_high / m_low, share); }

  /// the level of a stretch, 0 to `LEVELS` - 1
  int level(double stretch) const
  {
    const double share = std::log((std::max)(stretch, m_low) / m_low) / std::log(m_high / m_low);
    return static_cast<int>((std::min)(share, 1.) * (LEVELS - 1) + 0.5);
  }

  static Color color(int level)
  {
    static const Color anchors[] = {{68, 1, 84},    {72, 36, 117},  {65, 68, 135},  {53, 95, 141},
                                    {42, 120, 142}, {33, 145, 140}, {34, 168, 132}, {68, 191, 112},
                                    {122, 209, 81}, {189, 223, 38}, {253, 231, 37}};
    constexpr int INTERVALS = static_cast<int>(std::size(anchors)) - 1;
    const double place = static_cast<double>(level) / (LEVELS - 1) * INTERVALS;
    const int before = (std::min)(static_cast<int>(place), INTERVALS - 1);
    Color color{};
    for(int c = 0; c < 3; ++c)
      color[c] = static_cast<std::uint8_t>(
          std::lround(anchors[before][c] + (place - before) * (anchors[before + 1][c] - anchors[before][c])));
    return color;
  }

private:
  double m_low, m_high;
};

/// a color as SVG has it
inline std::string hexadecimal(const Color& color)
{
  char text[8];
  std::snprintf(text, sizeof text, "#%02x%02x%02x", color[0], color[1], color[2]);
  return text;
}

} // namespace square_map

#endif // SQUARE_MAP_STRETCH_COLORS_H
