// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_MODELS_H
#define CGAL_EXT_MODELS_H

#include "../../../examples/Square_parameterization/include/square_map/read_surface.h"
#include "first_border_halfedge.h"
#include "paper_tables/generated_meshes.h"

#include <CGAL_ext/Square_parameterization/internal/surface/Face_graph_patch.h>
#include <CGAL_ext/Square_parameterization/split_chords.h>

#include <exception>
#include <filesystem>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

/// a disk without chords
struct Model
{
  std::string name;
  CGAL_ext::Patch patch;
};

template <class Mesh>
Model make_model(const std::string& name, Mesh mesh)
{
  CGAL_ext::split_chords(mesh);
  return {name,
          CGAL_ext::internal::make_face_graph_patch(mesh, first_border_halfedge(mesh), get(CGAL::vertex_point, mesh))
              .patch};
}

/// the disks of a command line: files, and the generated ones for `--generated`; complains about the others
inline std::vector<Model> read_models(int argc, char** argv)
{
  std::vector<Model> models;
  for(int i = 1; i < argc; ++i)
    try {
      if(argv[i] == std::string("--generated")) {
        for(auto& [name, mesh] : paper_tables::generated_meshes())
          models.push_back(make_model(name, std::move(mesh)));
        continue;
      }
      CGAL_ext::internal::Surface_soup soup = square_map::read_soup(argv[i]);
      CGAL_ext::internal::condition_soup(soup);
      models.push_back(make_model(std::filesystem::path(argv[i]).stem().string(), square_map::make_mesh(soup)));
    } catch(const std::exception& error) {
      std::cerr << argv[i] << ": " << error.what() << '\n';
    }
  return models;
}

#endif // CGAL_EXT_MODELS_H
