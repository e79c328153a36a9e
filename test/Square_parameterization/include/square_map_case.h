// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_MAP_CASE_H
#define CGAL_EXT_SQUARE_MAP_CASE_H

#include "mesh_types.h"

#include <CGAL_ext/Square_parameterization/parameterize_onto_square.h>

#include <catch2/catch.hpp>

#include <vector>

typedef CGAL_ext::Square_map_result<Surface_mesh> Result;

struct Square_map
{
  Result result;
  std::vector<Eigen::Vector2d> uv; ///< empty unless the status is OK
};

inline Square_map map_onto_square(Surface_mesh& mesh, const CGAL_ext::Square_map_options<Surface_mesh>& options = {})
{
  Uv_storage<Surface_mesh, Point_2> storage;
  Square_map map{CGAL_ext::parameterize_onto_square(mesh, storage.map(), CGAL_ext::parameters::options(options)), {}};
  if(map.result.status == SMP::OK) {
    map.uv = storage.points(mesh);
    CHECK(count_orientations(mesh, storage).counterclockwise == mesh.number_of_faces());
  }
  return map;
}

inline Square_map map_onto_square(const Flat_mesh& flat, const CGAL_ext::Square_map_options<Surface_mesh>& options = {})
{
  Surface_mesh mesh = make_mesh<Surface_mesh>(flat);
  return map_onto_square(mesh, options);
}

/// keeps everything that a visitor is told
class Recording_visitor : public CGAL_ext::Search_visitor
{
public:
  void start_search(std::size_t candidates) override { starts.push_back(candidates); }
  void after_evaluation(const CGAL_ext::Search_report::Sample&) override { ++evaluations; }
  void end_search(const CGAL_ext::Search_report& report) override { searches.push_back(report); }
  void end_minimization(const CGAL_ext::Minimization_report& report) override { minimizations.push_back(report); }

  std::vector<std::size_t> starts;
  std::size_t evaluations = 0;
  std::vector<CGAL_ext::Search_report> searches;
  std::vector<CGAL_ext::Minimization_report> minimizations;
};

#endif // CGAL_EXT_SQUARE_MAP_CASE_H
