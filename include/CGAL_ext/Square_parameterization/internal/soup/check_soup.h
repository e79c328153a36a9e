// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SOUP_CHECK_SOUP_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SOUP_CHECK_SOUP_H

#include <CGAL_ext/Square_parameterization/internal/common/Complaint.h>
#include <CGAL_ext/Square_parameterization/internal/common/Thread_team.h>
#include <CGAL_ext/Square_parameterization/internal/soup/soup_components.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// refuses a soup without faces
inline void check_not_empty(const Surface_soup& soup)
{
  if(soup.faces.empty())
    throw Unmappable(CGAL::Surface_mesh_parameterization::ERROR_EMPTY_MESH,
                     "the surface cannot be mapped: it has no faces");
}

/// indicates whether a face repeats a vertex
inline bool repeats_vertex(const std::vector<std::size_t>& face)
{
  constexpr std::size_t FEW = 8; // as many vertices are compared in pairs, faster than they are copied and sorted
  if(face.size() > FEW) {
    std::vector<std::size_t> sorted = face;
    std::sort(sorted.begin(), sorted.end());
    return std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end();
  }
  for(auto v = face.begin(); v != face.end(); ++v)
    if(std::find(face.begin(), v, *v) != v)
      return true;
  return false;
}

/// refuses faces that repeat a vertex or have fewer than three and, unless they are to be split, those with more than
/// three. \p names holds the numbers of the faces for messages.
inline void check_faces(const Surface_soup& soup, const std::vector<std::size_t>& names, bool may_be_polygons)
{
  std::vector<std::string> polygons, repeating;
  std::size_t number_of_polygons = 0, number_of_repeating = 0;
  const auto name = [&names](std::size_t f) { return "face " + std::to_string(names[f]); };
  for(std::size_t f = 0; f < soup.faces.size(); ++f) {
    const auto& face = soup.faces[f];
    if((face.size() < 3 || (face.size() > 3 && !may_be_polygons)) && ++number_of_polygons <= NAMED_PLACES)
      polygons.push_back(name(f) + " has " + std::to_string(face.size()) + " vertices");
    if(repeats_vertex(face) && ++number_of_repeating <= NAMED_PLACES)
      repeating.push_back(name(f));
  }
  Complaint complaint;
  complaint.add(number_of_polygons, "non-triangular face", "non-triangular faces", polygons);
  if(number_of_polygons > 0 && !may_be_polygons)
    complaint.say("--triangulate splits polygons");
  complaint.add(number_of_repeating, "face that repeats a vertex", "faces that repeat a vertex", repeating);
  complaint.throw_if_any(CGAL::Surface_mesh_parameterization::ERROR_NON_TRIANGULAR_MESH);
}

/// refuses edges with more than two faces
inline void check_edges(const std::vector<Soup_side>& sides)
{
  Complaint complaint;
  std::size_t number_of_edges = 0;
  std::vector<std::string> edges;
  for_each_edge(sides, [&](auto begin, auto end) {
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

/// what `check_topology()` counts
struct Topology_counts
{
  std::size_t vertices = 0, edges = 0, borders = 0; // vertices: those with a face
  std::vector<int> fans;                            // #V, runs of faces round the vertex that are joined by edges
};

/// counts what an oriented soup of triangles without non-manifold edges is made of
inline Topology_counts count_topology(const Surface_soup& soup, const std::vector<Soup_side>& sides)
{
  const std::size_t V = soup.points.size(), F = soup.faces.size();
  Topology_counts counts;
  Disjoint_sets corners(3 * F), loops(V);
  const auto next = [](int corner) { return (corner + 1) % 3; };
  std::vector<bool> is_on_border(V, false);
  for_each_edge(sides, [&](auto begin, auto end) {
    ++counts.edges;
    if(end - begin == 2) { // oriented: where one face begins the edge the other ends it
      const Soup_side &f = *begin, &g = *std::next(begin);
      const std::size_t of_f = 3 * std::size_t(f.face), of_g = 3 * std::size_t(g.face);
      corners.union_set(of_f + f.corner, of_g + next(g.corner));
      corners.union_set(of_f + next(f.corner), of_g + g.corner);
    } else {
      loops.union_set(begin->low, begin->high);
      is_on_border[begin->low] = is_on_border[begin->high] = true;
    }
  });
  counts.fans.assign(V, 0);
  for(std::size_t f = 0; f < F; ++f)
    for(int k = 0; k < 3; ++k)
      if(corners.find_set(3 * f + k) == 3 * f + k)
        ++counts.fans[soup.faces[f][k]];
  for(std::size_t v = 0; v < V; ++v) {
    counts.vertices += counts.fans[v] > 0 ? 1 : 0;
    counts.borders += is_on_border[v] && loops.find_set(v) == v ? 1 : 0;
  }
  return counts;
}

/// adds what keeps a connected manifold surface from being a disk: borders, genus
inline void complain_about_disk(const Topology_counts& counts, std::size_t faces, Complaint& complaint)
{
  const long euler = static_cast<long>(counts.vertices + faces) - static_cast<long>(counts.edges);
  if(counts.borders == 0)
    complaint.say("it is closed: it has no border");
  if(counts.borders > 1)
    complaint.say(std::to_string(counts.borders) + " border loops");
  const long genus = (2 - static_cast<long>(counts.borders) - euler) / 2;
  if(genus > 0)
    complaint.say("genus " + std::to_string(genus));
}

/// refuses oriented manifold-edged triangle surfaces that are not manifold and connected or, where it is asked for, not
/// one disk: counts components, pinched vertices, borders, genus
/// \param sides of the soup by edge
inline void check_topology(const Surface_soup& soup, const std::vector<Soup_side>& sides, Topology topology)
{
  Topology_counts counts;
  std::vector<std::vector<std::size_t>> components;
  Thread_team::current()(2, [&](std::size_t i) {
    if(i == 0)
      counts = count_topology(soup, sides);
    else
      components = components_of(soup, sides);
  });
  std::size_t pinched = 0;
  std::vector<std::string> pinched_places;
  for(std::size_t v = 0; v < counts.fans.size(); ++v)
    if(counts.fans[v] > 1 && ++pinched <= NAMED_PLACES)
      pinched_places.push_back("vertex " + std::to_string(v));
  Complaint complaint;
  complaint.add(pinched, "non-manifold vertex", "non-manifold vertices", pinched_places);
  complain_about_components(components, complaint);
  if(topology == Topology::DISK && pinched == 0 && components.size() == 1)
    complain_about_disk(counts, soup.faces.size(), complaint);
  complaint.throw_if_any(CGAL::Surface_mesh_parameterization::ERROR_NO_TOPOLOGICAL_DISC);
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SOUP_CHECK_SOUP_H
