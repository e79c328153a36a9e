// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

// benchmark/Square_parameterization/minimizer_engines.cpp
//
// Compares minimizers of the balanced energy, sliding border, first candidate, one thread: seconds from the patch to a
// map whose energy is within 1e-3 and within 1e-4 of the least that any of them found, and where each ends.
//
//   minimizer_engines build/data/meshes/lion-head.off build/data/meshes/mannequin-devil.off

#include "include/minimizer_engines/Newton_minimizer.h"

#include <CGAL_ext/Square_parameterization/Stretch_minimization.h>
#include <CGAL_ext/Square_parameterization/internal/border_curves.h>
#include <CGAL_ext/Square_parameterization/parameterize_onto_square.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <chrono>
#include <filesystem>
#include <iomanip>
#include <iostream>

namespace {

using namespace CGAL_ext;
using namespace CGAL_ext::internal;
using minimizer_engines::Newton_minimizer;

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

/// maps a patch with at most the given number of steps on the mesh itself
typedef std::function<Minimized_map(const Patch&, const Uv_coordinates& border_uv, Balanced_options)> Engine;

Stretch_iteration make_start(const Patch& patch)
{
  Stretch_minimization start;
  start.maximum_iterations = 5;
  return start.make_iteration(patch);
}

Uv_coordinates start_map(const Patch& patch, const Uv_coordinates& border_uv)
{
  Stretch_iteration::Workspace workspace;
  return make_start(patch).minimize(border_uv, 1, workspace).uv;
}

Minimized_map by_newton(const Patch& patch, const Uv_coordinates& border_uv, Balanced_options options)
{
  Newton_minimizer::Workspace workspace;
  return Newton_minimizer(patch, options).minimize(start_map(patch, border_uv), workspace);
}

Minimized_map by_quasi_newton(const Patch& patch, const Uv_coordinates& border_uv, Balanced_options options)
{
  Balanced_minimizer::Workspace workspace;
  return Balanced_minimizer(patch, options).minimize({start_map(patch, border_uv), {}}, options.tolerance, workspace);
}

Minimized_map by_coarse_to_fine(const Patch& patch, const Uv_coordinates& border_uv, Balanced_options options)
{
  options.search_tolerance = options.tolerance;
  Multilevel_minimizer::Workspace workspace;
  return Multilevel_minimizer(patch, make_start, options).minimize(border_uv, workspace);
}

Minimized_map by_coarse_to_fine_newton(const Patch& patch, const Uv_coordinates& border_uv, Balanced_options options)
{
  Balanced_options no_steps = options;
  no_steps.maximum_iterations = 0;
  Multilevel_minimizer::Workspace workspace;
  Minimized_map start = Multilevel_minimizer(patch, make_start, no_steps).minimize(border_uv, workspace);
  Newton_minimizer::Workspace newton_workspace;
  return Newton_minimizer(patch, options).minimize(std::move(start.uv), newton_workspace);
}

const std::vector<std::pair<std::string, Engine>> engines{{"projected Newton", by_newton},
                                                          {"L-BFGS and sweeps", by_quasi_newton},
                                                          {"coarse to fine, Newton", by_coarse_to_fine_newton},
                                                          {"coarse to fine, L-BFGS", by_coarse_to_fine}};

struct Run
{
  Minimized_map map;
  double seconds;
};

Run timed(const Engine& engine, const Patch& patch, const Uv_coordinates& border_uv, const Balanced_options& options)
{
  const auto start = std::chrono::steady_clock::now();
  Run run{engine(patch, border_uv, options), 0};
  run.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return run;
}

/// the seconds to an energy, found by running again with as many steps as that took
std::string seconds_to(double energy, const Run& run, const Engine& engine, const Patch& patch,
                       const Uv_coordinates& border_uv, Balanced_options options)
{
  const std::vector<double>& history = run.map.report.history;
  const auto reached = std::find_if(history.begin(), history.end(), [energy](double e) { return e <= energy; });
  if(reached == history.end())
    return "-";
  options.maximum_iterations = static_cast<unsigned int>(reached - history.begin());
  std::ostringstream text;
  text << std::fixed << std::setprecision(3) << timed(engine, patch, border_uv, options).seconds;
  return text.str();
}

} // namespace

int main(int argc, char** argv)
{
  std::cout << std::fixed;
  for(int i = 1; i < argc; ++i) {
    Mesh mesh;
    if(!CGAL::IO::read_polygon_mesh(argv[i], mesh)) {
      std::cerr << "cannot read " << argv[i] << '\n';
      return EXIT_FAILURE;
    }
    split_chords(mesh);
    const Patch patch = make_face_graph_patch(mesh, first_border_halfedge(mesh), get(CGAL::vertex_point, mesh)).patch;
    const Border_walk walk(patch.border_lengths, Walk::COUNTER_CLOCKWISE);
    const Uv_coordinates border_uv = square_border(walk, corners_of_candidate(walk, 0, Corner_rule::NEAREST)).uv;
    for(const double balance : {0.3, 0.}) {
      Balanced_options options;
      options.balance = balance;
      std::vector<Run> runs;
      double least = std::numeric_limits<double>::infinity();
      for(const auto& engine : engines) {
        runs.push_back(timed(engine.second, patch, border_uv, options));
        least = (std::min)(least, runs.back().map.report.objective);
      }
      std::cout << std::filesystem::path(argv[i]).stem().string() << ", " << patch.number_of_faces()
                << " faces, balance " << std::setprecision(1) << balance << "\n"
                << "  engine                  seconds to 1e-3    to 1e-4     at end   steps     energy       L2\n";
      for(std::size_t e = 0; e < engines.size(); ++e) {
        const auto& [name, engine] = engines[e];
        const Minimization_report& report = runs[e].map.report;
        std::cout << "  " << std::left << std::setw(24) << name << std::right << std::setw(15)
                  << seconds_to(least * (1 + 1e-3), runs[e], engine, patch, border_uv, options) << std::setw(11)
                  << seconds_to(least * (1 + 1e-4), runs[e], engine, patch, border_uv, options) << std::setprecision(3)
                  << std::setw(11) << runs[e].seconds << std::setw(8) << report.iterations << std::setprecision(5)
                  << std::setw(11) << report.objective << std::setw(9) << report.l2 << std::endl;
      }
    }
  }
}
