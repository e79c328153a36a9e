// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SURFACE_APPLY_EDITS_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SURFACE_APPLY_EDITS_H

#include <CGAL_ext/Square_parameterization/internal/surface/Surface_edits.h>
#include <CGAL_ext/Square_parameterization/internal/surface/halfedge_between.h>

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <array>
#include <cstddef>
#include <set>
#include <utility>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// applies edits to the mesh on whose arrays they were decided: every face, vertex and point stays
template <class TriangleMesh, class VertexPointMap>
class Edit_application
{
public:
  typedef typename boost::graph_traits<TriangleMesh>::vertex_descriptor vertex_descriptor;
  typedef typename boost::graph_traits<TriangleMesh>::halfedge_descriptor halfedge_descriptor;

  /// \param vertices those of the arrays; new ones are appended
  Edit_application(TriangleMesh& mesh, VertexPointMap vpm, std::vector<vertex_descriptor>& vertices)
    : m_mesh(mesh), m_vpm(vpm), m_vertices(vertices)
  {}

  /// cuts along the seams
  void open(const Surface_edits& edits)
  {
    for(halfedge_descriptor h : halfedges_between(edits.seams)) // all of them found first: then links are missing
      double_edge(h);
    for(int original : edits.copies) {
      m_vertices.push_back(add_vertex(m_mesh));
      put(m_vpm, m_vertices.back(), Point(get(m_vpm, m_vertices[original])));
    }
    join(edits.opened);
  }

  /// splits edges at their midpoints, and the triangles beside them as `split_triangle()` does: into a fan round the
  /// midpoint of the first split side
  void split(const std::vector<std::array<int, 2>>& edges)
  {
    const std::vector<halfedge_descriptor> sides = halfedges_between(edges);
    std::set<halfedge_descriptor> is_split;
    for(halfedge_descriptor h : sides)
      is_split.insert({h, opposite(h, m_mesh)});
    const auto begins_fan = [&](halfedge_descriptor h) {
      return !CGAL::is_border(h, m_mesh) && first_split_side(h, is_split) == h;
    };
    std::vector<std::pair<bool, bool>> fans; // per edge, whether one begins on its sides
    for(halfedge_descriptor h : sides)
      fans.emplace_back(begins_fan(h), begins_fan(opposite(h, m_mesh)));
    std::vector<halfedge_descriptor> ends; // they end at the midpoint, on the side of the halfedge
    for(halfedge_descriptor h : sides)
      ends.push_back(split_edge(h));
    for(std::size_t k = 0; k < sides.size(); ++k) {
      if(fans[k].first)
        make_fan(ends[k]);
      if(fans[k].second)
        make_fan(opposite(sides[k], m_mesh));
    }
  }

private:
  typedef typename boost::property_traits<VertexPointMap>::value_type Point;

  std::vector<halfedge_descriptor> halfedges_between(const std::vector<std::array<int, 2>>& ends) const
  {
    std::vector<halfedge_descriptor> result;
    for(const auto& [a, b] : ends)
      result.push_back(halfedge_between(m_vertices[a], m_vertices[b], m_mesh));
    return result;
  }

  /// gives the face beyond an edge a halfedge of its own, so that both sides of the edge become border
  void double_edge(halfedge_descriptor kept)
  {
    const halfedge_descriptor freed = opposite(kept, m_mesh);
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
    for(halfedge_descriptor h : {freed, outside})
      set_face(h, boost::graph_traits<TriangleMesh>::null_face(), m_mesh);
  }

  /// gives every corner of every face its vertex, and joins the halfedges of the borders: now one at each vertex
  void join(const std::vector<std::array<int, 3>>& triangles)
  {
    const auto none = boost::graph_traits<TriangleMesh>::null_halfedge();
    std::vector<halfedge_descriptor> arriving(m_vertices.size(), none), leaving(m_vertices.size(), none);
    auto triangle = triangles.begin();
    for(auto f : faces(m_mesh)) {
      int corner = 0;
      for(halfedge_descriptor h : CGAL::halfedges_around_face(halfedge(f, m_mesh), m_mesh)) {
        const int a = (*triangle)[corner], b = (*triangle)[(corner + 1) % 3];
        ++corner;
        set_target(h, m_vertices[b], m_mesh);
        const halfedge_descriptor outer = opposite(h, m_mesh);
        if(CGAL::is_border(outer, m_mesh)) {
          set_target(outer, m_vertices[a], m_mesh);
          arriving[a] = leaving[b] = outer;
        }
      }
      ++triangle;
    }
    for(std::size_t v = 0; v < arriving.size(); ++v)
      if(arriving[v] != none) {
        set_next(arriving[v], leaving[v], m_mesh);
        set_halfedge(m_vertices[v], arriving[v], m_mesh);
      }
  }

  /// of the split sides of the face of \p h the one opposite to the first corner that has one
  halfedge_descriptor first_split_side(halfedge_descriptor h, const std::set<halfedge_descriptor>& is_split) const
  {
    halfedge_descriptor side = next(halfedge(face(h, m_mesh), m_mesh), m_mesh); // opposite to corner 0
    while(is_split.count(side) == 0)
      side = next(side, m_mesh);
    return side;
  }

  /// splits the edge of \p h; returns the halfedge that ends at the midpoint on its side
  halfedge_descriptor split_edge(halfedge_descriptor h)
  {
    const Point p(get(m_vpm, source(h, m_mesh))), q(get(m_vpm, target(h, m_mesh)));
    const auto middle = [](const auto& a, const auto& b) { return a / 2 + b / 2; };
    const halfedge_descriptor first = CGAL::Euler::split_edge(h, m_mesh);
    m_vertices.push_back(target(first, m_mesh));
    put(m_vpm, m_vertices.back(), Point(middle(p.x(), q.x()), middle(p.y(), q.y()), middle(p.z(), q.z())));
    return first;
  }

  /// splits the polygon of \p h into triangles round the target of \p h
  void make_fan(halfedge_descriptor h)
  {
    while(!CGAL::is_triangle(h, m_mesh))
      CGAL::Euler::split_face(h, next(next(h, m_mesh), m_mesh), m_mesh);
  }

  TriangleMesh& m_mesh;
  VertexPointMap m_vpm;
  std::vector<vertex_descriptor>& m_vertices;
};

/// applies edits to the mesh on whose arrays, of all faces, they were decided. Faces and vertices keep their descriptors
/// and their order; new ones come last. Complexity: linear in the mesh when there are seams, else in the splits.
/// \param vertices those of the arrays; the new ones are appended in the order of the edits
template <class TriangleMesh, class VertexPointMap>
void apply_edits(const Surface_edits& edits, TriangleMesh& mesh, VertexPointMap vpm,
                 std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor>& vertices)
{
  Edit_application<TriangleMesh, VertexPointMap> application(mesh, vpm, vertices);
  if(!edits.seams.empty())
    application.open(edits);
  const auto first_chord = edits.splits.begin() + static_cast<std::ptrdiff_t>(edits.border_splits);
  application.split({edits.splits.begin(), first_chord});
  application.split({first_chord, edits.splits.end()});
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SURFACE_APPLY_EDITS_H
