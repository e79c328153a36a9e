// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SOUP_TRIANGULATE_SOUP_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SOUP_TRIANGULATE_SOUP_H

#include <CGAL_ext/Square_parameterization/internal/soup/Ear_clipping.h>
#include <CGAL_ext/Square_parameterization/internal/soup/Surface_soup.h>
#include <CGAL_ext/Square_parameterization/internal/soup/triangulate_large_polygon.h>

#include <algorithm>
#include <cstddef>
#include <optional>
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

typedef std::vector<std::vector<std::size_t>> Soup_triangles;

/// splits one polygon by diagonals that are no edges yet, for an edge must not get a third face. What cannot be split
/// so, because all diagonals are edges, gets a vertex in its middle. The triangles are oriented as the polygon.
/// \param corners of the polygon, and \p plane its plane
inline Soup_triangles triangles_between_corners(const std::vector<std::size_t>& polygon,
                                                const std::vector<Eigen::Vector3d>& corners, const Polygon_plane& plane,
                                                Known_edges& edges, std::vector<Eigen::Vector3d>& points)
{
  Ear_clipping clipping(corners, plane);
  const auto is_known = [&](std::size_t a, std::size_t b) { return edges.contains(polygon[a], polygon[b]); };
  while(clipping.size() > 3 && clipping.clip(is_known)) {
    const auto& [a, b, c] = clipping.triangles().back();
    edges.add(polygon[a], polygon[c]);
  }
  Soup_triangles triangles;
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

/// calls `visit(a, b)` for the diagonals of a polygon of \p size corners, which are the sides of two of its triangles
template <class Visit>
void for_diagonals(const Polygon_triangulation& polygon, std::size_t size, const Visit& visit)
{
  for(const auto& triangle : polygon.triangles)
    for(int k = 0; k < 3; ++k) {
      const std::size_t a = triangle[k], b = triangle[(k + 1) % 3]; // of the two triangles in one is a < b
      if(a < b && b < size && b != a + 1 && (a != 0 || b + 1 != size))
        visit(a, b);
    }
}

/// splits one polygon with points inside, where that is worth while, or else between its corners
inline Soup_triangles triangles_of_polygon(const std::vector<std::size_t>& polygon, Known_edges& edges,
                                           std::vector<Eigen::Vector3d>& points)
{
  std::vector<Eigen::Vector3d> corners;
  for(std::size_t v : polygon)
    corners.push_back(points[v]);
  const Polygon_plane plane(corners);
  const std::optional<Polygon_triangulation> with_points = triangulate_large_polygon(corners, plane);
  bool may_be_split_so = with_points.has_value();
  if(with_points)
    for_diagonals(*with_points, polygon.size(), [&](std::size_t a, std::size_t b) {
      may_be_split_so = may_be_split_so && !edges.contains(polygon[a], polygon[b]);
    });
  if(!may_be_split_so)
    return triangles_between_corners(polygon, corners, plane, edges, points);
  for_diagonals(*with_points, polygon.size(), [&](std::size_t a, std::size_t b) { edges.add(polygon[a], polygon[b]); });
  const auto number = [&](std::size_t k) {
    return k < polygon.size() ? polygon[k] : points.size() + k - polygon.size();
  };
  Soup_triangles triangles;
  for(const auto& [a, b, c] : with_points->triangles)
    triangles.push_back({number(a), number(b), number(c)});
  points.insert(points.end(), with_points->added.begin(), with_points->added.end());
  return triangles;
}

/// splits the faces with more than three vertices; the triangles of a face take its place, and new vertices come last.
/// Returns how many faces it split. \p sides are those of the soup by edge, before any face is split.
/// \pre no face repeats a vertex, no edge has more than two faces
inline std::size_t triangulate_soup(Surface_soup& soup, const std::vector<Soup_side>& sides)
{
  Known_edges edges(sides);
  Soup_triangles triangles;
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
