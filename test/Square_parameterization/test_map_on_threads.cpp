// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

// One map on several threads: large patches are divided, and the result is the same for any number of threads.

#include "mapped_patches.h"
#include "test_meshes.h"

#include <CGAL_ext/Square_parameterization/internal/border/border_curves.h>
#include <CGAL_ext/Square_parameterization/internal/coarsening/Patch_sequence.h>
#include <CGAL_ext/Square_parameterization/internal/coarsening/insert_vertices.h>
#include <CGAL_ext/Square_parameterization/internal/common/Thread_team.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/Axis_matrix.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/Sweep_order.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/Vertex_sweep.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/make_minimizer.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/rows_by_ranges.h>
#include <CGAL_ext/Square_parameterization/internal/patch/Incident_corners.h>
#include <CGAL_ext/Square_parameterization/internal/patch/Patch_division.h>
#include <CGAL_ext/Square_parameterization/internal/patch/exact_orientation.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <numeric>
#include <vector>

using namespace CGAL_ext;
using namespace CGAL_ext::internal;

namespace {

/// what `compute()` returns on teams of 1, 2, 3 and 7 threads: all the same, by `==`
template <class Compute>
auto on_any_number_of_threads(const Compute& compute)
{
  Thread_team alone(1);
  const Thread_team::Scope scope(alone);
  const auto result = compute();
  for(unsigned int threads : {2u, 3u, 7u}) {
    Thread_team team(threads);
    const Thread_team::Scope scope_of_team(team);
    CHECK(compute() == result);
  }
  return result;
}

} // namespace

TEST_CASE("a division has every vertex and every triangle once, and no edge between two blocks or within a color")
{
  for(const Patch& patch :
      {make_patch_of(noisy_height_field(25)), make_patch_of(cone(2, 20, 30)), make_patch_of(spiral())})
    for(int vertices_per_block : {7, 50, 200}) {
      const Patch_division division(patch, vertices_per_block);
      CHECK(division.is_divided() == (patch.number_of_vertices() > 2 * vertices_per_block));
      const int n = patch.number_of_vertices();
      std::vector<int> block_of(n, -1), color_of(n, -1);
      int rank = 0;
      for(int b = 0; b < division.number_of_blocks(); ++b) {
        CHECK(division.block(b).begin == rank);
        CHECK(division.block(b).end - rank <= (division.is_divided() ? vertices_per_block : n));
        for(; rank < division.block(b).end; ++rank)
          block_of[division.vertex(rank)] = b;
      }
      CHECK(division.separators().begin == rank);
      CHECK(division.separators().end == n);
      int color = 0;
      for(const Patch_division::Range& range : division.colors()) {
        CHECK(range.begin == rank);
        for(; rank < range.end; ++rank)
          color_of[division.vertex(rank)] = color;
        ++color;
      }
      CHECK(rank == n);
      for(int v = 0; v < n; ++v) {
        CHECK(division.vertex(division.rank(v)) == v);
        CHECK((block_of[v] >= 0) != (color_of[v] >= 0));
      }
      for(const auto& [a, b] : patch.edges) {
        CHECK((block_of[a] == block_of[b] || block_of[a] < 0 || block_of[b] < 0));
        CHECK((color_of[a] != color_of[b] || color_of[a] < 0));
      }
      std::vector<int> visits(patch.triangles.size(), 0);
      for(int b = 0; b < division.number_of_blocks(); ++b)
        for(int i = division.triangles_of_block(b).begin; i < division.triangles_of_block(b).end; ++i) {
          const int f = division.triangle(i);
          ++visits[f];
          for(int v : patch.triangles[f])
            CHECK(block_of[v] == b);
        }
      for(int f : division.joints()) {
        ++visits[f];
        const auto& t = patch.triangles[f];
        CHECK(std::any_of(t.begin(), t.end(), [&](int v) { return color_of[v] >= 0; }));
      }
      CHECK(visits == std::vector<int>(patch.triangles.size(), 1));
    }
}

TEST_CASE("few vertices of a large patch are separators, whatever the order of its vertices")
{
  const Patch patch = make_patch_of(saddle(140)); // 19600 vertices
  const Patch_division division(patch);
  CHECK(division.number_of_blocks() == 10);
  CHECK(division.separators().end - division.separators().begin < 0.08 * patch.number_of_vertices());
}

