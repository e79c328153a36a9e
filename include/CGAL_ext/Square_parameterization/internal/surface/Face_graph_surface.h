// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SURFACE_FACE_GRAPH_SURFACE_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SURFACE_FACE_GRAPH_SURFACE_H

#include <CGAL_ext/Square_parameterization/internal/patch/Face_graph_patch.h>
#include <CGAL_ext/Square_parameterization/internal/soup/condition_soup.h>
#include <CGAL_ext/Square_parameterization/internal/surface/surface_of_soup.h>

#include <array>
#include <string>
#include <unordered_map>
#include <vector>

namespace CGAL_ext {
namespace internal {

/// a surface and the mesh elements that its own stand for
template <class TriangleMesh>
struct Face_graph_surface
{
  typedef typename boost::graph_traits<TriangleMesh>::vertex_descriptor vertex_descriptor;
  typedef typename boost::graph_traits<TriangleMesh>::halfedge_descriptor halfedge_descriptor;
  typedef typename boost::graph_traits<TriangleMesh>::edge_descriptor edge_descriptor;

  Triangle_surface surface;
  std::vector<vertex_descriptor> vertices;    ///< #V, in the order of the mesh; without isolated ones
  std::vector<std::size_t> new_index;         ///< per vertex of the mesh; `Conditioning_report::DROPPED` when isolated
  std::vector<halfedge_descriptor> halfedges; ///< 3 #F

  /// the edge of the mesh that edge \p e of the surface stands for
  edge_descriptor edge_of(int e, const TriangleMesh& mesh) const
  {
    return edge(halfedges[surface.edge_halfedges[e]], mesh);
  }
};

/// refuses a mesh without faces, with polygons, or of several components
template <class TriangleMesh>
void check_connected_triangles(const TriangleMesh& mesh)
{
  namespace SMP = CGAL::Surface_mesh_parameterization;
  if(faces(mesh).begin() == faces(mesh).end())
    throw Unmappable(SMP::ERROR_EMPTY_MESH, "the surface has no faces");
  std::size_t number_of_faces = 0, polygons = 0;
  for(auto f : faces(mesh)) {
    ++number_of_faces;
    if(!CGAL::is_triangle(halfedge(f, mesh), mesh))
      ++polygons;
  }
  if(polygons > 0)
    throw Unmappable(SMP::ERROR_NON_TRIANGULAR_MESH, std::to_string(polygons) + " faces are not triangles");
  if(faces_of_component(*faces(mesh).begin(), mesh).size() < number_of_faces)
    throw Unmappable(SMP::ERROR_NO_TOPOLOGICAL_DISC, "the surface has more than one connected component");
}

/// makes a surface of a mesh; faces keep their order. Coordinates are read as `double`, and scaled so that no square
/// overflows.
///
/// Throws `Unmappable` when the mesh is not one connected manifold triangle surface, when a coordinate is not finite,
/// and when no face has an area. Messages count vertices in the order of the mesh.
template <class TriangleMesh, class VertexPointMap>
Face_graph_surface<TriangleMesh> make_face_graph_surface(const TriangleMesh& mesh, VertexPointMap vpm)
{
  check_connected_triangles(mesh);
  Face_graph_surface<TriangleMesh> result;
  Surface_soup soup;
  std::unordered_map<typename Face_graph_surface<TriangleMesh>::vertex_descriptor, std::size_t> index;
  for(auto v : vertices(mesh)) {
    index.emplace(v, soup.points.size());
    soup.points.push_back(point_of(vpm, v));
  }
  for(auto f : faces(mesh)) {
    soup.faces.emplace_back();
    for(auto h : CGAL::halfedges_around_face(halfedge(f, mesh), mesh)) {
      soup.faces.back().push_back(index.at(source(h, mesh)));
      result.halfedges.push_back(h);
    }
  }
  Conditioning_options options;
  options.topology = Topology::CONNECTED;
  result.new_index = condition_soup(soup, options).new_index;
  std::size_t v = 0;
  for(auto vertex : vertices(mesh))
    if(result.new_index[v++] != Conditioning_report::DROPPED)
      result.vertices.push_back(vertex);
  result.surface = surface_of_soup(soup);
  return result;
}

} // namespace internal
} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SURFACE_FACE_GRAPH_SURFACE_H
