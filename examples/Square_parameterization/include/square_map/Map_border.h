// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_MAP_BORDER_H
#define SQUARE_MAP_MAP_BORDER_H

#include "Flat_map.h"
#include "Job.h"

#include <CGAL_ext/Square_parameterization/internal/sampling/Border_segments.h>
#include <CGAL_ext/Square_parameterization/internal/surface/make_disk_patch.h>

#include <array>
#include <cstddef>
#include <utility>
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

/// the border of the map, from the vertex at (0, 0) on, and the seams that its edges are sides of
class Map_border
{
public:
  typedef CGAL_ext::internal::Border_segment Border_segment;

  Map_border(const Flat_map& map, const Job& job)
  {
    using namespace CGAL_ext::internal;
    const int first = static_cast<int>(job.result.corners[0].idx());
    m_vertices = border_from(first, map.points.size(), map.triangles, number_edges(map.points.size(), map.triangles));
    std::vector<int> originals;
    Corners corners{};
    for(std::size_t k = 0; k < m_vertices.size(); ++k) {
      originals.push_back(map.originals[m_vertices[k]]);
      for(int c = 0; c < 4; ++c)
        if(static_cast<int>(job.result.corners[c].idx()) == m_vertices[k])
          corners[c] = static_cast<int>(k);
    }
    m_segments = border_segments(partner_edges(originals), corners);
  }

  std::size_t number_of_edges() const { return m_vertices.size(); }

  /// the vertex of the map at a position of the border loop; positions go round
  int vertex(int position) const { return m_vertices[static_cast<std::size_t>(position) % m_vertices.size()]; }

  /// both sides of each seam, one after the other, with the number of the seam. A seam ends where others meet it, at
  /// the border of the uncut surface, and at corners of the square.
  std::vector<std::pair<Border_segment, std::size_t>> seam_sides() const
  {
    std::vector<std::pair<Border_segment, std::size_t>> sides;
    for(std::size_t s = 0; s < m_segments.size(); ++s)
      if(m_segments[s].partner > static_cast<int>(s))
        for(const Border_segment& side : {m_segments[s], m_segments[m_segments[s].partner]})
          sides.emplace_back(side, sides.size() / 2);
    return sides;
  }

private:
  std::vector<int> m_vertices;
  std::vector<Border_segment> m_segments;
};

} // namespace square_map

#endif // SQUARE_MAP_MAP_BORDER_H
