// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The plug-ins with the classes of CGAL that they are made for, and with policies of a user.

#include "mesh_types.h"

#include <CGAL_ext/Square_parameterization/Brute_force_square_border_parameterizer_3.h>
#include <CGAL_ext/Square_parameterization/Circular_border_arc_length_parameterizer_3.h>
#include <CGAL_ext/Square_parameterization/Quarter_brute_force_square_border_parameterizer_3.h>
#include <CGAL_ext/Square_parameterization/Square_border_arc_length_parameterizer_3.h>
#include <CGAL_ext/Square_parameterization/Stretch_optimal_parameterizer_3.h>
#include <CGAL_ext/Square_parameterization/parameterize_onto_square.h>

#include <CGAL/Eigen_solver_traits.h>
#include <CGAL/Surface_mesh_parameterization/Circular_border_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Mean_value_coordinates_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Square_border_parameterizer_3.h>

#include <catch2/catch.hpp>

using namespace CGAL_ext;

namespace {

Surface_mesh curved_mesh()
{
  return make_mesh<Surface_mesh>(noisy_height_field(7));
}

/// a policy as the concept BaseWeights asks for, and nothing more
struct Inverse_length_weights
{
  Edge_weights operator()(const Patch& patch) const
  {
    Edge_weights weights(patch, 0, true);
    for(std::size_t e = 0; e < patch.edges.size(); ++e) {
      const double w = 1 / (patch.points[patch.edges[e][0]] - patch.points[patch.edges[e][1]]).norm();
      weights.values[e] = {w, w};
    }
    return weights;
  }
};

} // namespace

TEMPLATE_TEST_CASE("CGAL's mean value coordinates work with the searching borders", "",
                   Brute_force_square_border_parameterizer_3<Surface_mesh>,
                   Quarter_brute_force_square_border_parameterizer_3<Surface_mesh>,
                   Square_border_arc_length_parameterizer_3<Surface_mesh>,
                   Circular_border_arc_length_parameterizer_3<Surface_mesh>)
{
  Surface_mesh mesh = curved_mesh();
  CHECK(is_one_to_one(parameterize(mesh, SMP::Mean_value_coordinates_parameterizer_3<Surface_mesh, TestType>()),
                      mesh.number_of_faces()));
}

TEST_CASE("the optimal parameterizer is a drop-in, and its map is lower than that of the iteration")
{
  Surface_mesh mesh = curved_mesh();
  typedef Quarter_brute_force_square_border_parameterizer_3<Surface_mesh> Border;
  typedef boost::graph_traits<Surface_mesh>::vertex_descriptor vertex_descriptor;
  CHECK(is_one_to_one(parameterize(mesh, Stretch_optimal_parameterizer_3<Surface_mesh>()), mesh.number_of_faces()));
  const auto energy_of = [&mesh](const auto& parameterizer, double balance) {
    auto uvmap = mesh.add_property_map<vertex_descriptor, Point_2>("v:uv").first;
    const auto bhd = internal::first_border_halfedge(mesh);
    REQUIRE(SMP::parameterize(mesh, parameterizer, bhd, uvmap) == SMP::OK);
    const Stretch_measures measures = measure_stretch(mesh, uvmap);
    const double twice_l2 = 2 * measures.l2 * measures.l2;
    return twice_l2 + balance * (4 * measures.symmetric_dirichlet - twice_l2);
  };
  for(double balance : {0., 0.3, 1.}) {
    Balanced_minimization fixed, sliding;
    fixed.balance = sliding.balance = balance;
    fixed.border = Border_motion::FIXED;
    typedef Stretch_optimal_parameterizer_3<Surface_mesh, Border> Optimal;
    const double iterative = energy_of(Stretch_minimizing_parameterizer_3<Surface_mesh, Border>(), balance);
    CHECK(energy_of(Optimal(Border(), fixed), balance) < iterative);
    CHECK(energy_of(Optimal(Border(), sliding), balance) < energy_of(Optimal(Border(), fixed), balance));
  }
  Balanced_minimization wrong;
  wrong.balance = 1.5;
  CHECK(parameterize(mesh, Stretch_optimal_parameterizer_3<Surface_mesh>(
                               Bracketing_square_border_parameterizer_3<Surface_mesh>(), wrong))
            .status == SMP::ERROR_WRONG_PARAMETER);
}

