// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What cannot be mapped is refused with the code that says why, and no uv is written.

#include "mesh_types.h"

#include <CGAL_ext/Square_parameterization/Circular_border_arc_length_parameterizer_3.h>
#include <CGAL_ext/Square_parameterization/Square_border_arc_length_parameterizer_3.h>
#include <CGAL_ext/Square_parameterization/measure_stretch.h>
#include <CGAL_ext/Square_parameterization/parameterize_onto_square.h>

#include <CGAL/boost/graph/generators.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>
#include <vector>

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
  const auto halves = mesh.halfedges();
  const halfedge_descriptor inner = *std::find_if(
      halves.begin(), halves.end(), [&mesh](halfedge_descriptor h) { return !mesh.is_border(edge(h, mesh)); });
  const auto without_face = CGAL::Euler::add_edge(mesh.add_vertex({0, 0, 1}), mesh.add_vertex({0, 0, 2}), mesh);
  for(halfedge_descriptor h : {opposite(bhd, mesh), inner, halfedge(without_face, mesh)}) {
    CHECK(status_of(Square(), h) == SMP::ERROR_BORDER_TOO_SHORT);
    CHECK(status_of(Circle(), h) == SMP::ERROR_BORDER_TOO_SHORT);
  }
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

TEST_CASE("a mesh with places of removed vertices is mapped as it is without them")
{
  Surface_mesh mesh;
  const vertex_descriptor removed = mesh.add_vertex(Kernel::Point_3(9, 9, 9));
  std::vector<vertex_descriptor> fan;
  for(const auto& [x, y] : {std::pair(0., 0.), {3., 0.}, {3., 1.}, {1., 2.}, {0., 1.}})
    fan.push_back(mesh.add_vertex(Kernel::Point_3(x, y, 0)));
  for(std::size_t k = 2; k < fan.size(); ++k) // its edges inside are chords, and get vertices
    mesh.add_face(fan[0], fan[k - 1], fan[k]);
  mesh.remove_vertex(removed);
  Surface_mesh compact = mesh;
  compact.collect_garbage();

  const auto map = [](Surface_mesh& of) {
    Uv_storage<Surface_mesh, Point_2> storage;
    const Square_map_result<Surface_mesh> result = parameterize_onto_square(of, storage.map());
    REQUIRE(result.status == SMP::OK);
    CHECK(count_orientations(of, storage).counterclockwise == of.number_of_faces());
    const std::vector<double> measured = measure_stretch(of, storage.map()).face_l2;
    REQUIRE(result.measures.face_l2.size() == measured.size());
    for(std::size_t f = 0; f < measured.size(); ++f)
      CHECK(result.measures.face_l2[f] == Approx(measured[f]));
    return result.measures.l2;
  };
  CHECK(map(mesh) == Approx(map(compact)));
  CHECK(mesh.number_of_faces() == compact.number_of_faces());
  CHECK(mesh.number_of_faces() > 3);
}

TEST_CASE("a seam that is an edge without a face is refused")
{
  Surface_mesh mesh = make_mesh<Surface_mesh>(unit_square(3));
  Square_map_options<Surface_mesh> options;
  options.seams = {CGAL::Euler::add_edge(mesh.add_vertex({0, 0, 1}), mesh.add_vertex({0, 0, 2}), mesh)};
  Uv_storage<Surface_mesh, Point_2> storage;
  const auto result = parameterize_onto_square(mesh, storage.map(), parameters::options(options));
  CHECK(result.status == SMP::ERROR_WRONG_PARAMETER);
  CHECK(result.message == "a seam is not an edge of a face of the mesh");
}

TEST_CASE("a map whose triangles a uv map of floats would round flat is refused")
{
  Flat_mesh flat = rectangle(8, 8, 1, 1, 1, 0);
  for(Eigen::Vector3d& p : flat.points) // three columns that are 2e-8 apart, whichever way the square is turned
    if(std::abs(p.x() - 0.5) < 0.2)
      p.x() = 0.5 + 1.6e-7 * (p.x() - 0.5);
  const auto status_of = [&flat](auto kernel) {
    typedef typename decltype(kernel)::Point_2 Uv;
    Surface_mesh mesh = make_mesh<Surface_mesh>(flat);
    Uv_storage<Surface_mesh, Uv> storage;
    const auto result = parameterize_onto_square(mesh, storage.map());
    CHECK(storage.contains(vertex_at(mesh, 0)) == (result.status == SMP::OK));
    return result.status;
  };
  CHECK(status_of(Kernel()) == SMP::OK);
  CHECK(status_of(CGAL::Simple_cartesian<float>()) == SMP::ERROR_NO_1_TO_1_MAPPING);
}

TEST_CASE("measures do not depend on the units of the surface and of the image")
{
  const auto measures = [](double unit, double uv_unit) {
    Flat_mesh flat = saddle(4);
    for(Eigen::Vector3d& p : flat.points)
      p *= unit;
    const Surface_mesh mesh = make_mesh<Surface_mesh>(flat);
    Uv_storage<Surface_mesh, Point_2> storage;
    for(const vertex_descriptor v : mesh.vertices())
      put(storage.map(), v, Point_2(uv_unit * (mesh.point(v).x() / unit), uv_unit * (mesh.point(v).y() / unit)));
    return measure_stretch(mesh, storage.map());
  };
  const Stretch_measures usual = measures(1, 1);
  REQUIRE(usual.l2 > 1);
  for(double unit : {1e-200, 1e-90, 1e-80, 1e80, 1e200})
    for(double uv_unit : {1e-160, 1., 1e160}) {
      const Stretch_measures scaled = measures(unit, uv_unit);
      CHECK(scaled.l2 == Approx(usual.l2));
      CHECK(scaled.linf == Approx(usual.linf));
      CHECK(scaled.symmetric_dirichlet == Approx(usual.symmetric_dirichlet));
    }
  CHECK(measures(1, 1e3).uv_area == Approx(1e6 * usual.uv_area));
  const Surface_mesh none;
  CHECK(std::isinf(measure_stretch(none, Uv_storage<Surface_mesh, Point_2>().map()).l2));
}
