// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SOUP_CONDITION_SOUP_IMPL_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SOUP_CONDITION_SOUP_IMPL_H

#include <CGAL_ext/Square_parameterization/internal/common/compiled_core.h>
#include <CGAL_ext/Square_parameterization/internal/soup/condition_soup.h>
#include <CGAL_ext/Square_parameterization/internal/soup/orient_soup.h>
#include <CGAL_ext/Square_parameterization/internal/soup/triangulate_soup.h>

#include <numeric>
#include <string>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

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

CGAL_EXT_INLINE_FUNCTION Conditioning_report condition_soup(Surface_soup& soup, const Conditioning_options& options)
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

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SOUP_CONDITION_SOUP_IMPL_H
