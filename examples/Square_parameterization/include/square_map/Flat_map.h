// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_FLAT_MAP_H
#define SQUARE_MAP_FLAT_MAP_H

#include "write_map.h"

#include <CGAL_ext/Square_parameterization/internal/patch/write_uv.h>
#include <CGAL_ext/Square_parameterization/internal/sampling/vertex_normals.h>
#include <CGAL_ext/Square_parameterization/internal/surface/Face_graph_arrays.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>
#include <vector>

namespace square_map {

/// the map as flat arrays, which pictures are made of
struct Flat_map
{
  std::vector<Eigen::Vector3d> points;       ///< #V of the surface cut open
  std::vector<std::array<int, 3>> triangles; ///< #F
  CGAL_ext::internal::Uv_coordinates uv;     ///< #V by 2
  std::vector<int> originals;                ///< #V, the vertex of the uncut surface; itself for one that was added
  std::vector<Eigen::Vector3d> normals;      ///< #V, the same on both sides of a seam
  Vertex_colors colors;                      ///< #V, the same on both sides of a seam; empty unless asked for

  Eigen::AlignedBox3d box() const
  {
    Eigen::AlignedBox3d box;
    for(const Eigen::Vector3d& p : points)
      box.extend(p);
    return box;
  }
};

/// \param originals per vertex of the mesh, the vertex of the uncut one; vertices beyond were added
inline Flat_map flat_map(const Mesh& mesh, UV_map uv, const std::vector<int>& originals)
{
  using namespace CGAL_ext::internal;
  auto [arrays, vertices] = read_faces(mesh, mesh.faces(), mesh.points());
  Flat_map map;
  map.points = std::move(arrays.points);
  map.triangles = std::move(arrays.triangles);
  map.uv = read_uv(vertices, uv);
  map.originals.resize(map.points.size()); // a conditioned mesh has no vertex without a face
  std::iota(map.originals.begin(), map.originals.end(), 0);
  std::copy(originals.begin(), originals.end(), map.originals.begin());
  map.normals = vertex_normals(map.points, map.triangles, map.originals);
  return map;
}

} // namespace square_map

#endif // SQUARE_MAP_FLAT_MAP_H
