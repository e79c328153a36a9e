// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_SAMPLE_ON_GRID_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_SAMPLE_ON_GRID_H

#include <CGAL_ext/Square_parameterization/Grid_size.h>
#include <CGAL_ext/Square_parameterization/internal/patch/write_uv.h>
#include <CGAL_ext/Square_parameterization/internal/sampling/locate_samples.h>
#include <CGAL_ext/Square_parameterization/internal/sampling/vertex_normals.h>
#include <CGAL_ext/Square_parameterization/internal/surface/Face_graph_arrays.h>
#include <CGAL_ext/Square_parameterization/internal/surface/check_surface.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cstddef>
#include <string>
#include <type_traits>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {

/// \ingroup PkgSquareParameterizationSampling
///
/// a sample of a surface, at one place of a grid on its map
template <class TriangleMesh_, class Point_ = typename boost::property_traits<typename boost::property_map<
                                   TriangleMesh_, CGAL::vertex_point_t>::const_type>::value_type>
struct Grid_sample
{
  typedef Point_ Point_3;
  typedef typename CGAL::Kernel_traits<Point_3>::Kernel::Vector_3 Vector_3;
  typedef typename boost::graph_traits<TriangleMesh_>::face_descriptor face_descriptor;

  Point_3 point;        ///< in the units of the mesh
  Vector_3 normal;      ///< of length 1, interpolated between those of the vertices
  face_descriptor face; ///< that contains the sample
  /// not negative, of sum 1, for the sources of `halfedge(face)` and of the two halfedges that follow it: the same as
  /// those of CGAL's package Polygon Mesh Processing. What is given at vertices is carried over by them.
  std::array<double, 3> barycentric_coordinates;
};

/// \ingroup PkgSquareParameterizationSampling
///
/// what `sample_on_grid()` did
struct Sampling_result
{
  /// `OK`, or why there are no samples
  CGAL::Surface_mesh_parameterization::Error_code status = CGAL::Surface_mesh_parameterization::OK;
  std::string message; ///< one sentence that names the condition and the place; empty on `OK`
};

/// \ingroup PkgSquareParameterizationSampling
///
/// samples a surface on a regular grid of its map onto the unit square, as for a geometry image: points, normals, faces
/// and barycentric coordinates.
///
/// Samples on the border of the square lie exactly on the border of the surface, and the four corners of the square are
/// samples. Every sample belongs to exactly one face, by exact arithmetic: of several that meet there, to the first in
/// the order of the mesh. Deterministic.
///
/// The vertices at the same point of a surface that was cut open have normals of their own here; the command
/// `square_map` gives both sides of a seam the same.
///
/// \tparam TriangleMesh must be a model of `FaceListGraph`.
/// \tparam VertexUVMap must be a model of `ReadablePropertyMap` with the vertex descriptor as key type and a 2D point
///         as value type.
/// \tparam OutputIterator must be a model of `OutputIterator` that accepts `CGAL_ext::Grid_sample<TriangleMesh>`.
/// \tparam NamedParameters a sequence of named parameters
///
/// \param mesh the surface: triangles
/// \param uvmap a one-to-one map onto the unit square, such as that of `parameterize_onto_square()`
/// \param width number of samples along u; at least 2 and at most 65536
/// \param height number of samples along v; at least 2 and at most 65536
/// \param output receives the samples, row by row: (0, 0) first, then along u, (1, 1) last. Nothing unless the status is
///        `OK`.
/// \param np optional named parameters among those below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{the positions of the vertices}
///     \cgalParamType{a model of `ReadablePropertyMap` with the vertex descriptor as key type and a 3D point as value
///                    type}
///     \cgalParamDefault{the internal vertex point map of `mesh`}
///     \cgalParamExtra{The samples have its point type: `Grid_sample<TriangleMesh, Point>`.}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return the status: `ERROR_EMPTY_MESH`, `ERROR_NON_TRIANGULAR_MESH`, `ERROR_WRONG_PARAMETER` for a size out of range
///         or a coordinate of the surface that is not finite, `ERROR_NO_1_TO_1_MAPPING` when a uv triangle is not
///         counter-clockwise, as one with a coordinate that is not finite, or the map does not cover the square. No
///         exception is thrown for bad data.
///
/// Complexity: linear in samples, faces, and the rows of samples that each face meets. Coordinates are read as `double`.
template <class TriangleMesh, class VertexUVMap, class OutputIterator,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
Sampling_result sample_on_grid(const TriangleMesh& mesh, VertexUVMap uvmap, int width, int height,
                               OutputIterator output, const NamedParameters& np = NamedParameters())
{
  namespace CP = CGAL::parameters;
  namespace SMP = CGAL::Surface_mesh_parameterization;
  const auto vpm =
      CP::choose_parameter(CP::get_parameter(np, CGAL::internal_np::vertex_point), get(CGAL::vertex_point, mesh));
  typedef Grid_sample<TriangleMesh, typename boost::property_traits<std::decay_t<decltype(vpm)>>::value_type> Sample;
  typedef typename CGAL::Kernel_traits<typename Sample::Point_3>::Kernel::FT FT;
  try {
    if(!Grid_size{width, height}.is_valid())
      throw internal::Unmappable(SMP::ERROR_WRONG_PARAMETER, "a grid has 2 to 65536 samples a side, not " +
                                                                 std::to_string(width) + " by " +
                                                                 std::to_string(height));
    const auto [arrays, vertex_list] = internal::read_faces(mesh, faces(mesh), vpm);
    const auto& [points, triangles, places, border_sides] = arrays;
    const internal::Surface_arrays& surface = arrays;
    internal::check_faces(surface);
    internal::check_finite(points, [&surface](std::size_t v) { return surface.place(static_cast<int>(v)); });
    const auto locations = internal::locate_samples(triangles, internal::read_uv(vertex_list, uvmap), {width, height});
    const std::vector<Eigen::Vector3d> normals = internal::vertex_normals(points, triangles);
    const auto face_range = faces(mesh);
    const std::vector<typename Sample::face_descriptor> face_list(face_range.begin(), face_range.end());
    for(const auto& [f, weights] : locations) {
      const Eigen::Vector3d p = internal::interpolated(points, triangles[f], weights);
      const Eigen::Vector3d n = internal::sample_normal(normals, points, triangles[f], weights);
      *output++ = Sample{typename Sample::Point_3(FT(p.x()), FT(p.y()), FT(p.z())),
                         typename Sample::Vector_3(FT(n.x()), FT(n.y()), FT(n.z())), face_list[f], weights};
    }
  } catch(const internal::Unmappable& error) {
    return {error.code(), error.what()};
  }
  return {};
}

} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_SAMPLE_ON_GRID_H
