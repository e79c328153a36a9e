// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SURFACE_FACE_GRAPH_ARRAYS_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SURFACE_FACE_GRAPH_ARRAYS_H

#include <CGAL_ext/Square_parameterization/internal/common/Unmappable.h>
#include <CGAL_ext/Square_parameterization/internal/surface/Surface_arrays.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <array>
#include <cstddef>
#include <iterator>
#include <string>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// flat arrays and the mesh vertices that theirs stand for
template <class TriangleMesh>
struct Face_graph_arrays
{
  typedef typename boost::graph_traits<TriangleMesh>::vertex_descriptor vertex_descriptor;

  Surface_arrays arrays;
  std::vector<vertex_descriptor> vertices; ///< #V, in the order of the mesh
};

/// the position of \p v, read as `double`
template <class VertexPointMap, class Vertex>
Eigen::Vector3d point_of(VertexPointMap vpm, Vertex v)
{
  const auto& p = get(vpm, v);
  return {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())};
}

/// there are so many faces that are not triangles
[[noreturn]] inline void refuse_polygons(std::size_t polygons)
{
  throw Unmappable(CGAL::Surface_mesh_parameterization::ERROR_NON_TRIANGULAR_MESH,
                   std::to_string(polygons) + (polygons == 1 ? " face is not a triangle" : " faces are not triangles"));
}

/// reads some faces of a mesh, and their vertices: the one walk over a mesh. Corner 0 of a face is where its first
/// halfedge begins. Coordinates are read as `double`.
///
/// Throws `Unmappable` when a face is not a triangle. Complexity: linear.
template <class TriangleMesh, class FaceRange, class VertexPointMap>
Face_graph_arrays<TriangleMesh> read_faces(const TriangleMesh& mesh, const FaceRange& face_range, VertexPointMap vpm)
{
  Face_graph_arrays<TriangleMesh> result;
  auto index = get(CGAL::dynamic_vertex_property_t<int>(), mesh);
  for(auto v : vertices(mesh))
    put(index, v, -1);
  result.arrays.triangles.reserve(std::distance(std::begin(face_range), std::end(face_range)));
  int number_of_vertices = 0; // of faces, which are numbered as they are met, and then in the order of the mesh
  std::size_t polygons = 0;
  for(auto f : face_range) {
    std::array<int, 3> triangle{};
    std::size_t corners = 0;
    for(auto h : CGAL::halfedges_around_face(halfedge(f, mesh), mesh)) {
      const auto v = source(h, mesh);
      if(get(index, v) < 0)
        put(index, v, number_of_vertices++);
      if(corners < triangle.size())
        triangle[corners] = get(index, v);
      ++corners;
      result.arrays.border_sides += CGAL::is_border(opposite(h, mesh), mesh) ? 1 : 0;
    }
    polygons += corners == 3 ? 0 : 1;
    result.arrays.triangles.push_back(triangle);
  }
  if(polygons > 0)
    refuse_polygons(polygons);
  const auto range = vertices(mesh);
  const bool are_all_of_faces = std::distance(range.begin(), range.end()) == number_of_vertices;
  std::vector<int> number(number_of_vertices);
  result.vertices.reserve(number.size());
  result.arrays.points.reserve(number.size());
  std::size_t place = 0;
  for(auto v : range) {
    if(const int met = get(index, v); met >= 0) {
      number[met] = static_cast<int>(result.vertices.size());
      result.vertices.push_back(v);
      result.arrays.points.push_back(point_of(vpm, v));
      if(!are_all_of_faces)
        result.arrays.places.push_back(place);
    }
    ++place;
  }
  for(std::array<int, 3>& triangle : result.arrays.triangles)
    for(int& v : triangle)
      v = number[v];
  return result;
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SURFACE_FACE_GRAPH_ARRAYS_H
