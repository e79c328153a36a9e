// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "energy_by_definition.h"
#include "mapped_patches.h"

#include <CGAL_ext/Square_parameterization/internal/minimization/Balanced_minimizer.h>
#include <CGAL_ext/Square_parameterization/internal/patch/exact_orientation.h>
#include <CGAL_ext/Square_parameterization/measure_stretch.h>

#include <catch2/catch.hpp>

#include <set>
#include <tuple>
#include <vector>

using namespace CGAL_ext;
using namespace CGAL_ext::internal;

namespace {

Balanced_minimization minimization_of(double balance, bool is_border_sliding)
{
  Balanced_minimization result;
  result.balance = balance;
  result.border = is_border_sliding ? Border_motion::SLIDING : Border_motion::FIXED;
  return result;
}

Minimized_map minimized(const Patch& patch, Uv_coordinates start, const Balanced_minimization& options,
                        double tolerance)
{
  Balanced_minimizer::Workspace workspace;
  return Balanced_minimizer(patch, options).minimize({std::move(start), {}, {}}, tolerance, workspace);
}

Uv_coordinates random_coordinates(Eigen::Index rows, unsigned int seed)
{
  Random_numbers random(seed);
  Uv_coordinates result(rows, 2);
  for(Eigen::Index k = 0; k < result.size(); ++k)
    result(k / 2, k % 2) = random(-1, 1);
  return result;
}

/// the map with interior vertices moved to all but an edge of one of their triangles, unless one flips
Uv_coordinates squeezed(const Patch& patch, Uv_coordinates uv)
{
  constexpr double SHARE = 1 - 1e-7; // of the way
  std::vector<bool> is_done(patch.number_of_vertices(), false);
  for(int v : patch.border)
    is_done[v] = true;
  for(const auto& t : patch.triangles)
    for(int i = 0; i < 3; ++i) {
      const int v = t[i];
      if(is_done[v])
        continue;
      const Eigen::RowVector2d place = uv.row(v);
      uv.row(v) += SHARE * ((uv.row(t[(i + 1) % 3]) + uv.row(t[(i + 2) % 3])) / 2 - place);
      is_done[v] = number_of_flipped_faces(patch.triangles, uv) == 0;
      if(!is_done[v])
        uv.row(v) = place;
      break;
    }
  return uv;
}

/// the triangles at a vertex: their shapes, and the uv positions of their next two corners
struct Star_triangles
{
  Star_triangles(const Patch& patch, const Uv_coordinates& uv, int v)
  {
    for(int f = 0; f < patch.number_of_faces(); ++f)
      for(int k = 0; k < 3; ++k)
        if(const auto& t = patch.triangles[f]; t[k] == v) {
          shapes.push_back(corner_shape(patch.shapes[f], k));
          q.push_back(uv.row(t[(k + 1) % 3]));
          r.push_back(uv.row(t[(k + 2) % 3]));
        }
  }

  /// gives them to a star one by one
  void set(const Eigen::RowVector2d& origin, Vertex_star& star) const
  {
    star.set(origin, shapes.size(), [this](std::size_t i) { return Triangle_pair(shapes[i], q[i], r[i]); });
  }

  /// gives them to a star in pairs, as a sweep does
  void set_in_pairs(const Eigen::RowVector2d& origin, Vertex_star& star) const
  {
    star.set(origin, (shapes.size() + 1) / 2, [this](std::size_t pair) {
      const std::size_t i = 2 * pair, j = i + 1;
      return j == shapes.size() ? Triangle_pair(shapes[i], q[i], r[i])
                                : Triangle_pair({shapes[i], shapes[j]}, q[i], q[j], r[i], r[j]);
    });
  }

  std::vector<Corner_shape> shapes;
  std::vector<Eigen::RowVector2d> q, r;
};

} // namespace

TEST_CASE("the energy of a star is that of the map but for a constant, and its step is one of Newton's method")
{
  for(const Patch& patch : patches()) {
    const Uv_coordinates uv = some_map(patch);
    const Balanced_energy energy(patch, 0.3);
    for(int v = 0; v < patch.number_of_vertices(); v += 3) {
      Vertex_star star(0.3);
      Star_triangles(patch, uv, v).set(uv.row(v), star);
      Uv_coordinates moved = uv;
      moved.row(v) += 1e-4 * Eigen::RowVector2d(0.6, -0.8);
      if(!std::isfinite(energy(moved)))
        continue;
      CHECK(star.energy(moved.row(v)) - star.energy(uv.row(v)) ==
            Approx(energy(moved) - energy(uv)).margin(1e-12 * energy(uv)));
      Eigen::RowVector2d p = uv.row(v);
      for(int i = 0; i < 50 && star.improve(p, {true, true}); ++i) {
      }
      for(int axis = 0; axis < 2; ++axis) { // stationary, by central differences
        const double h = 1e-5;
        const Eigen::RowVector2d step = h * (axis == 0 ? Eigen::RowVector2d(1, 0) : Eigen::RowVector2d(0, 1));
        CHECK(std::abs(star.energy(p + step) - star.energy(p - step)) / (2 * h) < 1e-3 * star.energy(p));
      }
    }
  }
}

