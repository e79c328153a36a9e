// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "mapped_patches.h"
#include "test_meshes.h"

#include <CGAL_ext/Square_parameterization/internal/coarsening/Patch_sequence.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/Multigrid_preconditioner.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/make_minimizer.h>
#include <CGAL_ext/Square_parameterization/internal/patch/Ordered_patch.h>

#include <catch2/catch.hpp>

using namespace CGAL_ext;
using namespace CGAL_ext::internal;

namespace {

/// a patch, the next coarser one, and the V-cycle over both at a map of the first
struct Two_levels
{
  Two_levels(const Patch& given, int vertices_per_block)
    : given_division(given, vertices_per_block),
      patch(in_order_of(given_division, given)),
      patches(patch, false),
      division(given_division.in_order()),
      coarse_division(coarsened()),
      energy(patch, 0.3, 1, &division),
      coarse_energy(patches[1], 0.3),
      coarse(patches[1], coarse_division),
      fine(Multigrid_preconditioner::of_large(patch, division))
  {
    fine.set_coarser(Vertex_interpolation(patch, patches.coarse(1), division.order(), coarse_division.order()), coarse);
    uv = make_minimizer(patch, Balanced_minimization())->make_worker()(square_border_of(patch, 0), nullptr).uv;
    Uv_coordinates coarse_uv(patches[1].number_of_vertices(), 2);
    for(int v = 0; v < patches[1].number_of_vertices(); ++v)
      coarse_uv.row(v) = uv.row(patches.coarse(1).fine_vertex[v]);
    memory.coarser = &coarse_memory;
    REQUIRE(coarse.factorize(coarse_energy, coarse_uv, free_coordinates(patches[1], coarse_uv, true), coarse_memory));
    is_free = free_coordinates(patch, uv, true);
    REQUIRE(fine.factorize(energy, uv, is_free, memory));
  }

  const Patch& coarsened()
  {
    patches.coarsen({0.7, 0.05});
    REQUIRE(patches.size() > 1);
    return patches[1];
  }

  Uv_coordinates random_vector() const
  {
    return is_free.select(Uv_coordinates::Random(patch.number_of_vertices(), 2), 0.);
  }

  Uv_coordinates cycle(Uv_coordinates x)
  {
    fine.apply(memory, x);
    return x;
  }

  Patch_division given_division;
  Patch patch;
  Patch_sequence patches;
  Patch_division division, coarse_division;
  Balanced_energy energy, coarse_energy;
  Multigrid_preconditioner coarse, fine;
  Multigrid_preconditioner::Memory coarse_memory, memory;
  Uv_coordinates uv;
  Free_coordinates is_free;
};

} // namespace

TEST_CASE("a patch in the order of its division keeps the places of elimination of its vertices")
{
  Patch given = make_patch_of(saddle(30));
  for(int v = given.number_of_vertices(); v > 0; --v)
    given.elimination_places.push_back(v - 1);
  const Patch_division division(given, 100);
  REQUIRE(division.is_divided());
  const Patch ordered = in_order_of(division, given);
  for(int v = 0; v < given.number_of_vertices(); ++v)
    REQUIRE(ordered.elimination_places[division.rank(v)] == given.elimination_places[v]);
}

TEST_CASE("the V-cycle is symmetric, positive, and leaves what may not move")
{
  const Patch patch = make_patch_of(noisy_height_field(20));
  const int vertices_per_block = GENERATE(1000, 100, 20); // one block, and many
  Two_levels levels(patch, vertices_per_block);
  CHECK(levels.division.is_divided() == (vertices_per_block < 1000));
  for(int i = 0; i < 5; ++i) {
    const Uv_coordinates a = levels.random_vector(), b = levels.random_vector();
    const Uv_coordinates at_a = levels.cycle(a), at_b = levels.cycle(b);
    CHECK(dot(at_a, b) == Approx(dot(a, at_b)).epsilon(1e-9));
    CHECK(dot(at_a, a) > 0);
    CHECK(levels.is_free.select(Uv_coordinates::Zero(a.rows(), 2), at_a).norm() == 0);
  }
}

TEST_CASE("V-cycles solve the equations that factors solve, with less error each time")
{
  const Patch patch = make_patch_of(saddle(24));
  Two_levels levels(patch, GENERATE(1000, 50)); // one block, and many
  const Axis_preconditioner direct(levels.patch);
  Axis_preconditioner::Factors factors;
  REQUIRE(direct.factorize(levels.energy, levels.uv, levels.is_free, factors));
  const Uv_coordinates right_hand_side = levels.random_vector();
  Uv_coordinates exact = right_hand_side;
  direct.apply(factors, exact);

  // the residual is taken with the matrix of the V-cycle itself, in its upper triangle
  const auto residual = [&](const Uv_coordinates& x) {
    Uv_coordinates result = right_hand_side;
    const Axis_matrix::Matrix& matrix = levels.memory.matrix;
    for(int j = 0; j < matrix.outerSize(); ++j)
      for(Axis_matrix::Matrix::InnerIterator it(matrix, j); it; ++it)
        for(int axis = 0; axis < 2; ++axis) {
          result(it.row(), axis) -= it.value()[axis] * x(j, axis);
          if(it.row() != j)
            result(j, axis) -= it.value()[axis] * x(it.row(), axis);
        }
    return result;
  };
  Uv_coordinates x = Uv_coordinates::Zero(patch.number_of_vertices(), 2);
  double error = exact.norm();
  for(int i = 0; i < 12; ++i) {
    x += levels.cycle(residual(x));
    const double left = (x - exact).norm();
    CHECK(left < 0.6 * error + 1e-12);
    error = left;
  }
  CHECK(error < 1e-2 * exact.norm());
}
