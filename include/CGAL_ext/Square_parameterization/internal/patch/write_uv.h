// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PATCH_WRITE_UV_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PATCH_WRITE_UV_H

#include <CGAL_ext/Square_parameterization/internal/common/Unmappable.h>
#include <CGAL_ext/Square_parameterization/internal/patch/Patch.h>
#include <CGAL_ext/Square_parameterization/internal/patch/exact_orientation.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/number_utils.h>

#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstddef>
#include <string>
#include <type_traits>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// refuses a map that is one-to-one, mirrored or not, but is no more once it is rounded to the numbers of a uv map, as `float`.
/// Throws `Unmappable`. Complexity: linear; nothing is done for `double`.
template <class VertexUVMap>
void check_rounding(const std::vector<std::array<int, 3>>& triangles, const Uv_coordinates& uv)
{
  typedef typename boost::property_traits<VertexUVMap>::value_type Point_2;
  typedef typename CGAL::Kernel_traits<Point_2>::Kernel::FT FT;
  if constexpr(!std::is_same_v<FT, double>) {
    Uv_coordinates rounded = uv.unaryExpr([](double x) { return CGAL::to_double(FT(x)); });
    if(triangles.empty() || rounded == uv)
      return;
    if(!is_counterclockwise(uv, triangles.front()))
      rounded.col(0).swap(rounded.col(1));
    if(const std::size_t flipped = number_of_flipped_faces(triangles, rounded); flipped > 0)
      throw Unmappable(CGAL::Surface_mesh_parameterization::ERROR_NO_1_TO_1_MAPPING,
                       "rounded to the numbers of the uv map, the triangles of " + std::to_string(flipped) +
                           (flipped == 1 ? " face are" : " faces are") + " flat or flipped");
  }
}

/// writes row `k` of \p uv for `vertices[k]`, in the number type of the map, and marks the vertex as parameterized
template <class Vertex, class VertexUVMap, class VertexParameterizedMap>
void write_uv(const std::vector<Vertex>& vertices, const Uv_coordinates& uv, VertexUVMap uvmap,
              VertexParameterizedMap vpmap)
{
  typedef typename boost::property_traits<VertexUVMap>::value_type Point_2;
  typedef typename CGAL::Kernel_traits<Point_2>::Kernel::FT FT;
  for(std::size_t k = 0; k < vertices.size(); ++k) {
    put(uvmap, vertices[k], Point_2(FT(uv(k, 0)), FT(uv(k, 1))));
    put(vpmap, vertices[k], true);
  }
}

/// reads row `k` of the result from `vertices[k]`
template <class Vertex, class VertexUVMap>
Uv_coordinates read_uv(const std::vector<Vertex>& vertices, VertexUVMap uvmap)
{
  Uv_coordinates uv(vertices.size(), 2);
  for(std::size_t k = 0; k < vertices.size(); ++k) {
    const auto& p = get(uvmap, vertices[k]);
    uv(k, 0) = CGAL::to_double(p.x());
    uv(k, 1) = CGAL::to_double(p.y());
  }
  return uv;
}

/// the mesh vertices at the given vertices of a patch
template <class Vertex>
std::vector<Vertex> select(const std::vector<Vertex>& vertices, const std::vector<int>& selection)
{
  std::vector<Vertex> selected;
  for(int v : selection)
    selected.push_back(vertices[v]);
  return selected;
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PATCH_WRITE_UV_H