TEST_CASE("triangles that are given to a star in pairs count as those that are given one by one")
{
  const Patch patch = make_patch_of(saddle(5));
  const Uv_coordinates uv = some_map(patch);
  for(const Eigen::RowVector2d& scale : {Eigen::RowVector2d(1, 1), Eigen::RowVector2d(2, 0.5)})
    for(int v = 0; v < patch.number_of_vertices(); ++v) {
      Vertex_star one_by_one(0.3, scale), in_pairs(0.3, scale);
      const Star_triangles triangles(patch, uv, v);
      triangles.set(uv.row(v), one_by_one);
      triangles.set_in_pairs(uv.row(v), in_pairs);
      Eigen::RowVector2d a = uv.row(v), b = a;
      CHECK(in_pairs.energy(a) == Approx(one_by_one.energy(a)).epsilon(1e-13));
      CHECK(one_by_one.improve(a, {true, true}) == in_pairs.improve(b, {true, true}));
      CHECK((a - b).norm() < 1e-9);
    }
}

TEST_CASE("a sweep lowers the energy, moves only what is free, and flips nothing")
{
  for(const Patch& patch : patches())
    for(bool is_sliding : {false, true}) {
      const Uv_coordinates start = some_map(patch);
      const Free_coordinates is_free = free_coordinates(patch, start, is_sliding);
      Uv_coordinates uv = start;
      Vertex_sweep(patch, Patch_division(patch), 0.3)(is_free, {1, 1}, uv);
      CHECK(energy_by_definition(patch, uv, 0.3) < energy_by_definition(patch, start, 0.3));
      CHECK(number_of_flipped_faces(patch.triangles, uv) == 0);
      for(Eigen::Index k = 0; k < uv.size(); ++k)
        if(!is_free(k / 2, k % 2))
          CHECK(uv(k / 2, k % 2) == start(k / 2, k % 2));
    }
}

TEST_CASE("a sweep visits vertices at the same time, and makes the same map as if one came after the other")
{
  std::vector<Patch> all = patches();
  all.push_back(make_patch_of(noisy_height_field(25))); // with waves of more vertices than a batch has
  for(const Patch& patch : all)
    for(const auto& [scale, vertices_per_block, is_sliding] :
        {std::tuple(Eigen::RowVector2d(1, 1), 7, true), std::tuple(Eigen::RowVector2d(2, 0.5), 7, false),
         std::tuple(Eigen::RowVector2d(1, 1), 1000, false), std::tuple(Eigen::RowVector2d(2, 0.5), 1000, true)}) {
      Uv_coordinates expected = some_map(patch), uv = expected;
      const Free_coordinates is_free = free_coordinates(patch, uv, is_sliding);
      const Patch_division division(patch, vertices_per_block);
      for(int rank = 0; rank < patch.number_of_vertices(); ++rank) {
        const int v = division.vertex(rank);
        Vertex_star star(0.3, scale);
        Star_triangles(patch, expected, v).set_in_pairs(expected.row(v), star);
        Eigen::RowVector2d p = expected.row(v);
        star.improve(p, {is_free(v, 0), is_free(v, 1)});
        expected.row(v) = p;
      }
      Vertex_sweep(patch, division, 0.3)(is_free, scale, uv);
      CHECK(uv == expected);
    }
}

TEST_CASE("a sweep on a rectangle lowers the energy there")
{
  for(const Patch& patch : patches()) {
    const Balanced_energy energy(patch, 0.3, 5);
    Uv_coordinates uv = some_map(patch);
    const double before = energy(uv);
    Vertex_sweep(patch, Patch_division(patch), 0.3)(free_coordinates(patch, uv, true), energy.scale(uv), uv);
    CHECK(energy(uv) < before);
    CHECK(number_of_flipped_faces(patch.triangles, uv) == 0);
  }
}

