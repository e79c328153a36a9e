// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_MAKE_MESH_H
#define CGAL_EXT_MAKE_MESH_H

#include "test_meshes.h"

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/property_map/property_map.hpp>

#include <map>
#include <vector>

/// the flat mesh as a model of `MutableFaceGraph`; vertices and faces keep their order
template <class Mesh>
Mesh make_mesh(const Flat_mesh& flat)
{
  Mesh mesh;
  auto vpm = get(CGAL::vertex_point, mesh);
  typedef typename boost::property_traits<decltype(vpm)>::value_type Point;
  std::vector<typename boost::graph_traits<Mesh>::vertex_descriptor> added;
  for(const Eigen::Vector3d& p : flat.points) {
    added.push_back(add_vertex(mesh));
    put(vpm, added.back(), Point(p.x(), p.y(), p.z()));
  }
  for(const auto& [a, b, c] : flat.triangles)
    CGAL::Euler::add_face(
        std::array<typename boost::graph_traits<Mesh>::vertex_descriptor, 3>{added[a], added[b], added[c]}, mesh);
  return mesh;
}

/// the vertex at position `k` in the order of the mesh
template <class Mesh>
typename boost::graph_traits<Mesh>::vertex_descriptor vertex_at(const Mesh& mesh, std::size_t k)
{
  return *std::next(vertices(mesh).begin(), k);
}

/// the border halfedge that begins at the vertex at position `k`; null if that vertex is not on a border
template <class Mesh>
typename boost::graph_traits<Mesh>::halfedge_descriptor border_halfedge_from(const Mesh& mesh, std::size_t k)
{
  for(auto h : CGAL::halfedges_around_target(vertex_at(mesh, k), mesh))
    if(CGAL::is_border(opposite(h, mesh), mesh))
      return opposite(h, mesh);
  return boost::graph_traits<Mesh>::null_halfedge();
}

/// the border halfedge that begins at the first border vertex in the order of the mesh; null if there is no border
template <class Mesh>
typename boost::graph_traits<Mesh>::halfedge_descriptor first_border_halfedge_of(const Mesh& mesh)
{
  const auto null_halfedge = boost::graph_traits<Mesh>::null_halfedge();
  for(std::size_t k = 0; k < num_vertices(mesh); ++k)
    if(halfedge(vertex_at(mesh, k), mesh) != null_halfedge && border_halfedge_from(mesh, k) != null_halfedge)
      return border_halfedge_from(mesh, k);
  return null_halfedge;
}

/// a uv map of any mesh, outside of the mesh
template <class Mesh, class Point_2>
class Uv_storage
{
public:
  typedef typename boost::graph_traits<Mesh>::vertex_descriptor vertex_descriptor;
  typedef boost::associative_property_map<std::map<vertex_descriptor, Point_2>> Map;

  Map map() { return Map(m_points); }

  bool contains(vertex_descriptor v) const { return m_points.count(v) != 0; }

  /// the uv of all vertices, in the order of the mesh
  std::vector<Eigen::Vector2d> points(const Mesh& mesh) const
  {
    std::vector<Eigen::Vector2d> result;
    for(vertex_descriptor v : vertices(mesh))
      result.emplace_back(CGAL::to_double(m_points.at(v).x()), CGAL::to_double(m_points.at(v).y()));
    return result;
  }

private:
  std::map<vertex_descriptor, Point_2> m_points;
};

/// twice the signed area of a uv triangle
inline double twice_area(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c)
{
  return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
}

/// numbers of uv triangles that are counter-clockwise and clockwise
struct Orientation_count
{
  std::size_t counterclockwise = 0, clockwise = 0;
};

template <class Mesh, class Point_2>
Orientation_count count_orientations(const Mesh& mesh, Uv_storage<Mesh, Point_2>& storage)
{
  Orientation_count count;
  const auto point = [&](auto v) {
    const auto p = get(storage.map(), v);
    return Eigen::Vector2d(CGAL::to_double(p.x()), CGAL::to_double(p.y()));
  };
  for(auto f : faces(mesh)) {
    const auto h = halfedge(f, mesh);
    const double area = twice_area(point(source(h, mesh)), point(target(h, mesh)), point(target(next(h, mesh), mesh)));
    count.counterclockwise += area > 0 ? 1 : 0;
    count.clockwise += area < 0 ? 1 : 0;
  }
  return count;
}

#endif // CGAL_EXT_MAKE_MESH_H
