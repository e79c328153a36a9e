// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_CIRCULAR_BORDER_ARC_LENGTH_PARAMETERIZER_3_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_CIRCULAR_BORDER_ARC_LENGTH_PARAMETERIZER_3_H

#include <CGAL_ext/Square_parameterization/internal/border/border_curves.h>
#include <CGAL_ext/Square_parameterization/internal/patch/write_uv.h>
#include <CGAL_ext/Square_parameterization/internal/surface/measured_border.h>

#include <cmath>
#include <vector>

namespace CGAL_ext {

/// \ingroup PkgSquareParameterizationBorderParameterizers
///
/// parameterizes the border of a disk onto a circle around the origin by arc length, counter-clockwise, the source of
/// the border halfedge at (radius, 0).
///
/// Thread safety: one object may be used by several threads at a time.
///
/// \cgalModels `Parameterizer_3`
///
/// \tparam TriangleMesh_ must be a model of `FaceGraph`. Coordinates are read as `double`.
template <class TriangleMesh_>
class Circular_border_arc_length_parameterizer_3
{
public:
  typedef TriangleMesh_ Triangle_mesh;
  typedef TriangleMesh_ TriangleMesh;
  typedef typename boost::graph_traits<Triangle_mesh>::vertex_descriptor vertex_descriptor;
  typedef typename boost::graph_traits<Triangle_mesh>::halfedge_descriptor halfedge_descriptor;

  /// constructs the parameterizer.
  /// \param radius of the circle, positive, in uv units; the default gives it the area 1
  explicit Circular_border_arc_length_parameterizer_3(double radius = internal::unit_area_radius()) : m_radius(radius)
  {}

  /// assigns to the vertices of the border their position on the circle, and marks them as parameterized.
  /// An edge shorter than 1e-8 sqrt(area) counts as 1e-4 sqrt(area) long, with the area of the connected component, as
  /// in the border parameterizers that search: no two vertices coincide. Complexity: linear in the component.
  /// \return `OK`, `ERROR_BORDER_TOO_SHORT` for a border of fewer than three vertices or a halfedge that is on none,
  ///         `ERROR_NO_1_TO_1_MAPPING` for a surface without area, or `ERROR_WRONG_PARAMETER` for a radius that is not
  ///         positive and finite, or a coordinate that is not finite
  template <class VertexUVMap, class VertexIndexMap, class VertexParameterizedMap>
  CGAL::Surface_mesh_parameterization::Error_code parameterize(const Triangle_mesh& mesh, halfedge_descriptor bhd,
                                                               VertexUVMap uvmap, VertexIndexMap /* vimap */,
                                                               VertexParameterizedMap vpmap) const
  {
    namespace SMP = CGAL::Surface_mesh_parameterization;
    if(!(m_radius > 0 && std::isfinite(m_radius)))
      return SMP::ERROR_WRONG_PARAMETER;
    const std::vector<vertex_descriptor> loop = internal::border_loop(bhd, mesh);
    if(loop.size() < 3)
      return SMP::ERROR_BORDER_TOO_SHORT;
    std::vector<double> lengths;
    try {
      lengths = internal::measured_border(mesh, bhd, loop, get(CGAL::vertex_point, mesh));
    } catch(const internal::Unmappable& error) {
      return error.code();
    }
    internal::write_uv(loop, internal::circular_border(lengths, m_radius), uvmap, vpmap);
    return SMP::OK;
  }

  /// indicates if the border's shape is convex.
  bool is_border_convex() const { return true; }

private:
  double m_radius;
};

} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_CIRCULAR_BORDER_ARC_LENGTH_PARAMETERIZER_3_H
