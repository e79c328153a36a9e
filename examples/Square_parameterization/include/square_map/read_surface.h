// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_READ_SURFACE_H
#define SQUARE_MAP_READ_SURFACE_H

#include <CGAL_ext/Square_parameterization/internal/soup/condition_soup.h>

#include "read_seams.h"
#include "read_soup.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace square_map {

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

// The definitions are in src/square_map/read_surface.cpp: they are compiled once.

/// the vertex of a mesh with a number
inline Mesh::Vertex_index vertex(std::size_t v)
{
  return Mesh::Vertex_index(static_cast<Mesh::size_type>(v));
}

/// the mesh of a conditioned soup, with the threads of the current team; vertices and faces keep their order. Linear in the
/// faces but for sorting the edges at each vertex: to add face by face walks round vertices, and takes the square of their
/// valence.
Mesh make_mesh(const CGAL_ext::internal::Surface_soup& soup);

/// the edges of the mesh along the seams of a file. Throws `Unmappable` where there is none.
std::vector<Mesh::Edge_index> edges_of(const std::vector<File_seam>& seams, const Mesh& mesh, const std::string& path);

/// the vertices of the mesh that vertices of the file have become; none of its own for one that was dropped
std::array<Mesh::Vertex_index, 4> mesh_vertices(const std::array<std::size_t, 4>& file_vertices,
                                                const CGAL_ext::internal::Conditioning_report& conditioning);

} // namespace square_map

#endif // SQUARE_MAP_READ_SURFACE_H
