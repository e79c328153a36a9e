// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../../include/square_map/read_surface.h"

#include <CGAL_ext/Square_parameterization/internal/common/Unmappable.h>
#include <CGAL_ext/Square_parameterization/internal/patch/number_edges.h>
#include <CGAL_ext/Square_parameterization/internal/surface/halfedge_between.h>

namespace square_map {

namespace {

/// joins the halfedges without a face, of which at most one ends at each vertex, and gives each vertex one that ends there:
/// one without a face where there is one
void join_borders(Mesh& mesh)
{
  std::vector<Mesh::Halfedge_index> leaving(mesh.number_of_vertices(), Mesh::null_halfedge());
  for(const Mesh::Halfedge_index h : mesh.halfedges()) {
    if(mesh.is_border(h))
      leaving[mesh.source(h)] = h;
    else
      mesh.set_halfedge(mesh.target(h), h);
  }
  for(const Mesh::Halfedge_index h : leaving)
    if(h != Mesh::null_halfedge()) {
      mesh.set_next(h, leaving[mesh.target(h)]);
      mesh.set_halfedge(mesh.target(h), h);
    }
}

} // namespace

Mesh make_mesh(const CGAL_ext::internal::Surface_soup& soup)
{
  std::vector<std::array<int, 3>> triangles;
  for(const auto& face : soup.faces)
    triangles.push_back({static_cast<int>(face[0]), static_cast<int>(face[1]), static_cast<int>(face[2])});
  const CGAL_ext::internal::Edge_numbering numbering = CGAL_ext::internal::number_edges(soup.points.size(), triangles);

  Mesh mesh;
  mesh.reserve(static_cast<Mesh::size_type>(soup.points.size()), static_cast<Mesh::size_type>(numbering.edges.size()),
               static_cast<Mesh::size_type>(triangles.size()));
  for(const Eigen::Vector3d& p : soup.points)
    mesh.add_vertex(Kernel::Point_3(p.x(), p.y(), p.z()));
  for(const auto& [low, high] : numbering.edges)
    mesh.add_edge(vertex(low), vertex(high));
  for(std::size_t f = 0; f < triangles.size(); ++f) {
    const Mesh::Face_index face = mesh.add_face();
    std::array<Mesh::Halfedge_index, 3> sides; // side k ends at corner k
    for(std::size_t k = 0; k < 3; ++k) {
      const Mesh::Edge_index edge(static_cast<Mesh::size_type>(numbering.triangle_edges[f][(k + 1) % 3]));
      sides[k] = mesh.halfedge(edge, triangles[f][(k + 2) % 3] < triangles[f][k] ? 0 : 1);
      mesh.set_face(sides[k], face);
    }
    for(std::size_t k = 0; k < 3; ++k)
      mesh.set_next(sides[k], sides[(k + 1) % 3]);
    mesh.set_halfedge(face, sides[0]);
  }
  join_borders(mesh);
  return mesh;
}

std::vector<Mesh::Edge_index> edges_of(const std::vector<File_seam>& seams, const Mesh& mesh, const std::string& path)
{
  std::vector<Mesh::Edge_index> edges;
  for(const auto& [ends, place] : seams) {
    const auto h = CGAL_ext::internal::halfedge_between(vertex(ends[0]), vertex(ends[1]), mesh);
    if(h == Mesh::null_halfedge())
      throw CGAL_ext::internal::Unmappable(CGAL::Surface_mesh_parameterization::ERROR_WRONG_PARAMETER,
                                           "'" + path + "', " + place + " is not an edge of the surface");
    edges.push_back(mesh.edge(h));
  }
  return edges;
}

std::array<Mesh::Vertex_index, 4> mesh_vertices(const std::array<std::size_t, 4>& file_vertices,
                                                const CGAL_ext::internal::Conditioning_report& conditioning)
{
  std::array<Mesh::Vertex_index, 4> result;
  for(std::size_t k = 0; k < 4; ++k)
    if(const std::size_t v = conditioned_vertex(file_vertices[k], conditioning);
       v != CGAL_ext::internal::Conditioning_report::DROPPED)
      result[k] = vertex(v);
  return result;
}

} // namespace square_map