TEMPLATE_TEST_CASE("the optimal parameterizer takes any convex border as it is", "",
                   Square_border_arc_length_parameterizer_3<Surface_mesh>,
                   Circular_border_arc_length_parameterizer_3<Surface_mesh>,
                   SMP::Circular_border_arc_length_parameterizer_3<Surface_mesh>)
{
  Surface_mesh mesh = curved_mesh();
  typedef boost::graph_traits<Surface_mesh>::vertex_descriptor vertex_descriptor;
  auto border = mesh.add_property_map<vertex_descriptor, Point_2>("v:border").first;
  const auto bhd = internal::first_border_halfedge(mesh);
  REQUIRE(TestType().parameterize(mesh, bhd, border, CGAL::Constant_property_map<vertex_descriptor, int>(0),
                                  CGAL::Constant_property_map<vertex_descriptor, bool>()) == SMP::OK);
  typedef Stretch_optimal_parameterizer_3<Surface_mesh, TestType> Optimal;
  Balanced_minimization fixed;
  fixed.border = Border_motion::FIXED;
  for(const Balanced_minimization& minimization : {fixed, Balanced_minimization()}) {
    CHECK(is_one_to_one(parameterize(mesh, Optimal(TestType(), minimization)), mesh.number_of_faces()));
    auto uvmap = mesh.add_property_map<vertex_descriptor, Point_2>("v:uv").first;
    REQUIRE(SMP::parameterize(mesh, Optimal(TestType(), minimization), bhd, uvmap) == SMP::OK);
    const bool is_square = std::is_same_v<TestType, Square_border_arc_length_parameterizer_3<Surface_mesh>>;
    if(!is_square || minimization.border == Border_motion::FIXED)
      for(auto v : CGAL::vertices_around_face(bhd, mesh))
        CHECK(get(uvmap, v) == get(border, v));
    auto iterated = mesh.add_property_map<vertex_descriptor, Point_2>("v:iterated").first;
    REQUIRE(SMP::parameterize(mesh, Stretch_minimizing_parameterizer_3<Surface_mesh, TestType>(), bhd, iterated) ==
            SMP::OK);
    CHECK(measure_stretch(mesh, uvmap).symmetric_dirichlet < measure_stretch(mesh, iterated).symmetric_dirichlet);
  }
}

TEST_CASE("a disk without interior vertices is mapped with every kind of weights")
{
  Surface_mesh mesh = make_mesh<Surface_mesh>(
      Flat_mesh{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}, {0, 1, 2, 3}});
  typedef Quarter_brute_force_square_border_parameterizer_3<Surface_mesh> Border;
  CHECK(is_one_to_one(parameterize(mesh, Stretch_minimizing_parameterizer_3<Surface_mesh, Border>()), 2));
  CHECK(is_one_to_one(
      parameterize(mesh, Stretch_minimizing_parameterizer_3<Surface_mesh, Border, Mean_value_weights>()), 2));
  CHECK(is_one_to_one(parameterize(mesh, Stretch_optimal_parameterizer_3<Surface_mesh, Border>()), 2));
}

TEST_CASE("brute force over the full border is at least as good as over the quarter")
{
  Surface_mesh mesh = curved_mesh();
  const auto l2_of = [&mesh](const auto& border) {
    typedef std::decay_t<decltype(border)> Border;
    typedef boost::graph_traits<Surface_mesh>::vertex_descriptor vertex_descriptor;
    auto uvmap = mesh.add_property_map<vertex_descriptor, Point_2>("v:uv").first;
    REQUIRE(SMP::parameterize(mesh, Stretch_minimizing_parameterizer_3<Surface_mesh, Border>(border),
                              first_border_halfedge_of(mesh), uvmap) == SMP::OK);
    return measure_stretch(mesh, uvmap).l2;
  };
  const double full = l2_of(Brute_force_square_border_parameterizer_3<Surface_mesh>());
  const double quarter = l2_of(Quarter_brute_force_square_border_parameterizer_3<Surface_mesh>());
  const double first = l2_of(Square_border_arc_length_parameterizer_3<Surface_mesh>());
  CHECK(full <= quarter);
  CHECK(quarter < first);
}

