// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_CUT_FACE_GRAPH_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_CUT_FACE_GRAPH_H

#include <CGAL_ext/Square_parameterization/Square_map_options.h>
#include <CGAL_ext/Square_parameterization/internal/cut/cut_to_disk.h>
#include <CGAL_ext/Square_parameterization/internal/cut/open_seams.h>
#include <CGAL_ext/Square_parameterization/internal/surface/Face_graph_surface.h>

#include <array>
#include <iterator>
#include <string>
#include <variant>
#include <vector>

namespace CGAL_ext {
namespace internal {

/// the border halfedge whose source comes first among the border vertices, in the order of the mesh
template <class TriangleMesh>
typename boost::graph_traits<TriangleMesh>::halfedge_descriptor first_border_halfedge(const TriangleMesh& mesh)
{
  for(auto v : vertices(mesh)) {
    if(halfedge(v, mesh) == boost::graph_traits<TriangleMesh>::null_halfedge())
      continue; // isolated
    for(auto h : CGAL::halfedges_around_source(v, mesh))
      if(CGAL::is_border(h, mesh))
        return h;
  }
  return boost::graph_traits<TriangleMesh>::null_halfedge();
}

/// indicates whether a connected mesh of triangles has one border and Euler characteristic 1; of other meshes the
/// answer says nothing
template <class TriangleMesh>
bool is_disk(const TriangleMesh& mesh)
{
  const auto bhd = first_border_halfedge(mesh);
  if(bhd == boost::graph_traits<TriangleMesh>::null_halfedge())
    return false;
  long twice_euler = 0; // V - E + F where E = (3 F + B) / 2
  for(auto v : vertices(mesh))
    twice_euler += halfedge(v, mesh) != boost::graph_traits<TriangleMesh>::null_halfedge() ? 2 : 0;
  twice_euler -= std::distance(faces(mesh).begin(), faces(mesh).end());
  long border_edges = 0;
  for(auto h : halfedges(mesh))
    border_edges += CGAL::is_border(h, mesh) ? 1 : 0;
  twice_euler -= border_edges;
  return twice_euler == 2 && static_cast<long>(border_loop(bhd, mesh).size()) == border_edges;
}

/// seams given by places in the order of the mesh, as vertices of the surface
template <class TriangleMesh>
std::vector<std::array<int, 2>> surface_seams(const Face_graph_surface<TriangleMesh>& disk,
                                              const std::vector<std::array<std::size_t, 2>>& given)
{
  std::vector<std::array<int, 2>> seams;
  for(const auto& ends : given) {
    for(std::size_t v : ends)
      if(v >= disk.new_index.size() || disk.new_index[v] == Conditioning_report::DROPPED)
        refuse_seam(ends[0], ends[1]);
    seams.push_back({static_cast<int>(disk.new_index[ends[0]]), static_cast<int>(disk.new_index[ends[1]])});
  }
  return seams;
}

/// cuts the mesh to a disk. Returns the vertices added, with their originals.
template <class TriangleMesh, class VertexPointMap>
auto cut_mesh(TriangleMesh& mesh, VertexPointMap vpm, const Square_map_options& options, Cut_report& report)
{
  const auto disk = make_face_graph_surface(mesh, vpm);
  Cut_options cut_options = options.cut;
  cut_options.number_of_threads = options.search_options.number_of_threads;
  if(const auto* balanced = std::get_if<Balanced_minimization>(&options.minimization))
    cut_options.balance = balanced->balance;
  const Cut cut = cut_to_disk(disk.surface, surface_seams(disk, options.seams), cut_options, report);
  std::vector<typename boost::graph_traits<TriangleMesh>::edge_descriptor> seams;
  for(int e : cut.edges())
    seams.push_back(disk.edge_of(e, mesh));
  return open_seams(mesh, seams, vpm);
}

} // namespace internal
} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_CUT_FACE_GRAPH_H