TEST_CASE("the preconditioner inverts the blocks of the Hessian, with unit rows where coordinates are fixed")
{
  const bool has_order = GENERATE(false, true);
  Patch patch = make_patch_of(saddle(5));
  for(int v = patch.number_of_vertices(); has_order && v > 0; --v)
    patch.elimination_places.push_back(v - 1);
  const Uv_coordinates uv = some_map(patch);
  const Balanced_energy energy(patch, 0.3);
  const Axis_preconditioner preconditioner(patch);
  Axis_preconditioner::Factors factors;
  for(bool is_sliding : {false, true}) { // the second time with the memory of the first
    const Free_coordinates is_free = free_coordinates(patch, uv, is_sliding);
    REQUIRE(preconditioner.factorize(energy, uv, is_free, factors));
    const Uv_coordinates expected = is_free.select(random_coordinates(uv.rows(), 3), 0.);
    Uv_coordinates x = Uv_coordinates::Zero(uv.rows(), 2);
    for(int f = 0; f < patch.number_of_faces(); ++f)
      for(int axis = 0; axis < 2; ++axis)
        for(int i = 0; i < 3; ++i)
          for(int j = 0; j < 3; ++j)
            x(patch.triangles[f][i], axis) += energy.hessian_blocks({f, f}, uv, {1, 1})[0].of_axis(axis)(i, j) *
                                              expected(patch.triangles[f][j], axis);
    x = is_free.select(x, 0.);
    preconditioner.apply(factors, x);
    CHECK((x - expected).cwiseAbs().maxCoeff() < 1e-9);
  }
}

TEST_CASE("the matrices of a map are factored with fewer coordinates that may move as those with so few")
{
  const Patch patch = make_patch_of(noisy_height_field(20));
  const Balanced_energy energy(patch, 0.5);
  Random_numbers random(6);
  const Uv_coordinates uv = some_map(patch);
  const Axis_preconditioner preconditioner(patch);
  Axis_preconditioner::Factors fewer;
  Free_coordinates is_free = free_coordinates(patch, uv, true);
  REQUIRE(preconditioner.factorize(energy, uv, is_free, fewer));
  for(int repetition = 0; repetition < 5; ++repetition) {
    const Free_coordinates was_free = is_free;
    for(int i = 0; i <= repetition; ++i)
      is_free(random.below(patch.number_of_vertices()), random.below(2)) = false;
    REQUIRE(preconditioner.factorize_fewer(was_free, is_free, fewer));
    Axis_preconditioner::Factors afresh;
    REQUIRE(preconditioner.factorize(energy, uv, is_free, afresh));
    Uv_coordinates x = is_free.select(random_coordinates(uv.rows(), repetition), 0.), expected = x;
    preconditioner.apply(fewer, x);
    preconditioner.apply(afresh, expected);
    CHECK(x == expected);
  }
}

TEST_CASE("the secant memory maps the last change of the gradient to the last step, and keeps to its capacity")
{
  // gradients of a quadratic with the diagonal Hessian D
  const Uv_coordinates D = random_coordinates(7, 1).array().square() + 0.5;
  const auto identity = [](Uv_coordinates&) {};
  Secant_memory memory(3);
  for(unsigned int seed = 2; seed < 9; ++seed) {
    const Uv_coordinates step = random_coordinates(7, seed);
    memory.add(step, step.cwiseProduct(D));
    Uv_coordinates x = step.cwiseProduct(D);
    memory.apply(identity, x);
    CHECK((x - step).cwiseAbs().maxCoeff() < 1e-12);
  }
  const Uv_coordinates step = random_coordinates(7, 20);
  memory.add(step, -step); // no minimum that way
  Uv_coordinates x = step;
  memory.apply(identity, x);
  CHECK(x.cwiseProduct(step).sum() > 0);
  memory.clear();
  x = step;
  memory.apply(identity, x);
  CHECK(x == step);
}

