// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_SQUARE_BORDER_ARC_LENGTH_PARAMETERIZER_3_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_SQUARE_BORDER_ARC_LENGTH_PARAMETERIZER_3_H

#include <CGAL_ext/Square_parameterization/Corner_rule.h>
#include <CGAL_ext/Square_parameterization/internal/border/border_curves.h>
#include <CGAL_ext/Square_parameterization/internal/patch/write_uv.h>
#include <CGAL_ext/Square_parameterization/internal/surface/measured_border.h>

#include <array>
#include <optional>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {

/// \ingroup PkgSquareParameterizationBorderParameterizers
///
/// parameterizes the border of a disk onto the unit square by arc length, each side scaled by its own length, without a
/// search.
///
/// It differs from CGAL's class of the same name in what it guarantees: the four corners are distinct and in order
/// whatever the edge lengths, every border vertex lies on the square, and the map is not mirrored: faces that are
/// counter-clockwise in 3D are counter-clockwise in the plane.
///
/// Thread safety: one object may be used by several threads at a time.
///
/// \cgalModels `Parameterizer_3`
///
/// \tparam TriangleMesh_ must be a model of `FaceGraph`. Coordinates are read as `double`.
template <class TriangleMesh_>
class Square_border_arc_length_parameterizer_3
{
public:
  typedef TriangleMesh_ Triangle_mesh;
  typedef TriangleMesh_ TriangleMesh;
  typedef typename boost::graph_traits<Triangle_mesh>::vertex_descriptor vertex_descriptor;
  typedef typename boost::graph_traits<Triangle_mesh>::halfedge_descriptor halfedge_descriptor;

  /// constructs a parameterizer that puts the source of the border halfedge onto the corner (0, 0).
  /// \param corner_rule where the sides of the square end
  /// \param walk direction in which the sides are closed
  explicit Square_border_arc_length_parameterizer_3(Corner_rule corner_rule = Corner_rule::NEAREST,
                                                    Walk walk = Walk::COUNTER_CLOCKWISE)
    : m_corner_rule(corner_rule), m_walk(walk)
  {}

  /// constructs a parameterizer that puts four given vertices onto the corners (0, 0), (1, 0), (1, 1) and (0, 1).
  /// The vertices must be distinct and lie on the border, in counter-clockwise order; otherwise `parameterize()`
  /// returns `ERROR_WRONG_PARAMETER`.
  Square_border_arc_length_parameterizer_3(vertex_descriptor v0, vertex_descriptor v1, vertex_descriptor v2,
                                           vertex_descriptor v3)
    : m_corner_vertices({v0, v1, v2, v3})
  {}

  /// assigns to the vertices of the border their position on the square, and marks them as parameterized.
  /// An edge shorter than 1e-8 sqrt(area) counts as 1e-4 sqrt(area) long, with the area of the connected component, as
  /// in the border parameterizers that search: no two vertices coincide. Complexity: linear in the component.
  /// \return `OK`, `ERROR_BORDER_TOO_SHORT` for a border of fewer than four vertices or a halfedge that is on none,
  ///         `ERROR_NO_1_TO_1_MAPPING` for a surface without area, or `ERROR_WRONG_PARAMETER` for corners that are not
  ///         distinct and in order on the border, or a coordinate that is not finite
  template <class VertexUVMap, class VertexIndexMap, class VertexParameterizedMap>
  CGAL::Surface_mesh_parameterization::Error_code parameterize(const Triangle_mesh& mesh, halfedge_descriptor bhd,
                                                               VertexUVMap uvmap, VertexIndexMap /* vimap */,
                                                               VertexParameterizedMap vpmap) const
  {
    namespace SMP = CGAL::Surface_mesh_parameterization;
    const std::vector<vertex_descriptor> loop = internal::border_loop(bhd, mesh);
    if(loop.size() < 4)
      return SMP::ERROR_BORDER_TOO_SHORT;
    std::vector<double> lengths;
    try {
      lengths = internal::measured_border(mesh, bhd, loop, get(CGAL::vertex_point, mesh));
    } catch(const internal::Unmappable& error) {
      return error.code();
    }
    const internal::Border_walk walk(lengths, m_walk);
    internal::Corners corners = internal::corners_of_candidate(walk, 0, m_corner_rule);
    if(m_corner_vertices) {
      for(int k = 0; k < 4; ++k)
        corners[k] = static_cast<int>(std::find(loop.begin(), loop.end(), (*m_corner_vertices)[k]) - loop.begin());
      if(*std::max_element(corners.begin(), corners.end()) == walk.size() ||
         !internal::are_corners_in_order(corners, walk.size()))
        return SMP::ERROR_WRONG_PARAMETER;
    }
    internal::write_uv(loop, internal::square_border(walk, corners).uv, uvmap, vpmap);
    return SMP::OK;
  }

  /// indicates if the border's shape is convex.
  bool is_border_convex() const { return true; }

private:
  Corner_rule m_corner_rule = Corner_rule::NEAREST;
  Walk m_walk = Walk::COUNTER_CLOCKWISE;
  std::optional<std::array<vertex_descriptor, 4>> m_corner_vertices;
};

} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_SQUARE_BORDER_ARC_LENGTH_PARAMETERIZER_3_H
