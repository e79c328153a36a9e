// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

// benchmark/Square_parameterization/yardstick.cpp
//
// Measures a machine and a mesh: the seconds of one sparse factorization, Eigen's SimplicialLLT with its AMD ordering, of
// the Laplacian of the mesh, with the analysis and two solves: about what one linear map costs. With the option also
// the seconds of one call of CGAL's iterative authalic parameterizer, 15 iterations.
//
//   yardstick build/data/meshes/lion-head.off --iterative-authalic

#include "include/first_border_halfedge.h"

#include "../../examples/Square_parameterization/include/square_map/read_surface.h"

#include <CGAL/Surface_mesh_parameterization/Iterative_authalic_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Square_border_parameterizer_3.h>

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <ctime>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

namespace {

namespace SMP = CGAL::Surface_mesh_parameterization;
using square_map::Mesh;

/// of this process, on all its threads
double processor_seconds()
{
  return double(std::clock()) / CLOCKS_PER_SEC;
}

/// the graph Laplacian of the interior vertices: what a linear map with a fixed border solves; of a mesh without border
/// that of all vertices but one
Eigen::SparseMatrix<double> laplacian(const Mesh& mesh)
{
  std::vector<int> place(mesh.number_of_vertices(), -1);
  int n = 0;
  const bool is_closed = CGAL::is_closed(mesh);
  for(Mesh::Vertex_index v : mesh.vertices())
    if(is_closed ? v.idx() != 0 : !mesh.is_border(v))
      place[v.idx()] = n++;
  std::vector<Eigen::Triplet<double>> entries;
  for(Mesh::Vertex_index v : mesh.vertices())
    if(place[v.idx()] >= 0)
      entries.emplace_back(place[v.idx()], place[v.idx()], double(mesh.degree(v)));
  for(Mesh::Edge_index e : mesh.edges()) {
    const int a = place[mesh.vertex(e, 0).idx()], b = place[mesh.vertex(e, 1).idx()];
    if(a >= 0 && b >= 0) {
      entries.emplace_back(a, b, -1.);
      entries.emplace_back(b, a, -1.);
    }
  }
  Eigen::SparseMatrix<double> matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

/// the least of three times
double seconds_of_factorization(const Eigen::SparseMatrix<double>& matrix)
{
  double least = 0;
  for(int i = 0; i < 3; ++i) {
    const double start = processor_seconds();
    const Eigen::SimplicialLLT<Eigen::SparseMatrix<double>> solver(matrix);
    const Eigen::MatrixXd solution = solver.solve(Eigen::MatrixXd::Ones(matrix.rows(), 2));
    const double seconds = processor_seconds() - start;
    if(solver.info() != Eigen::Success || !solution.allFinite())
      throw std::runtime_error("the Laplacian cannot be factored");
    least = i == 0 ? seconds : (std::min)(least, seconds);
  }
  return least;
}

double seconds_of_iterative_authalic(Mesh& mesh)
{
  auto uv = mesh.add_property_map<Mesh::Vertex_index, square_map::Kernel::Point_2>("v:uv").first;
  typedef SMP::Square_border_arc_length_parameterizer_3<Mesh> Border;
  const auto border = first_border_halfedge(mesh);
  std::cout.setstate(std::ios::failbit); // it prints what it does
  const double start = processor_seconds();
  const SMP::Error_code status =
      SMP::Iterative_authalic_parameterizer_3<Mesh, Border>().parameterize(mesh, border, uv, 15);
  const double seconds = processor_seconds() - start;
  std::cout.clear();
  std::filesystem::remove("last_solve.off"); // it leaves its last map in the working folder
  if(status != SMP::OK)
    throw std::runtime_error(SMP::get_error_message(status));
  return seconds;
}

} // namespace

int main(int argc, char** argv)
{
  if(argc < 2 || argc > 3 || (argc == 3 && std::string(argv[2]) != "--iterative-authalic")) {
    std::cerr << "usage: yardstick FILE [--iterative-authalic]\n";
    return 2;
  }
  try {
    Mesh mesh = square_map::make_mesh(square_map::read_soup(argv[1]));
    std::cout << (argc == 3 ? seconds_of_iterative_authalic(mesh) : seconds_of_factorization(laplacian(mesh))) << '\n';
  } catch(const std::exception& error) {
    std::cerr << "yardstick: " << error.what() << '\n';
    return 1;
  }
}
