// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "closed_meshes.h"
#include "opened_surface.h"

#include <CGAL_ext/Square_parameterization/internal/cut/Nearest_vertex.h>
#include <CGAL_ext/Square_parameterization/internal/cut/cut_open.h>
#include <CGAL_ext/Square_parameterization/internal/cut/cut_paths.h>
#include <CGAL_ext/Square_parameterization/internal/cut/initial_cut.h>
#include <CGAL_ext/Square_parameterization/internal/cut/lift_cut.h>
#include <CGAL_ext/Square_parameterization/internal/cut/reroute_cut.h>

#include <catch2/catch.hpp>

#include <chrono>
#include <limits>
#include <map>
#include <numeric>

using namespace CGAL_ext::internal;

namespace {

/// one connected manifold disk, told from its triangles alone
void check_disk(const std::vector<std::array<int, 3>>& triangles, int number_of_vertices)
{
  std::map<std::pair<int, int>, int> next_on_border;
  std::map<std::pair<int, int>, int> sides;
  for(const auto& t : triangles)
    for(int k = 0; k < 3; ++k) {
      REQUIRE(t[k] != t[(k + 1) % 3]);
      REQUIRE(++sides[{t[k], t[(k + 1) % 3]}] == 1); // oriented, and no edge has three triangles
    }
  int edges = 0, border_edges = 0;
  std::map<int, int> following;
  for(const auto& side : sides) {
    const auto [from, to] = side.first;
    const bool is_border = sides.count({to, from}) == 0;
    edges += is_border || from < to ? 1 : 0;
    if(is_border) {
      ++border_edges;
      REQUIRE(following.emplace(from, to).second); // a border vertex is passed once
    }
  }
  REQUIRE(border_edges >= 3);
  int walked = 0, v = following.begin()->first;
  do
    v = following.at(v);
  while(++walked < border_edges && v != following.begin()->first);
  CHECK(walked == border_edges);
  CHECK(number_of_vertices - edges + static_cast<int>(triangles.size()) == 1);

  // around every vertex the triangles make one fan
  Disjoint_sets corners(3 * triangles.size());
  std::map<std::pair<int, int>, int> corner_of; // the corner that begins a side
  for(std::size_t h = 0; h < 3 * triangles.size(); ++h)
    corner_of[{triangles[h / 3][h % 3], triangles[h / 3][(h + 1) % 3]}] = static_cast<int>(h);
  const auto next = [](int h) { return h % 3 == 2 ? h - 2 : h + 1; };
  for(const auto& [side, h] : corner_of)
    if(const auto other = corner_of.find({side.second, side.first}); other != corner_of.end()) {
      corners.union_set(h, next(other->second));
      corners.union_set(next(h), other->second);
    }
  int fans = 0;
  for(std::size_t h = 0; h < 3 * triangles.size(); ++h)
    fans += corners.find_set(h) == h ? 1 : 0;
  CHECK(fans == number_of_vertices);
}

/// what cutting open promises
void check_opening(const Triangle_surface& surface, const Cut& cut)
{
  const Opened_triangles opened = cut_open(surface, cut);
  REQUIRE(opened.triangles.size() == surface.triangles.size());
  for(int v = 0; v < surface.number_of_vertices(); ++v)
    REQUIRE(opened.originals[v] == v);
  for(std::size_t f = 0; f < opened.triangles.size(); ++f)
    for(int k = 0; k < 3; ++k)
      REQUIRE(opened.originals[opened.triangles[f][k]] == surface.triangles[f][k]);
  check_disk(opened.triangles, static_cast<int>(opened.originals.size()));
}

Cut initial_cut_of(const Triangle_surface& surface, int root = 0)
{
  Cut cut(surface);
  initial_cut(surface, root, cut);
  return cut;
}

/// number of copies that seams of these degrees need
int expected_vertices(const Triangle_surface& surface, const Cut& cut)
{
  int count = 0;
  for(int v = 0; v < surface.number_of_vertices(); ++v)
    count += surface.is_border_vertex[v] ? cut.degree(v) + 1 : (std::max)(1, cut.degree(v));
  return count;
}

} // namespace

