// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_SPLIT_CHORDS_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_SPLIT_CHORDS_H

#include <CGAL_ext/Square_parameterization/internal/patch/split_edges.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <cstddef>
#include <vector>

namespace CGAL_ext {

/// \ingroup PkgSquareParameterizationConditioning
///
/// which chords are split
enum class Chords
{
  ALL, ///< every chord: afterwards every choice of corners has a one-to-one map
  EARS ///< only those that cut off a single face, as the authors of the published tables did
};

namespace internal {

/// splits the chords between border vertices as two predicates tell them, of vertices and of edges; returns the
/// midpoints
template <class TriangleMesh, class VertexPointMap, class Is_border_vertex, class Is_border_edge>
std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor>
split_chords(TriangleMesh& mesh, VertexPointMap vpm, Chords which, Is_border_vertex is_border_vertex,
             Is_border_edge is_border_edge)
{
  typedef typename boost::graph_traits<TriangleMesh>::edge_descriptor edge_descriptor;
  const auto cuts_off_a_face = [&](auto h) {
    return is_border_edge(edge(next(h, mesh), mesh)) && is_border_edge(edge(prev(h, mesh), mesh));
  };
  std::vector<edge_descriptor> chords;
  for(edge_descriptor e : edges(mesh)) {
    const auto h = halfedge(e, mesh);
    if(is_border_edge(e) || !is_border_vertex(source(h, mesh)) || !is_border_vertex(target(h, mesh)))
      continue;
    if(which == Chords::ALL || cuts_off_a_face(h) || cuts_off_a_face(opposite(h, mesh)))
      chords.push_back(e);
  }
  std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor> midpoints;
  for(edge_descriptor e : chords)
    midpoints.push_back(split_edge_at_midpoint(halfedge(e, mesh), mesh, vpm));
  return midpoints;
}

} // namespace internal

/// \ingroup PkgSquareParameterizationConditioning
///
/// splits the chords of a triangulated surface with border at their midpoints, and returns how many there were. A chord
/// is an interior edge with both ends on the border. When both ends come to lie on one side of the square the faces
/// beside the chord have no area: no one-to-one map exists. After the split each choice of corners has one.
///
/// The new vertices and faces come after the existing ones. Complexity: linear.
///
/// \tparam TriangleMesh must be a model of `MutableFaceGraph`.
/// \tparam VertexPointMap must be a model of `ReadWritePropertyMap` with the vertex descriptor as key type and a 3D
///         point as value type.
/// \pre all faces are triangles
template <class TriangleMesh, class VertexPointMap>
std::size_t split_chords(TriangleMesh& mesh, VertexPointMap vpm, Chords which = Chords::ALL)
{
  return internal::split_chords(
             mesh, vpm, which, [&mesh](auto v) { return bool(CGAL::is_border(v, mesh)); },
             [&mesh](auto e) { return CGAL::is_border_edge(halfedge(e, mesh), mesh); })
      .size();
}

/// \ingroup PkgSquareParameterizationConditioning
///
/// as above, with the internal vertex point map of \p mesh
template <class TriangleMesh>
std::size_t split_chords(TriangleMesh& mesh)
{
  return split_chords(mesh, get(CGAL::vertex_point, mesh));
}

/// \ingroup PkgSquareParameterizationConditioning
///
/// splits the chords that \p mesh has as a `CGAL::Seam_mesh`: edges that are not seams between two vertices on seams or
/// borders. Returns how many there were. New edges and vertices are on no seam.
///
/// \tparam TriangleMesh must be a model of `MutableFaceGraph`.
/// \tparam SeamEdgeMap must be a model of `ReadWritePropertyMap` with the edge descriptor as key type and `bool` as
///         value type.
/// \tparam SeamVertexMap must be a model of `ReadWritePropertyMap` with the vertex descriptor as key type and `bool` as
///         value type.
/// \pre all faces are triangles, and no `CGAL::Seam_mesh` of `mesh` has been made yet
template <class TriangleMesh, class SeamEdgeMap, class SeamVertexMap>
std::size_t split_seam_chords(TriangleMesh& mesh, SeamEdgeMap seam_edges, SeamVertexMap seam_vertices)
{
  const auto midpoints = internal::split_chords(
      mesh, get(CGAL::vertex_point, mesh), Chords::ALL,
      [&](auto v) { return get(seam_vertices, v) || CGAL::is_border(v, mesh); },
      [&](auto e) { return get(seam_edges, e) || CGAL::is_border_edge(halfedge(e, mesh), mesh); });
  for(auto v : midpoints) {
    put(seam_vertices, v, false);
    for(auto h : CGAL::halfedges_around_target(v, mesh))
      put(seam_edges, edge(h, mesh), false);
  }
  return midpoints.size();
}

} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_SPLIT_CHORDS_H
