// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What cannot be mapped is refused with the code that says why, and no uv is written.

#include "mesh_types.h"

#include <CGAL_ext/Square_parameterization/Circular_border_arc_length_parameterizer_3.h>
#include <CGAL_ext/Square_parameterization/Square_border_arc_length_parameterizer_3.h>
#include <CGAL_ext/Square_parameterization/parameterize_onto_square.h>

#include <CGAL/boost/graph/generators.h>

#include <catch2/catch.hpp>

#include <limits>

using namespace CGAL_ext;

namespace {

typedef boost::graph_traits<Surface_mesh>::halfedge_descriptor halfedge_descriptor;
typedef boost::graph_traits<Surface_mesh>::vertex_descriptor vertex_descriptor;

/// the status of the plug-in, called without CGAL's free function, which demands a border halfedge
SMP::Error_code plug_in_status(Surface_mesh& mesh, halfedge_descriptor bhd)
{
  Uv_storage<Surface_mesh, Point_2> storage;
  std::map<vertex_descriptor, int> indices;
  std::map<vertex_descriptor, bool> marks;
  Stretch_minimizing_parameterizer_3<Surface_mesh> parameterizer;
  const SMP::Error_code status = parameterizer.parameterize(
      mesh, bhd, storage.map(), boost::make_assoc_property_map(indices), boost::make_assoc_property_map(marks));
  for(vertex_descriptor v : mesh.vertices())
    CHECK(storage.contains(v) == (status == SMP::OK));
  return status;
}

SMP::Error_code plug_in_status(Surface_mesh& mesh)
{
  return plug_in_status(mesh, first_border_halfedge_of(mesh));
}

SMP::Error_code one_call_status(Surface_mesh& mesh, Cut_mode cut = Cut_mode::BEST)
{
  Uv_storage<Surface_mesh, Point_2> storage;
  Square_map_options<Surface_mesh> options;
  options.cut.mode = cut;
  const auto result = parameterize_onto_square(mesh, storage.map(), parameters::options(options));
  CHECK(result.message.empty() == (result.status == SMP::OK));
  for(vertex_descriptor v : mesh.vertices())
    CHECK(storage.contains(v) == (result.status == SMP::OK));
  return result.status;
}

/// a square with a square hole: 16 vertices in a grid, the middle cell left out
Surface_mesh annulus()
{
  Flat_mesh flat = rectangle(3, 3, 3, 3, 1, 0);
  flat.triangles.erase(flat.triangles.begin() + 8, flat.triangles.begin() + 10);
  return make_mesh<Surface_mesh>(flat);
}

Surface_mesh torus_with_hole()
{
  const int n = 5;
  Flat_mesh flat;
  const auto index = [](int i, int j) { return (i % n) * n + j % n; };
  for(int i = 0; i < n; ++i)
    for(int j = 0; j < n; ++j) {
      const double s = 2 * PI * i / n, t = 2 * PI * j / n, r = 3 + std::cos(t);
      flat.points.emplace_back(r * std::cos(s), r * std::sin(s), std::sin(t));
      if(i == 0 && j == 0)
        continue; // the hole has four border edges
      flat.triangles.push_back({index(i, j), index(i + 1, j), index(i + 1, j + 1)});
      flat.triangles.push_back({index(i, j), index(i + 1, j + 1), index(i, j + 1)});
    }
  return make_mesh<Surface_mesh>(flat);
}

} // namespace

TEST_CASE("a closed surface has no border")
{
  Surface_mesh mesh;
  CGAL::make_tetrahedron(Kernel::Point_3(0, 0, 0), Kernel::Point_3(1, 0, 0), Kernel::Point_3(0, 1, 0),
                         Kernel::Point_3(0, 0, 1), mesh);
  CHECK(plug_in_status(mesh, boost::graph_traits<Surface_mesh>::null_halfedge()) == SMP::ERROR_BORDER_TOO_SHORT);
  CHECK(plug_in_status(mesh, *mesh.halfedges().begin()) == SMP::ERROR_BORDER_TOO_SHORT);
  CHECK(one_call_status(mesh, Cut_mode::NONE) == SMP::ERROR_NO_TOPOLOGICAL_DISC);
}

