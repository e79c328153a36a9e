// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FIGURES_FOLDERS_H
#define FIGURES_FOLDERS_H

#include "draw_map.h"

#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace figures {

/// where meshes come from, and where figures go
struct Folders
{
  std::string meshes, figures;

  Mesh mesh(const std::string& name) const { return read(meshes + '/' + name); }

  void write(const std::string& name, const std::string& bytes) const
  {
    std::ofstream file(figures + '/' + name, std::ios::binary);
    if(!(file << bytes).flush())
      throw std::runtime_error("cannot write " + figures + '/' + name);
  }

  void write(const std::string& name, const std::vector<Picture>& pictures) const
  {
    write(name, png_file(side_by_side(pictures)));
  }
};

} // namespace figures

#endif // FIGURES_FOLDERS_H
