// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_WRITE_STL_H
#define SQUARE_MAP_WRITE_STL_H

#include "Output_file.h"

#include <Eigen/Geometry>
#include <boost/endian/conversion.hpp>

#include <cstdint>
#include <cstring>
#include <limits>
#include <ostream>
#include <string>

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

/// writes the faces of a triangle mesh as binary STL: without texture coordinates, for which it has no place. CGAL's
/// writer puts normals that are no numbers beside very small triangles, and infinite coordinates.
/// \throw Output_error for a coordinate that is too large for STL; nothing is written then
template <class Mesh>
void write_stl(std::ostream& stream, const Mesh& mesh)
{
  const auto vector = [&mesh](typename Mesh::Vertex_index v) {
    const auto& p = mesh.point(v);
    return Eigen::Vector3d(p.x(), p.y(), p.z());
  };
  for(const auto v : mesh.vertices())
    if(!(vector(v).cwiseAbs().maxCoeff() <= static_cast<double>(std::numeric_limits<float>::max())))
      throw Output_error("STL has no number as large as the coordinates of this surface");
  std::string header = "binary STL written by square_map";
  header.resize(80, ' ');
  stream << header;
  write_stl_number(stream, static_cast<std::uint32_t>(mesh.number_of_faces()));
  for(const auto f : mesh.faces()) {
    Eigen::Vector3d corners[3];
    int k = 0;
    for(const auto v : mesh.vertices_around_face(mesh.halfedge(f)))
      corners[k++] = vector(v);
    const Eigen::Vector3d normal = (corners[1] - corners[0])
                                       .stableNormalized()
                                       .cross((corners[2] - corners[0]).stableNormalized())
                                       .stableNormalized(); // zero for a triangle without area
    for(const Eigen::Vector3d& row : {normal, corners[0], corners[1], corners[2]})
      for(int i = 0; i < 3; ++i)
        write_stl_number(stream, row[i]);
    stream.write("\0\0", 2); // attributes
  }
}

} // namespace square_map

#endif // SQUARE_MAP_WRITE_STL_H
