// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "mapped_patches.h"

#include <CGAL_ext/Square_parameterization/Balanced_minimization.h>
#include <CGAL_ext/Square_parameterization/internal/energy/stretch_kernel.h>
#include <CGAL_ext/Square_parameterization/internal/iteration/repair_flips.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/make_minimizer.h>

#include <catch2/catch.hpp>

#include <set>

using namespace CGAL_ext;
using namespace CGAL_ext::internal;

namespace {

/// repairs the map, and returns whether that came to an end
bool is_repairable(const Patch& patch, Uv_coordinates& uv)
{
  long work = 0;
  const bool has_flips = number_of_flipped_faces(patch.triangles, uv) > 0;
  const bool is_repaired = repair_flips(patch, uv, work);
  if(has_flips && uv.allFinite())
    CHECK(work > 0);
  return is_repaired;
}

/// repairs the map and checks that it is one-to-one, that border vertices stay, and that the others change only in the
/// neighborhood of flipped triangles, of as many rings
void check_repair(const Patch& patch, const Uv_coordinates& spoilt, int rings)
{
  std::vector<bool> may_move(patch.points.size(), false);
  for(const auto& t : patch.triangles)
    if(!is_counterclockwise(spoilt, t))
      for(int v : t)
        may_move[v] = true;
  for(int ring = 0; ring < rings; ++ring) {
    const std::vector<bool> inner = may_move;
    for(const auto& t : patch.triangles)
      if(inner[t[0]] || inner[t[1]] || inner[t[2]])
        may_move[t[0]] = may_move[t[1]] = may_move[t[2]] = true;
  }
  for(int v : patch.border)
    may_move[v] = false;

  Uv_coordinates uv = spoilt;
  REQUIRE(number_of_flipped_faces(patch.triangles, uv) > 0);
  CHECK(is_repairable(patch, uv));
  CHECK(number_of_flipped_faces(patch.triangles, uv) == 0);
  CHECK(stretch_energy(patch, uv) < std::numeric_limits<double>::infinity());
  for(int v = 0; v < patch.number_of_vertices(); ++v)
    if(!may_move[v])
      CHECK(uv.row(v) == spoilt.row(v));
}

std::vector<int> interior_vertices(const Patch& patch)
{
  const std::set<int> border(patch.border.begin(), patch.border.end());
  std::vector<int> interior;
  for(int v = 0; v < patch.number_of_vertices(); ++v)
    if(border.count(v) == 0)
      interior.push_back(v);
  return interior;
}

} // namespace

TEST_CASE("a map without flips is left alone")
{
  for(const Patch& patch : patches()) {
    const Uv_coordinates before = some_map(patch);
    Uv_coordinates uv = before;
    CHECK(is_repairable(patch, uv));
    CHECK(uv == before);
  }
}

TEST_CASE("a vertex on an edge of its ring, beyond it, or on its neighbor, comes back")
{
  const Patch patch = make_patch_of(saddle(6));
  const Uv_coordinates map = some_map(patch);
  for(int v : interior_vertices(patch))
    for(const auto& t : patch.triangles) {
      const auto corner = std::find(t.begin(), t.end(), v);
      if(corner == t.end())
        continue;
      const int k = static_cast<int>(corner - t.begin()), a = t[(k + 1) % 3], b = t[(k + 2) % 3];
      Uv_coordinates uv = map;
      uv.row(v) = (map.row(a) + map.row(b)) / 2; // flat, or next to it
      uv.row(v) += 1e-17 * (uv.row(v) - map.row(v));
      if(number_of_flipped_faces(patch.triangles, uv) > 0)
        check_repair(patch, uv, 0);
      uv.row(v) = map.row(a) + map.row(b) - map.row(v);
      check_repair(patch, uv, 0);
      uv.row(v) = map.row(a);
      check_repair(patch, uv, 0);
    }
}

TEST_CASE("vertices that have run together are pulled apart")
{
  const Patch patch = make_patch_of(noisy_height_field(8));
  const Uv_coordinates map = some_map(patch);
  Random_numbers random(5);
  const std::vector<int> interior = interior_vertices(patch);
  for(int attempt = 0; attempt < 20; ++attempt) {
    const int center = interior[random.below(static_cast<int>(interior.size()))];
    Uv_coordinates uv = map;
    for(int v : interior)
      if((map.row(v) - map.row(center)).norm() < 0.2) // to the distance of a rounding error
        uv.row(v) = map.row(center) + 1e-17 * (map.row(v) - map.row(center));
    check_repair(patch, uv, 20);
  }
}

