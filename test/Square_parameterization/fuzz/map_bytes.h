// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_FUZZ_MAP_BYTES_H
#define CGAL_EXT_FUZZ_MAP_BYTES_H

#include "Choices_of_bytes.h"
#include "check_map.h"

#include <CGAL_ext/Square_parameterization/internal/cut_soup.h>

/// what became of a mesh
enum class Outcome
{
  REFUSED,   ///< by the conditioning or the cut
  UNMAPPED,  ///< no one-to-one map was found
  ONE_TO_ONE ///< and checked
};

/// some edges of the surface
inline std::vector<std::array<int, 2>> seams_at(const std::array<int, 4>& places,
                                                const CGAL_ext::internal::Surface_soup& soup)
{
  std::vector<std::array<int, 2>> seams;
  for(int place : places) {
    const auto& face = soup.faces[place % soup.faces.size()];
    seams.push_back({static_cast<int>(face[0]), static_cast<int>(face[1])});
  }
  return seams;
}

/// four border vertices, counter-clockwise; none when the places are not four
inline std::optional<std::array<std::size_t, 4>> corners_at(const std::array<int, 4>& places, const Fuzz_mesh& mesh)
{
  std::vector<std::size_t> loop;
  for(Fuzz_mesh::Halfedge_index first : mesh.halfedges())
    if(mesh.is_border(first)) {
      // a border halfedge has the surface on its right: backward is counter-clockwise
      for(auto h = first; loop.empty() || h != first; h = mesh.prev(h))
        loop.push_back(mesh.target(h).idx());
      break;
    }
  std::set<std::size_t> positions;
  for(int place : places)
    positions.insert(place % loop.size());
  if(positions.size() < 4)
    return {};
  std::array<std::size_t, 4> corners{};
  std::transform(positions.begin(), positions.end(), corners.begin(), [&loop](std::size_t k) { return loop[k]; });
  return corners;
}

/// builds a mesh from bytes and takes it through conditioning, cut, search and minimization. Throws when a map, or the
/// surface that is mapped, is not what it should be.
inline Outcome map_bytes(const std::uint8_t* data, std::size_t size)
{
  using namespace CGAL_ext::internal;
  Byte_source bytes(data, size);
  const Choices_of_bytes choices(bytes);
  Surface_soup soup = Soup_of_bytes(bytes).soup();
  if(!std::all_of(soup.points.begin(), soup.points.end(), [](const auto& p) { return p.allFinite(); }))
    return Outcome::REFUSED; // as the readers do
  try {
    condition_soup(soup, choices.conditioning_options);
    const Surface_soup uncut = soup;
    CGAL_ext::Cut_report report;
    const auto seams = choices.has_seams ? seams_at(choices.places, soup) : std::vector<std::array<int, 2>>();
    const std::vector<int> originals = cut_soup(soup, seams, choices.cut_options, report);
    check_cut(uncut, seams, soup, originals, report);
  } catch(const Unmappable&) {
    return Outcome::REFUSED;
  }
  Fuzz_mesh mesh = mesh_of_disk(soup);
  Fuzz_uv_map uv = mesh.add_property_map<Fuzz_mesh::Vertex_index, Fuzz_kernel::Point_2>("uv").first;
  CGAL_ext::Square_map_options options = choices.options;
  if(choices.has_corners)
    options.corners = corners_at(choices.places, mesh);
  const auto result = CGAL_ext::parameterize_onto_square(mesh, uv, CGAL_ext::parameters::options(options));
  namespace SMP = CGAL::Surface_mesh_parameterization;
  if(result.status == SMP::ERROR_BORDER_TOO_SHORT || result.status == SMP::ERROR_NO_1_TO_1_MAPPING)
    return result.search.evaluations == 0 ? Outcome::REFUSED : Outcome::UNMAPPED;
  if(result.status != SMP::OK)
    throw std::logic_error("a conditioned surface is refused: " + result.message);
  check_one_to_one(mesh, uv, result);
  return Outcome::ONE_TO_ONE;
}

#endif // CGAL_EXT_FUZZ_MAP_BYTES_H
