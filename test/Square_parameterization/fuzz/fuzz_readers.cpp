// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Bytes as a file: the readers of square_map and the conditioning must take or refuse them.

#include <square_map/read_surface.h>

#include <unistd.h>

#include <cstdint>
#include <cstdlib>

using namespace CGAL_ext::internal;

namespace {

/// a file of this process that vanishes
class Temporary_file
{
public:
  Temporary_file(const std::string& extension, const std::string& text)
    : m_path(std::filesystem::temp_directory_path() / ("fuzz_readers_" + std::to_string(getpid()) + extension))
  {
    std::ofstream(m_path, std::ios::binary) << text;
  }
  Temporary_file(const Temporary_file&) = delete;
  Temporary_file& operator=(const Temporary_file&) = delete;
  ~Temporary_file() { std::filesystem::remove(m_path); }

  std::string path() const { return m_path.string(); }

private:
  std::filesystem::path m_path;
};

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

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  static const char* const extensions[] = {".off", ".obj", ".ply", ".stl"};
  if(size == 0)
    return 0;
  const Temporary_file file(extensions[data[0] % 4], std::string(data + 1, data + size));
  try {
    const Surface_soup soup = square_map::read_soup(file.path());
    square_map::check_well_formed(soup, file.path());
    condition(soup, {Topology::CONNECTED, {}, false});
    condition(soup, {Topology::CONNECTED, 0, true});
    condition(soup, {Topology::DISK, 1, true});
  } catch(const square_map::Malformed_file&) {
    // refused with a sentence
  }
  return 0;
}
