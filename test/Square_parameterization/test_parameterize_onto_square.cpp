// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "reference_stretch.h"
#include "square_map_case.h"

#include <catch2/catch.hpp>

#include <chrono>

using namespace CGAL_ext;
using Catch::Matchers::Contains;

namespace {

Square_map_options<Surface_mesh> with_corners(const std::array<std::size_t, 4>& corners)
{
  Square_map_options<Surface_mesh> options;
  options.corners.emplace();
  for(std::size_t k = 0; k < 4; ++k)
    (*options.corners)[k] = Surface_mesh::Vertex_index(static_cast<Surface_mesh::size_type>(corners[k]));
  return options;
}

} // namespace

TEST_CASE("the result tells the map")
{
  const Flat_mesh flat = noisy_height_field(6);
  Square_map_options<Surface_mesh> options;
  options.search = Quarter_brute_force_corner_search();
  const bool is_iterative = GENERATE(true, false);
  if(is_iterative)
    options.minimization = Stretch_minimization();
  const auto [result, uv] = map_onto_square(flat, options);
  REQUIRE(result.status == SMP::OK);
  CHECK(result.message.empty());
  CHECK(result.chords_split == 0);
  CHECK(result.border_edges == 24);
  REQUIRE(result.corners.size() == 4);
  const Eigen::Vector2d expected[] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  for(int k = 0; k < 4; ++k)
    CHECK(uv[result.corners[k]] == expected[k]);

  CHECK(result.search.evaluations == std::size_t(result.search.candidates));
  CHECK(result.search.curve.size() == result.search.evaluations);
  CHECK(result.search.candidates >= 5);
  CHECK(result.search.candidates <= 8);
  for(const auto& sample : result.search.curve)
    CHECK(sample.objective >= result.search.best_objective);

  const Reference_stretch reference = reference_stretch(flat.points, flat.triangles, uv);
  if(is_iterative)
    CHECK(result.search.best_objective == Approx(reference.l2).epsilon(1e-12));
  CHECK(result.search.best_objective == result.minimization.objective);
  CHECK(result.minimization.l2 == Approx(reference.l2).epsilon(1e-12));
  CHECK(result.measures.l2 == Approx(reference.l2).epsilon(1e-12));
  CHECK(result.measures.linf == Approx(reference.linf).epsilon(1e-10));
  CHECK(result.measures.uv_area == Approx(1).epsilon(1e-14));
  CHECK(result.measures.flipped_faces == 0);
}

TEST_CASE("every candidate of brute force is what its corners give")
{
  const Flat_mesh flat = saddle(4);
  Square_map_options<Surface_mesh> options;
  options.search = Brute_force_corner_search();
  const Result result = map_onto_square(flat, options).result;
  REQUIRE(result.search.evaluations == 16);
  std::array<std::size_t, 4> corners{};
  std::copy(result.corners.begin(), result.corners.end(), corners.begin());
  const Result again = map_onto_square(flat, with_corners(corners)).result;
  CHECK(again.search.best_objective == result.search.best_objective);
  CHECK(again.corners == result.corners);
}

TEST_CASE("a flat square with its own corners is mapped to itself by weights with linear precision")
{
  const Flat_mesh flat = unit_square(8);
  Square_map_options<Surface_mesh> options = with_corners({0, 8, 80, 72});
  Stretch_minimization minimization;
  minimization.weights = Mean_value_weights();
  options.minimization = minimization;
  const auto [result, uv] = map_onto_square(flat, options);
  REQUIRE(result.status == SMP::OK);
  CHECK(std::abs(result.measures.l2 - 1) < 1e-12);
  for(std::size_t v = 0; v < uv.size(); ++v)
    CHECK((uv[v] - flat.points[v].head<2>()).norm() < 1e-10);
}

