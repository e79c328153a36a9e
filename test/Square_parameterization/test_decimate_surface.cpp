// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "closed_meshes.h"

#include <CGAL_ext/Square_parameterization/internal/coarsening/coarsen_surface.h>
#include <CGAL_ext/Square_parameterization/internal/cut/cut_to_disk.h>
#include <CGAL_ext/Square_parameterization/internal/cut/score_cut.h>
#include <CGAL_ext/Square_parameterization/internal/surface/decimate_surface.h>
#include <CGAL_ext/Square_parameterization/internal/surface/thin_fans.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

using namespace CGAL_ext;
using namespace CGAL_ext::internal;

namespace {

typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;

Mesh halfedge_mesh(const Closed_mesh& surface)
{
  Mesh mesh;
  for(const auto& p : surface.points)
    mesh.add_vertex({p[0], p[1], p[2]});
  for(const auto& [a, b, c] : surface.triangles)
    mesh.add_face(Mesh::Vertex_index(a), Mesh::Vertex_index(b), Mesh::Vertex_index(c));
  return mesh;
}

} // namespace

TEST_CASE("fans are thinned evenly, and keep their topology, their middles and vertices of their own")
{
  const Closed_mesh surface = lids(1000, GENERATE(true, false));
  Mesh mesh = halfedge_mesh(surface);
  const bool is_closed = CGAL::is_closed(mesh);
  thin_fans(mesh, 64, {});
  REQUIRE(CGAL::is_valid_polygon_mesh(mesh));
  CHECK(CGAL::is_closed(mesh) == is_closed);
  CHECK(mesh.number_of_vertices() - mesh.number_of_edges() + mesh.number_of_faces() == (is_closed ? 2u : 1u));
  for(Mesh::Vertex_index v : mesh.vertices())
    CHECK(mesh.degree(v) <= 64);
  for(Mesh::Edge_index e : mesh.edges()) { // of the circle: 16 edges have become one, or 32 at most
    const auto p = mesh.point(mesh.vertex(e, 0)), q = mesh.point(mesh.vertex(e, 1));
    if(p.z() == 0 && q.z() == 0)
      CHECK(std::sqrt(CGAL::squared_distance(p, q)) < 2 * PI * 33 / 1000);
  }
  for(Mesh::Vertex_index v : mesh.vertices())
    CHECK(CGAL::squared_distance(mesh.point(v), halfedge_mesh(surface).point(v)) == 0);
}

TEST_CASE("fans whose thinning would change the topology stay, and small ones are not touched")
{
  Mesh small = halfedge_mesh(lids(64));
  thin_fans(small, 64, {});
  CHECK(small.number_of_faces() == 128);

  Mesh least = halfedge_mesh(lids(12)); // down to a double tetrahedron, and no further
  thin_fans(least, 1, {});
  CHECK(CGAL::is_valid_polygon_mesh(least));
  CHECK(CGAL::is_closed(least));
  CHECK(least.number_of_vertices() - least.number_of_edges() + least.number_of_faces() == 2);
}

TEST_CASE("a closed surface of two wide fans is simplified")
{
  const Triangle_surface surface = surface_of(lids(4000));
  for(const Triangle_surface& simpler : {surface, coarsen_surface(surface, 200)}) {
    const auto copy = decimate_surface(simpler, 100);
    REQUIRE(copy);
    CHECK(copy->number_of_faces() <= 110);
    CHECK(copy->border_loops.empty());
    CHECK(copy->genus() == 0);
  }
}

TEST_CASE("of a flat disk on a thousand corners no vertex of a copy has very many neighbors")
{
  const Triangle_surface surface = surface_of(coin(1000, 0.01));
  const auto copy = decimate_surface(surface, 2 * surface.number_of_faces() / 5);
  REQUIRE(copy);
  std::vector<int> neighbors(copy->points.size(), 0);
  for(const auto& edge : copy->edges)
    for(int v : edge)
      ++neighbors[v];
  CHECK(*std::max_element(neighbors.begin(), neighbors.end()) <= 130);
}

TEST_CASE("a surface is coarsened to some of its vertices: border and topology stay, for any number of threads")
{
  const auto topology = [](const Triangle_surface& surface) {
    return std::array<std::size_t, 2>{surface.border_loops.size(), static_cast<std::size_t>(surface.genus())};
  };
  const Closed_mesh ring = torus(200, 150);
  for(const Closed_mesh& mesh : {ellipsoid(6, 2), ring, without_triangles(ring, {0, 1, 2, 31000})}) {
    const Triangle_surface fine = surface_of(mesh);
    const int faces = fine.number_of_faces() / 5;
    const Triangle_surface coarse = coarsen_surface(fine, faces);
    CHECK(coarse.number_of_faces() == Approx(faces).margin(1));
    CHECK(topology(coarse) == topology(fine));
    CHECK(coarse.area == Approx(fine.area).epsilon(0.03));
    for(const std::vector<int>& loop : coarse.border_loops)
      CHECK(std::any_of(fine.border_loops.begin(), fine.border_loops.end(), [&](const std::vector<int>& other) {
        return other.size() == loop.size() && fine.points[other[0]] == coarse.points[loop[0]];
      }));
    Thread_team team(3);
    const Thread_team::Scope scope(team);
    const Triangle_surface again = coarsen_surface(fine, faces);
    CHECK(again.triangles == coarse.triangles);
    CHECK(again.points == coarse.points);
  }
}

TEST_CASE("a score counts as one map of the opened surface at least, and for as many as its visits come to")
{
  const Triangle_surface surface = surface_of(ellipsoid(3, 2));
  Cut_report report;
  const Cut cut = cut_to_disk(surface, {}, Seam_options(), report);
  const long vertices = patch_of_cut(surface, cut).number_of_vertices();
  const auto work = [&](long ordinary_work) {
    Cut_score_options options;
    options.numbers.ordinary_work = ordinary_work;
    return score_cut(surface, cut, options).work;
  };
  CHECK(work(1000000) == vertices);
  CHECK(work(1) > 10 * vertices);
  CHECK(work(1) / 2 == work(2));
}
