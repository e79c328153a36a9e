// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "closed_meshes.h"

#include <CGAL_ext/Square_parameterization/internal/cut/open_disk.h>
#include <CGAL_ext/Square_parameterization/internal/pipeline/map_surface.h>
#include <CGAL_ext/Square_parameterization/internal/sampling/Grid_mesh.h>
#include <CGAL_ext/Square_parameterization/internal/sampling/Seam_fit.h>
#include <CGAL_ext/Square_parameterization/internal/sampling/locate_samples.h>
#include <CGAL_ext/Square_parameterization/internal/sampling/vertex_normals.h>

#include <catch2/catch.hpp>

#include <chrono>
#include <functional>
#include <set>

// Both sides of every seam carry the same samples, and what is rebuilt from them closes.

using namespace CGAL_ext;
using namespace CGAL_ext::internal;

namespace {

/// the least cost of counts with the given sums, by trying all up to a largest number
double least_cost(const std::vector<Interval_count>& counts, const std::array<int, 4>& totals, int largest)
{
  double best = std::numeric_limits<double>::infinity();
  std::vector<int> numbers(counts.size());
  const std::function<void(std::size_t, std::array<int, 4>, double)> choose =
      [&](std::size_t c, const std::array<int, 4>& left, double cost) {
        if(c == counts.size()) {
          if(left == std::array<int, 4>{})
            best = std::min(best, cost);
          return;
        }
        for(int n = counts[c].least; n <= largest; ++n) {
          std::array<int, 4> rest = left;
          for(int side : counts[c].sides)
            if(side >= 0)
              rest[side] -= n;
          if(*std::min_element(rest.begin(), rest.end()) >= 0)
            choose(c + 1, rest, cost + (n - counts[c].ideal) * (n - counts[c].ideal) / counts[c].ideal);
        }
      };
  choose(0, totals, 0);
  return best;
}

struct Rebuilt
{
  Square_map_report report;
  Mapped_surface map;
  std::vector<Eigen::Vector3d> points; // of the disk
  Grid_mesh mesh;
  Surface_topology topology;
};

Rebuilt rebuild(const Closed_mesh& closed, const Grid_size& grid, const Deadline& deadline = {})
{
  Square_map_settings settings;
  settings.seam_grid = grid;
  settings.cut.mode = Cut_mode::SHORTEST;
  settings.search = First_candidate_corner_search();
  settings.search_options.deadline = deadline;
  Rebuilt result;
  result.map = map_surface(arrays_of(closed), {}, settings, result.report);
  result.points = points_after(result.map.edits, closed.points);
  const auto locations = locate_samples(result.map.triangles, result.map.uv, grid);
  std::vector<Eigen::Vector3d> samples;
  for(const auto& [f, weights] : locations)
    samples.push_back(interpolated(result.points, result.map.triangles[f], weights));
  // the samples of a seam are the same points already, but for rounding
  for(const auto& [a, b] : result.report.seam_samples)
    CHECK((samples[grid_sample(a, grid)] - samples[grid_sample(b, grid)]).norm() < 1e-5);
  result.mesh = Grid_mesh_builder(grid, samples, welded_samples(grid, result.report.seam_samples))();
  result.topology = topology_of(result.mesh.samples.size(), result.mesh.triangles);
  return result;
}

} // namespace

