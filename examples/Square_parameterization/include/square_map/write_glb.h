// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_WRITE_GLB_H
#define SQUARE_MAP_WRITE_GLB_H

#include <Eigen/Core>

#include <array>
#include <ostream>
#include <string>
#include <vector>

namespace square_map {

/// writes a textured surface as binary glTF 2.0, with one vertex for each of the surface cut open. Coordinates, which
/// glTF has in 32 bits, are relative to the center of the bounding box, where the node stands.
/// \param uv #V by 2, v upwards
/// \param png the texture, the bytes of a PNG file
/// \throw Output_error for a surface that is too large for 32 bits
void write_glb(std::ostream& stream, const std::vector<Eigen::Vector3d>& points,
               const std::vector<Eigen::Vector3d>& normals,
               const Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor>& uv,
               const std::vector<std::array<int, 3>>& triangles, const std::string& png);

} // namespace square_map

#endif // SQUARE_MAP_WRITE_GLB_H