TEST_CASE("a mesh without faces is refused")
{
  Surface_mesh mesh;
  CHECK(one_call_status(mesh) != SMP::OK);
}

TEST_CASE("a surface with two borders is no disk")
{
  Surface_mesh mesh = annulus();
  CHECK(plug_in_status(mesh) == SMP::ERROR_NO_TOPOLOGICAL_DISC);
  CHECK(one_call_status(mesh, Cut_mode::NONE) == SMP::ERROR_NO_TOPOLOGICAL_DISC);
  CHECK(one_call_status(mesh) == SMP::OK);
}

TEST_CASE("a torus with one border is no disk")
{
  Surface_mesh mesh = torus_with_hole();
  CHECK(plug_in_status(mesh) == SMP::ERROR_NO_TOPOLOGICAL_DISC);
  CHECK(one_call_status(mesh, Cut_mode::NONE) == SMP::ERROR_NO_TOPOLOGICAL_DISC);
  CHECK(one_call_status(mesh) == SMP::OK);
}

TEST_CASE("a quadrilateral is no triangle")
{
  Surface_mesh mesh;
  CGAL::make_grid(3, 3, mesh);
  CHECK(plug_in_status(mesh) == SMP::ERROR_NON_TRIANGULAR_MESH);
  CHECK(one_call_status(mesh) == SMP::ERROR_NON_TRIANGULAR_MESH);
}

TEST_CASE("three border vertices are too few for a square: the one call adds one")
{
  Surface_mesh mesh = make_mesh<Surface_mesh>(
      polar_disk(2, 3, 1, [](double r, double t) { return Eigen::Vector3d(r * cos(t), r * sin(t), 0); }));
  CHECK(plug_in_status(mesh) == SMP::ERROR_BORDER_TOO_SHORT);
  CHECK(one_call_status(mesh) == SMP::OK);
}

TEST_CASE("coordinates that are not finite, and surfaces without extent, are refused")
{
  Flat_mesh flat = unit_square(4);
  SECTION("NaN")
  {
    flat.points[12].z() = std::numeric_limits<double>::quiet_NaN();
    Surface_mesh mesh = make_mesh<Surface_mesh>(flat);
    CHECK(plug_in_status(mesh) == SMP::ERROR_WRONG_PARAMETER);
    CHECK(one_call_status(mesh) == SMP::ERROR_WRONG_PARAMETER);
  }
  SECTION("all vertices on a line")
  {
    for(auto& p : flat.points)
      p = {p.x(), p.x(), 1};
    Surface_mesh mesh = make_mesh<Surface_mesh>(flat);
    CHECK(plug_in_status(mesh) == SMP::ERROR_NO_1_TO_1_MAPPING);
    CHECK(one_call_status(mesh) == SMP::ERROR_NO_1_TO_1_MAPPING);
  }
}

TEST_CASE("faces without area are mapped")
{
  Flat_mesh flat = unit_square(4);
  SECTION("two interior vertices in one place")
  {
    flat.points[12] = flat.points[13];
  }
  SECTION("a border edge without length")
  {
    flat.points[1] = flat.points[2];
  }
  Surface_mesh mesh = make_mesh<Surface_mesh>(flat);
  CHECK(plug_in_status(mesh) == SMP::OK);
  CHECK(one_call_status(mesh) == SMP::OK);
}

