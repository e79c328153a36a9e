// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_MEASURE_STRETCH_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_MEASURE_STRETCH_H

#include <CGAL_ext/Square_parameterization/internal/energy/stretch_kernel.h>
#include <CGAL_ext/Square_parameterization/internal/patch/Face_graph_patch.h>
#include <CGAL_ext/Square_parameterization/internal/patch/exact_orientation.h>
#include <CGAL_ext/Square_parameterization/internal/patch/write_uv.h>

#include <CGAL/boost/graph/helpers.h>

#include <cstddef>
#include <limits>
#include <unordered_map>
#include <vector>

namespace CGAL_ext {

/// \ingroup PkgSquareParameterizationMetric
///
/// the stretch of a map from the plane to a triangle mesh (Sander et al.\ \cgalCite{cgal:ssgh-tmpm-01}), normalised so
/// that an isometry up to scale has stretch 1. All stretches are dimensionless and infinite when a uv triangle is not
/// counter-clockwise. (CGAL's `compute_L2_stretch()` is another quantity, a norm of area ratios.)
struct Stretch_measures
{
  double l2 = 0;                  ///< root mean square of the stretch over all directions and over the surface
  double linf = 0;                ///< largest stretch of any direction anywhere
  double symmetric_dirichlet = 0; ///< area mean of (s1^2 + s2^2 + 1/s1^2 + 1/s2^2) / 4, s the singular values; least 1
  std::size_t flipped_faces = 0;  ///< number of uv triangles that are clockwise or flat, by exact arithmetic
  double uv_area = 0;             ///< sum of the signed areas of the uv triangles
  std::vector<double> face_l2;    ///< one per face, in the order of `faces(mesh)`
};

namespace internal {

/// measures a map given as flat arrays, in any unit of length
inline Stretch_measures measure(const std::vector<Flat_triangle>& shapes,
                                const std::vector<std::array<int, 3>>& triangles, const Uv_coordinates& uv)
{
  Stretch_measures result;
  result.flipped_faces = number_of_flipped_faces(triangles, uv);
  double energy = 0, inverse_energy = 0, surface_area = 0;
  for(std::size_t f = 0; f < triangles.size(); ++f) {
    const Triangle_stretch stretch = triangle_stretch(shapes[f], uv, triangles[f]);
    const double area = shapes[f].area();
    surface_area += area;
    result.uv_area += stretch.uv_area;
    result.linf = (std::max)(result.linf, stretch.linf);
    result.face_l2.push_back(std::sqrt(stretch.l2_squared));
    if(area > 0) {
      energy += stretch.l2_squared * area;
      // s1^2 + s2^2 of the surface-to-plane map: that of its inverse, divided by the squared determinant
      const double determinant = area / stretch.uv_area;
      inverse_energy += stretch.l2_squared / (determinant * determinant) * area;
    }
  }
  const double scale = std::sqrt(result.uv_area / surface_area);
  result.l2 = std::sqrt(energy / surface_area) * scale;
  result.linf *= scale;
  for(double& l2 : result.face_l2)
    l2 *= scale;
  result.symmetric_dirichlet = (energy * scale * scale + inverse_energy / (scale * scale)) / (2 * surface_area);
  if(result.flipped_faces > 0 || !(energy < std::numeric_limits<double>::infinity()))
    result.l2 = result.linf = result.symmetric_dirichlet = std::numeric_limits<double>::infinity();
  return result;
}

} // namespace internal

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
  typedef typename boost::graph_traits<TriangleMesh>::vertex_descriptor vertex_descriptor;
  CGAL_precondition(CGAL::is_triangle_mesh(mesh));
  std::vector<vertex_descriptor> vertex_list(vertices(mesh).begin(), vertices(mesh).end());
  std::unordered_map<vertex_descriptor, int> index;
  for(std::size_t v = 0; v < vertex_list.size(); ++v)
    index[vertex_list[v]] = static_cast<int>(v);
  std::vector<std::array<int, 3>> triangles;
  std::vector<internal::Flat_triangle> shapes;
  for(auto f : faces(mesh)) {
    const auto h = halfedge(f, mesh);
    const vertex_descriptor a = source(h, mesh), b = target(h, mesh), c = target(next(h, mesh), mesh);
    triangles.push_back({index[a], index[b], index[c]});
    shapes.push_back(
        internal::flatten(internal::point_of(vpm, a), internal::point_of(vpm, b), internal::point_of(vpm, c), 0));
  }
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