TEST_CASE("a flat square is mapped to itself by the defaults, as nearly as the tolerance asks")
{
  const Flat_mesh flat = unit_square(8);
  Balanced_minimization minimization;
  for(double tolerance : {1e-5, 1e-14}) {
    minimization.tolerance = tolerance;
    Square_map_options<Surface_mesh> options;
    options.minimization = minimization;
    const auto [result, uv] = map_onto_square(flat, options);
    REQUIRE(result.status == SMP::OK);
    CHECK(std::abs(result.measures.l2 - 1) < tolerance);
    CHECK(std::abs(result.measures.symmetric_dirichlet - 1) < tolerance);
  }
}

TEST_CASE("corners that are not four border vertices in order are refused")
{
  const Flat_mesh flat = unit_square(4); // corners 0, 4, 24, 20; vertex 12 is inside
  const auto status_of = [&](const std::array<std::size_t, 4>& corners) {
    return map_onto_square(flat, with_corners(corners)).result.status;
  };
  CHECK(status_of({4, 24, 20, 0}) == SMP::OK);
  CHECK(status_of({0, 20, 24, 4}) == SMP::ERROR_WRONG_PARAMETER);
  CHECK(status_of({0, 24, 4, 20}) == SMP::ERROR_WRONG_PARAMETER);
  CHECK(status_of({0, 0, 24, 20}) == SMP::ERROR_WRONG_PARAMETER);
  CHECK(status_of({0, 4, 24, 999}) == SMP::ERROR_WRONG_PARAMETER); // no vertex
  CHECK_THAT(map_onto_square(flat, with_corners({0, 12, 24, 20})).result.message, Contains("corner vertex 12 "));
}

TEST_CASE("numbers out of range are refused")
{
  const double eta = GENERATE(0., -1., 1.0001, std::nan(""));
  Square_map_options<Surface_mesh> options;
  Stretch_minimization iteration;
  iteration.eta = eta;
  Balanced_minimization balanced;
  balanced.start.eta = eta;
  for(const Minimization& minimization : {Minimization(iteration), Minimization(balanced)}) {
    options.minimization = minimization;
    CHECK(map_onto_square(unit_square(3), options).result.status == SMP::ERROR_WRONG_PARAMETER);
  }

  Surface_mesh mesh = make_mesh<Surface_mesh>(unit_square(3));
  typedef Stretch_minimizing_parameterizer_3<Surface_mesh> Parameterizer;
  typedef Parameterizer::Border_parameterizer Border;
  CHECK(parameterize(mesh, Parameterizer(Border(), Blended_weights(), eta)).status == SMP::ERROR_WRONG_PARAMETER);
}

TEST_CASE("another vertex point map may follow the options")
{
  typedef boost::graph_traits<Surface_mesh>::vertex_descriptor vertex_descriptor;
  // the same triangles with other points
  const Flat_mesh flat = rectangle(5, 5, 1, 1, 1);
  const Flat_mesh bent = transformed(
      flat, [](const Eigen::Vector3d& p) { return Eigen::Vector3d(p.x(), p.y(), p.x() * p.x() + p.y() / 2); });
  Surface_mesh mesh = make_mesh<Surface_mesh>(flat);
  auto points = mesh.add_property_map<vertex_descriptor, Kernel::Point_3>("v:bent").first;
  for(vertex_descriptor v : mesh.vertices())
    points[v] = Kernel::Point_3(bent.points[v].x(), bent.points[v].y(), bent.points[v].z());

  Uv_storage<Surface_mesh, Point_2> storage;
  const auto options = CGAL_ext::parameters::options(Square_map_options<Surface_mesh>());
  REQUIRE(parameterize_onto_square(mesh, storage.map(), options.vertex_point_map(points)).status == SMP::OK);
  CHECK(largest_difference(storage.points(mesh), map_onto_square(bent).uv) == 0);
  CHECK(largest_difference(storage.points(mesh), map_onto_square(flat).uv) > 1e-3);
}

