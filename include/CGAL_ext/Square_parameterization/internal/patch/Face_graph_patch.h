// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PATCH_FACE_GRAPH_PATCH_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PATCH_FACE_GRAPH_PATCH_H

#include <CGAL_ext/Square_parameterization/internal/patch/Patch.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace CGAL_ext {
namespace internal {

/// a patch and the mesh vertices that its vertices stand for
template <class TriangleMesh>
struct Face_graph_patch
{
  typedef typename boost::graph_traits<TriangleMesh>::vertex_descriptor vertex_descriptor;

  Patch patch;
  std::vector<vertex_descriptor> vertices; ///< #V
};

/// the faces of the connected component of \p seed, in the order of the mesh
template <class TriangleMesh>
std::vector<typename boost::graph_traits<TriangleMesh>::face_descriptor>
faces_of_component(typename boost::graph_traits<TriangleMesh>::face_descriptor seed, const TriangleMesh& mesh)
{
  typedef typename boost::graph_traits<TriangleMesh>::face_descriptor face_descriptor;
  std::unordered_set<face_descriptor> visited{seed};
  std::vector<face_descriptor> front{seed}, component;
  while(!front.empty()) {
    const face_descriptor f = front.back();
    front.pop_back();
    for(auto h : CGAL::halfedges_around_face(halfedge(f, mesh), mesh))
      if(!CGAL::is_border(opposite(h, mesh), mesh) && visited.insert(face(opposite(h, mesh), mesh)).second)
        front.push_back(face(opposite(h, mesh), mesh));
  }
  for(face_descriptor f : faces(mesh))
    if(visited.count(f) != 0)
      component.push_back(f);
  return component;
}

/// the border vertices met from source(\p bhd) on, counter-clockwise for someone who sees the faces so.
/// Border halfedges run the other way: the loop follows `prev()`.
template <class TriangleMesh>
std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor>
border_loop(typename boost::graph_traits<TriangleMesh>::halfedge_descriptor bhd, const TriangleMesh& mesh)
{
  std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor> loop;
  auto h = bhd;
  do {
    loop.push_back(source(h, mesh));
    h = prev(h, mesh);
  } while(h != bhd);
  return loop;
}

/// the position of \p v, read as `double`
template <class VertexPointMap, class Vertex>
Eigen::Vector3d point_of(VertexPointMap vpm, Vertex v)
{
  const auto& p = get(vpm, v);
  return {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())};
}

/// the lengths of the border edges along \p loop, which is the border of \p bhd, in units of the square root of the
/// area of the component; see `border_lengths()` for short ones. Polygons count as fans of triangles.
///
/// Throws `Unmappable` as `measured_patch()`. Complexity: linear.
template <class TriangleMesh, class VertexPointMap>
std::vector<double>
measured_border(const TriangleMesh& mesh, typename boost::graph_traits<TriangleMesh>::halfedge_descriptor bhd,
                const std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor>& loop,
                VertexPointMap vpm)
{
  typedef typename boost::graph_traits<TriangleMesh>::vertex_descriptor vertex_descriptor;
  std::unordered_map<vertex_descriptor, int> index;
  std::vector<Eigen::Vector3d> points;
  const auto index_of = [&](vertex_descriptor v) {
    const auto [found, is_new] = index.emplace(v, static_cast<int>(points.size()));
    if(is_new)
      points.push_back(point_of(vpm, v));
    return found->second;
  };
  std::vector<std::array<int, 3>> triangles;
  for(auto f : faces_of_component(face(opposite(bhd, mesh), mesh), mesh)) {
    const auto first = halfedge(f, mesh);
    for(auto h = next(first, mesh); next(h, mesh) != first; h = next(h, mesh))
      triangles.push_back({index_of(source(first, mesh)), index_of(source(h, mesh)), index_of(target(h, mesh))});
  }
  std::vector<int> border;
  for(vertex_descriptor v : loop)
    border.push_back(index_of(v));
  return measured_patch(std::move(points), std::move(triangles), std::move(border)).border_lengths;
}

/// makes a patch of the connected component of \p mesh at the border halfedge \p bhd; vertices and faces keep the order
/// of the mesh. The border starts at source(bhd). Coordinates are read as `double`.
///
/// Throws `Unmappable` when the component is not a triangulated disk, and as `make_patch()`.
template <class TriangleMesh, class VertexPointMap>
Face_graph_patch<TriangleMesh>
make_face_graph_patch(const TriangleMesh& mesh, typename boost::graph_traits<TriangleMesh>::halfedge_descriptor bhd,
                      VertexPointMap vpm)
{
  namespace SMP = CGAL::Surface_mesh_parameterization;
  typedef typename boost::graph_traits<TriangleMesh>::vertex_descriptor vertex_descriptor;

  if(bhd == boost::graph_traits<TriangleMesh>::null_halfedge() || !CGAL::is_border(bhd, mesh))
    throw Unmappable(SMP::ERROR_BORDER_TOO_SHORT, "the given halfedge is not on a border");
  const auto component = faces_of_component(face(opposite(bhd, mesh), mesh), mesh);

  Face_graph_patch<TriangleMesh> result;
  std::unordered_map<vertex_descriptor, int> index;
  std::size_t border_edges = 0;
  for(auto f : component) {
    int corners = 0;
    for(auto h : CGAL::halfedges_around_face(halfedge(f, mesh), mesh)) {
      index.emplace(target(h, mesh), 0);
      border_edges += CGAL::is_border(opposite(h, mesh), mesh) ? 1 : 0;
      ++corners;
    }
    if(corners != 3)
      throw Unmappable(SMP::ERROR_NON_TRIANGULAR_MESH, "a face has " + std::to_string(corners) + " vertices");
  }
  std::vector<Eigen::Vector3d> points;
  for(vertex_descriptor v : vertices(mesh)) {
    const auto found = index.find(v);
    if(found == index.end())
      continue;
    found->second = static_cast<int>(result.vertices.size());
    result.vertices.push_back(v);
    points.push_back(point_of(vpm, v));
  }
  std::vector<std::array<int, 3>> triangles;
  for(auto f : component) {
    const auto h = halfedge(f, mesh);
    triangles.push_back({index[source(h, mesh)], index[target(h, mesh)], index[target(next(h, mesh), mesh)]});
  }
  std::vector<int> border;
  for(vertex_descriptor v : border_loop(bhd, mesh))
    border.push_back(index[v]);

  const std::size_t distinct = std::unordered_set<int>(border.begin(), border.end()).size();
  if(distinct != border.size())
    throw Unmappable(SMP::ERROR_NO_TOPOLOGICAL_DISC, "the border visits a vertex twice");
  if(border_edges != border.size())
    throw Unmappable(SMP::ERROR_NO_TOPOLOGICAL_DISC, "the surface has more than one border");
  // V - E + F = 1 for a disk, and 2 E = 3 F + B
  const long twice_euler = 2 * static_cast<long>(points.size()) - static_cast<long>(triangles.size() + border.size());
  if(twice_euler != 2)
    throw Unmappable(SMP::ERROR_NO_TOPOLOGICAL_DISC,
                     "the surface has Euler characteristic " + std::to_string(twice_euler / 2) + ", not 1");
  result.patch = make_patch(std::move(points), std::move(triangles), std::move(border));
  return result;
}

} // namespace internal
} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PATCH_FACE_GRAPH_PATCH_H
