// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

// benchmark/Square_parameterization/paper_tables.cpp
//
// Prints the tables of Dechvijankit, Nagahashi and Aoki from real runs: on each mesh every strategy searches the first
// quarter of the border. Writes tables.csv, a stretch curve per mesh (figure 5) and a bar chart (figure 6).
//
//   paper_tables build/data/meshes/three_peaks.off --generated --output build/paper
//   paper_tables MESH --preset paper --walk clockwise

#include "include/paper_tables/figures.h"
#include "include/paper_tables/generated_meshes.h"

#include "../../examples/Square_parameterization/include/square_map/option_values.h"
#include "../../examples/Square_parameterization/include/square_map/read_surface.h"

#include <boost/program_options.hpp>

#include <filesystem>
#include <fstream>
#include <iomanip>
#include <iostream>

namespace {

using namespace paper_tables;

constexpr double TOLERANCE = 1e-3; // a search has found the best when it is within this relative distance

/// a row of cells, the first wide and left, the others right
template <class... Cells>
void print_row(const std::string& name, const Cells&... cells)
{
  std::cout << std::left << std::setw(28) << name << std::right;
  ((std::cout << ' ' << std::setw(12) << cells), ...);
  std::cout << '\n';
}

void print_tables(const std::vector<Experiment>& experiments)
{
  const auto run = [](const Experiment& e, const char* strategy) -> const Run& { return e.runs.at(strategy); };
  std::cout << std::fixed << std::setprecision(6);
  std::cout << "\nTable 1. Quarter brute force and step sampling\n";
  print_row("model", "evaluations", "L2", "step", "evaluations", "L2");
  for(const Experiment& e : experiments)
    print_row(e.name, run(e, "quarter-brute-force").evaluations, run(e, "quarter-brute-force").l2, e.step,
              run(e, "step-sampling").evaluations, run(e, "step-sampling").l2);

  std::cout << "\nTable 2. Hybrid; in the last column the evaluations of step sampling\n";
  print_row("model", "interval", "evaluations", "L2", "(step)");
  for(const Experiment& e : experiments)
    print_row(e.name, (std::max)(1, e.step - 1), run(e, "hybrid").evaluations, run(e, "hybrid").l2,
              run(e, "step-sampling").evaluations);

  std::cout << "\nTable 3. Seconds of the search\n";
  print_row("model", "quarter", "step", "hybrid");
  for(const Experiment& e : experiments)
    print_row(e.name, run(e, "quarter-brute-force").seconds, run(e, "step-sampling").seconds, run(e, "hybrid").seconds);

  std::cout << "\nTable 4. Sizes of the models, as mapped\n";
  print_row("model", "vertices", "faces", "border edges");
  for(const Experiment& e : experiments)
    print_row(e.name, e.vertices, e.faces, e.border_edges);

  std::cout << "\nThe searches that the paper describes without a table: L2, and the evaluations of the swarm\n";
  print_row("model", "swarm", "evaluations", "single high", "many high", "better of 2");
  for(const Experiment& e : experiments)
    print_row(e.name, run(e, "particle-swarm").l2, run(e, "particle-swarm").evaluations, run(e, "single-highest").l2,
              run(e, "many-high").l2, run(e, "better-of-two").l2);

  std::cout << "\nRank correlation over the candidates between one linear solve and the stretch-minimizing map\n";
  print_row("model", "uniform", "shape-pres.", "mean value", "harmonic");
  for(const Experiment& e : experiments)
    print_row(e.name, e.rank_correlation.at("uniform"), e.rank_correlation.at("shape-preserving"),
              e.rank_correlation.at("mean-value"), e.rank_correlation.at("harmonic"));
}

/// how often each search finds the best of the quarter, and where it does not
void print_misses(const std::vector<Experiment>& experiments)
{
  std::cout << "\nHow often the best of the quarter is found within " << 100 * TOLERANCE << " %\n";
  print_row("strategy", "found", "of", "evaluations");
  std::string misses;
  for(const auto& strategy : strategies()) {
    std::size_t found = 0, evaluations = 0;
    for(const Experiment& e : experiments) {
      const Run& run = e.runs.at(strategy.first);
      const double excess = run.l2 / e.runs.at("quarter-brute-force").l2 - 1;
      evaluations += run.evaluations;
      if(excess <= TOLERANCE)
        ++found;
      else
        misses += "  " + strategy.first + " on " + e.name + ": +" + std::to_string(100 * excess) + " %\n";
    }
    print_row(strategy.first, found, experiments.size(), evaluations);
  }
  std::cout << "misses:\n" << (misses.empty() ? "  none\n" : misses);
}

void write_files(const std::string& folder, const std::vector<Experiment>& experiments)
{
  std::filesystem::create_directories(folder);
  std::ofstream csv(folder + "/tables.csv");
  csv << "model,vertices,faces,border_edges,candidates,step,strategy,evaluations,candidate,l2,seconds\n";
  for(const Experiment& e : experiments) {
    for(const auto& [strategy, run] : e.runs)
      csv << e.name << ',' << e.vertices << ',' << e.faces << ',' << e.border_edges << ',' << e.candidates << ','
          << e.step << ',' << strategy << ',' << run.evaluations << ',' << run.candidate << ',' << std::setprecision(9)
          << run.l2 << ',' << run.seconds << '\n';
    std::ofstream svg(folder + "/curve-" + e.name + ".svg");
    write_stretch_curve(svg, e);
  }
  std::ofstream chart(folder + "/time-reduction.svg");
  write_bar_chart(chart, experiments);
}

} // namespace

