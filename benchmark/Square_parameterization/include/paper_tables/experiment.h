// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PAPER_TABLES_EXPERIMENT_H
#define PAPER_TABLES_EXPERIMENT_H

#include <CGAL_ext/Square_parameterization/Bracketing_corner_search.h>
#include <CGAL_ext/Square_parameterization/Hybrid_corner_search.h>
#include <CGAL_ext/Square_parameterization/Particle_swarm_corner_search.h>
#include <CGAL_ext/Square_parameterization/Step_sampling_corner_search.h>
#include <CGAL_ext/Square_parameterization/circle_corner_searches.h>
#include <CGAL_ext/Square_parameterization/parameterize_onto_square.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <string>
#include <vector>

namespace paper_tables {

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

/// what one strategy found on one mesh
struct Run
{
  std::size_t evaluations = 0;
  int candidate = -1;
  double l2 = 0, seconds = 0;
};

/// everything measured on one mesh
struct Experiment
{
  std::string name;
  std::size_t vertices = 0, faces = 0, border_edges = 0; // as mapped
  int candidates = 0, step = 0;
  std::vector<CGAL_ext::Search_report::Sample> curve; // of the quarter brute force
  std::map<std::string, Run> runs;                    // by strategy
  std::map<std::string, double> rank_correlation;     // by fast solver
};

/// the strategies of the paper, in its order, and bracketing
inline std::vector<std::pair<std::string, CGAL_ext::Corner_search>> strategies()
{
  return {{"quarter-brute-force", CGAL_ext::Quarter_brute_force_corner_search()},
          {"particle-swarm", CGAL_ext::Particle_swarm_corner_search()},
          {"step-sampling", CGAL_ext::Step_sampling_corner_search()},
          {"single-highest", CGAL_ext::Single_highest_corner_search()},
          {"many-high", CGAL_ext::Many_high_corner_search()},
          {"better-of-two", CGAL_ext::Better_of_two_corner_search()},
          {"hybrid", CGAL_ext::Hybrid_corner_search()},
          {"bracketing", CGAL_ext::Bracketing_corner_search()}};
}

/// the parameterizations by one linear system that the paper compares with
inline std::vector<std::pair<std::string, CGAL_ext::Stretch_minimization>> fast_solvers()
{
  std::vector<std::pair<std::string, CGAL_ext::Stretch_minimization>> solvers(4);
  solvers[0].first = "uniform";
  solvers[0].second.weights = CGAL_ext::Uniform_weights();
  solvers[1].first = "shape-preserving";
  solvers[1].second.weights = CGAL_ext::Shape_preserving_weights();
  solvers[2].first = "mean-value";
  solvers[2].second.weights = CGAL_ext::Mean_value_weights();
  solvers[3].first = "harmonic";
  solvers[3].second.weights = CGAL_ext::Harmonic_weights();
  for(auto& solver : solvers)
    solver.second.maximum_iterations = 0;
  return solvers;
}

/// ranks from 0, ties at their mean
inline std::vector<double> ranks(const std::vector<double>& values)
{
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  std::vector<double> result(values.size());
  for(std::size_t begin = 0; begin < order.size();) {
    std::size_t end = begin + 1;
    while(end < order.size() && values[order[end]] == values[order[begin]])
      ++end;
    for(std::size_t i = begin; i < end; ++i)
      result[order[i]] = double(begin + end - 1) / 2.;
    begin = end;
  }
  return result;
}

/// Spearman's rank correlation, in [-1, 1]; 0 when one side is constant
inline double rank_correlation(const std::vector<double>& a, const std::vector<double>& b)
{
  const std::vector<double> x = ranks(a), y = ranks(b);
  const double mean = double(x.size() - 1) / 2.;
  double xy = 0, xx = 0, yy = 0;
  for(std::size_t i = 0; i < x.size(); ++i) {
    xy += (x[i] - mean) * (y[i] - mean);
    xx += (x[i] - mean) * (x[i] - mean);
    yy += (y[i] - mean) * (y[i] - mean);
  }
  return xx * yy > 0 ? xy / std::sqrt(xx * yy) : 0;
}

inline std::vector<double> objective_of(const std::vector<CGAL_ext::Search_report::Sample>& curve)
{
  std::vector<double> stretch;
  for(const auto& sample : curve)
    stretch.push_back(sample.objective);
  return stretch;
}

/// maps a copy of \p mesh
inline CGAL_ext::Square_map_result<Mesh> map_copy(Mesh mesh, const CGAL_ext::Square_map_options<Mesh>& options)
{
  const auto uv = mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("h:uv").first;
  return CGAL_ext::parameterize_onto_square(mesh, uv, CGAL_ext::parameters::options(options));
}

/// runs every strategy on \p mesh. Throws `std::runtime_error` when the mesh cannot be mapped.
inline Experiment run_experiment(const std::string& name, const Mesh& mesh, CGAL_ext::Square_map_options<Mesh> options)
{
  Experiment experiment;
  experiment.name = name;
  for(const auto& [strategy, search] : strategies()) {
    options.search = search;
    const auto result = map_copy(mesh, options);
    if(result.status != CGAL::Surface_mesh_parameterization::OK)
      throw std::runtime_error(result.message);
    experiment.runs[strategy] = {result.search.evaluations, *result.search.best_candidate, result.measures.l2,
                                 result.search_seconds};
    if(strategy == "quarter-brute-force") {
      experiment.curve = result.search.curve;
      experiment.candidates = result.search.candidates;
      experiment.border_edges = result.border_edges;
      experiment.faces = result.measures.face_l2.size();
      experiment.vertices = (experiment.faces + experiment.border_edges) / 2 + 1; // of a disk
    }
  }
  CGAL_ext::Corner_search_problem problem;
  problem.number_of_candidates = experiment.candidates;
  problem.number_of_vertices = static_cast<int>(experiment.vertices);
  problem.number_of_faces = static_cast<int>(experiment.faces);
  experiment.step = CGAL_ext::internal::sampling_step(problem);

  options.search = CGAL_ext::Quarter_brute_force_corner_search();
  for(const auto& [solver, minimization] : fast_solvers()) {
    options.minimization = minimization;
    const auto result = map_copy(mesh, options);
    experiment.rank_correlation[solver] =
        rank_correlation(objective_of(result.search.curve), objective_of(experiment.curve));
  }
  return experiment;
}

} // namespace paper_tables

#endif // PAPER_TABLES_EXPERIMENT_H
