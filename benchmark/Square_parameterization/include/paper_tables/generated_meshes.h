// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PAPER_TABLES_GENERATED_MESHES_H
#define PAPER_TABLES_GENERATED_MESHES_H

#include "experiment.h"

#include "../../../../test/Square_parameterization/include/test_meshes.h"

namespace paper_tables {

inline Mesh mesh_of(const Flat_mesh& flat)
{
  Mesh mesh;
  for(const Eigen::Vector3d& p : flat.points)
    mesh.add_vertex(Kernel::Point_3(p.x(), p.y(), p.z()));
  for(const auto& [a, b, c] : flat.triangles)
    mesh.add_face(Mesh::Vertex_index(a), Mesh::Vertex_index(b), Mesh::Vertex_index(c));
  return mesh;
}

/// ten disks, made the same everywhere, with at least 100 border edges each
inline std::vector<std::pair<std::string, Mesh>> generated_meshes()
{
  std::vector<std::pair<std::string, Mesh>> meshes;
  meshes.emplace_back("saddle-30", mesh_of(saddle(30)));
  meshes.emplace_back("saddle-45", mesh_of(saddle(45, 12)));
  meshes.emplace_back("height-field-30", mesh_of(noisy_height_field(30)));
  meshes.emplace_back("height-field-50", mesh_of(noisy_height_field(50, 13)));
  meshes.emplace_back("strip", mesh_of(long_strip()));
  meshes.emplace_back("spiral", mesh_of(spiral()));
  meshes.emplace_back("cone", mesh_of(cone(2, 20, 120)));
  meshes.emplace_back("tall-cone", mesh_of(cone(6, 25, 140, 17)));
  meshes.emplace_back("hemisphere", mesh_of(hemisphere(25, 120)));
  meshes.emplace_back("fan-with-ears", mesh_of(fan_with_ears(90, 3)));
  return meshes;
}

} // namespace paper_tables

#endif // PAPER_TABLES_GENERATED_MESHES_H