TEST_CASE("a patch that is not large is one block in its own order")
{
  const Patch patch = make_patch_of(saddle(30));
  const Patch_division division(patch);
  CHECK_FALSE(division.is_divided());
  std::vector<int> order(patch.points.size());
  std::iota(order.begin(), order.end(), 0);
  CHECK(division.ranks() == order);
  CHECK(division.joints().empty());
}

TEST_CASE("a sweep visits vertices in batches without edges, each after its neighbors with lower ranks")
{
  const std::vector<Patch> patches{make_patch_of(noisy_height_field(25)), make_patch_of(cone(2, 20, 30)),
                                   make_patch_of(long_strip(40))};
  for(const Patch& patch : patches)
    for(int vertices_per_block : {7, 50, 10000}) {
      const Patch_division division(patch, vertices_per_block);
      const Sweep_order order(patch, division, Incident_corners(patch));
      const int n = patch.number_of_vertices();
      std::vector<int> place_of(n, -1), batch_of(n);
      int batches = 0;
      for(int place = 0; place < n; ++batches) {
        const int begin = place, end = order.end_of_batch(begin);
        REQUIRE(end > begin);
        CHECK(end - begin <= Sweep_order::LARGEST_BATCH);
        for(; place < end; ++place) {
          CHECK(order.end_of_batch(place) == end);
          place_of[order.vertex(place)] = place;
          batch_of[order.vertex(place)] = batches;
        }
      }
      REQUIRE(std::count(place_of.begin(), place_of.end(), -1) == 0);
      for(const auto& [a, b] : patch.edges) {
        CHECK(batch_of[a] != batch_of[b]);
        CHECK((place_of[a] < place_of[b]) == (division.rank(a) < division.rank(b)));
      }
      const auto keeps = [&](Patch_division::Range range) { // its vertices
        return std::all_of(place_of.begin(), place_of.end(), [&](int place) {
          const int rank = division.rank(order.vertex(place));
          return (place >= range.begin && place < range.end) == (rank >= range.begin && rank < range.end);
        });
      };
      for(int b = 0; b < division.number_of_blocks(); ++b)
        CHECK(keeps(division.block(b)));
      for(const Patch_division::Range& color : division.colors())
        CHECK(keeps(color));
      if(&patch == &patches[0] && !division.is_divided())
        CHECK(batches < n / 5); // a grid, row by row: waves go over it aslant
    }
}

TEST_CASE("gradient and Hessian of a divided patch are those of the whole one")
{
  for(const Patch& patch : patches()) {
    const Uv_coordinates uv = some_map(patch);
    const Patch_division division(patch, 5);
    const Balanced_energy whole(patch, 0.3, std::nullopt), divided(patch, 0.3, std::nullopt, &division);
    Uv_coordinates gradient, expected;
    CHECK(divided.gradient(uv, gradient) == Approx(whole.gradient(uv, expected)).epsilon(1e-13));
    CHECK((gradient - expected).norm() <= 1e-13 * expected.norm());

    const Axis_matrix matrix_of_whole(patch, division.ranks()), matrix_of_parts(patch, division.ranks(), &division);
    const Free_coordinates is_free = free_coordinates(patch, uv, true);
    Axis_matrix::Matrix a = matrix_of_whole.make(), b = matrix_of_parts.make();
    matrix_of_whole.set(whole, uv, is_free, a);
    matrix_of_parts.set(divided, uv, is_free, b);
    REQUIRE(a.nonZeros() == b.nonZeros());
    double largest = 0;
    for(Eigen::Index k = 0; k < a.nonZeros(); ++k)
      largest = (std::max)({largest, a.valuePtr()[k][0], a.valuePtr()[k][1]});
    for(Eigen::Index k = 0; k < a.nonZeros(); ++k)
      for(int axis = 0; axis < 2; ++axis)
        CHECK(b.valuePtr()[k][axis] == Approx(a.valuePtr()[k][axis]).epsilon(1e-13).margin(1e-13 * largest));
  }
}

TEST_CASE("sweeps over a divided patch lower the energy, without flips, and the same on any number of threads")
{
  const Patch patch = make_patch_of(noisy_height_field(40));
  const Uv_coordinates start = some_map(patch);
  const Balanced_energy energy(patch, 0.3);
  for(int vertices_per_block : {20, 200}) {
    const Patch_division division(patch, vertices_per_block);
    const Vertex_sweep sweep(patch, division, 0.3);
    const Free_coordinates is_free = free_coordinates(patch, start, true);
    const Uv_coordinates uv = on_any_number_of_threads([&] {
      Uv_coordinates result = start;
      double before = energy(result);
      for(int i = 0; i < 5; ++i) {
        sweep(is_free, {1, 1}, result);
        CHECK(energy(result) < before);
        before = energy(result);
      }
      return result;
    });
    CHECK(number_of_flipped_faces(patch.triangles, uv) == 0);
  }
}

