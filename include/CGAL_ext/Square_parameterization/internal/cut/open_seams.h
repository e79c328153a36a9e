// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_OPEN_SEAMS_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_OPEN_SEAMS_H

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL_ext {
namespace internal {

/// cuts a mesh open in place, edge by edge: every face, vertex and point stays, copies are added
template <class TriangleMesh>
class Seam_opening
{
public:
  typedef typename boost::graph_traits<TriangleMesh>::vertex_descriptor vertex_descriptor;
  typedef typename boost::graph_traits<TriangleMesh>::halfedge_descriptor halfedge_descriptor;
  typedef typename boost::graph_traits<TriangleMesh>::edge_descriptor edge_descriptor;

  explicit Seam_opening(TriangleMesh& mesh) : m_mesh(mesh) {}

  /// gives the face beyond the edge a halfedge of its own, so that both sides of the edge become border. What follows
  /// on the border is set by `link_borders()`.
  void double_edge(edge_descriptor e)
  {
    const halfedge_descriptor kept = halfedge(e, m_mesh), freed = opposite(kept, m_mesh);
    const halfedge_descriptor copy = halfedge(add_edge(m_mesh), m_mesh), outside = opposite(copy, m_mesh);
    const auto f = face(freed, m_mesh);
    set_target(copy, target(freed, m_mesh), m_mesh);
    set_target(outside, target(kept, m_mesh), m_mesh);
    const halfedge_descriptor before = prev(freed, m_mesh), after = next(freed, m_mesh);
    set_next(before, copy, m_mesh);
    set_next(copy, after, m_mesh);
    set_face(copy, f, m_mesh);
    if(halfedge(f, m_mesh) == freed)
      set_halfedge(f, copy, m_mesh);
    for(halfedge_descriptor h : {freed, outside}) {
      set_face(h, boost::graph_traits<TriangleMesh>::null_face(), m_mesh);
      m_seam_vertices.insert(target(h, m_mesh));
    }
  }

  /// joins the halfedges of each border, old and new
  void link_borders()
  {
    for(halfedge_descriptor h : halfedges(m_mesh))
      if(CGAL::is_border(h, m_mesh) && m_seam_vertices.count(target(h, m_mesh)) != 0)
        set_next(h, border_after(h), m_mesh);
  }

  /// gives every fan of faces round a vertex of the seams a vertex of its own; the fan of the first face keeps the one
  /// there is. Returns the copies with their originals.
  template <class VertexPointMap>
  std::vector<std::pair<vertex_descriptor, vertex_descriptor>> part_vertices(VertexPointMap vpm)
  {
    std::vector<std::pair<vertex_descriptor, vertex_descriptor>> copies;
    std::unordered_set<vertex_descriptor> taken;
    std::unordered_set<halfedge_descriptor> visited; // the border halfedges that end in a fan
    for(auto f : faces(m_mesh))
      for(halfedge_descriptor h : CGAL::halfedges_around_face(halfedge(f, m_mesh), m_mesh)) {
        const vertex_descriptor original = target(h, m_mesh);
        if(m_seam_vertices.count(original) == 0)
          continue;
        const halfedge_descriptor last = border_of_fan(h);
        if(!visited.insert(last).second)
          continue;
        vertex_descriptor v = original;
        if(!taken.insert(original).second) {
          v = add_vertex(m_mesh);
          put(vpm, v, typename boost::property_traits<VertexPointMap>::value_type(get(vpm, original)));
          copies.emplace_back(v, original);
        }
        give_fan(last, v);
      }
    return copies;
  }

private:
  /// the border halfedge that leaves the target of border halfedge \p h on the other side of the fan of faces
  halfedge_descriptor border_after(halfedge_descriptor h) const
  {
    halfedge_descriptor leaving = opposite(h, m_mesh);
    while(!CGAL::is_border(leaving, m_mesh))
      leaving = opposite(prev(leaving, m_mesh), m_mesh);
    return leaving;
  }

  /// the border halfedge that ends at the target of \p h, in the same fan of faces
  halfedge_descriptor border_of_fan(halfedge_descriptor h) const
  {
    while(!CGAL::is_border(h, m_mesh))
      h = opposite(next(h, m_mesh), m_mesh);
    return h;
  }

  /// lets the halfedges of the fan that begins with border halfedge \p first end at \p v
  void give_fan(halfedge_descriptor first, vertex_descriptor v)
  {
    set_halfedge(v, first, m_mesh);
    halfedge_descriptor h = first;
    set_target(h, v, m_mesh);
    while(!CGAL::is_border(opposite(h, m_mesh), m_mesh)) {
      h = prev(opposite(h, m_mesh), m_mesh);
      set_target(h, v, m_mesh);
    }
  }

  TriangleMesh& m_mesh;
  std::unordered_set<vertex_descriptor> m_seam_vertices;
};

/// cuts the mesh open along interior edges. Faces and vertices keep their descriptors and order; copies of vertices
/// come last, and are returned with their originals. Complexity: linear.
template <class TriangleMesh, class VertexPointMap>
std::vector<std::pair<typename boost::graph_traits<TriangleMesh>::vertex_descriptor,
                      typename boost::graph_traits<TriangleMesh>::vertex_descriptor>>
open_seams(TriangleMesh& mesh, const std::vector<typename boost::graph_traits<TriangleMesh>::edge_descriptor>& seams,
           VertexPointMap vpm)
{
  Seam_opening<TriangleMesh> opening(mesh);
  for(auto e : seams)
    opening.double_edge(e);
  opening.link_borders();
  return opening.part_vertices(vpm);
}

} // namespace internal
} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_OPEN_SEAMS_H
