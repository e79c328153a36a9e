// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_READ_SURFACE_H
#define SQUARE_MAP_READ_SURFACE_H

#include <CGAL_ext/Square_parameterization/internal/patch/number_edges.h>
#include <CGAL_ext/Square_parameterization/internal/soup/condition_soup.h>
#include <CGAL_ext/Square_parameterization/internal/surface/halfedge_between.h>

#include "File_format.h"
#include "Memory_limit.h"
#include "read_bytes.h"
#include "read_ply.h"
#include "read_seams.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace square_map {

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

// what a reader may allocate, in bytes; real files need a third of it
constexpr std::size_t MEMORY_TO_START_READING = 1 << 28, MEMORY_PER_BYTE = 64;

/// reads points and polygons of a text, by the reader of its format
/// \throw Malformed_file with the reason alone
inline CGAL_ext::internal::Surface_soup parse_soup(std::string_view text, File_format format, Passed_over& passed_over,
                                                   Vertex_colors* colors = nullptr)
{
  const Memory_limit limit(MEMORY_TO_START_READING + MEMORY_PER_BYTE * text.size());
  switch(format) {
  case File_format::OFF:
    return read_off(text, passed_over, colors);
  case File_format::OBJ:
    return read_obj(text, passed_over, colors);
  case File_format::PLY:
    return read_ply(text, passed_over, colors);
  default:
    return read_stl(text, passed_over);
  }
}

/// what to say after the reason why a file could not be read in a format: that it begins as one of another
inline std::string other_format(std::string_view text, File_format format)
{
  const std::optional<File_format> begun = format_of_content(text);
  return begun && *begun != format ? std::string("; it begins as ") + name_of(*begun) : "";
}

/// refuses coordinates that are not finite and faces that have too few vertices or name one that does not exist
/// \throw Malformed_file with the reason alone
inline void check_well_formed(const CGAL_ext::internal::Surface_soup& soup)
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
    throw Malformed_file(complaint.text());
}

/// reads points and polygons of a file or a pipe, which are well formed; "-" is standard input
/// \param format_name the format, in place of what the extension says; empty for none
/// \param passed_over what of the file was not used is added, unless it is null
/// \param colors receives the colors of the vertices, unless it is null; none for a file that has none
inline CGAL_ext::internal::Surface_soup read_soup(const std::string& path, const std::string& format_name = "",
                                                  Passed_over* passed_over = nullptr, Vertex_colors* colors = nullptr)
{
  Passed_over unused;
  std::string reader, hint; // in messages
  try {
    const File_bytes file = read_bytes(path);
    const std::string_view text =
        has_size_of_binary_stl(file.bytes) ? std::string_view(file.bytes) : without_byte_order_mark(file.bytes);
    const File_format format =
        format_name.empty() ? format_of(path, file.is_stream, text) : file_formats().at(format_name);
    if(text.empty())
      throw Malformed_file("it is empty");
    reader = std::string(" as ") + name_of(format);
    hint = other_format(text, format);
    CGAL_ext::internal::Surface_soup soup =
        parse_soup(text, format, passed_over != nullptr ? *passed_over : unused, colors);
    if(soup.points.empty() && soup.faces.empty())
      throw Malformed_file("it has neither vertices nor faces");
    check_well_formed(soup);
    return soup;
  } catch(const Malformed_file& error) {
    throw Malformed_file("cannot read " + (path == "-" ? "standard input" : "'" + path + "'") + reader + ": " +
                         error.what() + hint);
  }
}

/// the vertex of a mesh with a number
inline Mesh::Vertex_index vertex(std::size_t v)
{
  return Mesh::Vertex_index(static_cast<Mesh::size_type>(v));
}

/// joins the halfedges without a face, of which at most one ends at each vertex, and gives each vertex one that ends there:
/// one without a face where there is one
inline void join_borders(Mesh& mesh)
{
  std::vector<Mesh::Halfedge_index> leaving(mesh.number_of_vertices(), Mesh::null_halfedge());
  for(const Mesh::Halfedge_index h : mesh.halfedges()) {
    if(mesh.is_border(h))
      leaving[mesh.source(h)] = h;
    else
      mesh.set_halfedge(mesh.target(h), h);
  }
  for(const Mesh::Halfedge_index h : leaving)
    if(h != Mesh::null_halfedge()) {
      mesh.set_next(h, leaving[mesh.target(h)]);
      mesh.set_halfedge(mesh.target(h), h);
    }
}

/// the mesh of a conditioned soup; vertices and faces keep their order. Linear in the faces but for sorting the edges at each
/// vertex: to add face by face walks round vertices, and takes the square of their valence.
inline Mesh make_mesh(const CGAL_ext::internal::Surface_soup& soup)
{
  std::vector<std::array<int, 3>> triangles;
  for(const auto& face : soup.faces)
    triangles.push_back({static_cast<int>(face[0]), static_cast<int>(face[1]), static_cast<int>(face[2])});
  const CGAL_ext::internal::Edge_numbering numbering = CGAL_ext::internal::number_edges(soup.points.size(), triangles);

  Mesh mesh;
  mesh.reserve(static_cast<Mesh::size_type>(soup.points.size()), static_cast<Mesh::size_type>(numbering.edges.size()),
               static_cast<Mesh::size_type>(triangles.size()));
  for(const Eigen::Vector3d& p : soup.points)
    mesh.add_vertex(Kernel::Point_3(p.x(), p.y(), p.z()));
  for(const auto& [low, high] : numbering.edges)
    mesh.add_edge(vertex(low), vertex(high));
  for(std::size_t f = 0; f < triangles.size(); ++f) {
    const Mesh::Face_index face = mesh.add_face();
    std::array<Mesh::Halfedge_index, 3> sides; // side k ends at corner k
    for(std::size_t k = 0; k < 3; ++k) {
      const Mesh::Edge_index edge(static_cast<Mesh::size_type>(numbering.triangle_edges[f][(k + 1) % 3]));
      sides[k] = mesh.halfedge(edge, triangles[f][(k + 2) % 3] < triangles[f][k] ? 0 : 1);
      mesh.set_face(sides[k], face);
    }
    for(std::size_t k = 0; k < 3; ++k)
      mesh.set_next(sides[k], sides[(k + 1) % 3]);
    mesh.set_halfedge(face, sides[0]);
  }
  join_borders(mesh);
  return mesh;
}

/// the edges of the mesh along the seams of a file. Throws `Unmappable` where there is none.
inline std::vector<Mesh::Edge_index> edges_of(const std::vector<File_seam>& seams, const Mesh& mesh,
                                              const std::string& path)
{
  std::vector<Mesh::Edge_index> edges;
  for(const auto& [ends, place] : seams) {
    const auto h = CGAL_ext::internal::halfedge_between(vertex(ends[0]), vertex(ends[1]), mesh);
    if(h == Mesh::null_halfedge())
      throw CGAL_ext::internal::Unmappable(CGAL::Surface_mesh_parameterization::ERROR_WRONG_PARAMETER,
                                           "'" + path + "', " + place + " is not an edge of the surface");
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