TEST_CASE("the minimizer lowers the energy at every step to a stationary map without flips, at every balance")
{
  for(const Patch& patch : patches())
    for(double balance : {0., 0.1, 0.3, 1.})
      for(bool is_sliding : {false, true}) {
        const Uv_coordinates start = some_map(patch);
        const Minimized_map map = minimized(patch, start, minimization_of(balance, is_sliding), 1e-12);
        INFO("balance " << balance << ", sliding " << is_sliding);
        CHECK(number_of_flipped_faces(patch.triangles, map.uv) == 0);
        for(std::size_t i = 1; i < map.report.history.size(); ++i)
          CHECK(map.report.history[i] <= map.report.history[i - 1] * (1 + 1e-14));
        CHECK(
            (map.report.stop_reason == Stop_reason::CONVERGED || map.report.stop_reason == Stop_reason::NO_LOWER_MAP));
        CHECK(map.report.objective == Approx(energy_by_definition(patch, map.uv, balance)).epsilon(1e-9));
        CHECK(map.report.l2 == Approx(measure(patch.shapes, patch.triangles, map.uv).l2).epsilon(1e-12));
        Uv_coordinates first;
        Balanced_energy(patch, balance).gradient(start, first);
        CHECK(map.report.gradient_norm < 1e-4 * first.norm());
      }
}

TEST_CASE("a map stopped after any number of steps has no flips, and continued it is the map made at once")
{
  const Patch patch = make_patch_of(cone(6, 6, 19));
  for(unsigned int steps = 0; steps < 12; ++steps) {
    Balanced_minimization stopped = minimization_of(0, true);
    stopped.maximum_iterations = steps;
    const Minimized_map map = minimized(patch, some_map(patch), stopped, 0);
    CHECK(number_of_flipped_faces(patch.triangles, map.uv) == 0);
    CHECK(map.report.iterations == steps);
    CHECK(map.report.history.size() == steps + 1);
  }
  Balanced_minimizer::Workspace workspace;
  const Balanced_minimizer minimizer(patch, minimization_of(0.3, true));
  const Minimized_map rough = minimizer.minimize({some_map(patch), {}, {}}, 1e-2, workspace);
  const Minimized_map continued = minimizer.minimize(rough, 1e-10, workspace);
  const Minimized_map at_once = minimizer.minimize({some_map(patch), {}, {}}, 1e-10, workspace);
  CHECK(rough.report.objective > continued.report.objective);
  CHECK(continued.report.objective == Approx(at_once.report.objective).epsilon(1e-8));
  CHECK(continued.report.iterations >= rough.report.iterations);
  CHECK(continued.report.history.size() == continued.report.iterations + 1);
}

TEST_CASE("the work of a map is that of its steps, and more where triangles stand in their way")
{
  for(const Patch& patch :
      {make_patch_of(saddle(6)), make_patch_of(cone(6, 12, 19)), make_patch_of(noisy_height_field(12))}) {
    const auto work_beside_steps = [&patch](const Uv_coordinates& start) {
      const Minimized_map map = minimized(patch, start, minimization_of(0.3, true), 1e-6);
      return map.work - Minimizer_numbers::STEP_WORK * map.report.iterations * patch.number_of_vertices();
    };
    const Uv_coordinates map = some_map(patch);
    CHECK(work_beside_steps(map) == 0);
    CHECK(double(work_beside_steps(squeezed(patch, map))) >=
          Minimizer_numbers::ROUNDABOUT_WORK * patch.number_of_vertices());
  }
}

TEST_CASE("a minimization ends when its steps have cost what they may")
{
  const Patch patch = make_patch_of(noisy_height_field(12));
  const Balanced_minimizer minimizer(patch, minimization_of(0.3, true));
  Balanced_minimizer::Workspace workspace;
  const long step = Minimizer_numbers::STEP_WORK * patch.number_of_vertices();
  for(long steps : {0, 1, 3}) {
    const Minimized_map map = minimizer.minimize({some_map(patch), {}, {}}, 0, {600, steps * step}, workspace);
    CHECK(map.report.iterations == steps + 1); // the one that goes beyond
    CHECK(map.work == (steps + 1) * step);
    CHECK(map.report.stop_reason == Stop_reason::MAXIMUM_ITERATIONS);
    const Minimized_map continued = minimizer.minimize(map, 0, {600, (steps + 2) * step}, workspace);
    CHECK(continued.report.iterations == steps + 3); // the steps behind the map count
    CHECK(continued.work == (steps + 3) * step);
  }
}

