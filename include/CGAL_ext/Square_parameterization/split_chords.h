// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_SPLIT_CHORDS_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_SPLIT_CHORDS_H

#include <CGAL/boost/graph/Euler_operations.h>
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

/// splits the edge of \p h at its midpoint, and its two faces with it
template <class TriangleMesh, class VertexPointMap>
void split_edge_at_midpoint(typename boost::graph_traits<TriangleMesh>::halfedge_descriptor h, TriangleMesh& mesh,
                            VertexPointMap vpm)
{
  typedef typename boost::property_traits<VertexPointMap>::reference Reference;
  typedef typename boost::property_traits<VertexPointMap>::value_type Point;
  Reference p = get(vpm, source(h, mesh)), q = get(vpm, target(h, mesh));
  const auto middle = [](const auto& a, const auto& b) { return a / 2 + b / 2; };
  const Point midpoint(middle(p.x(), q.x()), middle(p.y(), q.y()), middle(p.z(), q.z()));
  const auto first = CGAL::Euler::split_edge(h, mesh); // ends at the new vertex; h begins there
  put(vpm, target(first, mesh), midpoint);
  CGAL::Euler::split_face(first, next(h, mesh), mesh);
  const auto second = opposite(h, mesh); // ends at the new vertex, on the other side
  CGAL::Euler::split_face(second, next(next(second, mesh), mesh), mesh);
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
  typedef typename boost::graph_traits<TriangleMesh>::edge_descriptor edge_descriptor;
  const auto is_on_border = [&mesh](auto v) { return bool(CGAL::is_border(v, mesh)); };
  const auto cuts_off_a_face = [&mesh](auto h) {
    return CGAL::is_border(opposite(next(h, mesh), mesh), mesh) && CGAL::is_border(opposite(prev(h, mesh), mesh), mesh);
  };
  std::vector<edge_descriptor> chords;
  for(edge_descriptor e : edges(mesh)) {
    const auto h = halfedge(e, mesh);
    if(CGAL::is_border(h, mesh) || CGAL::is_border(opposite(h, mesh), mesh))
      continue;
    if(!is_on_border(source(h, mesh)) || !is_on_border(target(h, mesh)))
      continue;
    if(which == Chords::ALL || cuts_off_a_face(h) || cuts_off_a_face(opposite(h, mesh)))
      chords.push_back(e);
  }
  for(edge_descriptor e : chords)
    internal::split_edge_at_midpoint(halfedge(e, mesh), mesh, vpm);
  return chords.size();
}

/// \ingroup PkgSquareParameterizationConditioning
///
/// as above, with the internal vertex point map of \p mesh
template <class TriangleMesh>
std::size_t split_chords(TriangleMesh& mesh)
{
  return split_chords(mesh, get(CGAL::vertex_point, mesh));
}

} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_SPLIT_CHORDS_H
