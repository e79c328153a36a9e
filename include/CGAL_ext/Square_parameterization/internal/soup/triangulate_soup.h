// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SOUP_TRIANGULATE_SOUP_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SOUP_TRIANGULATE_SOUP_H

#include <CGAL_ext/Square_parameterization/internal/soup/Ear_clipping.h>
#include <CGAL_ext/Square_parameterization/internal/soup/Surface_soup.h>

#include <algorithm>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// the edges of a soup, to which diagonals are added
class Known_edges
{
public:
  /// \param sides of the soup by edge; they are kept by reference
  explicit Known_edges(const std::vector<Soup_side>& sides) : m_sides(sides) {}

  void add(std::size_t a, std::size_t b) { m_diagonals.insert(std::minmax(a, b)); }

  bool contains(std::size_t a, std::size_t b) const
  {
    const std::pair<std::size_t, std::size_t> edge = std::minmax(a, b);
    const auto side = std::lower_bound(m_sides.begin(), m_sides.end(), edge,
                                       [](const Soup_side& s, const std::pair<std::size_t, std::size_t>& e) {
                                         return std::tie(s.low, s.high) < std::tie(e.first, e.second);
                                       });
    const bool is_edge = side != m_sides.end() && side->low == edge.first && side->high == edge.second;
    return is_edge || m_diagonals.count(edge) != 0;
  }

private:
  const std::vector<Soup_side>& m_sides;
  std::set<std::pair<std::size_t, std::size_t>> m_diagonals;
};

/// splits one polygon by diagonals that are no edges yet, for an edge must not get a third face. What cannot be split
/// so, because all diagonals are edges, gets a vertex in its middle. The triangles are oriented as the polygon.
inline std::vector<std::vector<std::size_t>>
triangles_of_polygon(const std::vector<std::size_t>& polygon, Known_edges& edges, std::vector<Eigen::Vector3d>& points)
{
  std::vector<Eigen::Vector3d> corners;
  for(std::size_t v : polygon)
    corners.push_back(points[v]);
  Ear_clipping clipping(corners);
  const auto is_known = [&](std::size_t a, std::size_t b) { return edges.contains(polygon[a], polygon[b]); };
  while(clipping.size() > 3 && clipping.clip(is_known)) {
    const auto& [a, b, c] = clipping.triangles().back();
    edges.add(polygon[a], polygon[c]);
  }
  std::vector<std::vector<std::size_t>> triangles;
  for(const auto& [a, b, c] : clipping.triangles())
    triangles.push_back({polygon[a], polygon[b], polygon[c]});
  const std::vector<std::size_t> rest = clipping.rest();
  if(rest.size() == 3) {
    triangles.push_back({polygon[rest[0]], polygon[rest[1]], polygon[rest[2]]});
    return triangles;
  }
  Eigen::Vector3d middle(0, 0, 0);
  for(std::size_t k : rest)
    middle += corners[k] / static_cast<double>(rest.size());
  for(std::size_t i = 0; i < rest.size(); ++i)
    triangles.push_back({polygon[rest[i]], polygon[rest[(i + 1) % rest.size()]], points.size()});
  points.push_back(middle);
  return triangles;
}

/// splits the faces with more than three vertices; the triangles of a face take its place, and new vertices come last.
/// Returns how many faces it split. \p sides are those of the soup by edge, before any face is split.
/// \pre no face repeats a vertex, no edge has more than two faces
inline std::size_t triangulate_soup(Surface_soup& soup, const std::vector<Soup_side>& sides)
{
  Known_edges edges(sides);
  std::vector<std::vector<std::size_t>> triangles;
  std::size_t polygons = 0;
  for(auto& face : soup.faces) {
    if(face.size() == 3) {
      triangles.push_back(std::move(face));
      continue;
    }
    ++polygons;
    for(auto& triangle : triangles_of_polygon(face, edges, soup.points))
      triangles.push_back(std::move(triangle));
  }
  soup.faces = std::move(triangles);
  return polygons;
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SOUP_TRIANGULATE_SOUP_H
