// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SOUP_CHECK_SOUP_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SOUP_CHECK_SOUP_H

#include <CGAL_ext/Square_parameterization/internal/common/Complaint.h>
#include <CGAL_ext/Square_parameterization/internal/soup/soup_components.h>

#include <set>
#include <string>
#include <utility>
#include <vector>

namespace CGAL_ext {
namespace internal {

/// refuses a soup without faces
inline void check_not_empty(const Surface_soup& soup)
{
  if(soup.faces.empty())
    throw Unmappable(CGAL::Surface_mesh_parameterization::ERROR_EMPTY_MESH,
                     "the surface cannot be mapped: it has no faces");
}

/// refuses faces that repeat a vertex or have fewer than three and, unless they are to be split, those with more than
/// three. \p names holds the numbers of the faces for messages.
inline void check_faces(const Surface_soup& soup, const std::vector<std::size_t>& names, bool may_be_polygons)
{
  std::vector<std::string> polygons, repeating;
  std::size_t number_of_polygons = 0, number_of_repeating = 0;
  for(std::size_t f = 0; f < soup.faces.size(); ++f) {
    const auto& face = soup.faces[f];
    const std::string name = "face " + std::to_string(names[f]);
    if((face.size() < 3 || (face.size() > 3 && !may_be_polygons)) && ++number_of_polygons <= NAMED_PLACES)
      polygons.push_back(name + " has " + std::to_string(face.size()) + " vertices");
    if(std::set<std::size_t>(face.begin(), face.end()).size() < face.size() && ++number_of_repeating <= NAMED_PLACES)
      repeating.push_back(name);
  }
  Complaint complaint;
  complaint.add(number_of_polygons, "non-triangular face", "non-triangular faces", polygons);
  if(number_of_polygons > 0 && !may_be_polygons)
    complaint.say("--triangulate splits polygons");
  complaint.add(number_of_repeating, "face that repeats a vertex", "faces that repeat a vertex", repeating);
  complaint.throw_if_any(CGAL::Surface_mesh_parameterization::ERROR_NON_TRIANGULAR_MESH);
}

/// refuses edges with more than two faces
inline void check_edges(const Surface_soup& soup)
{
  Complaint complaint;
  std::size_t number_of_edges = 0;
  std::vector<std::string> edges;
  for_each_edge(sides_by_edge(soup.faces), [&](auto begin, auto end) {
    if(end - begin > 2 && ++number_of_edges <= NAMED_PLACES)
      edges.push_back("vertices " + std::to_string(begin->low) + " and " + std::to_string(begin->high));
  });
  complaint.add(number_of_edges, "non-manifold edge", "non-manifold edges", edges);
  complaint.throw_if_any(CGAL::Surface_mesh_parameterization::ERROR_NO_TOPOLOGICAL_DISC);
}

/// what a conditioned soup may be
enum class Topology
{
  DISK,
  CONNECTED ///< with any number of borders and handles: to be cut
};

/// refuses oriented manifold-edged surfaces that are not manifold and connected or, where it is asked for, not one
/// disk: counts components, pinched vertices, borders, genus
inline void check_topology(const Surface_soup& soup, Topology topology)
{
  const std::size_t V = soup.points.size(), F = soup.faces.size();
  Disjoint_sets corners(3 * F), loops(V);
  const auto next = [](int corner) { return (corner + 1) % 3; };
  std::vector<bool> is_used(V, false), is_on_border(V, false);
  std::size_t E = 0;
  for_each_edge(sides_by_edge(soup.faces), [&](auto begin, auto end) {
    ++E;
    is_used[begin->low] = is_used[begin->high] = true;
    if(end - begin == 2) { // oriented: where one face begins the edge the other ends it
      const auto& [f, g] = std::make_pair(*begin, *(begin + 1));
      corners.union_set(3 * f.face + f.corner, 3 * g.face + next(g.corner));
      corners.union_set(3 * f.face + next(f.corner), 3 * g.face + g.corner);
    } else {
      loops.union_set(begin->low, begin->high);
      is_on_border[begin->low] = is_on_border[begin->high] = true;
    }
  });
  std::vector<int> fans(V, 0);
  for(std::size_t f = 0; f < F; ++f)
    for(int k = 0; k < 3; ++k)
      if(corners.find_set(3 * f + k) == 3 * f + k)
        ++fans[soup.faces[f][k]];

  std::size_t used = 0, borders = 0, pinched = 0;
  std::vector<std::string> pinched_places;
  for(std::size_t v = 0; v < V; ++v) {
    used += is_used[v] ? 1 : 0;
    borders += is_on_border[v] && loops.find_set(v) == v ? 1 : 0;
    if(fans[v] > 1 && ++pinched <= NAMED_PLACES)
      pinched_places.push_back("vertex " + std::to_string(v));
  }
  Complaint complaint;
  complaint.add(pinched, "non-manifold vertex", "non-manifold vertices", pinched_places);
  const std::vector<std::vector<std::size_t>> components = components_of(soup);
  complain_about_components(components, complaint);
  if(topology == Topology::DISK && pinched == 0 && components.size() == 1) {
    const long euler = static_cast<long>(used + F) - static_cast<long>(E);
    if(borders == 0)
      complaint.say("it is closed: it has no border");
    if(borders > 1)
      complaint.say(std::to_string(borders) + " border loops");
    const long genus = (2 - static_cast<long>(borders) - euler) / 2;
    if(genus > 0)
      complaint.say("genus " + std::to_string(genus));
  }
  complaint.throw_if_any(CGAL::Surface_mesh_parameterization::ERROR_NO_TOPOLOGICAL_DISC);
}

} // namespace internal
} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SOUP_CHECK_SOUP_H
