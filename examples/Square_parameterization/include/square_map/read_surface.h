// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_READ_SURFACE_H
#define SQUARE_MAP_READ_SURFACE_H

#include <CGAL_ext/Square_parameterization/internal/patch/number_edges.h>
#include <CGAL_ext/Square_parameterization/internal/soup/condition_soup.h>
#include <CGAL_ext/Square_parameterization/internal/surface/halfedge_between.h>

#include "read_seams.h"
#include "read_soup.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace square_map {

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

/// the vertex of a mesh with a number
inline Mesh::Vertex_index vertex(std::size_t v)
{
  return Mesh::Vertex_index(static_cast<Mesh::size_type>(v));
}

/// joins the halfedges without a face, of which at most one ends at each vertex, and gives each vertex one that ends there:
/// one without a face where there is one
inline void join_borders(Mesh& mesh)
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

/// the mesh of a conditioned soup; vertices and faces keep their order. Linear in the faces but for sorting the edges at each
/// vertex: to add face by face walks round vertices, and takes the square of their valence.
inline Mesh make_mesh(const CGAL_ext::internal::Surface_soup& soup)
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

/// the edges of the mesh along the seams of a file. Throws `Unmappable` where there is none.
inline std::vector<Mesh::Edge_index> edges_of(const std::vector<File_seam>& seams, const Mesh& mesh,
                                              const std::string& path)
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

/// the vertices of the mesh that vertices of the file have become; none of its own for one that was dropped
inline std::array<Mesh::Vertex_index, 4> mesh_vertices(const std::array<std::size_t, 4>& file_vertices,
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

#endif // SQUARE_MAP_READ_SURFACE_H
