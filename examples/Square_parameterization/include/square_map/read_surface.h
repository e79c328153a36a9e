// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_READ_SURFACE_H
#define SQUARE_MAP_READ_SURFACE_H

#include <CGAL_ext/Square_parameterization/internal/condition_soup.h>

#include "Memory_limit.h"
#include "check_ply_header.h"

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace square_map {

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

/// a file that cannot be read, or whose content makes no sense
struct Malformed_file : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

// what a reader may allocate, in bytes; real files need a third of it
constexpr std::size_t MEMORY_TO_START_READING = 1 << 28, MEMORY_PER_BYTE = 64;

/// reads points and polygons through CGAL's readers (OFF, OBJ, PLY, STL by extension)
inline CGAL_ext::internal::Surface_soup read_soup(const std::string& path)
{
  std::error_code error;
  if(!std::filesystem::exists(path, error))
    throw Malformed_file("cannot read '" + path + "': there is no such file");
  if(!std::filesystem::is_regular_file(path, error))
    throw Malformed_file("cannot read '" + path + "': it is not a regular file");
  const std::string fault = ply_header_fault(path);
  if(!fault.empty())
    throw Malformed_file("cannot read '" + path + "': " + fault);
  std::vector<Kernel::Point_3> points;
  CGAL_ext::internal::Surface_soup soup;
  bool is_read = false;
  try {
    const Memory_limit limit(MEMORY_TO_START_READING + MEMORY_PER_BYTE * std::filesystem::file_size(path));
    is_read = CGAL::IO::read_polygon_soup(path, points, soup.faces, CGAL::parameters::verbose(false));
  } catch(const std::exception&) {
    // among them std::bad_alloc, for a header that promises more than the file holds
  }
  if(!is_read || (points.empty() && soup.faces.empty()))
    throw Malformed_file("cannot read '" + path + "': it is not a complete OFF, OBJ, PLY or STL file");
  for(const Kernel::Point_3& p : points)
    soup.points.emplace_back(p.x(), p.y(), p.z());
  return soup;
}

/// refuses coordinates that are not finite and faces that have too few vertices or name one that does not exist
inline void check_well_formed(const CGAL_ext::internal::Surface_soup& soup, const std::string& path)
{
  for(std::size_t v = 0; v < soup.points.size(); ++v)
    if(!soup.points[v].allFinite())
      throw Malformed_file("'" + path + "' is malformed: vertex " + std::to_string(v) +
                           " has a coordinate that is not finite");
  for(std::size_t f = 0; f < soup.faces.size(); ++f) {
    if(soup.faces[f].size() < 3)
      throw Malformed_file("'" + path + "' is malformed: face " + std::to_string(f) + " has " +
                           std::to_string(soup.faces[f].size()) + " vertices");
    for(std::size_t v : soup.faces[f])
      if(v >= soup.points.size())
        throw Malformed_file("'" + path + "' is malformed: face " + std::to_string(f) + " names vertex " +
                             std::to_string(v) + " of " + std::to_string(soup.points.size()));
  }
}

/// reads seams: two vertex numbers a line; returns them as vertices of the conditioned soup
inline std::vector<std::array<std::size_t, 2>> read_seams(const std::string& path,
                                                          const CGAL_ext::internal::Conditioning_report& conditioning)
{
  std::ifstream file(path);
  if(!file)
    throw Malformed_file("cannot read '" + path + "'");
  std::vector<std::array<std::size_t, 2>> seams;
  std::size_t line_number = 0;
  for(std::string line; std::getline(file, line);) {
    ++line_number;
    std::istringstream stream(line);
    long ends[2];
    if((stream >> std::ws).eof())
      continue;
    if(!(stream >> ends[0] >> ends[1]) || !(stream >> std::ws).eof())
      throw Malformed_file("'" + path + "' is malformed: line " + std::to_string(line_number) +
                           " is not two vertex numbers");
    std::array<std::size_t, 2> seam{};
    for(int k = 0; k < 2; ++k) {
      using CGAL_ext::internal::Conditioning_report;
      if(ends[k] < 0 || static_cast<std::size_t>(ends[k]) >= conditioning.new_index.size() ||
         conditioning.new_index[ends[k]] == Conditioning_report::DROPPED)
        throw Malformed_file("'" + path + "' is malformed: line " + std::to_string(line_number) + " names vertex " +
                             std::to_string(ends[k]) + ", which no mapped face has");
      seam[k] = conditioning.new_index[ends[k]];
    }
    seams.push_back(seam);
  }
  return seams;
}

/// the mesh of a conditioned soup; vertices and faces keep their order
inline Mesh make_mesh(const CGAL_ext::internal::Surface_soup& soup)
{
  Mesh mesh;
  mesh.reserve(soup.points.size(), soup.points.size() + soup.faces.size(), soup.faces.size());
  for(const Eigen::Vector3d& p : soup.points)
    mesh.add_vertex(Kernel::Point_3(p.x(), p.y(), p.z()));
  for(const auto& face : soup.faces)
    mesh.add_face(Mesh::Vertex_index(face[0]), Mesh::Vertex_index(face[1]), Mesh::Vertex_index(face[2]));
  return mesh;
}

} // namespace square_map

#endif // SQUARE_MAP_READ_SURFACE_H