TEST_CASE("counts of intervals are those of least cost, as far as all of them are tried")
{
  Random_numbers random(5);
  int found = 0;
  for(int trial = 0; trial < 300; ++trial) {
    CAPTURE(trial);
    std::vector<Interval_count> counts;
    for(int c = 0; c < 5; ++c) {
      const int a = static_cast<int>(random(0, 3.999)), b = static_cast<int>(random(-0.999, 3.999));
      counts.push_back({{a, random(0, 1) < 0.2 ? -1 : b}, random(0.5, 6), random(0, 1) < 0.8 ? 1 : 2});
    }
    const std::array<int, 4> totals{7, 6, 7, 6};
    Count_fitting fitting(counts);
    const auto chosen = fitting(totals);
    const double least = least_cost(counts, totals, 14);
    CHECK(chosen.has_value() == (least < std::numeric_limits<double>::infinity()));
    if(!chosen)
      continue;
    ++found;
    std::array<int, 4> sums{};
    for(std::size_t c = 0; c < counts.size(); ++c) {
      CHECK((*chosen)[c] >= counts[c].least);
      for(int side : counts[c].sides)
        if(side >= 0)
          sums[side] += (*chosen)[c];
    }
    CHECK(sums == totals);
    CHECK(fitting.cost() <= 1.5 * least + 1);
  }
  CHECK(found > 20);
}

TEST_CASE("the segments of a border end where seams end, at the corners and across from them")
{
  // a sphere cut along the path 0 1 2 3 4: the border loop goes there and back
  const std::vector<int> originals{0, 1, 2, 3, 4, 3, 2, 1};
  const std::vector<int> partners = partner_edges(originals);
  CHECK(partners == std::vector<int>{7, 6, 5, 4, 3, 2, 1, 0});
  CHECK(is_seam_tip(partners, 0));
  CHECK(is_seam_tip(partners, 4));
  CHECK(!is_seam_node(partners, 2));
  const auto segments = border_segments(partners, {1, 3, 5, 6});
  std::vector<std::array<int, 4>> found;
  for(const Border_segment& s : segments)
    found.push_back({s.first, s.edges, s.side, s.partner});
  CHECK(found == std::vector<std::array<int, 4>>{{1, 1, 0, 5}, // 1 2
                                                 {2, 1, 0, 4}, // 2 3, for corner 6 is across from 2
                                                 {3, 1, 1, 3}, // 3 4
                                                 {4, 1, 1, 2},
                                                 {5, 1, 2, 1},
                                                 {6, 1, 3, 0},
                                                 {7, 1, 3, 7},
                                                 {0, 1, 3, 6}});
  // a cylinder: two borders and one seam
  const std::vector<int> cylinder{0, 1, 2, 0, 3, 4, 5, 3};
  CHECK(partner_edges(cylinder) == std::vector<int>{-1, -1, -1, 7, -1, -1, -1, 3});
  for(int k = 0; k < 8; ++k)
    CHECK(is_seam_node(partner_edges(cylinder), k) == (cylinder[k] % 3 == 0));
}

TEST_CASE("samples of the border, counted round, are those of the grid")
{
  const Grid_size grid{4, 3};
  std::vector<std::size_t> round;
  for(int k = 0; k < number_of_border_samples(grid); ++k)
    round.push_back(grid_sample(k, grid));
  CHECK(round == std::vector<std::size_t>{0, 1, 2, 3, 7, 11, 10, 9, 8, 4});
}

TEST_CASE("a surface rebuilt from samples is closed and manifold, of the same genus")
{
  const std::vector<std::pair<Closed_mesh, int>> surfaces{
      {ellipsoid(2), 0}, {ellipsoid(3, 4), 0}, {torus(12, 8), 1}, {tetrahedron(), 0}};
  for(const auto& [surface, genus] : surfaces)
    for(const Grid_size& grid : {Grid_size{33, 33}, Grid_size{32, 32}, Grid_size{40, 25}, Grid_size{17, 64}}) {
      if(surface.points.size() == 4 && grid.width != grid.height)
        continue; // its four border vertices leave no other corners, and no other numbers
      INFO("genus " << genus << ", " << grid.width << " x " << grid.height);
      const Rebuilt rebuilt = rebuild(surface, grid);
      CHECK(!rebuilt.report.seam_samples.empty());
      CHECK(rebuilt.report.seam_message == "");
      CHECK(rebuilt.report.measures.flipped_faces == 0);
      CHECK(rebuilt.topology.is_closed);
      CHECK(rebuilt.topology.is_manifold);
      CHECK(rebuilt.topology.genus == genus);
      // the border of a tetrahedron cut open has four vertices: seams end at two corners
      const int folded = surface.points.size() == 4 ? 2 : 0;
      CHECK(static_cast<int>(rebuilt.mesh.triangles.size()) == 2 * ((grid.width - 1) * (grid.height - 1) - folded));
    }
}