TEST_CASE("the borders without a search refuse what they cannot place")
{
  Surface_mesh mesh = make_mesh<Surface_mesh>(unit_square(3));
  const auto status_of = [&](const auto& border, halfedge_descriptor bhd) {
    Uv_storage<Surface_mesh, Point_2> storage;
    std::map<vertex_descriptor, bool> marks;
    return border.parameterize(mesh, bhd, storage.map(), 0, boost::make_assoc_property_map(marks));
  };
  typedef Square_border_arc_length_parameterizer_3<Surface_mesh> Square;
  typedef Circular_border_arc_length_parameterizer_3<Surface_mesh> Circle;
  const halfedge_descriptor bhd = first_border_halfedge_of(mesh);
  const auto corner = [&](int k) { return vertex_at(mesh, k); };
  CHECK(status_of(Square(), bhd) == SMP::OK);
  CHECK(status_of(Square(corner(0), corner(3), corner(15), corner(12)), bhd) == SMP::OK);
  CHECK(status_of(Square(corner(0), corner(12), corner(15), corner(3)), bhd) == SMP::ERROR_WRONG_PARAMETER);
  CHECK(status_of(Square(corner(0), corner(5), corner(15), corner(12)), bhd) == SMP::ERROR_WRONG_PARAMETER);
  CHECK(status_of(Square(), Surface_mesh::null_halfedge()) == SMP::ERROR_BORDER_TOO_SHORT);
  CHECK(status_of(Circle(), bhd) == SMP::OK);
  CHECK(status_of(Circle(), Surface_mesh::null_halfedge()) == SMP::ERROR_BORDER_TOO_SHORT);
  CHECK(status_of(Circle(0), bhd) == SMP::ERROR_WRONG_PARAMETER);
  CHECK(status_of(Circle(-1), bhd) == SMP::ERROR_WRONG_PARAMETER);
}

TEST_CASE("the borders without a search give edges without length the least length of those that search")
{
  Flat_mesh flat = unit_square(4);
  flat.points[1] = flat.points[2]; // both on the first side
  flat.points[10] = flat.points[5];
  for(double scale : {1., 1e-150, 1e150}) {
    Flat_mesh scaled = flat;
    for(auto& p : scaled.points)
      p *= scale;
    const Surface_mesh mesh = make_mesh<Surface_mesh>(scaled);
    const auto uv_of = [&mesh](const auto& border) {
      Uv_storage<Surface_mesh, Point_2> storage;
      std::map<vertex_descriptor, bool> marks;
      REQUIRE(border.parameterize(mesh, first_border_halfedge_of(mesh), storage.map(), 0,
                                  boost::make_assoc_property_map(marks)) == SMP::OK);
      return storage;
    };
    const auto disk = internal::make_face_graph_patch(mesh, first_border_halfedge_of(mesh), mesh.points());
    const std::vector<double>& lengths = disk.patch.border_lengths;
    CHECK(*std::min_element(lengths.begin(), lengths.end()) == internal::LEAST_LENGTH);
    const internal::Border_walk walk(lengths, Walk::COUNTER_CLOCKWISE);
    const auto square = internal::square_border(walk, internal::corners_of_candidate(walk, 0, Corner_rule::NEAREST)).uv;
    const auto circle = internal::circular_border(lengths, 2);
    auto on_square = uv_of(Square_border_arc_length_parameterizer_3<Surface_mesh>());
    auto on_circle = uv_of(Circular_border_arc_length_parameterizer_3<Surface_mesh>(2));
    for(std::size_t k = 0; k < lengths.size(); ++k) {
      const vertex_descriptor v = disk.vertices[disk.patch.border[k]];
      CHECK(get(on_square.map(), v) == Point_2(square(k, 0), square(k, 1)));
      CHECK(get(on_circle.map(), v) == Point_2(circle(k, 0), circle(k, 1)));
    }
  }
}

TEST_CASE("the borders without a search measure polygons, and refuse surfaces without area")
{
  Surface_mesh mesh;
  CGAL::make_grid(3, 2, mesh);
  const auto status = [&mesh] {
    Uv_storage<Surface_mesh, Point_2> storage;
    std::map<vertex_descriptor, bool> marks;
    return Circular_border_arc_length_parameterizer_3<Surface_mesh>().parameterize(
        mesh, first_border_halfedge_of(mesh), storage.map(), 0, boost::make_assoc_property_map(marks));
  };
  CHECK(status() == SMP::OK);
  for(vertex_descriptor v : mesh.vertices())
    mesh.point(v) = Kernel::Point_3(mesh.point(v).x(), 0, 0);
  CHECK(status() == SMP::ERROR_NO_1_TO_1_MAPPING);
  mesh.point(*mesh.vertices().begin()) = Kernel::Point_3(std::numeric_limits<double>::quiet_NaN(), 0, 0);
  CHECK(status() == SMP::ERROR_WRONG_PARAMETER);
}
