// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CONDITION_SOUP_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CONDITION_SOUP_H

#include <CGAL_ext/Square_parameterization/internal/Surface_soup.h>
#include <CGAL_ext/Square_parameterization/internal/Unmappable.h>

#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace CGAL_ext {
namespace internal {

/// what `condition_soup()` changed
struct Conditioning_report
{
  std::size_t vertices_dropped = 0;   ///< isolated vertices
  std::size_t faces_reoriented = 0;   ///< faces that were turned round
  std::vector<std::size_t> new_index; ///< per vertex of the input; `DROPPED` for an isolated one

  static constexpr std::size_t DROPPED = static_cast<std::size_t>(-1);
};

/// gathers what is wrong with a surface into one sentence that names numbers and first places
class Complaint
{
public:
  /// adds a sentence
  void say(const std::string& text) { m_text += (m_text.empty() ? "" : "; ") + text; }

  /// adds `count` things, none for 0, of which `places` are the first few
  void add(std::size_t count, const std::string& singular, const std::string& plural,
           const std::vector<std::string>& places = {})
  {
    if(count == 0)
      return;
    std::string text = std::to_string(count) + " " + (count == 1 ? singular : plural);
    for(std::size_t i = 0; i < places.size(); ++i)
      text += (i == 0 ? " (" : ", ") + places[i];
    if(!places.empty())
      text += count > places.size() ? ", ...)" : ")";
    say(text);
  }