TEST_CASE("surfaces know their topology")
{
  for(const Named_mesh& named : many_surfaces()) {
    INFO(named.name);
    const Triangle_surface surface = surface_of(named.mesh);
    CHECK(surface.genus() == named.genus);
    CHECK(static_cast<int>(surface.border_loops.size()) == named.loops);
    CHECK(surface.is_disk() == (named.genus == 0 && named.loops == 1));
    for(int h = 0; h < 3 * surface.number_of_faces(); ++h) {
      const auto& e = surface.edges[surface.edge_of_halfedge[h]];
      CHECK(std::minmax(surface.origin(h), surface.target(h)) == std::minmax(e[0], e[1]));
      if(surface.opposites[h] >= 0) {
        CHECK(surface.opposites[surface.opposites[h]] == h);
        CHECK(surface.origin(surface.opposites[h]) == surface.target(h));
      }
    }
  }
}

TEST_CASE("every surface is cut to a disk, before rerouting and after, and rerouting never lengthens")
{
  for(const Named_mesh& named : many_surfaces()) {
    INFO(named.name);
    const Triangle_surface surface = surface_of(named.mesh);
    for(int root = 0; root < surface.number_of_vertices(); root += 1 + surface.number_of_vertices() / 4) {
      Cut cut = initial_cut_of(surface, root);
      check_opening(surface, cut);
      CHECK(static_cast<int>(cut_open(surface, cut).originals.size()) == expected_vertices(surface, cut));
      const double before = cut.length(surface);
      reroute_cut(surface, cut);
      check_opening(surface, cut);
      CHECK(cut.length(surface) <= before);
      const double once = cut.length(surface);
      reroute_cut(surface, cut);
      CHECK(cut.length(surface) == once);
    }
  }
}

TEST_CASE("the nearest vertex is that of lowest number among all that are nearest")
{
  const auto check = [](const Triangle_surface& surface, const Eigen::Vector3d& p) {
    std::vector<double> squared;
    for(const Eigen::Vector3d& q : surface.points)
      squared.push_back((q - p).squaredNorm());
    return Nearest_vertex(surface)(p) == std::min_element(squared.begin(), squared.end()) - squared.begin();
  };
  // on a grid the ends and the middle of every edge, and the middle of every face, are as near to several vertices
  for(const Triangle_surface& surface :
      {surface_of(plane(9, 3)), surface_of(ellipsoid(3, 2)), surface_of(plane(5, 0))}) {
    for(const auto& [a, b] : surface.edges)
      for(double t : {0., 0.25, 0.5, 1.})
        CHECK(check(surface, (1 - t) * surface.points[a] + t * surface.points[b]));
    for(const auto& [a, b, c] : surface.triangles)
      CHECK(check(surface, (surface.points[a] + surface.points[b] + surface.points[c]) / 3));
  }
  Triangle_surface coincident = surface_of(plane(9, 3));
  for(std::size_t v = 20; v < coincident.points.size(); ++v)
    coincident.points[v] = coincident.points[20]; // more of them than a leaf of a tree holds
  for(int v : {3, 19, 20, 40})
    CHECK(check(coincident, coincident.points[v]));
  CHECK(check(coincident, {100, -1, 7}));
}

TEST_CASE("a lifted cut keeps to its way though another is shorter")
{
  // from the equator over a pole to the other side, where the way along the equator is much shorter
  constexpr double HEIGHT = 2;
  const Triangle_surface simple = surface_of(ellipsoid(3, HEIGHT)), surface = surface_of(ellipsoid(5, HEIGHT));
  const auto is_over_pole = [](const Eigen::Vector3d& p) { return std::abs(p.y()) < 1e-12 && p.z() > -1e-12; };
  Cut cut(simple);
  for(int e = 0; e < simple.number_of_edges(); ++e)
    if(is_over_pole(simple.points[simple.edges[e][0]]) && is_over_pole(simple.points[simple.edges[e][1]]))
      cut.insert(simple, e);
  for(int v = 0; v < simple.number_of_vertices(); ++v)
    if(cut.degree(v) == 1)
      cut.add_terminal(v);
  REQUIRE(cut.terminals().size() == 2);
  const double edge = cut.length(simple) / static_cast<double>(cut.edges().size());

  const Cut lifted = lift_cut(simple, cut, surface);
  check_opening(surface, lifted);
  CHECK(lifted.length(surface) <= 1.05 * cut.length(simple));
  const std::vector<int> way = seam_vertices(simple, cut);
  for(int v : seam_vertices(surface, lifted)) {
    double nearest = std::numeric_limits<double>::infinity();
    for(int w : way)
      nearest = (std::min)(nearest, (surface.points[v] - simple.points[w]).norm());
    CHECK(nearest < 3 * edge);
  }
  Cut shorter = lifted;
  reroute_cut(surface, shorter);
  CHECK(shorter.length(surface) < 0.8 * lifted.length(surface)); // so that the way was worth keeping to
}

