// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_FUZZ_MAP_BYTES_H
#define CGAL_EXT_FUZZ_MAP_BYTES_H

#include "Soup_of_bytes.h"

#include <CGAL_ext/Square_parameterization/Bracketing_corner_search.h>
#include <CGAL_ext/Square_parameterization/internal/condition_soup.h>
#include <CGAL_ext/Square_parameterization/internal/cut_soup.h>
#include <CGAL_ext/Square_parameterization/parameterize_onto_square.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <stdexcept>
#include <string>

/// what became of a mesh
enum class Outcome
{
  REFUSED,   ///< by the conditioning or the cut
  UNMAPPED,  ///< no one-to-one map was found
  ONE_TO_ONE ///< and checked
};

typedef CGAL::Exact_predicates_inexact_constructions_kernel Fuzz_kernel;
typedef CGAL::Surface_mesh<Fuzz_kernel::Point_3> Fuzz_mesh;
typedef Fuzz_mesh::Property_map<Fuzz_mesh::Vertex_index, Fuzz_kernel::Point_2> Fuzz_uv_map;

/// throws unless the map is onto the unit square and without flips, by exact predicates
inline void check_one_to_one(const Fuzz_mesh& mesh, Fuzz_uv_map uv,
                             const CGAL_ext::Square_map_result<Fuzz_mesh>& result)
{
  for(Fuzz_mesh::Face_index f : mesh.faces()) {
    const auto h = mesh.halfedge(f);
    if(CGAL::orientation(uv[mesh.source(h)], uv[mesh.target(h)], uv[mesh.target(mesh.next(h))]) != CGAL::LEFT_TURN)
      throw std::logic_error("face " + std::to_string(f.idx()) + " is flipped or flat");
  }
  for(Fuzz_mesh::Vertex_index v : mesh.vertices()) {
    const double x = uv[v].x(), y = uv[v].y();
    if(!(x >= 0 && x <= 1 && y >= 0 && y <= 1) || (mesh.is_border(v) && x != 0 && x != 1 && y != 0 && y != 1))
      throw std::logic_error("vertex " + std::to_string(v.idx()) + " is off the square, or off its border");
  }
  if(result.corners.size() != 4 || result.measures.flipped_faces != 0 || !(result.measures.l2 >= 1 - 1e-9) ||
     !std::isfinite(result.measures.l2))
    throw std::logic_error("the report does not fit the map");
}

/// what the bytes choose
inline CGAL_ext::Square_map_options options_of(Byte_source& bytes)
{
  CGAL_ext::Square_map_options options;
  options.search_options.number_of_threads = 1;
  const int choice = bytes.next();
  if(choice % 2 == 1) {
    options.balanced = CGAL_ext::Balanced_minimization();
    options.balanced->balance = (choice / 2 % 4) / 3.;
    options.balanced->border = choice / 8 % 2 == 1 ? CGAL_ext::Border_motion::SLIDING : CGAL_ext::Border_motion::FIXED;
  }
  if(choice / 16 % 2 == 1)
    options.search = CGAL_ext::Bracketing_corner_search();
  return options;
}

/// builds a mesh from bytes and takes it through conditioning, cut, search and minimization. Throws when a map is not
/// what it should be.
inline Outcome map_bytes(const std::uint8_t* data, std::size_t size)
{
  using namespace CGAL_ext::internal;
  Byte_source bytes(data, size);
  const CGAL_ext::Square_map_options options = options_of(bytes);
  CGAL_ext::Cut_options cut_options;
  cut_options.mode = bytes.next() % 4 == 0 ? CGAL_ext::Cut_mode::BEST : CGAL_ext::Cut_mode::SHORTEST;
  Surface_soup soup = Soup_of_bytes(bytes).soup();
  try {
    condition_soup(soup, {Topology::CONNECTED, 0, false});
    CGAL_ext::Cut_report report;
    cut_soup(soup, {}, cut_options, report);
  } catch(const Unmappable&) {
    return Outcome::REFUSED;
  }
  Fuzz_mesh mesh;
  for(const Eigen::Vector3d& p : soup.points)
    mesh.add_vertex(Fuzz_kernel::Point_3(p.x(), p.y(), p.z()));
  for(const auto& face : soup.faces)
    if(mesh.add_face(Fuzz_mesh::Vertex_index(face[0]), Fuzz_mesh::Vertex_index(face[1]),
                     Fuzz_mesh::Vertex_index(face[2])) == Fuzz_mesh::null_face())
      throw std::logic_error("a conditioned soup is no mesh");
  Fuzz_uv_map uv = mesh.add_property_map<Fuzz_mesh::Vertex_index, Fuzz_kernel::Point_2>("uv").first;
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
