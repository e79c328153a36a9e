// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_VERTEX_COLORS_H
#define SQUARE_MAP_VERTEX_COLORS_H

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace square_map {

/// red, green and blue from 0 to 1 for each vertex; empty when a file has none
typedef std::vector<Eigen::Vector3d> Vertex_colors;

/// the mean of the colors at the vertex's neighbors: of the two that it is the midpoint of, when there are such
inline std::optional<Eigen::Vector3d> color_from(const std::vector<int>& neighbors, int vertex,
                                                 const std::vector<Eigen::Vector3d>& points,
                                                 const std::vector<std::optional<Eigen::Vector3d>>& colors)
{
  Eigen::Vector3d sum(0, 0, 0);
  int count = 0;
  for(int a : neighbors)
    if(colors[a]) {
      for(int b : neighbors) // as a chord is split
        if(b > a && colors[b] && points[vertex] == points[a] / 2 + points[b] / 2)
          return Eigen::Vector3d((*colors[a] + *colors[b]) / 2);
      sum += *colors[a];
      ++count;
    }
  return count > 0 ? std::optional<Eigen::Vector3d>(sum / count) : std::nullopt;
}

/// gives the vertices that have none, those that were added, the colors of their neighbors
/// \pre the surface is connected and a vertex has a color
inline Vertex_colors completed_colors(std::vector<std::optional<Eigen::Vector3d>> colors,
                                      const std::vector<Eigen::Vector3d>& points,
                                      const std::vector<std::array<int, 3>>& triangles)
{
  std::vector<std::vector<int>> neighbors(points.size()); // of those without a color
  for(const auto& t : triangles)
    for(int k = 0; k < 3; ++k)
      if(!colors[t[k]])
        neighbors[t[k]].insert(neighbors[t[k]].end(), {t[(k + 1) % 3], t[(k + 2) % 3]});
  for(bool is_complete = false; !is_complete;) {
    is_complete = true;
    const auto before = colors;
    for(std::size_t v = 0; v < colors.size(); ++v)
      if(!before[v]) {
        colors[v] = color_from(neighbors[v], static_cast<int>(v), points, before);
        is_complete = false;
      }
  }
  Vertex_colors result;
  for(const auto& color : colors)
    result.push_back(*color);
  return result;
}

} // namespace square_map

#endif // SQUARE_MAP_VERTEX_COLORS_H