TEST_CASE("a disk needs no cut")
{
  const Triangle_surface surface = surface_of(plane(6, 3));
  CHECK(initial_cut_of(surface).edges().empty());
}

TEST_CASE("a sphere is cut along a path of two edges or more")
{
  for(const Closed_mesh& mesh : {tetrahedron(), pillow(), ellipsoid(0), ellipsoid(2)}) {
    const Triangle_surface surface = surface_of(mesh);
    Cut cut = initial_cut_of(surface);
    reroute_cut(surface, cut);
    CHECK(cut.edges().size() >= 2);
    CHECK(cut.terminals().size() == 2);
    for(int v = 0; v < surface.number_of_vertices(); ++v)
      CHECK(cut.degree(v) <= 2);
  }
  CHECK(initial_cut_of(surface_of(tetrahedron())).edges().size() == 2);
}

TEST_CASE("the cut of a torus is as short as its two shortest loops")
{
  // the 16 edges round the hole lie on the inner circle, the 9 of the other loop on a meridian
  const Triangle_surface surface = surface_of(torus(16, 9));
  Cut cut = initial_cut_of(surface, 40);
  reroute_cut(surface, cut);
  const double meridian = 9 * 2 * std::sin(PI / 9);
  double shortest_row = std::numeric_limits<double>::infinity();
  for(int j = 0; j < 9; ++j)
    shortest_row = (std::min)(shortest_row, 16 * 2 * std::sin(PI / 16) * (2 + std::cos(2 * PI * j / 9)));
  CHECK(cut.length(surface) <= (meridian + shortest_row) * 1.05);
  CHECK(cut.length(surface) >= (meridian + shortest_row) * 0.8);
}

TEST_CASE("two holes are joined by the shortest path between them")
{
  // a strip of unit squares in two rows; a hole at each end
  const Flat_mesh flat = rectangle(12, 3, 12, 3, 1, 0);
  Closed_mesh strip{flat.points, flat.triangles};
  std::set<int> removed;
  for(const int column : {1, 10}) {
    const int cell = 12 + column; // in the middle row
    removed.insert({2 * cell, 2 * cell + 1});
  }
  const Triangle_surface surface = surface_of(without_triangles(strip, removed));
  REQUIRE(surface.border_loops.size() == 3);
  Cut cut = initial_cut_of(surface);
  reroute_cut(surface, cut);
  check_opening(surface, cut);
  CHECK(cut.length(surface) == Approx(2)); // one edge from each hole to the outer border
}

TEST_CASE("holes that are one edge apart are joined by that edge")
{
  // the two triangles of one cell, and of the next but one, share the edge between the cells' neighbors only
  const Closed_mesh grid = plane(6, 2);
  const Triangle_surface whole = surface_of(grid);
  int tried = 0;
  for(int e = 0; e < whole.number_of_edges() && tried < 20; ++e) {
    const auto [a, b] = whole.edges[e];
    if(whole.is_border_vertex[a] || whole.is_border_vertex[b])
      continue;
    // a triangle at each end of the edge, with no vertex in common and none on the border
    for(std::size_t f = 0; f < grid.triangles.size(); ++f)
      for(std::size_t g = 0; g < grid.triangles.size(); ++g) {
        const auto& t = grid.triangles[f];
        const auto& s = grid.triangles[g];
        const auto has = [](const std::array<int, 3>& triangle, int v) {
          return std::find(triangle.begin(), triangle.end(), v) != triangle.end();
        };
        const bool is_inside = std::none_of(t.begin(), t.end(), [&](int v) { return whole.is_border_vertex[v]; }) &&
                               std::none_of(s.begin(), s.end(), [&](int v) { return whole.is_border_vertex[v]; });
        const bool is_apart = std::none_of(t.begin(), t.end(), [&](int v) { return has(s, v); });
        if(!has(t, a) || !has(s, b) || !is_inside || !is_apart)
          continue;
        ++tried;
        const Triangle_surface surface =
            surface_of(without_triangles(grid, {static_cast<int>(f), static_cast<int>(g)}));
        REQUIRE(surface.border_loops.size() == 3);
        Cut cut = initial_cut_of(surface);
        check_opening(surface, cut);
        reroute_cut(surface, cut);
        check_opening(surface, cut);
      }
  }
  CHECK(tried >= 20);
}

