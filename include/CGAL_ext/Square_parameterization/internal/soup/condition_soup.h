// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SOUP_CONDITION_SOUP_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SOUP_CONDITION_SOUP_H

#include <CGAL_ext/Square_parameterization/internal/soup/check_soup.h>
#include <CGAL_ext/Square_parameterization/internal/soup/orient_soup.h>
#include <CGAL_ext/Square_parameterization/internal/soup/triangulate_soup.h>

#include <numeric>
#include <optional>
#include <string>
#include <vector>

namespace CGAL_ext {
namespace internal {

/// what `condition_soup()` is to do
struct Conditioning_options
{
  Topology topology = Topology::DISK;
  /// keeps one connected component alone: 0 is that with most faces, the first of them when there are several. None:
  /// there must be one component.
  std::optional<std::size_t> component;
  bool triangulate = false; ///< splits polygons; they are refused otherwise
};

/// what `condition_soup()` changed
struct Conditioning_report
{
  std::size_t components = 1;            ///< how many there were
  std::size_t component = 0;             ///< the one that was kept
  std::size_t faces_dropped = 0;         ///< those of the other components
  std::size_t vertices_dropped = 0;      ///< isolated vertices and those of the other components
  std::size_t faces_reoriented = 0;      ///< faces that were turned round
  std::size_t polygons_triangulated = 0; ///< faces that were split
  std::size_t vertices_added = 0;        ///< in the middle of polygons that no diagonal could split; they come last
  std::vector<std::size_t> new_index;    ///< per vertex of the input; `DROPPED` for one without a face

  static constexpr std::size_t DROPPED = static_cast<std::size_t>(-1);
};

/// drops the faces of all components but the chosen one, and their sides; returns the numbers that the others had
inline std::vector<std::size_t> choose_component(const Conditioning_options& options, Surface_soup& soup,
                                                 std::vector<Soup_side>& sides, Conditioning_report& report)
{
  std::vector<std::size_t> names(soup.faces.size());
  std::iota(names.begin(), names.end(), 0);
  if(!options.component)
    return names;
  const std::vector<std::vector<std::size_t>> components = components_of(soup, sides);
  if(*options.component >= components.size())
    throw Unmappable(CGAL::Surface_mesh_parameterization::ERROR_WRONG_PARAMETER,
                     "there is no component " + std::to_string(*options.component) + ": the surface has " +
                         std::to_string(components.size()) + ", counted from 0");
  names = components[*options.component];
  report.components = components.size();
  report.component = *options.component;
  report.faces_dropped = soup.faces.size() - names.size();
  keep_component(names, soup, sides);
  return names;
}

/// drops the vertices of no face; the others keep their order
inline void drop_isolated_vertices(Surface_soup& soup, Conditioning_report& report)
{
  const std::size_t input_vertices = soup.points.size() - report.vertices_added;
  report.new_index.assign(soup.points.size(), Conditioning_report::DROPPED);
  for(const auto& face : soup.faces)
    for(std::size_t v : face)
      report.new_index[v] = 0;
  std::size_t kept = 0;
  for(std::size_t v = 0; v < soup.points.size(); ++v)
    if(report.new_index[v] != Conditioning_report::DROPPED) {
      report.new_index[v] = kept;
      soup.points[kept++] = soup.points[v];
    }
  report.vertices_dropped = soup.points.size() - kept;
  soup.points.resize(kept);
  for(auto& face : soup.faces)
    for(std::size_t& v : face)
      v = report.new_index[v];
  report.new_index.resize(input_vertices);
}

/// makes a soup one connected, manifold, oriented triangle surface: chooses a component and splits polygons where that
/// is asked for, turns faces round, and drops isolated vertices. Throws `Unmappable` with a sentence that counts what
/// is wrong and names the first places by their numbers in the given soup; with `ERROR_WRONG_PARAMETER` when there is
/// no such component.
///
/// Complexity: linear in the number of sides but for sorting those at each vertex and, where polygons are split,
/// quadratic in the size of each.
/// \pre every index of a face is that of a point, every coordinate is finite
inline Conditioning_report condition_soup(Surface_soup& soup, const Conditioning_options& options = {})
{
  Conditioning_report report;
  check_not_empty(soup);
  std::vector<Soup_side> sides = sides_by_edge(soup); // the one sorted list, which every step uses
  const std::vector<std::size_t> names = choose_component(options, soup, sides, report);
  check_faces(soup, names, options.triangulate);
  check_edges(sides);
  report.faces_reoriented = orient_faces(soup, sides, names);
  if(options.triangulate) {
    const std::size_t input_vertices = soup.points.size();
    report.polygons_triangulated = triangulate_soup(soup, sides);
    report.vertices_added = soup.points.size() - input_vertices;
    if(report.polygons_triangulated > 0)
      sides = sides_by_edge(soup);
  }
  check_topology(soup, sides, options.topology);
  drop_isolated_vertices(soup, report);
  return report;
}

} // namespace internal
} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SOUP_CONDITION_SOUP_H
