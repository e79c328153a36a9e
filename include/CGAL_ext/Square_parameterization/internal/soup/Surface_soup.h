// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SOUP_SURFACE_SOUP_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SOUP_SURFACE_SOUP_H

#include <Eigen/Core>

#include <algorithm>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL_ext {
namespace internal {

/// a surface as a file gives it: points and polygons, in no particular state
struct Surface_soup
{
  std::vector<Eigen::Vector3d> points;
  std::vector<std::vector<std::size_t>> faces;
};

/// a side of a face: `corner` begins it, in the orientation of the face
struct Soup_side
{
  std::size_t low, high, face;
  int corner;
};

/// the sides of all faces, those of one edge together
inline std::vector<Soup_side> sides_by_edge(const std::vector<std::vector<std::size_t>>& faces)
{
  std::vector<Soup_side> sides;
  for(std::size_t f = 0; f < faces.size(); ++f)
    for(std::size_t k = 0; k < faces[f].size(); ++k) {
      const auto [low, high] = std::minmax(faces[f][k], faces[f][(k + 1) % faces[f].size()]);
      sides.push_back({low, high, f, static_cast<int>(k)});
    }
  std::sort(sides.begin(), sides.end(), [](const Soup_side& a, const Soup_side& b) {
    return std::tie(a.low, a.high, a.face, a.corner) < std::tie(b.low, b.high, b.face, b.corner);
  });
  return sides;
}

/// calls `visit(begin, end)` with the sides of each edge
template <class Visit>
void for_each_edge(const std::vector<Soup_side>& sides, Visit visit)
{
  for(auto begin = sides.begin(); begin != sides.end();) {
    const auto end = std::find_if(begin, sides.end(), [begin](const Soup_side& side) {
      return side.low != begin->low || side.high != begin->high;
    });
    visit(begin, end);
    begin = end;
  }
}

} // namespace internal
} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SOUP_SURFACE_SOUP_H
