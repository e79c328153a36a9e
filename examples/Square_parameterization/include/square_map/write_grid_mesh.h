// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_WRITE_GRID_MESH_H
#define SQUARE_MAP_WRITE_GRID_MESH_H

#include "Geometry_image.h"
#include "write_stl.h"

#include <CGAL/IO/OBJ.h>
#include <CGAL/IO/OFF.h>
#include <CGAL/IO/PLY.h>

#include <array>
#include <ostream>
#include <string>
#include <vector>

namespace square_map {

/// writes the surface that is rebuilt from the samples, in the format of \p extension: obj, off, ply or stl (both binary)
inline void write_grid_mesh(std::ostream& stream, const Geometry_image& image, const std::string& extension)
{
  if(extension == "stl") {
    std::vector<std::array<Eigen::Vector3d, 3>> corners;
    for(const auto& [a, b, c] : image.mesh.triangles)
      corners.push_back({image.mesh_point(a), image.mesh_point(b), image.mesh_point(c)});
    write_stl(stream, corners);
    return;
  }
  const auto precision = CGAL::parameters::stream_precision(17);
  std::vector<Kernel::Point_3> points;
  for(std::size_t sample : image.mesh.samples) {
    const Eigen::Vector3d& p = image.points[sample];
    points.emplace_back(p.x(), p.y(), p.z());
  }
  if(extension == "obj")
    CGAL::IO::write_OBJ(stream, points, image.mesh.triangles, precision);
  else if(extension == "off")
    CGAL::IO::write_OFF(stream, points, image.mesh.triangles, precision);
  else {
    CGAL::IO::set_binary_mode(stream);
    CGAL::IO::write_PLY(stream, points, image.mesh.triangles, precision);
  }
}

} // namespace square_map

#endif // SQUARE_MAP_WRITE_GRID_MESH_H