int main(int argc, char** argv)
{
  namespace po = boost::program_options;
  std::vector<std::string> files;
  std::string preset, walk = "counter-clockwise", output;
  bool generated = false;
  unsigned int threads = 0;
  po::options_description options("options");
  auto add = options.add_options();
  add("meshes", po::value(&files), "meshes with one border");
  add("generated", po::bool_switch(&generated), "ten generated disks besides");
  add("preset", po::value(&preset), "paper: the settings of the published tables");
  add("walk", po::value(&walk), "counter-clockwise or clockwise");
  add("threads", po::value(&threads), "0 for all cores");
  add("output", po::value(&output), "folder for tables.csv and the figures");
  try {
    po::variables_map given;
    po::store(po::command_line_parser(argc, argv)
                  .options(options)
                  .positional(po::positional_options_description().add("meshes", -1))
                  .run(),
              given);
    po::notify(given);
  } catch(const po::error& error) {
    std::cerr << error.what() << '\n' << options;
    return EXIT_FAILURE;
  }
  CGAL_ext::Square_map_options map_options;
  map_options.minimization = CGAL_ext::Stretch_minimization(); // the iteration of the paper
  if(preset == "paper")
    square_map::apply_paper_preset(map_options);
  map_options.search_options.number_of_threads = threads;
  if(walk == "clockwise")
    map_options.search_options.walk = CGAL_ext::Walk::CLOCKWISE;

  std::vector<std::pair<std::string, Mesh>> meshes;
  if(generated)
    meshes = generated_meshes();
  std::vector<Experiment> experiments;
  for(const std::string& file : files)
    try {
      auto soup = square_map::read_soup(file);
      CGAL_ext::internal::condition_soup(soup);
      meshes.emplace_back(std::filesystem::path(file).stem().string(), square_map::make_mesh(soup));
    } catch(const std::exception& error) {
      std::cerr << file << ": " << error.what() << '\n';
    }
  for(const auto& [name, mesh] : meshes)
    try {
      experiments.push_back(run_experiment(name, mesh, map_options));
    } catch(const std::exception& error) {
      std::cerr << name << ": " << error.what() << '\n';
    }
  print_tables(experiments);
  print_misses(experiments);
  if(!output.empty())
    write_files(output, experiments);
  return experiments.empty() ? EXIT_FAILURE : EXIT_SUCCESS;
}
