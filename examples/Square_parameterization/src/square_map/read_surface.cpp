// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../../include/square_map/read_surface.h"

#include <CGAL_ext/Square_parameterization/internal/common/Unmappable.h>
#include <CGAL_ext/Square_parameterization/internal/common/ranges.h>
#include <CGAL_ext/Square_parameterization/internal/patch/number_edges.h>
#include <CGAL_ext/Square_parameterization/internal/surface/halfedge_between.h>

namespace square_map {

namespace {

/// joins the halfedges of a face
void join_face(const CGAL_ext::internal::Edge_numbering& numbering, const std::array<int, 3>& triangle, std::size_t f,
               Mesh& mesh)
{
  const Mesh::Face_index face(static_cast<Mesh::size_type>(f));
  std::array<Mesh::Halfedge_index, 3> sides; // side k ends at corner k
  for(std::size_t k = 0; k < 3; ++k) {
    const Mesh::Edge_index edge(static_cast<Mesh::size_type>(numbering.triangle_edges[f][(k + 1) % 3]));
    sides[k] = mesh.halfedge(edge, triangle[(k + 2) % 3] < triangle[k] ? 0 : 1);
    mesh.set_face(sides[k], face);
  }
  for(std::size_t k = 0; k < 3; ++k)
    mesh.set_next(sides[k], sides[(k + 1) % 3]);
  mesh.set_halfedge(face, sides[0]);
}

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
  using CGAL_ext::internal::for_ranges;
  std::vector<std::array<int, 3>> triangles;
  triangles.reserve(soup.faces.size());
  for(const auto& face : soup.faces)
    triangles.push_back({static_cast<int>(face[0]), static_cast<int>(face[1]), static_cast<int>(face[2])});
  const CGAL_ext::internal::Edge_numbering numbering = CGAL_ext::internal::number_edges(soup.points.size(), triangles);

  Mesh mesh; // made of a given size by a member that CGAL's manual does not have, for several threads to fill
  mesh.resize(static_cast<Mesh::size_type>(soup.points.size()), static_cast<Mesh::size_type>(numbering.edges.size()),
              static_cast<Mesh::size_type>(triangles.size()));
  for_ranges(soup.points.size(), [&](std::size_t begin, std::size_t end) {
    for(std::size_t v = begin; v < end; ++v) {
      const Eigen::Vector3d& p = soup.points[v];
      mesh.point(vertex(v)) = Kernel::Point_3(p.x(), p.y(), p.z());
    }
  });
  for_ranges(numbering.edges.size(), [&](std::size_t begin, std::size_t end) {
    for(std::size_t e = begin; e < end; ++e) {
      const Mesh::Edge_index edge(static_cast<Mesh::size_type>(e));
      for(int k = 0; k < 2; ++k)
        mesh.set_target(mesh.halfedge(edge, k), vertex(numbering.edges[e][1 - k]));
    }
  });
  for_ranges(triangles.size(), [&](std::size_t begin, std::size_t end) {
    for(std::size_t f = begin; f < end; ++f)
      join_face(numbering, triangles[f], f, mesh);
  });
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