  void throw_if_any(CGAL::Surface_mesh_parameterization::Error_code code) const
  {
    if(!m_text.empty())
      throw Unmappable(code, "the surface cannot be mapped: " + m_text);
  }

private:
  std::string m_text;
};

constexpr std::size_t NAMED_PLACES = 3; // as many places are named in a message

/// refuses faces that are not triangles or repeat a vertex, and edges with more than two faces
inline void check_triangles_and_edges(const Surface_soup& soup)
{
  namespace SMP = CGAL::Surface_mesh_parameterization;
  if(soup.faces.empty())
    throw Unmappable(SMP::ERROR_EMPTY_MESH, "the surface cannot be mapped: it has no faces");
  Complaint complaint;
  std::vector<std::string> polygons, repeating;
  std::size_t number_of_polygons = 0, number_of_repeating = 0;
  for(std::size_t f = 0; f < soup.faces.size(); ++f) {
    const auto& face = soup.faces[f];
    if(face.size() != 3 && ++number_of_polygons <= NAMED_PLACES)
      polygons.push_back("face " + std::to_string(f) + " has " + std::to_string(face.size()) + " vertices");
    if(std::set<std::size_t>(face.begin(), face.end()).size() < face.size() && ++number_of_repeating <= NAMED_PLACES)
      repeating.push_back("face " + std::to_string(f));
  }
  complaint.add(number_of_polygons, "non-triangular face", "non-triangular faces", polygons);
  complaint.add(number_of_repeating, "face that repeats a vertex", "faces that repeat a vertex", repeating);
  complaint.throw_if_any(SMP::ERROR_NON_TRIANGULAR_MESH);

  std::size_t number_of_edges = 0;
  std::vector<std::string> edges;
  for_each_edge(sides_by_edge(soup.faces), [&](auto begin, auto end) {
    if(end - begin > 2 && ++number_of_edges <= NAMED_PLACES)
      edges.push_back("vertices " + std::to_string(begin->low) + " and " + std::to_string(begin->high));
  });
  complaint.add(number_of_edges, "non-manifold edge", "non-manifold edges", edges);
  complaint.throw_if_any(SMP::ERROR_NO_TOPOLOGICAL_DISC);
}

/// turns faces round until neighbors agree, in each component as few as possible; returns how many it turned
inline std::size_t orient_faces(Surface_soup& soup)
{
  struct Neighbor
  {
    std::size_t face;
    bool is_opposed; ///< the two faces run through their edge in the same direction
  };
  std::vector<std::vector<Neighbor>> neighbors(soup.faces.size());
  for_each_edge(sides_by_edge(soup.faces), [&](auto begin, auto end) {
    if(end - begin != 2)
      return;
    const bool opposed = soup.faces[begin->face][begin->corner] == soup.faces[(begin + 1)->face][(begin + 1)->corner];
    neighbors[begin->face].push_back({(begin + 1)->face, opposed});
    neighbors[(begin + 1)->face].push_back({begin->face, opposed});
  });
  enum class Turn : char
  {
    UNKNOWN,
    NO,
    YES
  };
  std::vector<Turn> turns(soup.faces.size(), Turn::UNKNOWN);
  std::size_t turned = 0;
  for(std::size_t seed = 0; seed < soup.faces.size(); ++seed) {
    if(turns[seed] != Turn::UNKNOWN)
      continue;
    std::vector<std::size_t> component{seed};
    turns[seed] = Turn::NO;
    std::size_t to_turn = 0;
    for(std::size_t i = 0; i < component.size(); ++i)
      for(const Neighbor& neighbor : neighbors[component[i]]) {
        const bool turn = (turns[component[i]] == Turn::YES) != neighbor.is_opposed;
        Turn& known = turns[neighbor.face];
        if(known == Turn::UNKNOWN) {
          known = turn ? Turn::YES : Turn::NO;
          to_turn += turn ? 1 : 0;
          component.push_back(neighbor.face);
        } else if((known == Turn::YES) != turn)
          throw Unmappable(CGAL::Surface_mesh_parameterization::ERROR_NO_TOPOLOGICAL_DISC,
                           "the surface cannot be mapped: it is not orientable (faces " + std::to_string(component[i]) +
                               " and " + std::to_string(neighbor.face) + " disagree)");
      }
    const Turn side_to_turn = 2 * to_turn > component.size() ? Turn::NO : Turn::YES;
    for(std::size_t f : component)
      if(turns[f] == side_to_turn) {
        std::reverse(soup.faces[f].begin(), soup.faces[f].end());
        ++turned;
      }
  }
  return turned;
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
  Disjoint_sets components(V), corners(3 * F), loops(V);
  const auto next = [](int corner) { return (corner + 1) % 3; };
  std::vector<bool> is_used(V, false), is_on_border(V, false);
  std::size_t E = 0;
  for_each_edge(sides_by_edge(soup.faces), [&](auto begin, auto end) {
    ++E;
    components.unite(begin->low, begin->high);
    is_used[begin->low] = is_used[begin->high] = true;
    if(end - begin == 2) { // oriented: where one face begins the edge the other ends it
      const auto& [f, g] = std::make_pair(*begin, *(begin + 1));
      corners.unite(3 * f.face + f.corner, 3 * g.face + next(g.corner));
      corners.unite(3 * f.face + next(f.corner), 3 * g.face + g.corner);
    } else {
      loops.unite(begin->low, begin->high);
      is_on_border[begin->low] = is_on_border[begin->high] = true;
    }
  });
  std::vector<int> fans(V, 0);
  for(std::size_t f = 0; f < F; ++f)
    for(int k = 0; k < 3; ++k)
      if(corners.find(3 * f + k) == 3 * f + k)
        ++fans[soup.faces[f][k]];

  std::size_t used = 0, number_of_components = 0, borders = 0, pinched = 0;
  std::vector<std::string> pinched_places;
  for(std::size_t v = 0; v < V; ++v) {
    used += is_used[v] ? 1 : 0;
    number_of_components += is_used[v] && components.find(v) == v ? 1 : 0;
    borders += is_on_border[v] && loops.find(v) == v ? 1 : 0;
    if(fans[v] > 1 && ++pinched <= NAMED_PLACES)
      pinched_places.push_back("vertex " + std::to_string(v));
  }
  Complaint complaint;
  complaint.add(pinched, "non-manifold vertex", "non-manifold vertices", pinched_places);
  if(number_of_components > 1)
    complaint.say(std::to_string(number_of_components) + " connected components");
  if(topology == Topology::DISK && pinched == 0 && number_of_components == 1) {
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

/// drops the vertices of no face; the others keep their order
inline void drop_isolated_vertices(Surface_soup& soup, Conditioning_report& report)
{
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
}

/// makes a soup one connected, manifold, oriented triangle surface by turning faces round and dropping isolated
/// vertices, or throws `Unmappable` with a sentence that counts what is wrong and names the first places.
/// \pre every index of a face is that of a point, every coordinate is finite
inline Conditioning_report condition_soup(Surface_soup& soup, Topology topology = Topology::DISK)
{
  Conditioning_report report;
  check_triangles_and_edges(soup);
  report.faces_reoriented = orient_faces(soup);
  check_topology(soup, topology);
  drop_isolated_vertices(soup, report);
  return report;
}

} // namespace internal
} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CONDITION_SOUP_H
