// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "mesh_types.h"

#include <CGAL_ext/Square_parameterization/internal/surface/halfedge_between.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/Seam_mesh.h>
#include <CGAL/boost/graph/graph_traits_Polyhedron_3.h>

#include <catch2/catch.hpp>

namespace {

template <class Mesh>
Parameterization map_of(const Flat_mesh& flat)
{
  Mesh mesh = make_mesh<Mesh>(flat);
  return parameterize(mesh, CGAL_ext::Stretch_minimizing_parameterizer_3<Mesh>());
}

/// a box without a lid, 2 x 1 x 1, every side a jittered grid of n x n cells glued by position
Flat_mesh open_box(int n)
{
  // the unfolded cross would be glued along four edges; a height over rings is the same surface
  return polar_disk(2 * n, 8 * n, 51, [](double r, double t) -> Eigen::Vector3d {
    const double x = std::cos(t), y = std::sin(t), square = std::max(std::abs(x), std::abs(y));
    const double inside = std::min(1., 2 * r), height = std::max(0., 2 * r - 1);
    return {2 * inside * x / square, inside * y / square, height};
  });
}

/// the cylinder x^2 + y^2 = 1, 0 <= z <= 2, `sectors` x `rings` cells, all jittered but at the two ends; vertex
/// `sectors` i + s lies on circle i
Flat_mesh cylinder(int sectors, int rings)
{
  Flat_mesh mesh;
  Random_numbers random(52);
  for(int i = 0; i <= rings; ++i)
    for(int s = 0; s < sectors; ++s) {
      const double t = 2 * PI * (s + random(-.2, .2)) / sectors;
      const double z = 2. * (i + (i % rings == 0 ? 0 : random(-.2, .2))) / rings;
      mesh.points.emplace_back(std::cos(t), std::sin(t), z);
    }
  for(int i = 0; i < rings; ++i)
    for(int s = 0; s < sectors; ++s) {
      const int a = i * sectors + s, b = i * sectors + (s + 1) % sectors, c = b + sectors, d = a + sectors;
      if(s == sectors - 1 && i == rings - 1) { // no ear at the corners of the cut cylinder
        mesh.triangles.push_back({a, b, c});
        mesh.triangles.push_back({a, c, d});
      } else if((s == 0 && i == rings - 1) || (s == sectors - 1 && i == 0)) {
        mesh.triangles.push_back({a, b, d});
        mesh.triangles.push_back({b, c, d});
      } else {
        mesh.triangles.push_back({a, b, c});
        mesh.triangles.push_back({a, c, d});
      }
    }
  return mesh;
}

/// the cylinder cut open from vertex 0 upwards: the vertices of the cut come twice, first and last in their ring
Flat_mesh cut_cylinder(int sectors, int rings)
{
  const Flat_mesh closed = cylinder(sectors, rings);
  Flat_mesh mesh;
  const int columns = sectors + 1;
  for(int i = 0; i <= rings; ++i)
    for(int s = 0; s < columns; ++s)
      mesh.points.push_back(closed.points[i * sectors + s % sectors]);
  for(std::size_t f = 0; f < closed.triangles.size(); ++f) {
    const bool is_last_sector = (f / 2) % sectors == std::size_t(sectors - 1);
    std::array<int, 3> t = closed.triangles[f];
    for(int& v : t) {
      const int i = v / sectors, s = v % sectors;
      v = i * columns + (is_last_sector && s == 0 ? sectors : s);
    }
    mesh.triangles.push_back(t);
  }
  return mesh;
}

} // namespace

TEST_CASE("Surface_mesh and Polyhedron_3 have the same map")
{
  typedef CGAL::Polyhedron_3<Kernel> Polyhedron;
  for(const Flat_mesh& flat : {saddle(7), noisy_height_field(7), hemisphere(), open_box(2)}) {
    // CGAL gives the faces of the two meshes other first halfedges: sums run in another order
    const Parameterization expected = map_of<Surface_mesh>(flat), result = map_of<Polyhedron>(flat);
    REQUIRE(is_one_to_one(expected, flat.triangles.size()));
    REQUIRE(is_one_to_one(result, flat.triangles.size()));
    CHECK(largest_difference(expected.uv, result.uv) < 1e-10);
  }
}

TEST_CASE("a mesh of exact numbers has the map of its doubles")
{
  typedef CGAL::Exact_predicates_exact_constructions_kernel Exact_kernel;
  typedef CGAL::Surface_mesh<Exact_kernel::Point_3> Exact_mesh;
  const Flat_mesh flat = saddle(6);
  Exact_mesh mesh = make_mesh<Exact_mesh>(flat);
  typedef CGAL_ext::Stretch_minimizing_parameterizer_3<Exact_mesh> Parameterizer;
  const Parameterization result = parameterize<Exact_kernel::Point_2>(mesh, Parameterizer());
  REQUIRE(is_one_to_one(result, flat.triangles.size()));
  CHECK(largest_difference(map_of<Surface_mesh>(flat).uv, result.uv) == 0);
}

