// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

// benchmark/Square_parameterization/iteration_defaults.cpp
//
// Justifies the defaults of Stretch_minimization: for each mesh the least L2 stretch over the candidates of the first
// quarter, and the seconds of that search, with different weights, eta and patience.
//
//   iteration_defaults build/data/meshes/lion-head.off build/data/meshes/nefertiti.off

#include "../../examples/Square_parameterization/include/compiled_reader.h"

#include <CGAL_ext/Square_parameterization/corner_searches.h>
#include <CGAL_ext/Square_parameterization/parameterize_onto_square.h>

#include <filesystem>
#include <iomanip>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

namespace {

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef std::function<CGAL_ext::internal::Edge_weights(const CGAL_ext::internal::Patch&)> Weights;

const std::vector<std::pair<std::string, Weights>> all_weights{
    {"blended", CGAL_ext::Blended_weights()},
    {"shape-preserving", CGAL_ext::Shape_preserving_weights()},
    {"shape-preserving-plain", CGAL_ext::Shape_preserving_weights(CGAL_ext::Shape_preserving_weights::Average::PLAIN)},
    {"mean-value", CGAL_ext::Mean_value_weights()},
    {"symmetric-mean-value", CGAL_ext::Symmetric_mean_value_weights()},
    {"uniform", CGAL_ext::Uniform_weights()},
    {"clamped-cotangent", CGAL_ext::Clamped_cotangent_weights()},
    {"harmonic", CGAL_ext::Harmonic_weights()}};

void print_setting(const std::string& weights, double eta, unsigned int patience)
{
  std::cout << std::left << std::setw(23) << weights << std::right << std::defaultfloat << std::setprecision(3)
            << std::setw(5) << eta << std::setw(3) << patience << std::fixed;
}

/// one row: a cell of stretch and seconds per mesh
void measure(const std::vector<Mesh>& meshes, const std::string& name, const Weights& weights, double eta,
             unsigned int patience)
{
  print_setting(name, eta, patience);
  CGAL_ext::Square_map_options<Mesh> options;
  options.search = CGAL_ext::Quarter_brute_force_corner_search();
  CGAL_ext::Stretch_minimization minimization;
  minimization.weights = weights;
  minimization.eta = eta;
  minimization.patience = patience;
  options.minimization = minimization;
  for(Mesh mesh : meshes) {
    const auto uv = mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("h:uv").first;
    const auto result = CGAL_ext::parameterize_onto_square(mesh, uv, CGAL_ext::parameters::options(options));
    if(result.status == CGAL::Surface_mesh_parameterization::OK)
      std::cout << std::setw(9) << std::setprecision(4) << result.measures.l2;
    else
      std::cout << std::setw(9) << "no map";
    std::cout << std::setw(8) << std::setprecision(3) << result.search_seconds << std::flush;
  }
  std::cout << std::endl;
}

} // namespace

int main(int argc, char** argv)
{
  if(argc < 2) {
    std::cerr << "usage: iteration_defaults MESH...\n";
    return EXIT_FAILURE;
  }
  std::vector<Mesh> meshes(argc - 1);
  std::cout << "least L2 stretch and seconds of the search\n\n"
            << std::left << std::setw(23) << "weights"
            << "  eta  p";
  for(int i = 1; i < argc; ++i) {
    if(!CGAL::IO::read_polygon_mesh(argv[i], meshes[i - 1])) {
      std::cerr << "cannot read " << argv[i] << '\n';
      return EXIT_FAILURE;
    }
    std::cout << std::right << std::setw(17) << std::filesystem::path(argv[i]).stem().string().substr(0, 16);
  }
  std::cout << std::endl;
  for(const auto& [name, weights] : all_weights)
    for(double eta : {1., 0.5, 0.3, 0.2})
      measure(meshes, name, weights, eta, 1);
  for(unsigned int patience : {0u, 1u, 3u})
    measure(meshes, "blended", CGAL_ext::Blended_weights(), 0.3, patience);
}
