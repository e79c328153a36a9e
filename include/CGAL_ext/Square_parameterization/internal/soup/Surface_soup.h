// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SOUP_SURFACE_SOUP_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SOUP_SURFACE_SOUP_H

#include <CGAL_ext/Square_parameterization/internal/common/ranges.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// a surface as a file gives it: points and polygons, in no particular state
struct Surface_soup
{
  std::vector<Eigen::Vector3d> points;
  std::vector<std::vector<std::size_t>> faces;
};

/// a side of a face: `corner` begins it, in the orientation of the face. Numbers have 32 bits: there are millions of sides.
struct Soup_side
{
  std::uint32_t low, high, face;
  int corner;
};

/// the sides of all faces: those of one edge together, edges by their lower and then by their higher vertex, the sides of
/// an edge by their faces.
///
/// They are put into buckets by their lower vertex first, for few sides begin at one: linear in the number of sides but
/// for sorting in each bucket, which is done with the threads of the current team.
/// \pre every index of a face is that of a point, and numbers of points and faces have 32 bits
inline std::vector<Soup_side> sides_by_edge(const Surface_soup& soup)
{
  const auto visit_sides = [&soup](auto visit) {
    for(std::size_t f = 0; f < soup.faces.size(); ++f) {
      const std::vector<std::size_t>& face = soup.faces[f];
      for(std::size_t k = 0; k < face.size(); ++k) {
        const auto [low, high] = std::minmax(face[k], face[k + 1 < face.size() ? k + 1 : 0]);
        visit(Soup_side{static_cast<std::uint32_t>(low), static_cast<std::uint32_t>(high),
                        static_cast<std::uint32_t>(f), static_cast<int>(k)});
      }
    }
  };
  std::vector<std::size_t> ends(soup.points.size() + 1, 0); // of the buckets, once they are filled
  visit_sides([&ends](const Soup_side& side) { ++ends[side.low + 1]; });
  std::partial_sum(ends.begin(), ends.end(), ends.begin());
  std::vector<Soup_side> sides(ends.back());
  visit_sides([&ends, &sides](const Soup_side& side) { sides[ends[side.low]++] = side; });
  for_ranges(soup.points.size(), [&ends, &sides](std::size_t range_begin, std::size_t range_end) {
    for(std::size_t v = range_begin; v < range_end; ++v)
      std::sort(sides.begin() + static_cast<std::ptrdiff_t>(v == 0 ? 0 : ends[v - 1]),
                sides.begin() + static_cast<std::ptrdiff_t>(ends[v]), [](const Soup_side& a, const Soup_side& b) {
                  return std::tie(a.high, a.face, a.corner) < std::tie(b.high, b.face, b.corner);
                });
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

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SOUP_SURFACE_SOUP_H