TEST_CASE("a grid that is too small for the seams leaves the map as it is")
{
  const Rebuilt rebuilt = rebuild(torus(12, 8), {2, 2});
  CHECK(rebuilt.report.seam_samples.empty());
  CHECK_THAT(rebuilt.report.seam_message, Catch::Matchers::EndsWith("the border of the grid has 4"));
  CHECK(!rebuilt.topology.is_closed);
  CHECK(rebuilt.topology.is_manifold);
  CHECK(rebuilt.topology.genus == 0);
}

TEST_CASE(
    "the seams of a surface with many handles close as soon as the border has the intervals that are said to miss")
{
  // the cut graph of 16 handles has 3 (2 * 16 - 1) seams, where no more than three meet
  const Closed_mesh plate = plate_with_handles(4, 4);
  const Rebuilt open = rebuild(plate, {17, 17});
  REQUIRE(open.report.seam_samples.empty());
  const std::string& message = open.report.seam_message;
  CHECK_THAT(message, Catch::Matchers::EndsWith(", and the border of the grid has 64"));
  const int needed = std::stoi(message.substr(message.find(" need ") + 6));
  CHECK(needed > 64);
  // the four sides do not share them evenly, and a seam that has both sides on one side of the grid has an even number
  const int least_side = needed / 4 + 1;
  Rebuilt closed = rebuild(plate, {least_side, least_side});
  for(int side = least_side + 1; side <= 3 * least_side / 2 && !closed.topology.is_closed; ++side)
    closed = rebuild(plate, {side, side});
  CHECK(closed.report.seam_message == "");
  CHECK(closed.topology.is_closed);
  CHECK(closed.topology.is_manifold);
  CHECK(closed.topology.genus == 16);
}

TEST_CASE("a deadline ends the map for the seams, which is one-to-one, or leaves the map as it is")
{
  const Closed_mesh surface = ellipsoid(6, 3);
  const auto start = std::chrono::steady_clock::now();
  for(int milliseconds : {150, 300, 600, 1200}) {
    CAPTURE(milliseconds);
    try {
      const Rebuilt rebuilt =
          rebuild(surface, {65, 65}, std::chrono::steady_clock::now() + std::chrono::milliseconds(milliseconds));
      CHECK(rebuilt.report.measures.flipped_faces == 0);
      CHECK(rebuilt.topology.is_closed == rebuilt.report.seam_message.empty());
      if(!rebuilt.report.seam_message.empty())
        CHECK(rebuilt.report.search.is_cancelled);
    } catch(const Unmappable&) { // there was no time for any map
    }
  }
  CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(30));
}

TEST_CASE("what is not manifold is said to be so")
{
  const auto topology = [](int vertices, const std::vector<std::array<int, 3>>& triangles) {
    const Surface_topology found = topology_of(vertices, triangles);
    return std::array<int, 3>{found.is_closed, found.is_manifold, found.genus};
  };
  CHECK(topology(4, tetrahedron().triangles) == std::array<int, 3>{1, 1, 0});
  CHECK(topology(3, {{0, 1, 2}}) == std::array<int, 3>{0, 1, 0});
  CHECK(topology(5, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}) == std::array<int, 3>{0, 0, 0}); // an edge of three
  CHECK(topology(4, {{0, 1, 2}, {0, 1, 3}}) == std::array<int, 3>{0, 0, 0});            // turned round
  CHECK(topology(5, {{0, 1, 2}, {0, 3, 4}})[1] == 0);                                   // two fans
  CHECK(topology_of(96, torus(12, 8).triangles).genus == 1);
}