TEST_CASE("terminals are reached, and stay reached when the cut is rerouted")
{
  for(const Named_mesh& named : many_surfaces()) {
    INFO(named.name);
    const Triangle_surface surface = surface_of(named.mesh);
    Cut cut = initial_cut_of(surface);
    Random_numbers random(11);
    for(int i = 0; i < 4; ++i) {
      connect_terminal(surface, random.below(surface.number_of_vertices()), cut);
      reroute_cut(surface, cut);
      check_opening(surface, cut);
    }
    for(int terminal : cut.terminals())
      CHECK((cut.degree(terminal) > 0 || surface.is_border_vertex[terminal]));
    const double reached = cut.length(surface);
    for(int terminal : std::vector<int>(cut.terminals()))
      if(cut.terminals().size() > 2) {
        cut.remove_terminal(terminal);
        prune(surface, cut);
      }
    CHECK(cut.length(surface) <= reached);
  }
}

TEST_CASE("no path of a rerouted cut can be shortened")
{
  int paths = 0;
  for(const Named_mesh& named : many_surfaces()) {
    INFO(named.name);
    const Triangle_surface surface = surface_of(named.mesh);
    Cut cut = initial_cut_of(surface, surface.number_of_vertices() / 2);
    connect_terminal(surface, surface.number_of_vertices() - 1, cut);
    reroute_cut(surface, cut);
    for(const Cut_path& path : paths_longest_first(surface, cut)) {
      // without the path the opened surface is an annulus, unless the path alone ended at a terminal
      Cut others = cut;
      for(int e : path.edges)
        others.erase(surface, e);
      const Triangle_surface annulus = opened_surface(surface, others);
      if(annulus.border_loops.size() != 2)
        continue;
      ++paths;
      const Shortest_paths across = shortest_paths(annulus, annulus.border_loops[0]);
      double least = std::numeric_limits<double>::infinity();
      for(int v : annulus.border_loops[1])
        least = (std::min)(least, across.distances[v]);
      CHECK(path.length == Approx(least));
    }
  }
  CHECK(paths > 100);
}

TEST_CASE("chords are split, and the disk stays one")
{
  for(const Named_mesh& named : many_surfaces()) {
    INFO(named.name);
    const Triangle_surface surface = surface_of(named.mesh);
    const Triangle_surface opened = opened_surface(surface, initial_cut_of(surface));
    const Triangle_surface split = without_chords(opened);
    check_disk(split.triangles, split.number_of_vertices());
    CHECK(split.area == Approx(surface.area));
    for(int e = 0; e < split.number_of_edges(); ++e)
      CHECK((split.is_border_edge(e) || !split.is_border_vertex[split.edges[e][0]] ||
             !split.is_border_vertex[split.edges[e][1]]));
  }
}

TEST_CASE("a border of three edges gets a fourth, where it is longest")
{
  const Triangle_surface surface = surface_of(without_triangles(ellipsoid(1), {3}));
  REQUIRE(surface.border_loops.front().size() == 3);
  const Triangle_surface split = with_long_border(surface);
  check_disk(split.triangles, split.number_of_vertices());
  REQUIRE(split.border_loops.front().size() == 4);
  CHECK(split.area == Approx(surface.area));
  CHECK(with_long_border(split).triangles == split.triangles);

  const Triangle_surface triangle = surface_of({{{0, 0, 0}, {4, 0, 0}, {0, 3, 0}}, {{0, 1, 2}}});
  CHECK(with_long_border(triangle).points.back() == Eigen::Vector3d(2, 1.5, 0));
}

TEST_CASE("a hundred handles are cut in a moment")
{
  const Triangle_surface surface = surface_of(plate_with_handles(10, 10));
  REQUIRE(surface.genus() == 100);
  const auto start = std::chrono::steady_clock::now();
  Cut cut = initial_cut_of(surface);
  const double before = cut.length(surface);
  reroute_cut(surface, cut);
  CHECK(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() < 20); // 0.1 when optimised
  CHECK(cut.length(surface) < before);
  check_opening(surface, cut);
}
