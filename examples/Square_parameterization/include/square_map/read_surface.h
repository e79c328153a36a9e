// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_READ_SURFACE_H
#define SQUARE_MAP_READ_SURFACE_H

#include <CGAL_ext/Square_parameterization/internal/soup/condition_soup.h>

#include "Memory_limit.h"
#include "check_ply_header.h"
#include "read_off.h"

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <cctype>
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

/// extension of the path in lower case, without the dot
inline std::string extension_of(const std::string& path)
{
  std::string extension = std::filesystem::path(path).extension().string();
  extension.erase(0, 1);
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

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
    is_read = extension_of(path) == "off"
                  ? read_off(path, points, soup.faces)
                  : CGAL::IO::read_polygon_soup(path, points, soup.faces, CGAL::parameters::verbose(false));
  } catch(const std::exception&) {
    // among them std::bad_alloc, for a header that promises more than the file holds
  }
  if(!is_read || (points.empty() && soup.faces.empty()))
    throw Malformed_file("cannot read '" + path +
                         "': it is not a complete OFF, OBJ, PLY or STL file, or has a coordinate "
                         "or an index that is no number or out of range");
  for(const Kernel::Point_3& p : points)
    soup.points.emplace_back(p.x(), p.y(), p.z());
  return soup;
}

/// refuses coordinates that are not finite and faces that have too few vertices or name one that does not exist
inline void check_well_formed(const CGAL_ext::internal::Surface_soup& soup, const std::string& path)
{
  using CGAL_ext::internal::NAMED_PLACES;
  std::size_t infinite = 0, short_faces = 0, out_of_range = 0;
  std::vector<std::string> infinite_places, short_places, out_of_range_places;
  const auto face_name = [](std::size_t f) { return "face " + std::to_string(f); };
  for(std::size_t v = 0; v < soup.points.size(); ++v)
    if(!soup.points[v].allFinite() && ++infinite <= NAMED_PLACES)
      infinite_places.push_back("vertex " + std::to_string(v));
  for(std::size_t f = 0; f < soup.faces.size(); ++f) {
    const auto& face = soup.faces[f];
    if(face.size() < 3 && ++short_faces <= NAMED_PLACES)
      short_places.push_back(face_name(f) + " has " + std::to_string(face.size()));
    const auto missing =
        std::find_if(face.begin(), face.end(), [&soup](std::size_t v) { return v >= soup.points.size(); });
    if(missing != face.end() && ++out_of_range <= NAMED_PLACES) // a negative number was read as a large one
      out_of_range_places.push_back(face_name(f) + " names vertex " +
                                    std::to_string(static_cast<std::ptrdiff_t>(*missing)) + " of " +
                                    std::to_string(soup.points.size()));
  }
  CGAL_ext::internal::Complaint complaint;
  complaint.add(infinite, "vertex has a coordinate that is not finite", "vertices have a coordinate that is not finite",
                infinite_places);
  complaint.add(short_faces, "face has fewer than three vertices", "faces have fewer than three vertices",
                short_places);
  complaint.add(out_of_range, "face names a vertex that does not exist", "faces name vertices that do not exist",
                out_of_range_places);
  if(!complaint.text().empty())
    throw Malformed_file("'" + path + "' is malformed: " + complaint.text());
}

/// the vertex of the conditioned soup that a vertex of the file has become; `DROPPED` when there is none
inline std::size_t conditioned_vertex(std::size_t v, const CGAL_ext::internal::Conditioning_report& conditioning)
{
  return v < conditioning.new_index.size() ? conditioning.new_index[v]
                                           : CGAL_ext::internal::Conditioning_report::DROPPED;
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
      seam[k] = conditioned_vertex(static_cast<std::size_t>(ends[k]), conditioning); // a negative number is a large one
      if(seam[k] == CGAL_ext::internal::Conditioning_report::DROPPED)
        throw Malformed_file("'" + path + "' is malformed: line " + std::to_string(line_number) + " names vertex " +
                             std::to_string(ends[k]) + ", which no mapped face has");
    }
    seams.push_back(seam);
  }
  return seams;
}

/// the vertex of a mesh with a number
inline Mesh::Vertex_index vertex(std::size_t v)
{
  return Mesh::Vertex_index(static_cast<Mesh::size_type>(v));
}

/// the mesh of a conditioned soup; vertices and faces keep their order
inline Mesh make_mesh(const CGAL_ext::internal::Surface_soup& soup)
{
  Mesh mesh;
  const auto V = static_cast<Mesh::size_type>(soup.points.size()), F = static_cast<Mesh::size_type>(soup.faces.size());
  mesh.reserve(V, V + F, F);
  for(const Eigen::Vector3d& p : soup.points)
    mesh.add_vertex(Kernel::Point_3(p.x(), p.y(), p.z()));
  for(const auto& face : soup.faces)
    mesh.add_face(vertex(face[0]), vertex(face[1]), vertex(face[2]));
  return mesh;
}

/// the edges of the mesh between pairs of vertices. Throws `Unmappable` where there is none.
inline std::vector<Mesh::Edge_index> edges_between(const std::vector<std::array<std::size_t, 2>>& pairs,
                                                   const Mesh& mesh)
{
  std::vector<Mesh::Edge_index> edges;
  for(const auto& [a, b] : pairs) {
    const auto h = mesh.halfedge(vertex(a), vertex(b));
    if(h == Mesh::null_halfedge())
      throw CGAL_ext::internal::Unmappable(CGAL::Surface_mesh_parameterization::ERROR_WRONG_PARAMETER,
                                           "the seam from vertex " + std::to_string(a) + " to vertex " +
                                               std::to_string(b) + " is not an edge of the surface");
    edges.push_back(mesh.edge(h));
  }
  return edges;
}

/// the vertices of the mesh that vertices of the file have become; none of its own for one that was dropped
inline std::array<Mesh::Vertex_index, 4> mesh_vertices(const std::array<std::size_t, 4>& file_vertices,
                                                       const CGAL_ext::internal::Conditioning_report& conditioning)
{
  std::array<Mesh::Vertex_index, 4> result;
  for(std::size_t k = 0; k < 4; ++k)
    if(const std::size_t v = conditioned_vertex(file_vertices[k], conditioning);
       v != CGAL_ext::internal::Conditioning_report::DROPPED)
      result[k] = vertex(v);
  return result;
}

} // namespace square_map

#endif // SQUARE_MAP_READ_SURFACE_H