TEST_CASE("the map does not depend on the scale and the place of the mesh")
{
  const Flat_mesh flat = noisy_height_field(6);
  const std::vector<Eigen::Vector2d> expected = map_onto_square(flat).uv;
  CHECK(largest_difference(map_onto_square(scaled(flat, 1e-8)).uv, expected) < 1e-10);
  CHECK(largest_difference(map_onto_square(scaled(flat, 1e8)).uv, expected) < 1e-10);
  // coordinates near 1e3 are rounded to 1e-13
  CHECK(largest_difference(map_onto_square(translated(flat, {1e3, -1e3, 1e3})).uv, expected) < 1e-9);
}

TEST_CASE("the map is the same to the last bit for any number of threads")
{
  const Flat_mesh flat = noisy_height_field(9);
  Square_map_options<Surface_mesh> options;
  options.search = Brute_force_corner_search();
  options.search_options.number_of_threads = 1;
  const Square_map expected = map_onto_square(flat, options);
  for(unsigned int threads : {2, 8, 0}) {
    options.search_options.number_of_threads = threads;
    const Square_map map = map_onto_square(flat, options);
    CHECK(map.uv == expected.uv);
    CHECK(map.result.corners == expected.result.corners);
    REQUIRE(map.result.search.curve.size() == expected.result.search.curve.size());
    for(std::size_t i = 0; i < map.result.search.curve.size(); ++i)
      CHECK(map.result.search.curve[i].objective == expected.result.search.curve[i].objective);
  }
}

TEST_CASE("the visitor is told of the search and of the minimization")
{
  Recording_visitor visitor;
  Square_map_options<Surface_mesh> options;
  options.search_options.visitor = &visitor;
  const Result result = map_onto_square(saddle(6), options).result;
  REQUIRE(visitor.starts.size() == 1);
  REQUIRE(visitor.searches.size() == 1);
  REQUIRE(visitor.minimizations.size() == 1);
  CHECK(visitor.starts[0] == std::size_t(result.search.candidates));
  CHECK(visitor.evaluations == result.search.evaluations);
  CHECK(visitor.searches[0].best_objective == result.search.best_objective);
  CHECK(visitor.searches[0].corners == result.search.corners);
  CHECK(visitor.minimizations[0].history == result.minimization.history);
}

TEST_CASE("a cancelled search delivers the best map so far")
{
  Square_map_options<Surface_mesh> options;
  options.search = Brute_force_corner_search();
  options.search_options.number_of_threads = 1;
  options.search_options.callback = [](double share) { return share < 0.5; };
  const auto [result, uv] = map_onto_square(saddle(5), options);
  CHECK(result.status == SMP::OK);
  CHECK(result.search.is_cancelled);
  CHECK(result.search.evaluations == 10);
  CHECK(uv.size() == 36);
}

TEST_CASE("a deadline that has passed leaves the mesh as it was, one that passes gives the best map so far")
{
  Square_map_options<Surface_mesh> options;
  options.search = Brute_force_corner_search();
  options.search_options.number_of_threads = 1;
  options.search_options.deadline = std::chrono::steady_clock::now();
  const auto [late, no_uv] = map_onto_square(saddle(5), options);
  CHECK(late.status == SMP::ERROR_NO_1_TO_1_MAPPING);
  CHECK(late.message == "the search was stopped after 0 candidates, none with a one-to-one map");
  CHECK(late.search.is_cancelled);
  CHECK(no_uv.empty());
  options.search_options.deadline = std::chrono::steady_clock::now() + std::chrono::seconds(1);
  const auto [result, uv] = map_onto_square(saddle(60), options); // all candidates take some ten seconds
  CHECK(result.status == SMP::OK);
  CHECK(result.search.is_cancelled);
  CHECK(result.search.evaluations >= 1);
  CHECK(result.search.evaluations < 240);
}