TEST_CASE("random positions inside the square are untangled, or the failure is told")
{
  for(const Patch& patch : patches()) {
    Random_numbers random(7);
    Uv_coordinates uv = some_map(patch);
    for(int v : interior_vertices(patch))
      uv.row(v) << random(0, 1), random(0, 1);
    const Uv_coordinates before = uv;
    const bool is_repaired = is_repairable(patch, uv);
    CHECK(is_repaired == (number_of_flipped_faces(patch.triangles, uv) == 0));
    for(int v : patch.border)
      CHECK(uv.row(v) == before.row(v));
  }
}

TEST_CASE("what cannot be repaired is told: a chord on a side, positions that are no numbers")
{
  const Patch patch = make_patch_of(fan_with_ears(8, 4));
  Uv_coordinates uv = some_map(patch);
  for(const auto& [a, b] : patch.chords)
    uv.row(a) = uv.row(b);
  CHECK_FALSE(is_repairable(patch, uv));
  uv(0, 0) = std::numeric_limits<double>::quiet_NaN();
  CHECK_FALSE(is_repairable(patch, uv));
}

TEST_CASE("flips all over a map are repaired where vertices have room, and given up soon where they have none")
{
  const Patch patch = make_patch_of(unit_square(60));
  const Uv_coordinates map = some_map(patch);
  const std::vector<int> interior = interior_vertices(patch);
  Uv_coordinates spoilt = map;
  for(std::size_t i = 0; i < interior.size(); i += 5) // over the edge of the ring
    spoilt.row(interior[i]) += Eigen::RowVector2d(0.03, 0.001);
  REQUIRE(number_of_flipped_faces(patch.triangles, spoilt) > 1000);
  CHECK(is_repairable(patch, spoilt));

  Random_numbers random(11);
  Uv_coordinates tangled = map;
  for(int v : interior)
    tangled.row(v) << random(0, 1), random(0, 1);
  long work = 0;
  CHECK_FALSE(repair_flips(patch, tangled, work));
  const long work_of_sweep = 3 * static_cast<long>(patch.triangles.size());
  CHECK(work > work_of_sweep);
  CHECK(work < (Minimizer_numbers::REPAIR_SWEEPS_PER_RING + 1) * work_of_sweep);
}

TEST_CASE("the vertex of a large fan, whose kernel takes time with the square of its triangles, is counted so")
{
  const int n = 2000;
  const Patch patch = make_patch_of(flat_disk(1, n));
  const std::vector<int> interior = interior_vertices(patch);
  REQUIRE(interior.size() == 1);
  Uv_coordinates uv = some_map(patch);
  uv.row(interior[0]) << 0.5, 2;
  long work = 0;
  CHECK(repair_flips(patch, uv, work));
  CHECK(work > 10 * n);
}

TEST_CASE("an iteration that starts with a map lost in rounding goes on from the repaired one")
{
  // weights that leave the vertices of the inner part within a rounding error of each other
  const Patch patch = make_patch_of(unit_square(8));
  const std::vector<int> interior = interior_vertices(patch);
  const int pole = interior[interior.size() / 2];
  Stretch_minimization options;
  options.weights = [&](const Patch& p) {
    Edge_weights weights(p, 1);
    for(std::size_t e = 0; e < p.edges.size(); ++e)
      for(int side : {0, 1})
        if((p.points[p.edges[e][1 - side]] - p.points[pole]).norm() + 1e-9 <
           (p.points[p.edges[e][side]] - p.points[pole]).norm())
          weights.values[e][side] = 1e9; // of the neighbor nearer to the pole
    return weights;
  };
  const Square_border border =
      square_border(Border_walk(patch.border_lengths, Walk::COUNTER_CLOCKWISE), {0, 8, 16, 24});
  const Minimized_map map = make_minimizer(patch, options)->make_worker()(border.uv, nullptr);
  REQUIRE(map.uv.rows() == patch.number_of_vertices());
  CHECK(number_of_flipped_faces(patch.triangles, map.uv) == 0);
  CHECK(std::isfinite(map.report.l2));
  CHECK(map.report.l2 == Approx(std::sqrt(stretch_energy(patch, map.uv))));
}
