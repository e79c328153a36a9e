// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_MEASURE_STRETCH_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_MEASURE_STRETCH_H

#include <CGAL_ext/Square_parameterization/internal/common/named_parameters.h>
#include <CGAL_ext/Square_parameterization/internal/energy/measure.h>
#include <CGAL_ext/Square_parameterization/internal/patch/write_uv.h>
#include <CGAL_ext/Square_parameterization/internal/surface/Face_graph_arrays.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {

/// \cond SKIP_IN_MANUAL
namespace internal {

/// puts the stretch of every vertex: the root of the area mean of the squared stretch of its triangles
template <class Vertex, class VertexStretchMap>
void put_vertex_stretch(const std::vector<Vertex>& vertices, const std::vector<std::array<int, 3>>& triangles,
                        const std::vector<Flat_triangle>& shapes, const std::vector<double>& face_l2,
                        VertexStretchMap vertex_stretch)
{
  std::vector<double> sum(vertices.size(), 0.), area(vertices.size(), 0.);
  for(std::size_t f = 0; f < triangles.size(); ++f)
    for(int v : triangles[f]) {
      sum[v] += face_l2[f] * face_l2[f] * shapes[f].area();
      area[v] += shapes[f].area();
    }
  for(std::size_t v = 0; v < vertices.size(); ++v)
    if(area[v] > 0)
      put(vertex_stretch, vertices[v], std::sqrt(sum[v] / area[v]));
}

} // namespace internal
/// \endcond

namespace parameters {

/// \ingroup PkgSquareParameterizationMetric
///
/// the named parameter that receives the stretch of the vertices from `measure_stretch()`. It must come first in a chain
/// of named parameters: `parameters::vertex_stretch_map(map).vertex_point_map(vpm)`.
template <class VertexStretchMap>
CGAL::Named_function_parameters<VertexStretchMap, internal::vertex_stretch_map_t>
vertex_stretch_map(const VertexStretchMap& map)
{
  return {map};
}

} // namespace parameters

/// \ingroup PkgSquareParameterizationMetric
///
/// measures the stretch of the map \p uvmap of the triangle mesh \p mesh: over the whole mesh and per face.
///
/// \tparam TriangleMesh must be a model of `FaceGraph`.
/// \tparam VertexUVMap must be a model of `ReadablePropertyMap` with the vertex descriptor as key type and a 2D point
///         as value type.
/// \tparam NamedParameters a sequence of named parameters
///
/// \param mesh the surface
/// \param uvmap the position of every vertex of a face in the plane
/// \param np optional named parameters among those below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_stretch_map}
///     \cgalParamDescription{receives the stretch of every vertex of a face: the root of the area mean of the squared
///                           stretch of its incident faces, border vertices too; dimensionless}
///     \cgalParamType{a model of `WritablePropertyMap` with the vertex descriptor as key type and `double` as value type}
///     \cgalParamDefault{none}
///     \cgalParamExtra{It is made by `CGAL_ext::parameters::vertex_stretch_map()` and must come first.}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{the positions of the vertices in space}
///     \cgalParamType{a model of `ReadablePropertyMap` with the vertex descriptor as key type and a 3D point as value
///                    type}
///     \cgalParamDefault{the internal vertex point map of `mesh`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \pre all faces are triangles
///
/// Complexity: linear. Coordinates are read as `double`.
template <class TriangleMesh, class VertexUVMap, class NamedParameters = CGAL::parameters::Default_named_parameters>
Stretch_measures measure_stretch(const TriangleMesh& mesh, VertexUVMap uvmap,
                                 const NamedParameters& np = NamedParameters())
{
  namespace CP = CGAL::parameters;
  CGAL_precondition(CGAL::is_triangle_mesh(mesh));
  const auto vpm =
      CP::choose_parameter(CP::get_parameter(np, CGAL::internal_np::vertex_point), get(CGAL::vertex_point, mesh));
  const auto vertex_stretch = CP::get_parameter(np, internal::vertex_stretch_map);
  const auto [arrays, vertex_list] = internal::read_faces(mesh, faces(mesh), vpm);
  const auto& [points, triangles, places, border_sides] = arrays;
  double largest = 0;
  for(const Eigen::Vector3d& p : points)
    largest = (std::max)(largest, p.cwiseAbs().maxCoeff());
  const double scale = internal::scale_to_one(largest);
  std::vector<internal::Flat_triangle> shapes;
  for(const auto& [a, b, c] : triangles)
    shapes.push_back(internal::flatten(scale * points[a], scale * points[b], scale * points[c], 0));
  const internal::Uv_coordinates uv = internal::read_uv(vertex_list, uvmap);
  const double uv_scale = internal::scale_to_one(uv.rows() > 0 ? uv.cwiseAbs().maxCoeff() : 0);
  Stretch_measures result = internal::measure(shapes, triangles, uv_scale * uv);
  result.uv_area = result.uv_area / uv_scale / uv_scale;
  if constexpr(!std::is_same_v<std::decay_t<decltype(vertex_stretch)>, CGAL::internal_np::Param_not_found>)
    internal::put_vertex_stretch(vertex_list, triangles, shapes, result.face_l2, vertex_stretch);
  return result;
}

} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_MEASURE_STRETCH_H