TEST_CASE("a search that is cancelled at the first question delivers nothing, and says so")
{
  for(bool is_bracketing : {true, false}) {
    int questions = 0;
    Square_map_options<Surface_mesh> options;
    if(!is_bracketing)
      options.search = Brute_force_corner_search();
    options.search_options.number_of_threads = 1;
    options.search_options.callback = [&questions](double share) {
      ++questions;
      CHECK(share == 0);
      return false;
    };
    const auto [result, uv] = map_onto_square(saddle(5), options);
    CHECK(result.status == SMP::ERROR_NO_1_TO_1_MAPPING);
    CHECK(result.message == "the search was stopped after 0 candidates, none with a one-to-one map");
    CHECK(result.search.is_cancelled);
    CHECK(result.search.evaluations == 0);
    CHECK_FALSE(result.search.best_candidate);
    CHECK(questions == 1);
    CHECK(uv.empty());
  }
}

TEST_CASE("the walk and the corner rule change the corners, not the orientation")
{
  for(Walk walk : {Walk::COUNTER_CLOCKWISE, Walk::CLOCKWISE})
    for(Corner_rule rule : {Corner_rule::AUTHOR, Corner_rule::NEAREST}) {
      Square_map_options<Surface_mesh> options;
      options.search_options.walk = walk;
      options.search_options.corner_rule = rule;
      const auto [result, uv] = map_onto_square(noisy_height_field(6), options); // checks the orientation
      REQUIRE(result.status == SMP::OK);
      CHECK(uv[result.corners[1]] == Eigen::Vector2d(1, 0));
      CHECK(uv[result.corners[3]] == Eigen::Vector2d(0, 1));
    }
}

TEST_CASE("corners are counted in the order of the vertices of the mesh, isolated ones included")
{
  Flat_mesh flat = unit_square(4);
  for(auto& t : flat.triangles)
    for(int& v : t)
      ++v;
  flat.points.insert(flat.points.begin(), Eigen::Vector3d(9, 9, 9));
  Surface_mesh mesh = make_mesh<Surface_mesh>(flat);
  Uv_storage<Surface_mesh, Point_2> storage;
  const Result result =
      parameterize_onto_square(mesh, storage.map(), CGAL_ext::parameters::options(with_corners({1, 5, 25, 21})));
  REQUIRE(result.status == SMP::OK);
  CHECK(result.corners[0] == vertex_at(mesh, 1));
  CHECK(get(storage.map(), vertex_at(mesh, 25)) == Point_2(1, 1));
}

TEST_CASE("a start that leads to no map gives way to the others, in their order, and the report says so")
{
  const Flat_mesh flat = noisy_height_field(8);
  const Result usual = map_onto_square(flat).result;
  CHECK(usual.start == Map_start::AS_CHOSEN);
  Balanced_minimization broken;
  broken.start.weights = [](const Patch& patch) { return Edge_weights(patch, 0, true); }; // a singular system
  Square_map_options<Surface_mesh> options;
  options.minimization = broken;
  SECTION("in a search") {}
  SECTION("with corners of the user")
  {
    options.corners = with_corners({0, 8, 80, 72}).corners;
  }
  const Result other = map_onto_square(flat, options).result;
  REQUIRE(other.status == SMP::OK);
  CHECK(other.start == Map_start::BLENDED_WEIGHTS); // gradual coarsening has the broken weights, too
  CHECK(other.search.best_objective < 1.2 * usual.search.best_objective);
}

TEST_CASE("a long tube, whose map is lost in rounding when the mesh loses half its vertices at a time, is mapped in "
          "small steps")
{
  const Flat_mesh flat = crumpled_tube(150, 1);
  const auto [result, uv] = map_onto_square(flat);
  REQUIRE(result.status == SMP::OK);
  CHECK(result.start == Map_start::GRADUAL_COARSENING);
  CHECK(result.measures.l2 < 30);
  CHECK(result.measures.l2 == Approx(reference_stretch(flat.points, flat.triangles, uv).l2).epsilon(1e-9));
}
