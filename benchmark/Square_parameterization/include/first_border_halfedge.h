// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_FIRST_BORDER_HALFEDGE_H
#define CGAL_EXT_FIRST_BORDER_HALFEDGE_H

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

/// the border halfedge whose source comes first among the border vertices, in the order of the mesh: where
/// `parameterize_onto_square()` begins to count candidates; null when there is no border
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

#endif // CGAL_EXT_FIRST_BORDER_HALFEDGE_H
