// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

// benchmark/Square_parameterization/cut_defaults.cpp
//
// Justifies the defaults of Cut_numbers: decides on the cut of every mesh with each number in turn made lower and
// higher, and prints what that does to the sum over the meshes of L2 stretch + 0.05 times the length of the cut, to the
// mesh that loses most, and to the processor seconds of the decision. The L2 stretch is that of the delivered map.
//
//   cut_defaults build/data/meshes/pig.off build/data/meshes/eight.off --numbers patience,growth_work
//
// All numbers over the default meshes take an hour or two. Numbers for many handles change cuts of such meshes alone.

#include "../../examples/Square_parameterization/include/square_map/read_surface.h"

#include <CGAL_ext/Square_parameterization/Bracketing_corner_search.h>
#include <CGAL_ext/Square_parameterization/internal/cut/open_disk.h>
#include <CGAL_ext/Square_parameterization/internal/cut/search_cut.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/make_minimizer.h>
#include <CGAL_ext/Square_parameterization/internal/search/square_search.h>
#include <CGAL_ext/Square_parameterization/internal/soup/condition_soup.h>
#include <CGAL_ext/Square_parameterization/internal/surface/Face_graph_arrays.h>
#include <CGAL_ext/Square_parameterization/internal/surface/check_surface.h>

#include <boost/algorithm/string.hpp>
#include <boost/program_options.hpp>

#include <algorithm>
#include <ctime>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

