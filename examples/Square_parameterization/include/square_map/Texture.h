// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_TEXTURE_H
#define SQUARE_MAP_TEXTURE_H

#include "Malformed_file.h"
#include "pictures.h"
#include "read_bytes.h"

#include <filesystem>
#include <ostream>
#include <string>

namespace square_map {

/// the bytes of the PNG file that `--texture` names: a checkerboard, or a file
/// \param name `checker`, empty for the same, or a path
/// \throw Malformed_file for a file that cannot be read or is no PNG picture
inline std::string texture_file(const std::string& name)
{
  if(name.empty() || name == "checker")
    return png_file(checkerboard(32, 32));
  try {
    const File_bytes file = read_bytes(name);
    std::string bytes(file.bytes);
    read_png(bytes);
    return bytes;
  } catch(const Malformed_file& error) {
    throw Malformed_file("cannot read the texture '" + name + "': " + error.what());
  }
}

/// a file beside another, of the same name but for its extension
inline std::string beside(const std::string& path, const std::string& extension)
{
  return std::filesystem::path(path).replace_extension(extension).string();
}

/// the material of an OBJ file: a matt surface in the colors of the picture
inline void write_material(std::ostream& stream, const std::string& picture)
{
  stream << "newmtl square\nKa 1 1 1\nKd 1 1 1\nKs 0 0 0\nillum 1\nmap_Kd "
         << std::filesystem::path(picture).filename().string() << '\n';
}

} // namespace square_map

#endif // SQUARE_MAP_TEXTURE_H
