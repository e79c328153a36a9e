// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_FUZZ_CHECK_MAP_H
#define CGAL_EXT_FUZZ_CHECK_MAP_H

#include <CGAL_ext/Square_parameterization/internal/soup/Surface_soup.h>
#include <CGAL_ext/Square_parameterization/parameterize_onto_square.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

// What must hold for every surface that is mapped: else these throw.

typedef CGAL::Exact_predicates_inexact_constructions_kernel Fuzz_kernel;
typedef CGAL::Surface_mesh<Fuzz_kernel::Point_3> Fuzz_mesh;
typedef Fuzz_mesh::Property_map<Fuzz_mesh::Vertex_index, Fuzz_kernel::Point_2> Fuzz_uv_map;

/// throws a sentence unless the condition holds
inline void demand(bool condition, const std::string& sentence)
{
  if(!condition)
    throw std::logic_error(sentence);
}

/// the mesh of conditioned triangles
inline Fuzz_mesh mesh_of(const CGAL_ext::internal::Surface_soup& soup)
{
  const auto vertex = [](std::size_t v) { return Fuzz_mesh::Vertex_index(static_cast<Fuzz_mesh::size_type>(v)); };
  Fuzz_mesh mesh;
  for(const Eigen::Vector3d& p : soup.points)
    mesh.add_vertex(Fuzz_kernel::Point_3(p.x(), p.y(), p.z()));
  for(const auto& face : soup.faces)
    demand(mesh.add_face(vertex(face[0]), vertex(face[1]), vertex(face[2])) != Fuzz_mesh::null_face(),
           "a conditioned soup is no mesh");
  return mesh;
}

/// throws unless the mesh has one border and Euler characteristic 1
inline void check_disk(const Fuzz_mesh& mesh)
{
  std::set<Fuzz_mesh::Halfedge_index> border;
  for(Fuzz_mesh::Halfedge_index h : mesh.halfedges())
    if(mesh.is_border(h))
      border.insert(h);
  demand(!border.empty(), "the cut surface has no border");
  const auto first = *border.begin();
  auto h = first;
  do
    border.erase(h);
  while((h = mesh.next(h)) != first);
  demand(border.empty(), "the cut surface has several borders");
  demand(mesh.number_of_vertices() + mesh.number_of_faces() == mesh.number_of_edges() + 1,
         "the cut surface is no disk");
}

/// throws unless the cut surface is the uncut one with vertices copied and edges split, as the report says, and no
/// given seam is left in one piece
inline void check_cut(const Fuzz_mesh& uncut, const std::vector<Fuzz_mesh::Edge_index>& seams, const Fuzz_mesh& cut,
                      const CGAL_ext::Square_map_result<Fuzz_mesh>& result)
{
  typedef Fuzz_mesh::Vertex_index Vertex;
  const std::size_t splits = result.border_edges_split + result.chords_split;
  demand(cut.number_of_vertices() == uncut.number_of_vertices() + result.copies.size() + splits,
         "the number of vertices does not fit the report");
  for(Vertex v : uncut.vertices())
    demand(cut.point(v) == uncut.point(v), "a vertex has moved");
  std::map<Vertex, Vertex> originals;
  for(const auto& [copy, original] : result.copies) {
    demand(cut.point(copy) == uncut.point(original), "a copied vertex is elsewhere");
    originals[copy] = original;
  }
  const auto original = [&](Vertex v) { return originals.count(v) != 0 ? originals[v] : v; };
  std::set<std::pair<Vertex, Vertex>> inside; // edges of the uncut surface that are still no border
  for(Fuzz_mesh::Edge_index e : cut.edges())
    if(!cut.is_border(e))
      inside.insert(std::minmax({original(cut.vertex(e, 0)), original(cut.vertex(e, 1))}));
  for(Fuzz_mesh::Edge_index seam : seams)
    demand(inside.count(std::minmax({uncut.vertex(seam, 0), uncut.vertex(seam, 1)})) == 0, "a seam is not cut");
}

/// throws unless the map is onto the unit square and without flips, by exact predicates, and the report fits it
inline void check_one_to_one(const Fuzz_mesh& mesh, Fuzz_uv_map uv,
                             const CGAL_ext::Square_map_result<Fuzz_mesh>& result)
{
  for(Fuzz_mesh::Face_index f : mesh.faces()) {
    const auto h = mesh.halfedge(f);
    demand(CGAL::orientation(uv[mesh.source(h)], uv[mesh.target(h)], uv[mesh.target(mesh.next(h))]) == CGAL::LEFT_TURN,
           "face " + std::to_string(f.idx()) + " is flipped or flat");
  }
  for(Fuzz_mesh::Vertex_index v : mesh.vertices()) {
    const double x = uv[v].x(), y = uv[v].y();
    demand(x >= 0 && x <= 1 && y >= 0 && y <= 1, "vertex " + std::to_string(v.idx()) + " is off the square");
    demand(!mesh.is_border(v) || x == 0 || x == 1 || y == 0 || y == 1,
           "vertex " + std::to_string(v.idx()) + " is off the border");
  }
  demand(result.corners.size() == 4, "there are not four corners");
  for(int k = 0; k < 4; ++k)
    demand(uv[result.corners[k]] == Fuzz_kernel::Point_2(k == 1 || k == 2, k >= 2), "a corner is not at a corner");
  demand(result.measures.flipped_faces == 0 && result.measures.l2 >= 1 - 1e-9 && std::isfinite(result.measures.l2) &&
             std::isfinite(result.search.best_objective),
         "the report does not fit the map");
}

#endif // CGAL_EXT_FUZZ_CHECK_MAP_H