TEST_CASE("a vertex is in a later wave than the vertices round it, and waves make the same map as one after the other")
{
  const Patch patch = make_patch_of(noisy_height_field(60));
  Patch_sequence sequence(patch, false);
  sequence.coarsen({0.7});
  REQUIRE(sequence.size() > 1);
  const Coarse_patch& coarse = sequence.coarse(1);
  std::vector<int> wave(patch.points.size(), -1);
  CHECK(coarse.waves.removals.size() == coarse.removals.size());
  for(std::size_t w = 0; w < coarse.waves.size(); ++w)
    for(std::size_t k = coarse.waves.first[w]; k < coarse.waves.first[w + 1]; ++k) {
      const int v = coarse.removals[coarse.waves.removals[k]].vertex;
      CHECK(wave[v] == -1);
      wave[v] = static_cast<int>(w);
    }
  for(const Coarse_patch::Removal& removal : coarse.removals)
    for(int v : coarse.ring(removal))
      CHECK(wave[v] < wave[removal.vertex]);

  const Uv_coordinates coarse_uv = some_map(coarse.patch);
  const Uv_coordinates uv =
      on_any_number_of_threads([&] { return *insert_vertices(patch, coarse, coarse_uv, {}, 0.3); });
  Uv_coordinates in_turn(patch.number_of_vertices(), 2);
  for(std::size_t v = 0; v < coarse.fine_vertex.size(); ++v)
    in_turn.row(coarse.fine_vertex[v]) = coarse_uv.row(v);
  Vertex_insertion insertion(patch, 0.3, {1, 1}, true, in_turn);
  for(std::size_t i = coarse.removals.size(); i-- > 0;)
    REQUIRE(insertion.insert_inside(coarse.removals[i].vertex, coarse.ring(coarse.removals[i])));
  CHECK(uv == in_turn);
}

TEST_CASE("vertices are put back into a patch of which the faces were forgotten as into a whole one")
{
  const Patch patch = make_patch_of(noisy_height_field(60));
  Patch_sequence whole(patch, true), short_of_faces(patch, true);
  for(Patch_sequence* sequence : {&whole, &short_of_faces})
    sequence->coarsen({0.7});
  REQUIRE(whole.size() > 2);
  short_of_faces.forget_faces(1);
  CHECK(short_of_faces[1].triangles.capacity() == 0);
  CHECK(short_of_faces[1].edges.capacity() == 0);
  CHECK(short_of_faces[1].border == whole[1].border);
  const Uv_coordinates coarse_uv = some_map(whole[2]);
  CHECK(*insert_vertices(short_of_faces[1], short_of_faces.coarse(2), coarse_uv, {}, 0.3) ==
        *insert_vertices(whole[1], whole.coarse(2), coarse_uv, {}, 0.3));
}

TEST_CASE("the map of a large patch has the same bytes on any number of threads")
{
  const Patch patch = make_patch_of(noisy_height_field(150)); // larger than what is factored
  REQUIRE(patch.number_of_vertices() > Minimizer_numbers::LARGEST_FACTORED);
  Balanced_minimization minimization;
  minimization.aspect = GENERATE(std::optional<double>(1), std::optional<double>());
  const Uv_coordinates uv = on_any_number_of_threads([&] {
    const auto minimizer = make_minimizer(patch, minimization);
    return minimizer->finish(minimizer->make_worker()(square_border_of(patch, 0), nullptr)).uv;
  });
  CHECK(uv.rows() == patch.number_of_vertices());
  CHECK(number_of_flipped_faces(patch.triangles, uv) == 0);
}

TEST_CASE("a patch that is made coarse in blocks is the same for any number of threads")
{
  const Patch patch = make_patch_of(noisy_height_field(60));
  const std::vector<int> curve = vertices_along_curve(patch.points);
  const auto rings = on_any_number_of_threads([&] {
    const Coarse_patch coarse = Patch_coarsener(patch)(patch.number_of_vertices() / 2, curve, 300);
    return std::make_pair(coarse.rings, coarse.patch.triangles);
  });
  CHECK(rings.first.size() > patch.points.size());
}
