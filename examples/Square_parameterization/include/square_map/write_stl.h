// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_WRITE_STL_H
#define SQUARE_MAP_WRITE_STL_H

#include "Output_file.h"

#include <Eigen/Geometry>
#include <boost/endian/conversion.hpp>

#include <array>
#include <cstdint>
#include <cstring>
#include <limits>
#include <ostream>
#include <string>
#include <vector>

namespace square_map {

/// numbers in the order of bytes of STL
inline void write_stl_number(std::ostream& stream, std::uint32_t bits)
{
  boost::endian::native_to_little_inplace(bits);
  stream.write(reinterpret_cast<const char*>(&bits), sizeof bits);
}

/// a coordinate, rounded to the four bytes that STL has for it
inline void write_stl_number(std::ostream& stream, double x)
{
  const float rounded = static_cast<float>(x);
  std::uint32_t bits = 0;
  std::memcpy(&bits, &rounded, sizeof bits);
  write_stl_number(stream, bits);
}

/// writes triangles as binary STL: without texture coordinates, for which it has no place. CGAL's writer puts normals
/// that are no numbers beside very small triangles, and infinite coordinates.
/// \throw Output_error for a coordinate that is too large for STL; nothing is written then
inline void write_stl(std::ostream& stream, const std::vector<std::array<Eigen::Vector3d, 3>>& triangles)
{
  for(const auto& triangle : triangles)
    for(const Eigen::Vector3d& p : triangle)
      if(!(p.cwiseAbs().maxCoeff() <= static_cast<double>(std::numeric_limits<float>::max())))
        throw Output_error("STL has no number as large as the coordinates of this surface");
  std::string header = "binary STL written by square_map";
  header.resize(80, ' ');
  stream << header;
  write_stl_number(stream, static_cast<std::uint32_t>(triangles.size()));
  for(const auto& [a, b, c] : triangles) {
    const Eigen::Vector3d normal = (b - a).stableNormalized().cross((c - a).stableNormalized()).stableNormalized();
    for(const Eigen::Vector3d& row : {normal, a, b, c}) // the normal of a triangle without area is zero
      for(int i = 0; i < 3; ++i)
        write_stl_number(stream, row[i]);
    stream.write("\0\0", 2); // attributes
  }
}

/// writes the faces of a triangle mesh
template <class Mesh>
void write_stl_of(std::ostream& stream, const Mesh& mesh)
{
  std::vector<std::array<Eigen::Vector3d, 3>> triangles;
  for(const auto f : mesh.faces()) {
    auto corner = triangles.emplace_back().begin();
    for(const auto v : mesh.vertices_around_face(mesh.halfedge(f))) {
      const auto& p = mesh.point(v);
      *corner++ = {p.x(), p.y(), p.z()};
    }
  }
  write_stl(stream, triangles);
}

} // namespace square_map

#endif // SQUARE_MAP_WRITE_STL_H
