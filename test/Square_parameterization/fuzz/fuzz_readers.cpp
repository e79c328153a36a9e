// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Bytes as a file: the readers of square_map and the conditioning must take or refuse them.

#include <square_map/detect_format.h>
#include <square_map/read_surface.h>

#include <cstdint>
#include <cstdlib>
#include <string_view>

using namespace CGAL_ext::internal;

namespace {

/// ends the program unless the soup has become what it should: triangles that CGAL takes as a mesh without isolated
/// vertices
void check_conditioned(const Surface_soup& soup)
{
  const square_map::Mesh mesh = square_map::make_mesh(soup);
  if(mesh.number_of_faces() != soup.faces.size() || !mesh.is_valid(false))
    std::abort();
  for(square_map::Mesh::Vertex_index v : mesh.vertices())
    if(mesh.is_isolated(v))
      std::abort();
}

void condition(Surface_soup soup, const Conditioning_options& options)
{
  try {
    condition_soup(soup, options);
    check_conditioned(soup);
  } catch(const Unmappable&) {
    // refused with a sentence
  }
}

/// reads bytes as a surface, in one format
void read_as(square_map::File_format format, std::string_view text)
{
  try {
    square_map::Passed_over passed_over;
    square_map::Vertex_colors colors;
    const Surface_soup soup = square_map::parse_soup(text, format, passed_over, &colors);
    if(!colors.empty() && colors.size() != soup.points.size())
      std::abort();
    square_map::check_well_formed(soup);
    condition(soup, {Topology::CONNECTED, {}, false});
    condition(soup, {Topology::CONNECTED, 0, true});
    condition(soup, {Topology::DISK, 1, true});
  } catch(const square_map::Malformed_file&) {
    // refused with a sentence
  }
}

/// reads bytes as seams of a surface of eight vertices, the last of which is dropped
void read_as_seams(std::string_view text)
{
  Conditioning_report conditioning;
  conditioning.new_index = {0, 1, 2, 3, 4, 5, 6, Conditioning_report::DROPPED};
  try {
    for(const square_map::File_seam& seam : square_map::parse_seams(text, conditioning))
      if(seam.ends[0] > 6 || seam.ends[1] > 6)
        std::abort();
  } catch(const square_map::Malformed_file&) {
    // refused with a sentence
  }
}

} // namespace

/// the first byte chooses the format: one of the four, what the content says, or seams
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  if(size == 0)
    return 0;
  const std::string_view text =
      square_map::without_byte_order_mark({reinterpret_cast<const char*>(data) + 1, size - 1});
  const int choice = data[0] % 6;
  if(choice < 4)
    read_as(static_cast<square_map::File_format>(choice), text);
  else if(choice == 5)
    read_as_seams(text);
  else if(const auto format = square_map::format_of_content(text))
    read_as(*format, text);
  return 0;
}