TEST_CASE("a map whose energy falls fast may cost up to three times as much")
{
  const auto falls_fast = [](const std::vector<double>& history) {
    const double energy = history.back();
    return history[history.size() - 1 - Minimizer_numbers::LONG_RUN] - energy > Minimizer_numbers::FAST_FALL * energy;
  };
  std::set<bool> have_cost_most;
  for(const Patch& patch : {make_patch_of(spiral()), make_patch_of(long_strip())}) {
    const long step = Minimizer_numbers::STEP_WORK * patch.number_of_vertices(), most = 60 * step;
    Balanced_minimizer::Workspace workspace;
    const Minimized_map map = Balanced_minimizer(patch, minimization_of(0, false))
                                  .minimize({some_map(patch), {}, {}}, 0, {600, most}, workspace);
    REQUIRE(map.report.stop_reason == Stop_reason::MAXIMUM_ITERATIONS);
    CHECK(map.work > most + step);
    // directions round triangles count for more than in the work of the map
    const double of_steps = double(step * map.report.iterations);
    const double counted = of_steps + Minimizer_numbers::ROUNDABOUT_WORK_OF_DELIVERED /
                                          Minimizer_numbers::ROUNDABOUT_WORK * (double(map.work) - of_steps);
    const bool has_cost_most = counted > double(Minimizer_numbers::MOST_TIMES_WORK * most);
    CHECK(falls_fast(map.report.history) == has_cost_most);
    have_cost_most.insert(has_cost_most);
  }
  CHECK(have_cost_most.size() == 2);
}

TEST_CASE(
    "a stretched map that is delivered is done when thirty steps have gained less than a thousandth of its energy")
{
  const Patch patch = make_patch_of(rectangle(700, 2, 700, 2, 4));
  const Balanced_minimization options = minimization_of(0.3, true);
  const Balanced_minimizer minimizer(patch, options);
  Balanced_minimizer::Workspace workspace;
  const auto history_of = [&](double tolerance) {
    const Minimized_map map = minimizer.minimize({some_map(patch), {}, {}}, tolerance, {600}, workspace);
    REQUIRE(map.report.stop_reason == Stop_reason::CONVERGED);
    return map.report.history;
  };
  const std::vector<double> delivered = history_of(options.tolerance), further = history_of(1.01 * options.tolerance);
  REQUIRE(delivered.back() > Minimizer_numbers::STRETCHED);
  REQUIRE(delivered.size() < further.size());
  CHECK(std::equal(delivered.begin(), delivered.end(), further.begin())); // the same steps, and fewer
  const auto gains_little = [&](std::size_t steps) {
    const double energy = delivered[steps];
    return delivered[steps - Minimizer_numbers::LONG_RUN] - energy <= 1e-3 * energy;
  };
  CHECK(gains_little(delivered.size() - 1));
  CHECK_FALSE(gains_little(delivered.size() - 2));
}

TEST_CASE("settling a map mends what one vertex spoils")
{
  const Patch patch = make_patch_of(cone(6, 6, 19));
  const auto linf = [&](const Uv_coordinates& uv) { return measure(patch.shapes, patch.triangles, uv).linf; };
  for(double balance : {0., 0.3}) {
    const Minimized_map good = minimized(patch, some_map(patch), minimization_of(balance, true), 1e-10);
    const auto& t = patch.triangles[patch.number_of_faces() / 2]; // of interior vertices
    Minimized_map spoiled = good;
    spoiled.uv.row(t[0]) = 0.005 * good.uv.row(t[0]) + 0.4975 * (good.uv.row(t[1]) + good.uv.row(t[2]));
    REQUIRE(number_of_flipped_faces(patch.triangles, spoiled.uv) == 0);
    REQUIRE(linf(spoiled.uv) > 10 * linf(good.uv));
    Balanced_minimizer(patch, minimization_of(balance, true)).settle(spoiled);
    CHECK(number_of_flipped_faces(patch.triangles, spoiled.uv) == 0);
    CHECK(linf(spoiled.uv) < 1.5 * linf(good.uv));
    CHECK(spoiled.report.objective == Approx(energy_by_definition(patch, spoiled.uv, balance)).epsilon(1e-12));
    CHECK(spoiled.report.history.size() == good.report.history.size());
  }
}

TEST_CASE("the flat square is found from a bad start, with its border fixed and sliding")
{
  const Patch patch = make_patch_of(unit_square(6));
  Uv_coordinates expected(patch.points.size(), 2);
  const Eigen::Vector3d origin = patch.points[patch.border[0]];
  for(std::size_t v = 0; v < patch.points.size(); ++v)
    expected.row(v) = (patch.points[v] - origin).head<2>().transpose();
  const Uv_coordinates start = some_map(patch, 0);
  CHECK((start - expected).cwiseAbs().maxCoeff() > 0.01);
  for(bool is_sliding : {false, true}) {
    const Minimized_map map = minimized(patch, start, minimization_of(0.3, is_sliding), 1e-15);
    CHECK(map.report.l2 == Approx(1).epsilon(1e-10));
    CHECK((map.uv - expected).cwiseAbs().maxCoeff() < 1e-5);
  }
}
