// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

// benchmark/Square_parameterization/optimal_map_tables.cpp
//
// Measures the least balanced energy, best corners against best corners, in three tables: what the balance does to the
// measures of the map; what the interior, the corners and the sliding border gain; and how often the bracketing search
// finds the best of the quarter.
//
//   optimal_map_tables build/data/meshes/lion-head.off build/data/meshes/three_peaks.off --generated

#include "include/models.h"

#include "../../examples/Square_parameterization/include/square_map/option_values.h"

#include <CGAL_ext/Square_parameterization/internal/energy/measure.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/make_minimizer.h>
#include <CGAL_ext/Square_parameterization/internal/search/square_search.h>

#include <Eigen/SVD>

#include <iomanip>
#include <iostream>

namespace {

using namespace CGAL_ext;
using namespace CGAL_ext::internal;

/// measures that the library has no use for
struct Jacobian_measures
{
  double largest_magnification = 0; ///< largest s1
  double angle = 0;                 ///< mean of (s1/s2 + s2/s1) / 2 by area; 1 for a conformal map
};

Jacobian_measures measure_jacobians(const Patch& patch, const Uv_coordinates& uv)
{
  Jacobian_measures result;
  for(int f = 0; f < patch.number_of_faces(); ++f) {
    const auto& [a, b, c] = patch.triangles[f];
    const Flat_triangle& shape = patch.shapes[f];
    Eigen::Matrix2d plane, surface;
    plane << (uv.row(b) - uv.row(a)).transpose(), (uv.row(c) - uv.row(a)).transpose();
    surface << shape.x1, shape.x2, 0, shape.y2;
    const Eigen::Vector2d s = (plane * surface.inverse()).jacobiSvd().singularValues();
    result.largest_magnification = (std::max)(result.largest_magnification, s[0]);
    result.angle += shape.area() * (s[0] / s[1] + s[1] / s[0]) / 2;
  }
  return result;
}

/// with the corners of the best candidate: these tables compare what strategies find
Search_outcome search(const Patch& patch, const Map_minimizer& minimizer, const Corner_search& strategy,
                      Square_search_options options = {})
{
  options.moves_corners = false;
  return search_square_map(patch, minimizer, strategy, options);
}

std::shared_ptr<const Map_minimizer> balanced_minimizer(const Patch& patch, double balance,
                                                        Border_motion border = Border_motion::SLIDING)
{
  Balanced_minimization minimization;
  minimization.balance = balance;
  minimization.border = border;
  return make_minimizer(patch, minimization);
}

void print_measures(const std::string& row, const Patch& patch, const Uv_coordinates& uv)
{
  const Stretch_measures measures = measure(patch.shapes, patch.triangles, uv);
  const Jacobian_measures jacobians = measure_jacobians(patch, uv);
  std::cout << "  " << std::left << std::setw(24) << row << std::right << std::setprecision(4) << std::setw(9)
            << measures.l2 << std::setw(9) << measures.linf << std::setw(9) << measures.symmetric_dirichlet
            << std::setw(9) << jacobians.angle << std::setw(10) << jacobians.largest_magnification << std::setw(7)
            << measures.flipped_faces << std::endl;
}

/// the paper's map and ours at several balances, each at its best corners
void print_balances(const Model& model)
{
  std::cout << model.name << ", " << model.patch.number_of_faces()
            << " faces               L2     Linf sym.Dir.   angles largest s1 flips\n";
  Square_map_settings paper;
  paper.minimization = Stretch_minimization();
  square_map::apply_paper_preset(paper);
  print_measures("paper, brute force", model.patch,
                 search(model.patch, *make_minimizer(model.patch, paper.minimization), Brute_force_corner_search(),
                        paper.search_options)
                     .map.uv);
  print_measures(
      "iteration, brute force", model.patch,
      search(model.patch, *make_minimizer(model.patch, Stretch_minimization()), Brute_force_corner_search()).map.uv);
  for(const double balance : {0., 0.03, 0.1, 0.2, 0.3, 0.5, 1.}) {
    std::ostringstream row;
    row << "balance " << balance;
    print_measures(row.str(), model.patch,
                   search(model.patch, *balanced_minimizer(model.patch, balance), Bracketing_corner_search()).map.uv);
  }
}

/// L2 stretch of the first and of the best candidate: of the iteration, with a fixed and with a sliding border
void print_gains(const Model& model)
{
  const auto l2_of = [&](const Map_minimizer& minimizer, const Corner_search& strategy) {
    return search(model.patch, minimizer, strategy).map.report.l2;
  };
  std::cout << std::left << std::setw(28) << model.name << std::right << std::setprecision(4);
  const auto print_pair = [&](const Map_minimizer& minimizer, const Corner_search& strategy) {
    std::cout << std::setw(10) << l2_of(minimizer, First_candidate_corner_search()) << std::setw(10)
              << l2_of(minimizer, strategy);
  };
  print_pair(*make_minimizer(model.patch, Stretch_minimization()), Quarter_brute_force_corner_search());
  print_pair(*balanced_minimizer(model.patch, 0.3, Border_motion::FIXED), Bracketing_corner_search());
  print_pair(*balanced_minimizer(model.patch, 0.3), Bracketing_corner_search());
  std::cout << std::endl;
}

/// the bracketing search against brute force over the quarter; returns whether it finds the best within 0.02 % of the
/// energy with as few evaluations as it promises
bool print_bracketing(const Model& model)
{
  constexpr double TOLERANCE = 2e-4;
  const auto minimizer = balanced_minimizer(model.patch, 0.3);
  const Search_report all = search(model.patch, *minimizer, Quarter_brute_force_corner_search()).report;
  const Search_report found = search(model.patch, *minimizer, Bracketing_corner_search()).report;
  double least = std::numeric_limits<double>::infinity(), reached = least;
  for(const auto& sample : all.curve)
    least = (std::min)(least, sample.objective);
  for(const auto& sample : found.curve)
    reached = (std::min)(reached, sample.objective);
  const double limit = (std::max)(12., std::floor(2 * std::log2(double(all.candidates))) + 4);
  const bool is_hit = reached <= least * (1 + TOLERANCE) && double(found.evaluations) <= limit;
  std::cout << std::left << std::setw(28) << model.name << std::right << std::setw(8) << all.candidates << std::setw(13)
            << found.evaluations << std::setw(8) << std::setprecision(0) << limit << std::setw(12)
            << std::setprecision(4) << 100 * (reached / least - 1) << (is_hit ? "" : "  missed") << std::endl;
  return is_hit;
}

} // namespace

int main(int argc, char** argv)
{
  const std::vector<Model> models = read_models(argc, argv);
  std::cout << std::fixed << "Balances, best corners\n";
  for(const Model& model : models)
    print_balances(model);

  std::cout << "\nL2 at balance 0.3             iteration            fixed border        sliding border\n"
               "                                first      best     first      best     first      best\n";
  for(const Model& model : models)
    print_gains(model);

  std::cout
      << "\nBracketing search, meshes with 40 border vertices or more; energy above the best of the quarter in %\n"
         "                           candidates  evaluations   limit      excess\n";
  std::size_t tried = 0, hits = 0;
  for(const Model& model : models)
    if(model.patch.border.size() >= 40) {
      ++tried;
      hits += print_bracketing(model) ? 1 : 0;
    }
  std::cout << hits << " of " << tried << " found\n";
}
