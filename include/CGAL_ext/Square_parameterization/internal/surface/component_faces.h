// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SURFACE_COMPONENT_FACES_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SURFACE_COMPONENT_FACES_H

#include <CGAL_ext/Square_parameterization/internal/surface/Face_graph_arrays.h>

#include <vector>

namespace CGAL_ext {
namespace internal {

/// the faces of the connected component of \p seed, in the order of the mesh. (CGAL's `connected_component()` has them in
/// the order of its search.)
template <class TriangleMesh>
std::vector<typename boost::graph_traits<TriangleMesh>::face_descriptor>
faces_of_component(typename boost::graph_traits<TriangleMesh>::face_descriptor seed, const TriangleMesh& mesh)
{
  typedef typename boost::graph_traits<TriangleMesh>::face_descriptor face_descriptor;
  auto is_met = get(CGAL::dynamic_face_property_t<bool>(), mesh);
  for(face_descriptor f : faces(mesh))
    put(is_met, f, false);
  put(is_met, seed, true);
  std::vector<face_descriptor> front{seed}, component;
  while(!front.empty()) {
    const face_descriptor f = front.back();
    front.pop_back();
    for(auto h : CGAL::halfedges_around_face(halfedge(f, mesh), mesh)) {
      if(CGAL::is_border(opposite(h, mesh), mesh))
        continue;
      const face_descriptor neighbor = face(opposite(h, mesh), mesh);
      if(!get(is_met, neighbor))
        front.push_back(neighbor);
      put(is_met, neighbor, true);
    }
  }
  for(face_descriptor f : faces(mesh))
    if(get(is_met, f))
      component.push_back(f);
  return component;
}

/// indicates whether a halfedge, which may be null, is on the border of a face: an edge may have none
template <class TriangleMesh>
bool is_on_border_of_face(typename boost::graph_traits<TriangleMesh>::halfedge_descriptor bhd, const TriangleMesh& mesh)
{
  return bhd != boost::graph_traits<TriangleMesh>::null_halfedge() && CGAL::is_border(bhd, mesh) &&
         !CGAL::is_border(opposite(bhd, mesh), mesh);
}

/// the border vertices met from source(\p bhd) on, counter-clockwise for someone who sees the faces so.
/// Border halfedges run the other way: the loop follows `prev()`. None when \p bhd is not on the border of a face.
template <class TriangleMesh>
std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor>
border_loop(typename boost::graph_traits<TriangleMesh>::halfedge_descriptor bhd, const TriangleMesh& mesh)
{
  std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor> loop;
  if(!is_on_border_of_face(bhd, mesh))
    return loop;
  auto h = bhd;
  do {
    loop.push_back(source(h, mesh));
    h = prev(h, mesh);
  } while(h != bhd);
  return loop;
}

} // namespace internal
} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SURFACE_COMPONENT_FACES_H
