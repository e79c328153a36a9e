// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_FUZZ_MAP_SOUP_H
#define CGAL_EXT_FUZZ_MAP_SOUP_H

#include "Choices_of_bytes.h"
#include "check_map.h"

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

/// what became of a surface
enum class Outcome
{
  REFUSED,   ///< by the conditioning or the cut
  UNMAPPED,  ///< no one-to-one map was found
  ONE_TO_ONE ///< and checked
};

struct Mapped_soup
{
  Outcome outcome;
  std::string message;                   ///< why there is no map
  CGAL_ext::Stretch_measures measures{}; ///< of the map
  CGAL_ext::Map_start start{};           ///< where it began
  bool has_shortest_cut = false;         ///< instead of the one that was decided on
};

/// some edges of the mesh
inline std::vector<Fuzz_mesh::Edge_index> seams_at(const std::array<int, 4>& places, const Fuzz_mesh& mesh)
{
  std::vector<Fuzz_mesh::Edge_index> seams;
  for(int place : places) {
    seams.push_back(mesh.edge(mesh.halfedge(Fuzz_mesh::Face_index(place % mesh.number_of_faces()))));
  }
  return seams;
}

/// four vertices of one border, counter-clockwise; none when the places are not four. Of a closed surface any four,
/// which the cut may put on the border, and one of them several times.
inline std::optional<std::array<Fuzz_mesh::Vertex_index, 4>> corners_at(const std::array<int, 4>& places,
                                                                        const Fuzz_mesh& mesh)
{
  std::array<Fuzz_mesh::Vertex_index, 4> corners{};
  std::vector<Fuzz_mesh::Vertex_index> loop;
  for(Fuzz_mesh::Halfedge_index first : mesh.halfedges())
    if(mesh.is_border(first)) {
      // a border halfedge has the surface on its right: backward is counter-clockwise
      for(auto h = first; loop.empty() || h != first; h = mesh.prev(h))
        loop.push_back(mesh.target(h));
      break;
    }
  if(loop.empty()) {
    std::transform(places.begin(), places.end(), corners.begin(),
                   [&mesh](int place) { return Fuzz_mesh::Vertex_index(place % mesh.number_of_vertices()); });
    return corners;
  }
  std::set<std::size_t> positions;
  for(int place : places)
    positions.insert(place % loop.size());
  if(positions.size() < 4)
    return {};
  std::transform(positions.begin(), positions.end(), corners.begin(), [&loop](std::size_t k) { return loop[k]; });
  return corners;
}

/// takes a soup through conditioning, cut, search and minimization. Throws when a map, or the surface that is mapped, is
/// not what it should be.
inline Mapped_soup map_soup(CGAL_ext::internal::Surface_soup soup, const Choices_of_bytes& choices)
{
  using namespace CGAL_ext::internal;
  if(!std::all_of(soup.points.begin(), soup.points.end(), [](const auto& p) { return p.allFinite(); }))
    return {Outcome::REFUSED, "not all coordinates are finite"}; // as the readers do
  try {
    condition_soup(soup, choices.conditioning_options);
  } catch(const Unmappable& error) {
    return {Outcome::REFUSED, error.what()};
  }
  const Fuzz_mesh uncut = mesh_of(soup);
  CGAL_ext::Square_map_options<Fuzz_mesh> options = choices.options;
  if(choices.has_seams)
    options.seams = seams_at(choices.places, uncut);
  if(choices.has_corners)
    options.corners = corners_at(choices.places, uncut);
  Fuzz_mesh mesh = uncut;
  Fuzz_uv_map uv = mesh.add_property_map<Fuzz_mesh::Vertex_index, Fuzz_kernel::Point_2>("uv").first;
  const auto result = CGAL_ext::parameterize_onto_square(mesh, uv, CGAL_ext::parameters::options(options));
  namespace SMP = CGAL::Surface_mesh_parameterization;
  if(result.status == SMP::ERROR_BORDER_TOO_SHORT || result.status == SMP::ERROR_NO_1_TO_1_MAPPING)
    return {result.search.evaluations == 0 ? Outcome::REFUSED : Outcome::UNMAPPED, result.message};
  if((result.status == SMP::ERROR_NO_TOPOLOGICAL_DISC && choices.has_seams) || // seams that separate the surface
     (result.status == SMP::ERROR_WRONG_PARAMETER && choices.has_corners))     // a cut may have changed their order
    return {Outcome::REFUSED, result.message};
  if(result.status != SMP::OK)
    throw std::logic_error("a conditioned surface is refused: " + result.message);
  check_disk(mesh);
  check_cut(uncut, options.seams, mesh, result);
  check_one_to_one(mesh, uv, result);
  check_border_walk(mesh, uv, result.corners[0]);
  check_stretch(mesh, uv, result.measures);
  return {Outcome::ONE_TO_ONE, "", result.measures, result.start, result.cut.is_replaced};
}

#endif // CGAL_EXT_FUZZ_MAP_SOUP_H