namespace {

using namespace CGAL_ext;
using namespace CGAL_ext::internal;

typedef std::variant<int Cut_numbers::*, long Cut_numbers::*, double Cut_numbers::*> Number;

/// a number, and the values it is given in place of its default
struct Variation
{
  std::string name;
  Number number;
  double lower, higher;
};

const std::vector<Variation> variations{
    {"decision_faces", &Cut_numbers::decision_faces, 2000, 8000},
    {"growth_faces", &Cut_numbers::growth_faces, 600, 1200},
    {"simpler_copies", &Cut_numbers::simpler_copies, 1, 3},
    {"simpler_copies_of_small", &Cut_numbers::simpler_copies_of_small, 0, 3},
    {"simplest_growth_faces", &Cut_numbers::simplest_growth_faces, 300, 500},
    {"faces_per_loop", &Cut_numbers::faces_per_loop, 6, 24},
    {"least_reduction", &Cut_numbers::least_reduction, 1, 2},
    {"very_fine", &Cut_numbers::very_fine, 3.25, 1000},
    {"still_fine", &Cut_numbers::still_fine, 1.5, 3},
    {"corner_candidates", &Cut_numbers::corner_candidates, 2, 16},
    {"start_iterations", &Cut_numbers::start_iterations, 0, 4},
    {"score_steps", &Cut_numbers::score_steps, 25, 400},
    {"mapped", &Cut_numbers::mapped, 3, 20},
    {"first_score_tolerance", &Cut_numbers::first_score_tolerance, 1e-2, 1},
    {"mapped_roughly", &Cut_numbers::mapped_roughly, 3, 10},
    {"rough_score_tolerance", &Cut_numbers::rough_score_tolerance, 1e-3, 3e-2},
    {"scored_well", &Cut_numbers::scored_well, 1, 10},
    {"starts_scored_well", &Cut_numbers::starts_scored_well, 0.1, 1},
    {"score_tolerance", &Cut_numbers::score_tolerance, 1e-4, 1e-2},
    {"decision_tolerance", &Cut_numbers::decision_tolerance, 1e-5, 1e-3},
    {"start_work", &Cut_numbers::start_work, 1, 8},
    {"ordinary_work", &Cut_numbers::ordinary_work, 50, 170},
    {"most_roots", &Cut_numbers::most_roots, 3, 24},
    {"fewest_roots", &Cut_numbers::fewest_roots, 1, 6},
    {"roots_times_handles", &Cut_numbers::roots_times_handles, 6, 600},
    {"most_additions", &Cut_numbers::most_additions, 3, 20},
    {"patience", &Cut_numbers::patience, 1, 6},
    {"candidates", &Cut_numbers::candidates, 2, 10},
    {"circle_iterations", &Cut_numbers::circle_iterations, 1, 20},
    {"growth_work", &Cut_numbers::growth_work, 50000, 450000},
    {"growth_work_per_vertex", &Cut_numbers::growth_work_per_vertex, 100, 300},
    {"growth_work_of_small", &Cut_numbers::growth_work_of_small, 50, 150},
    {"least_growth_work", &Cut_numbers::least_growth_work, 0, 20000},
    {"decision_work_per_vertex", &Cut_numbers::decision_work_per_vertex, 20, 150},
    {"times_work_without_map", &Cut_numbers::times_work_without_map, 1, 20},
    {"times_work_without_map_of_small", &Cut_numbers::times_work_without_map_of_small, 1, 5},
    {"little_growth_work", &Cut_numbers::little_growth_work, 10000, 100000},
    {"many_loops", &Cut_numbers::many_loops, 2, 1000},
    {"move_rounds", &Cut_numbers::move_rounds, 0, 4},
    {"most_neighbors", &Cut_numbers::most_neighbors, 6, 24},
    {"selected", &Cut_numbers::selected, 3, 30},
    {"far", &Cut_numbers::far, 0.01, 0.2},
    {"directions", &Cut_numbers::directions, 1, 8},
    {"first_step", &Cut_numbers::first_step, 0.06, 0.24},
    {"last_step", &Cut_numbers::last_step, 0.015, 0.06},
    {"refinement_work", &Cut_numbers::refinement_work, 0, 8000},
    {"refinement_work_outside", &Cut_numbers::refinement_work_outside, 0, 120000},
    {"largest_refined_stretch", &Cut_numbers::largest_refined_stretch, 1, 1e6},
    {"largest_judged_stretch", &Cut_numbers::largest_judged_stretch, 1, 1e6},
    {"far_from_best", &Cut_numbers::far_from_best, 0, 1},
    {"most_judged", &Cut_numbers::most_judged, 1, 10},
    {"lift_samples", &Cut_numbers::lift_samples, 1, 32},
    {"lift_band", &Cut_numbers::lift_band, 0.5, 8},
    {"near_best", &Cut_numbers::near_best, 0, 0.1},
    {"tie", &Cut_numbers::tie, 0, 0.02},
    {"largest_mapped_twice", &Cut_numbers::largest_mapped_twice, 0, 100000}};

double value_of(const Cut_numbers& numbers, const Number& number)
{
  return std::visit([&](auto member) { return static_cast<double>(numbers.*member); }, number);
}

Cut_numbers with(const Number& number, double value)
{
  Cut_numbers numbers;
  std::visit([&](auto member) { numbers.*member = static_cast<std::decay_t<decltype(numbers.*member)>>(value); },
             number);
  return numbers;
}

/// what a cut is worth, and what it takes to find out
struct Measured_cut
{
  double worth = 0; // L2 stretch of the map that is delivered, plus the weighted length of the cut
  double seconds = 0;
};

/// a mesh, and the cuts that were measured
struct Model
{
  std::string name;
  Triangle_surface surface;
  std::map<std::vector<int>, Measured_cut> worths; // by the edges of a cut
};

/// what became of all meshes
struct Outcome
{
  std::vector<std::vector<int>> cuts; // their edges, per mesh
  std::vector<double> worths;         // per mesh
  double seconds = 0;                 // of all threads together
};

double seconds_since(std::clock_t start)
{
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

Measured_cut measure(const Triangle_surface& surface, const Cut& cut)
{
  const std::clock_t start = std::clock();
  try {
    const Patch patch = patch_of_cut(surface, cut);
    const auto minimizer = make_minimizer(patch, Balanced_minimization());
    const double l2 = search_square_map(patch, *minimizer, Bracketing_corner_search(), {}).map.report.l2;
    return {l2 + Cut_options().cut_weight * cut.length(surface) / std::sqrt(surface.area), seconds_since(start)};
  } catch(const Unmappable&) {
    return {std::numeric_limits<double>::infinity(), seconds_since(start)};
  }
}

Outcome decide(std::vector<Model>& models, const Cut_numbers& numbers, unsigned int threads)
{
  Thread_team team(threads);
  Outcome outcome;
  for(Model& model : models) {
    Cut_report report;
    const std::clock_t start = std::clock();
    const std::vector<Decided_cut> cuts = search_cut(model.surface, Seam_options(), team, report, numbers);
    outcome.seconds += seconds_since(start);
    std::vector<std::pair<double, std::vector<int>>> measured;
    for(std::size_t i = 0; i < cuts.size(); ++i) {
      const auto [worth, is_new] = model.worths.try_emplace(cuts[i].cut.edges(), Measured_cut());
      if(is_new)
        worth->second = measure(model.surface, cuts[i].cut);
      measured.emplace_back(worth->second.worth, worth->first);
      outcome.seconds += i > 0 ? worth->second.seconds : 0; // the first is mapped in any case
    }
    const auto best = std::min_element(measured.begin(), measured.end());
    outcome.worths.push_back(best->first);
    outcome.cuts.push_back(best->second);
  }
  return outcome;
}

double sum(const std::vector<double>& values)
{
  double result = 0;
  for(double value : values)
    result += value;
  return result;
}

double percent(double value, double reference)
{
  return 100 * (value / reference - 1);
}

void print(const std::string& name, double value, const Outcome& outcome, const Outcome& defaults,
           const std::vector<Model>& models)
{
  int changed = 0;
  std::size_t worst = 0;
  for(std::size_t i = 0; i < models.size(); ++i) {
    changed += outcome.cuts[i] != defaults.cuts[i] ? 1 : 0;
    if(percent(outcome.worths[i], defaults.worths[i]) > percent(outcome.worths[worst], defaults.worths[worst]))
      worst = i;
  }
  std::cout << std::left << std::setw(21) << name << std::right << std::defaultfloat << std::setw(8) << value
            << std::setw(6) << changed << std::fixed << std::setprecision(4) << std::setw(10) << sum(outcome.worths)
            << std::setprecision(2) << std::setw(8) << percent(sum(outcome.worths), sum(defaults.worths))
            << std::setw(8) << percent(outcome.worths[worst], defaults.worths[worst]) << "  " << std::left
            << std::setw(20) << models[worst].name << std::right << std::setw(8) << outcome.seconds << std::setw(7)
            << outcome.seconds / defaults.seconds << std::endl;
}

/// reads the meshes; the default ones are of genus 0, 1, 2 and more, with and without borders, and of one size each
std::vector<Model> read_models(std::vector<std::string> files)
{
  if(files.empty())
    for(const char* name : {"pig", "hand", "cow", "knot1", "eight", "bull", "fandisk", "bear", "cheese"})
      files.push_back(std::string(CGAL_EXT_MESHES) + "/" + name + ".off");
  std::vector<Model> models;
  for(const std::string& file : files) {
    Surface_soup soup = square_map::read_soup(file);
    Conditioning_options options;
    options.topology = Topology::CONNECTED;
    condition_soup(soup, options);
    const square_map::Mesh mesh = square_map::make_mesh(soup);
    const Surface_arrays arrays = read_faces(mesh, mesh.faces(), mesh.points()).arrays;
    models.push_back({std::filesystem::path(file).stem().string(), make_checked_surface(arrays), {}});
  }
  return models;
}

/// the variations of the names, which are parted by commas; all of them for none
std::vector<Variation> chosen_variations(const std::string& names)
{
  if(names.empty())
    return variations;
  std::vector<std::string> list;
  boost::split(list, names, boost::is_any_of(","));
  std::vector<Variation> chosen;
  for(const std::string& name : list) {
    const auto found =
        std::find_if(variations.begin(), variations.end(), [&](const Variation& v) { return v.name == name; });
    if(found == variations.end())
      throw std::invalid_argument("there is no number '" + name + "'");
    chosen.push_back(*found);
  }
  return chosen;
}

void print_table(std::vector<Model>& models, const std::vector<Variation>& chosen, unsigned int threads)
{
  std::cout
      << "worth: L2 + " << Cut_options().cut_weight
      << " times the length of the cut, in sides of the square; changes in %; processor seconds of\nthe decision\n\n"
         "number                  value  cuts       sum  change   worst  of                   seconds  times\n";
  const Outcome defaults = decide(models, {}, threads);
  print("(defaults)", 0, defaults, defaults, models);
  for(const Variation& variation : chosen) {
    std::cout << std::left << std::setw(21) << variation.name << std::right << std::defaultfloat << std::setw(8)
              << value_of({}, variation.number) << "  by default\n";
    for(const double value : {variation.lower, variation.higher})
      print("", value, decide(models, with(variation.number, value), threads), defaults, models);
  }
}

} // namespace

int main(int argc, char** argv)
{
  namespace po = boost::program_options;
  std::vector<std::string> files;
  std::string names;
  unsigned int threads = 0;
  po::options_description options("cut_defaults [MESH...] [options]");
  auto add = options.add_options();
  add("mesh", po::value(&files), "surfaces to be cut; default: nine meshes of libcgal-demo");
  add("numbers", po::value(&names)->value_name("A,B,..."), "members of Cut_numbers to vary; default: all");
  add("threads", po::value(&threads)->value_name("N"), "0 (default) for all cores");
  add("list", "prints the names of the numbers and their values, and ends");
  try {
    po::variables_map given;
    po::store(po::command_line_parser(argc, argv)
                  .options(options)
                  .positional(po::positional_options_description().add("mesh", -1))
                  .run(),
              given);
    po::notify(given);
    const std::vector<Variation> chosen = chosen_variations(names);
    if(given.count("list") != 0) {
      for(const auto& [name, number, lower, higher] : chosen)
        std::cout << name << ": " << value_of({}, number) << ", " << lower << ", " << higher << '\n';
      return EXIT_SUCCESS;
    }
    std::vector<Model> models = read_models(files);
    print_table(models, chosen, threads);
  } catch(const po::error& error) {
    std::cerr << error.what() << '\n' << options;
    return EXIT_FAILURE;
  } catch(const std::exception& error) {
    std::cerr << error.what() << '\n';
    return EXIT_FAILURE;
  }
}
