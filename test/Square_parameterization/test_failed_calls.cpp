// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A call decides on arrays and touches the mesh last: one that fails leaves mesh and uv as they were, whatever the type
// of the mesh.

#include "closed_meshes.h"
#include "square_map_case.h"

#include <CGAL_ext/Square_parameterization/mark_seams.h>
#include <CGAL_ext/Square_parameterization/measure_stretch.h>
#include <CGAL_ext/Square_parameterization/split_chords.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/Seam_mesh.h>
#include <CGAL/boost/graph/graph_traits_Polyhedron_3.h>
#include <CGAL/boost/graph/properties_Seam_mesh.h>

#include <catch2/catch.hpp>

using namespace CGAL_ext;
using Catch::Matchers::Contains;

namespace {

typedef CGAL::Polyhedron_3<Kernel> Polyhedron;

Flat_mesh flat(const Closed_mesh& mesh)
{
  return {mesh.points, mesh.triangles, {}};
}

/// everything that a call might change
template <class Mesh>
struct Snapshot
{
  explicit Snapshot(const Mesh& mesh) : vertices(num_vertices(mesh)), edges(num_edges(mesh)), faces(num_faces(mesh))
  {
    const auto points = get(CGAL::vertex_point, mesh);
    for(auto h : halfedges(mesh)) {
      const auto p = get(points, target(h, mesh));
      halfedges_of_mesh.push_back({next(h, mesh), CGAL::is_border(h, mesh)});
      for(double x : {p[0], p[1], p[2]})
        coordinates.push_back(x);
    }
  }

  bool operator==(const Snapshot& other) const
  {
    return vertices == other.vertices && edges == other.edges && faces == other.faces &&
           halfedges_of_mesh == other.halfedges_of_mesh && coordinates == other.coordinates;
  }

  std::size_t vertices, edges, faces;
  std::vector<std::pair<typename boost::graph_traits<Mesh>::halfedge_descriptor, bool>> halfedges_of_mesh;
  std::vector<double> coordinates; // of the targets
};

/// calls with \p options, which must fail, and returns the message
template <class Mesh>
std::string failure(Mesh& mesh, const Square_map_options<Mesh>& options)
{
  const Snapshot<Mesh> before(mesh);
  Uv_storage<Mesh, Point_2> storage;
  const auto result = parameterize_onto_square(mesh, storage.map(), parameters::options(options));
  CHECK(result.status != SMP::OK);
  CHECK(result.copies.empty());
  CHECK(result.corners.empty());
  CHECK(Snapshot<Mesh>(mesh) == before);
  for(auto v : vertices(mesh))
    CHECK_FALSE(storage.contains(v));
  return result.message;
}

} // namespace

TEMPLATE_TEST_CASE("a failed call leaves the mesh as it was", "", Surface_mesh, Polyhedron)
{
  Square_map_options<TestType> options;
  TestType sphere = make_mesh<TestType>(flat(ellipsoid(2, 2)));
  SECTION("a corner that the cut has not put on the border")
  {
    options.corners = {vertex_at(sphere, 0), vertex_at(sphere, 0), vertex_at(sphere, 0), vertex_at(sphere, 0)};
    failure(sphere, options); // one vertex has at most as many copies as seams meet there
  }
  SECTION("a search that is stopped before it has a map")
  {
    options.search_options.callback = [](double) { return false; };
    CHECK_THAT(failure(sphere, options), Contains("the search was stopped after 0 candidates"));
    TestType ears = make_mesh<TestType>(fan_with_ears(8, 1)); // its chords would be split
    CHECK_THAT(failure(ears, options), Contains("the search was stopped after 0 candidates"));
    TestType triangle = make_mesh<TestType>(Flat_mesh{{{0, 0, 0}, {1, 0, 0}, {0, 2, 0}}, {{0, 1, 2}}, {0, 1, 2}});
    CHECK_THAT(failure(triangle, options), Contains("the search was stopped after 0 candidates")); // and its border
  }
  SECTION("weights that give no one-to-one map")
  {
    Stretch_minimization iteration;
    iteration.weights = [](const internal::Patch& patch) {
      internal::Edge_weights weights(patch, 1, true);
      for(std::size_t e = 0; e < weights.values.size(); e += 2)
        weights.values[e] = {-2, -2};
      return weights;
    };
    options.minimization = iteration;
    options.search = First_candidate_corner_search();
    CHECK_THAT(failure(sphere, options), Contains("none of 1 evaluated candidate has a one-to-one map"));
  }
  SECTION("a surface that is not to be cut")
  {
    options.cut.mode = Cut_mode::NONE;
    CHECK_THAT(failure(sphere, options), Contains("closed"));
  }
  SECTION("a coordinate that is not finite")
  {
    const auto points = get(CGAL::vertex_point, sphere);
    put(points, vertex_at(sphere, 5), Kernel::Point_3(0, 1e308 * 10, 0));
    CHECK_THAT(failure(sphere, options), Contains("vertex 5 has a coordinate that is not finite"));
  }
  SECTION("an exception of the user's own")
  {
    struct Stop
    {
    };
    options.search_options.number_of_threads = 1;
    options.search_options.callback = [](double) -> bool { throw Stop(); };
    const Snapshot<TestType> before(sphere);
    Uv_storage<TestType, Point_2> storage;
    CHECK_THROWS_AS(parameterize_onto_square(sphere, storage.map(), parameters::options(options)), Stop);
    CHECK(Snapshot<TestType>(sphere) == before);
  }
}

