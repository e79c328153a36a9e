// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_WRITE_MAP_H
#define SQUARE_MAP_WRITE_MAP_H

#include "read_surface.h"
#include "write_stl.h"

#include <CGAL/Surface_mesh/IO/OFF.h>
#include <CGAL/Surface_mesh/IO/PLY.h>

#include <algorithm>
#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

namespace square_map {

typedef Mesh::Property_map<Mesh::Vertex_index, Kernel::Point_2> UV_map;

/// Wavefront OBJ: one texture vertex per vertex of the cut mesh, faces `v/vt`. The vertices are those of the uncut
/// surface, in their order, followed by the midpoints of split chords: a seam parts texture vertices alone. Vertices
/// without a face, and those of components that are not mapped, are left out.
/// \param originals per vertex of the cut mesh, the vertex of the uncut one; vertices beyond are midpoints
/// \param aspect width over height of the rectangle that the unit square stands for: a comment, unless it is 1
/// \param materials the name of the file with the material `square`; empty for none
inline void write_obj(std::ostream& stream, const Mesh& mesh, UV_map uv, const std::vector<int>& originals,
                      double aspect, const std::string& materials)
{
  if(aspect != 1)
    stream << "# aspect " << aspect << '\n';
  if(!materials.empty())
    stream << "mtllib " << materials << "\nusemtl square\n";
  const std::size_t uncut = originals.empty() ? 0 : *std::max_element(originals.begin(), originals.end()) + 1;
  const auto vertex_number = [&](Mesh::Vertex_index v) {
    return (v.idx() < originals.size() ? originals[v.idx()] : uncut + (v.idx() - originals.size())) + 1;
  };
  for(Mesh::Vertex_index v : mesh.vertices())
    if(v.idx() < uncut || v.idx() >= originals.size())
      stream << "v " << mesh.point(v) << '\n';
  for(Mesh::Vertex_index v : mesh.vertices())
    stream << "vt " << uv[v] << '\n';
  for(Mesh::Face_index f : mesh.faces()) {
    stream << 'f';
    for(Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f)))
      stream << ' ' << vertex_number(v) << '/' << v.idx() + 1;
    stream << '\n';
  }
}

/// writes the mesh with its map, in the format of \p extension: obj, off (STOFF: texture coordinates after each point),
/// ply (vertex properties s and t), or stl (the mesh alone)
/// \param aspect of an OBJ file, see `write_obj()`
/// \param materials of an OBJ file, see `write_obj()`
inline void write_map(std::ostream& stream, Mesh& mesh, UV_map uv, const std::vector<int>& originals,
                      const std::string& extension, double aspect, const std::string& materials = "")
{
  if(extension == "obj")
    write_obj(stream, mesh, uv, originals, aspect, materials);
  else if(extension == "off")
    CGAL::IO::write_OFF(stream, mesh, CGAL::parameters::vertex_texture_map(uv).stream_precision(17));
  else if(extension == "stl")
    write_stl_of(stream, mesh);
  else {
    auto s = mesh.add_property_map<Mesh::Vertex_index, double>("v:s").first;
    auto t = mesh.add_property_map<Mesh::Vertex_index, double>("v:t").first;
    for(Mesh::Vertex_index v : mesh.vertices()) {
      s[v] = uv[v].x();
      t[v] = uv[v].y();
    }
    CGAL::IO::write_PLY(stream, mesh, CGAL::parameters::stream_precision(17));
  }
}

} // namespace square_map

#endif // SQUARE_MAP_WRITE_MAP_H