TEST_CASE("CGAL's circle border under the stretch-minimizing parameterizer gives a one-to-one map")
{
  typedef SMP::Circular_border_arc_length_parameterizer_3<Surface_mesh> Border;
  Surface_mesh mesh = curved_mesh();
  const Parameterization result = parameterize(mesh, Stretch_minimizing_parameterizer_3<Surface_mesh, Border>());
  CHECK(is_one_to_one(result, mesh.number_of_faces()));
}

TEST_CASE("CGAL's square border mirrors the map, which stays one-to-one")
{
  typedef SMP::Square_border_arc_length_parameterizer_3<Surface_mesh> Border;
  Surface_mesh mesh = curved_mesh();
  const Parameterization result = parameterize(mesh, Stretch_minimizing_parameterizer_3<Surface_mesh, Border>());
  REQUIRE(result.status == SMP::OK);
  CHECK(result.orientations.clockwise == mesh.number_of_faces());
}

TEMPLATE_TEST_CASE(
    "a sparse solver of CGAL agrees with the direct one", "",
    (CGAL::Eigen_solver_traits<Eigen::SimplicialLDLT<CGAL::Eigen_sparse_symmetric_matrix<double>::EigenType>>),
    (CGAL::Eigen_solver_traits<
        Eigen::BiCGSTAB<CGAL::Eigen_sparse_matrix<double>::EigenType, Eigen::IncompleteLUT<double>>>))
{
  Surface_mesh mesh = curved_mesh();
  typedef Square_border_arc_length_parameterizer_3<Surface_mesh> Border;
  const Parameterization expected = parameterize(mesh, Stretch_minimizing_parameterizer_3<Surface_mesh, Border>());
  typedef Stretch_minimizing_parameterizer_3<Surface_mesh, Border, CGAL::Default, TestType> Parameterizer;
  const Parameterization result = parameterize(mesh, Parameterizer());
  REQUIRE(is_one_to_one(result, mesh.number_of_faces()));
  CHECK(largest_difference(expected.uv, result.uv) < 1e-8); // BiCGSTAB stops at a residual of about 1e-16 |b|
}

TEST_CASE("general weights work with an iterative solver of CGAL")
{
  typedef CGAL::Eigen_solver_traits<
      Eigen::BiCGSTAB<CGAL::Eigen_sparse_matrix<double>::EigenType, Eigen::IncompleteLUT<double>>>
      Solver;
  typedef Square_border_arc_length_parameterizer_3<Surface_mesh> Border;
  Surface_mesh mesh = curved_mesh();
  typedef Stretch_minimizing_parameterizer_3<Surface_mesh, Border, Shape_preserving_weights> Direct;
  typedef Stretch_minimizing_parameterizer_3<Surface_mesh, Border, Shape_preserving_weights, Solver> Iterative;
  CHECK(largest_difference(parameterize(mesh, Direct()).uv, parameterize(mesh, Iterative()).uv) < 1e-8);
}

TEST_CASE("base weights of a user work in the parameterizer and in the free function")
{
  typedef Square_border_arc_length_parameterizer_3<Surface_mesh> Border;
  Surface_mesh mesh = curved_mesh();
  const Parameterization result =
      parameterize(mesh, Stretch_minimizing_parameterizer_3<Surface_mesh, Border, Inverse_length_weights>());
  CHECK(is_one_to_one(result, mesh.number_of_faces()));

  Square_map_options options;
  Stretch_minimization minimization;
  minimization.weights = Inverse_length_weights();
  options.minimization = minimization;
  Uv_storage<Surface_mesh, Point_2> storage;
  CHECK(parameterize_onto_square(mesh, storage.map(), CGAL_ext::parameters::options(options)).status == SMP::OK);
  CHECK(count_orientations(mesh, storage).counterclockwise == mesh.number_of_faces());
}
