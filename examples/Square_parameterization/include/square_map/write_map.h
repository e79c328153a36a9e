// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_WRITE_MAP_H
#define SQUARE_MAP_WRITE_MAP_H

#include "read_surface.h"
#include "write_stl.h"

#include <CGAL_ext/Square_parameterization/internal/common/ranges.h>

#include <CGAL/Surface_mesh/IO/OFF.h>
#include <CGAL/Surface_mesh/IO/PLY.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <filesystem>
#include <initializer_list>
#include <ostream>
#include <string>
#include <type_traits>
#include <vector>

namespace square_map {

typedef Mesh::Property_map<Mesh::Vertex_index, Kernel::Point_2> UV_map;

/// writes the lines of elements of a mesh in their order. Many are made at a time, by the threads of the current team: of
/// a whole job of two threads this was a tenth.
/// \param append appends the line of an element to a text
template <class Elements, class Append>
void write_lines(std::ostream& stream, const Elements& elements, const Append& append)
{
  constexpr std::size_t LINES = 4096; // of a text
  constexpr std::size_t TEXTS = 16;   // that are in memory
  const std::vector<std::decay_t<decltype(*elements.begin())>> all(elements.begin(), elements.end());
  for(std::size_t first = 0; first < all.size(); first += TEXTS * LINES) {
    const std::size_t count = (std::min)(TEXTS * LINES, all.size() - first);
    std::vector<std::string> texts((count + LINES - 1) / LINES);
    CGAL_ext::internal::for_ranges(
        count,
        [&](std::size_t begin, std::size_t end) {
          for(std::size_t i = begin; i < end; ++i)
            append(all[first + i], texts[begin / LINES]);
        },
        LINES);
    for(const std::string& text : texts)
      stream << text;
  }
}

/// appends a line of numbers with 17 digits, from which the same numbers are read
inline void append_line(const char* word, std::initializer_list<double> numbers, std::string& text)
{
  text += word;
  for(double number : numbers) {
    std::array<char, 32> digits;
    const auto end =
        std::to_chars(digits.data(), digits.data() + digits.size(), number, std::chars_format::general, 17);
    text += ' ';
    text.append(digits.data(), end.ptr);
  }
  text += '\n';
}

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
  write_lines(stream, mesh.vertices(), [&](Mesh::Vertex_index v, std::string& text) {
    if(v.idx() < uncut || v.idx() >= originals.size()) {
      const Kernel::Point_3& p = mesh.point(v);
      append_line("v", {p.x(), p.y(), p.z()}, text);
    }
  });
  write_lines(stream, mesh.vertices(), [&](Mesh::Vertex_index v, std::string& text) {
    append_line("vt", {uv[v].x(), uv[v].y()}, text);
  });
  write_lines(stream, mesh.faces(), [&](Mesh::Face_index f, std::string& text) {
    text += 'f';
    for(Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f)))
      text += ' ' + std::to_string(vertex_number(v)) + '/' + std::to_string(v.idx() + 1);
    text += '\n';
  });
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