TEST_CASE("a cylinder cut by a seam has the map of the cut cylinder")
{
  typedef boost::graph_traits<Surface_mesh>::edge_descriptor edge_descriptor;
  typedef boost::graph_traits<Surface_mesh>::vertex_descriptor vertex_descriptor;
  typedef Surface_mesh::Property_map<edge_descriptor, bool> Edge_marks;
  typedef Surface_mesh::Property_map<vertex_descriptor, bool> Vertex_marks;
  typedef CGAL::Seam_mesh<Surface_mesh, Edge_marks, Vertex_marks> Seam_mesh;
  const int sectors = 12, rings = 5;

  Surface_mesh closed = make_mesh<Surface_mesh>(cylinder(sectors, rings));
  Edge_marks edge_marks = closed.add_property_map<edge_descriptor, bool>("e:on_seam", false).first;
  Vertex_marks vertex_marks = closed.add_property_map<vertex_descriptor, bool>("v:on_seam", false).first;
  Seam_mesh seam_mesh(closed, edge_marks, vertex_marks);
  for(int i = 0; i < rings; ++i)
    REQUIRE(seam_mesh.add_seam(vertex_at(closed, i * sectors), vertex_at(closed, (i + 1) * sectors)));

  Surface_mesh cut = make_mesh<Surface_mesh>(cut_cylinder(sectors, rings));
  const Parameterization expected = parameterize(cut, CGAL_ext::Stretch_minimizing_parameterizer_3<Surface_mesh>());
  REQUIRE(is_one_to_one(expected, cut.number_of_faces()));

  // the same first border edge, between vertices 0 and 1 or their copies
  const auto is_at = [](const auto& mesh, auto v, const Kernel::Point_3& p) {
    return get(get(CGAL::vertex_point, mesh), v) == p;
  };
  const auto first = border_halfedge_from(cut, 0);
  const Kernel::Point_3 from = cut.point(source(first, cut)), to = cut.point(target(first, cut));
  auto bhd = boost::graph_traits<Seam_mesh>::null_halfedge();
  for(auto h : halfedges(seam_mesh))
    if(is_border(h, seam_mesh) && is_at(seam_mesh, source(h, seam_mesh), from) &&
       is_at(seam_mesh, target(h, seam_mesh), to))
      bhd = h;
  REQUIRE(bhd != boost::graph_traits<Seam_mesh>::null_halfedge());

  Uv_storage<Seam_mesh, Point_2> storage;
  REQUIRE(SMP::parameterize(seam_mesh, CGAL_ext::Stretch_minimizing_parameterizer_3<Seam_mesh>(), bhd, storage.map()) ==
          SMP::OK);
  CHECK(count_orientations(seam_mesh, storage).counterclockwise == cut.number_of_faces());
  // the two meshes number their vertices differently, and a point of the seam has two uv: the nearer one counts
  for(auto v : vertices(seam_mesh)) {
    const Point_2 uv = get(storage.map(), v);
    double nearest = 1;
    for(auto w : vertices(cut))
      if(is_at(seam_mesh, v, cut.point(w)))
        nearest = std::min(nearest, (expected.uv[w] - Eigen::Vector2d(uv.x(), uv.y())).norm());
    CHECK(nearest < 1e-9);
  }
}

TEST_CASE("one component of a mesh is mapped, the others are left alone")
{
  Flat_mesh two = saddle(5);
  const std::size_t size = two.points.size();
  for(const Eigen::Vector3d& p : hemisphere().points)
    two.points.push_back(p);
  for(const auto& [a, b, c] : hemisphere().triangles)
    two.triangles.push_back({a + int(size), b + int(size), c + int(size)});
  Surface_mesh mesh = make_mesh<Surface_mesh>(two);

  const Parameterization alone = map_of<Surface_mesh>(saddle(5));
  Uv_storage<Surface_mesh, Point_2> storage;
  REQUIRE(SMP::parameterize(mesh, CGAL_ext::Stretch_minimizing_parameterizer_3<Surface_mesh>(),
                            border_halfedge_from(mesh, 0), storage.map()) == SMP::OK);
  for(std::size_t v = 0; v < size; ++v) {
    const Point_2 uv = get(storage.map(), vertex_at(mesh, v));
    CHECK(uv.x() == alone.uv[v].x());
    CHECK(uv.y() == alone.uv[v].y());
  }
  for(std::size_t v = size; v < mesh.number_of_vertices(); ++v)
    CHECK_FALSE(storage.contains(vertex_at(mesh, v)));
}

TEST_CASE("the halfedge between two vertices is that of CGAL, or none, as far as either end has been walked round")
{
  const Surface_mesh mesh =
      make_mesh<Surface_mesh>(hemisphere(3, 9)); // the pole has nine neighbors, others six or less
  for(const auto a : vertices(mesh))
    for(const auto b : vertices(mesh)) {
      const auto [expected, is_there] = halfedge(a, b, mesh);
      CHECK(CGAL_ext::internal::halfedge_between(a, b, mesh) == (is_there ? expected : Surface_mesh::null_halfedge()));
    }
}
