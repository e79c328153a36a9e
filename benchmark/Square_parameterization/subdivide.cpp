// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

// benchmark/Square_parameterization/subdivide.cpp
//
// Splits every face at the midpoints of its edges, as often as asked for: the same surface with four times the faces
// each time. Writes OFF with coordinates that are read back as they are.
//
//   subdivide build/data/meshes/lion-head.off 2 lion-head-2.off

#include "../../examples/Square_parameterization/include/square_map/read_soup.h"

#include <CGAL_ext/Square_parameterization/internal/patch/number_edges.h>

#include <array>
#include <fstream>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

namespace {

struct Triangles
{
  std::vector<Eigen::Vector3d> points;
  std::vector<std::array<int, 3>> faces;
};

Triangles read_triangles(const std::string& path)
{
  Triangles mesh;
  const auto soup = square_map::read_soup(path);
  for(const auto& p : soup.points)
    mesh.points.emplace_back(p[0], p[1], p[2]);
  for(const auto& face : soup.faces) {
    if(face.size() != 3)
      throw std::runtime_error(path + " has a face that is no triangle");
    mesh.faces.push_back({static_cast<int>(face[0]), static_cast<int>(face[1]), static_cast<int>(face[2])});
  }
  return mesh;
}

Triangles split_at_midpoints(Triangles mesh)
{
  const auto numbering = CGAL_ext::internal::number_edges(mesh.points.size(), mesh.faces);
  const int first = static_cast<int>(mesh.points.size());
  for(const auto& [a, b] : numbering.edges)
    mesh.points.push_back((mesh.points[a] + mesh.points[b]) / 2);
  std::vector<std::array<int, 3>> faces;
  for(std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const auto& t = mesh.faces[f];
    std::array<int, 3> middle; // of the edge opposite to each corner
    for(int k = 0; k < 3; ++k)
      middle[k] = first + numbering.triangle_edges[f][k];
    for(int k = 0; k < 3; ++k)
      faces.push_back({t[k], middle[(k + 2) % 3], middle[(k + 1) % 3]});
    faces.push_back(middle);
  }
  mesh.faces = std::move(faces);
  return mesh;
}

void write_off(const Triangles& mesh, const std::string& path)
{
  std::ofstream output(path);
  output.precision(std::numeric_limits<double>::max_digits10);
  output << "OFF\n" << mesh.points.size() << ' ' << mesh.faces.size() << " 0\n";
  for(const Eigen::Vector3d& p : mesh.points)
    output << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
  for(const auto& [a, b, c] : mesh.faces)
    output << "3 " << a << ' ' << b << ' ' << c << '\n';
  if(!output.flush())
    throw std::runtime_error("cannot write '" + path + "'");
}

} // namespace

int main(int argc, char** argv)
{
  if(argc != 4) {
    std::cerr << "usage: subdivide INPUT TIMES OUTPUT.off\n";
    return 2;
  }
  try {
    Triangles mesh = read_triangles(argv[1]);
    for(int i = std::stoi(argv[2]); i > 0; --i)
      mesh = split_at_midpoints(std::move(mesh));
    write_off(mesh, argv[3]);
  } catch(const std::exception& error) {
    std::cerr << "subdivide: " << error.what() << '\n';
    return 1;
  }
}
