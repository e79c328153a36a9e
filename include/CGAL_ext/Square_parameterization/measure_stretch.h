// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_MEASURE_STRETCH_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_MEASURE_STRETCH_H

#include <CGAL_ext/Square_parameterization/internal/energy/measure.h>
#include <CGAL_ext/Square_parameterization/internal/patch/write_uv.h>
#include <CGAL_ext/Square_parameterization/internal/surface/Face_graph_arrays.h>

#include <CGAL/boost/graph/helpers.h>

#include <cmath>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL_ext {

/// \ingroup PkgSquareParameterizationMetric
///
/// measures the stretch of the map \p uvmap of the triangle mesh \p mesh: over the whole mesh and per face.
///
/// \tparam TriangleMesh must be a model of `FaceGraph`.
/// \tparam VertexUVMap must be a model of `ReadablePropertyMap` with the vertex descriptor as key type and a 2D point
///         as value type.
/// \tparam VertexPointMap must be a model of `ReadablePropertyMap` with the vertex descriptor as key type and a 3D
///         point as value type.
/// \tparam VertexStretchMap must be a model of `WritablePropertyMap` with the vertex descriptor as key type and
///         `double` as value type, or null.
/// \param mesh the surface
/// \param uvmap the position of every vertex in the plane
/// \param vpm the position of every vertex in space
/// \param vertex_stretch receives the stretch of every vertex with a face: the root of the area mean of the squared
///        stretch of its incident faces, border vertices too
/// \pre all faces are triangles
///
/// Complexity: linear. Coordinates are read as `double`.
template <class TriangleMesh, class VertexUVMap, class VertexPointMap, class VertexStretchMap>
Stretch_measures measure_stretch(const TriangleMesh& mesh, VertexUVMap uvmap, VertexPointMap vpm,
                                 VertexStretchMap vertex_stretch)
{
  CGAL_precondition(CGAL::is_triangle_mesh(mesh));
  const auto [arrays, vertex_list] = internal::read_faces(mesh, faces(mesh), vpm);
  const auto& [points, triangles, places, border_sides] = arrays;
  std::vector<internal::Flat_triangle> shapes;
  for(const auto& [a, b, c] : triangles)
    shapes.push_back(internal::flatten(points[a], points[b], points[c], 0));
  const Stretch_measures result = internal::measure(shapes, triangles, internal::read_uv(vertex_list, uvmap));

  if constexpr(!std::is_same_v<VertexStretchMap, std::nullptr_t>) {
    std::vector<double> sum(vertex_list.size(), 0.), area(vertex_list.size(), 0.);
    for(std::size_t f = 0; f < triangles.size(); ++f)
      for(int v : triangles[f]) {
        sum[v] += result.face_l2[f] * result.face_l2[f] * shapes[f].area();
        area[v] += shapes[f].area();
      }
    for(std::size_t v = 0; v < vertex_list.size(); ++v)
      if(area[v] > 0)
        put(vertex_stretch, vertex_list[v], std::sqrt(sum[v] / area[v]));
  }
  return result;
}

/// \ingroup PkgSquareParameterizationMetric
///
/// as above, with the internal vertex point map of \p mesh and without the stretch of vertices
template <class TriangleMesh, class VertexUVMap>
Stretch_measures measure_stretch(const TriangleMesh& mesh, VertexUVMap uvmap)
{
  return measure_stretch(mesh, uvmap, get(CGAL::vertex_point, mesh), nullptr);
}

} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_MEASURE_STRETCH_H