TEST_CASE("closed surfaces of both mesh types are cut, split and mapped alike")
{
  for(const Named_mesh& named : {many_surfaces()[0], many_surfaces()[7], many_surfaces()[12]}) {
    CAPTURE(named.name);
    Surface_mesh mesh = make_mesh<Surface_mesh>(flat(named.mesh));
    Polyhedron polyhedron = make_mesh<Polyhedron>(flat(named.mesh));
    Uv_storage<Surface_mesh, Point_2> uv;
    Uv_storage<Polyhedron, Point_2> polyhedron_uv;
    const auto expected = parameterize_onto_square(mesh, uv.map());
    const auto result = parameterize_onto_square(polyhedron, polyhedron_uv.map());
    REQUIRE(expected.status == SMP::OK);
    REQUIRE(result.status == SMP::OK);
    CHECK(CGAL::is_valid_polygon_mesh(mesh));
    CHECK(CGAL::is_valid_polygon_mesh(polyhedron));
    CHECK(num_vertices(polyhedron) == num_vertices(mesh));
    CHECK(num_faces(polyhedron) == num_faces(mesh));
    CHECK(count_orientations(polyhedron, polyhedron_uv).counterclockwise == num_faces(mesh));
    // CGAL gives the faces of the two meshes other first halfedges: decisions on cuts may differ
    CHECK(result.measures.l2 == Approx(expected.measures.l2).epsilon(0.05));
    const Stretch_measures measured = measure_stretch(mesh, uv.map());
    CHECK(measured.l2 == Approx(expected.measures.l2));
    REQUIRE(measured.face_l2.size() == expected.measures.face_l2.size());
    for(std::size_t f = 0; f < measured.face_l2.size(); ++f)
      CHECK(measured.face_l2[f] == Approx(expected.measures.face_l2[f]));
  }
}

TEST_CASE("a failed call of the plug-in leaves a Seam_mesh and its uv as they were")
{
  typedef Surface_mesh::Property_map<Surface_mesh::Edge_index, bool> Edge_marks;
  typedef Surface_mesh::Property_map<Surface_mesh::Vertex_index, bool> Vertex_marks;
  typedef CGAL::Seam_mesh<Surface_mesh, Edge_marks, Vertex_marks> Seam_mesh;
  Surface_mesh closed = make_mesh<Surface_mesh>(flat(ellipsoid(2, 2)));
  Edge_marks edge_marks = closed.add_property_map<Surface_mesh::Edge_index, bool>("e:on_seam", false).first;
  Vertex_marks vertex_marks = closed.add_property_map<Surface_mesh::Vertex_index, bool>("v:on_seam", false).first;
  REQUIRE(mark_seams(closed, edge_marks, vertex_marks).status == SMP::OK);
  split_seam_chords(closed, edge_marks, vertex_marks);
  Seam_mesh seam_mesh(closed, edge_marks, vertex_marks);
  const Snapshot<Surface_mesh> before(closed);
  auto bhd = boost::graph_traits<Seam_mesh>::null_halfedge();
  for(auto h : halfedges(seam_mesh))
    if(CGAL::is_border(h, seam_mesh))
      bhd = h;
  Uv_storage<Seam_mesh, Point_2> storage;
  typedef Stretch_minimizing_parameterizer_3<Seam_mesh> Parameterizer;
  Square_search_options options;
  options.callback = [](double) { return false; };
  const Parameterizer::Border_parameterizer stopped({}, options);
  CHECK(SMP::parameterize(seam_mesh, Parameterizer(stopped), bhd, storage.map()) == SMP::ERROR_NO_1_TO_1_MAPPING);
  CHECK(Snapshot<Surface_mesh>(closed) == before);
  for(auto v : vertices(seam_mesh))
    CHECK_FALSE(storage.contains(v));
  CHECK(SMP::parameterize(seam_mesh, Parameterizer(), bhd, storage.map()) == SMP::OK);
}
