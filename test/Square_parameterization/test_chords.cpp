// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "square_map_case.h"

#include <CGAL_ext/Square_parameterization/Brute_force_square_border_parameterizer_3.h>
#include <CGAL_ext/Square_parameterization/split_chords.h>

#include <CGAL/Surface_mesh/IO/OFF.h>
#include <CGAL/boost/graph/helpers.h>

#include <fstream>
#include <string>

using namespace CGAL_ext;

TEST_CASE("chords are split so that every candidate has a map")
{
  const Flat_mesh flat = GENERATE(fan_with_ears(12, 3), fan_with_ears(7, 1), rectangle(6, 1, 6, 1, 1));
  Surface_mesh mesh = make_mesh<Surface_mesh>(flat);
  const std::size_t edges_before = mesh.number_of_edges(), faces_before = mesh.number_of_faces();
  std::size_t chords = 0;
  for(auto e : mesh.edges())
    chords += !mesh.is_border(e) && mesh.is_border(mesh.vertex(e, 0)) && mesh.is_border(mesh.vertex(e, 1)) ? 1 : 0;

  Square_map_options<Surface_mesh> options;
  options.search = Brute_force_corner_search();
  const auto [result, uv] = map_onto_square(mesh, options);
  REQUIRE(result.status == SMP::OK);
  CHECK(chords > 0);
  CHECK(result.chords_split == chords);
  CHECK(mesh.number_of_vertices() == flat.points.size() + chords);
  CHECK(mesh.number_of_edges() == edges_before + 3 * chords);
  CHECK(mesh.number_of_faces() == faces_before + 2 * chords);
  CHECK(CGAL::is_valid_polygon_mesh(mesh));
  CHECK(CGAL::is_triangle_mesh(mesh));
  CHECK(result.search.evaluations == flat.border.size());
  for(const auto& sample : result.search.curve)
    CHECK(std::isfinite(sample.objective));
  CHECK(split_chords(mesh) == 0);
}

TEST_CASE("a chord is split at its midpoint")
{
  Surface_mesh mesh = make_mesh<Surface_mesh>(
      Flat_mesh{{{0, 0, 0}, {2, 0, 1}, {2, 2, 4}, {0, 2, 0}}, {{0, 1, 2}, {0, 2, 3}}, {0, 1, 2, 3}});
  CHECK(split_chords(mesh) == 1);
  REQUIRE(mesh.number_of_vertices() == 5);
  CHECK(mesh.point(vertex_at(mesh, 4)) == Kernel::Point_3(1, 1, 2));
  CHECK(mesh.number_of_faces() == 4);
  CHECK(mesh.degree(vertex_at(mesh, 4)) == 4);
}

TEST_CASE("a border of three edges gets a fourth")
{
  Surface_mesh mesh = make_mesh<Surface_mesh>(Flat_mesh{{{0, 0, 0}, {1, 0, 0}, {0, 2, 0}}, {{0, 1, 2}}, {0, 1, 2}});
  const auto [result, uv] = map_onto_square(mesh);
  REQUIRE(result.status == SMP::OK);
  CHECK(result.border_edges_split == 1);
  CHECK(result.border_edges == 4);
  CHECK(result.chords_split == 1); // from the midpoint of the longest edge to the vertex opposite
  CHECK(CGAL::is_valid_polygon_mesh(mesh));
  REQUIRE(mesh.number_of_vertices() == 5);
  CHECK(mesh.point(vertex_at(mesh, 3)) == Kernel::Point_3(0.5, 1, 0));
  CHECK(result.measures.flipped_faces == 0);
}

TEST_CASE("only ears may be split, as the authors did")
{
  // one row of six cells: each end has one ear; the other chords stay
  Surface_mesh strip = make_mesh<Surface_mesh>(rectangle(6, 1, 6, 1, 1));
  CHECK(split_chords(strip, parameters::chords(Chords::EARS)) == 2);
  CHECK(CGAL::is_valid_polygon_mesh(strip));
  Surface_mesh fan = make_mesh<Surface_mesh>(fan_with_ears(12, 3));
  CHECK(split_chords(fan, parameters::chords(Chords::EARS).vertex_point_map(fan.points())) == 4);
}

TEST_CASE("the plug-in passes over candidates whose chords lie on a side, and does not change the mesh")
{
  // four ears a quarter apart: only with an ear at every corner no chord lies on a side
  Surface_mesh mesh = make_mesh<Surface_mesh>(fan_with_ears(12, 3));
  const Surface_mesh before = mesh;
  Recording_visitor visitor;
  Square_search_options options;
  options.visitor = &visitor;
  typedef Brute_force_square_border_parameterizer_3<Surface_mesh> Border;
  typedef Stretch_minimizing_parameterizer_3<Surface_mesh, Border> Parameterizer;
  const Parameterization result = parameterize(mesh, Parameterizer(Border({}, options)));
  CHECK(is_one_to_one(result, mesh.number_of_faces()));
  CHECK(mesh.number_of_vertices() == before.number_of_vertices());

  REQUIRE(visitor.searches.size() == 1);
  std::size_t feasible = 0;
  for(const auto& sample : visitor.searches[0].curve)
    feasible += std::isfinite(sample.objective) ? 1 : 0;
  CHECK(visitor.searches[0].evaluations == 16);
  CHECK(feasible == 4);
}

TEST_CASE("the plug-in returns that there is no one-to-one map when every candidate has a chord on a side")
{
  // eight ears, four corners
  Surface_mesh mesh = make_mesh<Surface_mesh>(fan_with_ears(8, 1));
  typedef Brute_force_square_border_parameterizer_3<Surface_mesh> Border;
  CHECK(parameterize(mesh, Stretch_minimizing_parameterizer_3<Surface_mesh, Border>()).status ==
        SMP::ERROR_NO_1_TO_1_MAPPING);
  CHECK(parameterize(mesh, Stretch_minimizing_parameterizer_3<Surface_mesh>()).status == SMP::ERROR_NO_1_TO_1_MAPPING);
  CHECK(split_chords(mesh) == 8);
  CHECK(is_one_to_one(parameterize(mesh, Stretch_minimizing_parameterizer_3<Surface_mesh>()), mesh.number_of_faces()));
}

TEST_CASE("real disks are mapped one-to-one for every corner, with their chords split")
{
  const std::string name = GENERATE("nefertiti.off", "three_peaks.off", "mushroom.off");
  const std::string path = std::string(REAL_MESHES) + "/" + name;
  std::ifstream file(path);
  if(!file) {
    WARN("skipped: there is no " << path);
    return;
  }
  Surface_mesh mesh;
  REQUIRE(CGAL::IO::read_OFF(file, mesh));
  Square_map_options<Surface_mesh> options;
  options.search = Quarter_brute_force_corner_search();
  options.search_options.callback = [](double share) { return share < 0.1; }; // some candidates are enough
  const auto [result, uv] = map_onto_square(mesh, options);                   // checks the orientation of every face
  REQUIRE(result.status == SMP::OK);
  CHECK(result.measures.flipped_faces == 0);
  CHECK((name == "three_peaks.off") == (result.chords_split > 0));
  for(const auto& sample : result.search.curve)
    CHECK(std::isfinite(sample.objective));
  for(const Eigen::Vector2d& p : uv)
    CHECK((p.minCoeff() >= 0 && p.maxCoeff() <= 1));
}
