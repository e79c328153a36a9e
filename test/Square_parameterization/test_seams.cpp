// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "closed_meshes.h"
#include "square_map_case.h"

#include <CGAL_ext/Square_parameterization/cut_along_seams.h>
#include <CGAL_ext/Square_parameterization/mark_seams.h>
#include <CGAL_ext/Square_parameterization/split_chords.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Surface_mesh_parameterization/Mean_value_coordinates_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Square_border_parameterizer_3.h>
#include <CGAL/boost/graph/Seam_mesh.h>
#include <CGAL/boost/graph/properties_Seam_mesh.h>

#include <catch2/catch.hpp>

#include <chrono>
#include <iterator>
#include <limits>
#include <map>

using namespace CGAL_ext;
using Catch::Matchers::Contains;

namespace {

typedef CGAL::Polyhedron_3<Kernel> Polyhedron;
typedef Surface_mesh::Property_map<Surface_mesh::Edge_index, bool> Edge_map;
typedef Surface_mesh::Property_map<Surface_mesh::Vertex_index, bool> Vertex_map;

template <class Mesh>
Mesh make_mesh(const Closed_mesh& closed)
{
  return ::make_mesh<Mesh>(Flat_mesh{closed.points, closed.triangles, {}});
}

/// seams of a mesh, outside of it
template <class Mesh>
struct Seams
{
  typedef boost::graph_traits<Mesh> Traits;
  std::map<typename Traits::edge_descriptor, bool> edges;
  std::map<typename Traits::vertex_descriptor, bool> vertices;

  auto edge_map() { return boost::make_assoc_property_map(edges); }
  auto vertex_map() { return boost::make_assoc_property_map(vertices); }
};

template <class Mesh>
std::size_t count_border_edges(const Mesh& mesh)
{
  std::size_t count = 0;
  for(auto h : halfedges(mesh))
    count += CGAL::is_border(h, mesh) ? 1 : 0;
  return count;
}

/// one border and Euler characteristic 1
template <class Mesh>
bool is_disk(const Mesh& mesh)
{
  const auto bhd = first_border_halfedge_of(mesh);
  std::size_t length = 0;
  for(auto h : CGAL::halfedges_around_face(bhd, mesh)) {
    static_cast<void>(h);
    ++length;
  }
  return length == count_border_edges(mesh) && num_vertices(mesh) + num_faces(mesh) == num_edges(mesh) + 1;
}

Closed_mesh some_surface(const std::string& name)
{
  for(const Named_mesh& named : many_surfaces())
    if(named.name == name)
      return named.mesh;
  throw std::logic_error(name);
}

template <class Mesh>
std::vector<std::vector<Kernel::Point_3>> face_points(const Mesh& mesh)
{
  std::vector<std::vector<Kernel::Point_3>> result;
  for(auto f : faces(mesh)) {
    result.emplace_back();
    for(auto v : CGAL::vertices_around_face(halfedge(f, mesh), mesh))
      result.back().push_back(get(get(CGAL::vertex_point, mesh), v));
  }
  return result;
}

template <class Mesh>
void check_cut(const Named_mesh& named)
{
  CAPTURE(named.name);
  const Mesh mesh = make_mesh<Mesh>(named.mesh);
  Seams<Mesh> seams;
  const Seam_result result = mark_seams(mesh, seams.edge_map(), seams.vertex_map());
  REQUIRE(result.status == SMP::OK);
  CHECK(result.message.empty());
  CHECK(result.cut.history.empty() == (result.cut.seam_edges == 0)); // some of the surfaces are disks
  std::size_t marked = 0;
  double length = 0, area = 0;
  std::map<typename boost::graph_traits<Mesh>::vertex_descriptor, bool> ends;
  for(auto e : edges(mesh))
    if(seams.edges[e]) {
      ++marked;
      CHECK(!CGAL::is_border(halfedge(e, mesh), mesh));
      CHECK(!CGAL::is_border(opposite(halfedge(e, mesh), mesh), mesh));
      ends[source(e, mesh)] = ends[target(e, mesh)] = true;
      const auto points = get(CGAL::vertex_point, mesh);
      length += std::sqrt(CGAL::squared_distance(get(points, source(e, mesh)), get(points, target(e, mesh))));
    }
  for(const auto& face : face_points(mesh))
    area += std::sqrt(CGAL::squared_area(face[0], face[1], face[2]));
  for(auto v : vertices(mesh))
    CHECK(seams.vertices[v] == ends[v]);
  CHECK(result.cut.seam_edges == marked);
  CHECK(result.cut.cut_length == Approx(length / std::sqrt(area)));

  std::vector<std::pair<typename boost::graph_traits<Mesh>::vertex_descriptor,
                        typename boost::graph_traits<Mesh>::vertex_descriptor>>
      originals;
  const Mesh cut = cut_along_seams(mesh, seams.edge_map(),
                                   CGAL::parameters::vertex_to_vertex_output_iterator(std::back_inserter(originals)));
  CHECK(CGAL::is_valid_polygon_mesh(cut));
  CHECK(is_disk(cut));
  CHECK(count_border_edges(cut) == count_border_edges(mesh) + 2 * marked);
  CHECK(face_points(cut) == face_points(mesh)); // the same faces in the same order
  REQUIRE(originals.size() == num_vertices(cut));
  auto v = vertices(cut).begin();
  auto original = vertices(mesh).begin();
  for(std::size_t k = 0; k < originals.size(); ++k, ++v) {
    CHECK(originals[k].second == *v);
    if(k < num_vertices(mesh))
      CHECK(originals[k].first == *original++);
    CHECK(get(get(CGAL::vertex_point, mesh), originals[k].first) == get(get(CGAL::vertex_point, cut), *v));
  }
}

} // namespace

TEST_CASE("seams cut surfaces of any topology to disks, which keep the order of the mesh")
{
  for(const Named_mesh& named : many_surfaces())
    check_cut<Surface_mesh>(named);
  for(const Named_mesh& named : {many_surfaces()[0], many_surfaces()[7], many_surfaces()[12]})
    check_cut<Polyhedron>(named);
}

TEST_CASE("a disk gets no seams, a surface that may not be cut is refused")
{
  const Surface_mesh disk = ::make_mesh<Surface_mesh>(unit_square(3));
  Seams<Surface_mesh> seams;
  CHECK(mark_seams(disk, seams.edge_map(), seams.vertex_map()).status == SMP::OK);
  for(const auto& [edge, is_seam] : seams.edges)
    CHECK(!is_seam);

  const Surface_mesh sphere = make_mesh<Surface_mesh>(ellipsoid(1));
  Seam_options options;
  options.mode = Cut_mode::NONE;
  Seams<Surface_mesh> none;
  const Seam_result result = mark_seams(sphere, none.edge_map(), none.vertex_map(), parameters::options(options));
  CHECK(result.status == SMP::ERROR_NO_TOPOLOGICAL_DISC);
  CHECK_THAT(result.message, Contains("not a disk"));
  CHECK(none.vertices.empty()); // nothing was written

  const auto status_of = [&](const Seam_options& wrong) {
    return mark_seams(sphere, none.edge_map(), none.vertex_map(), parameters::options(wrong)).status;
  };
  options = Seam_options();
  options.max_cut_length = -1;
  CHECK(status_of(options) == SMP::ERROR_WRONG_PARAMETER);
  for(double aspect : {0., -1., 1e-4, 2e3, std::numeric_limits<double>::quiet_NaN()}) {
    options = Seam_options();
    options.aspect = aspect;
    CHECK(status_of(options) == SMP::ERROR_WRONG_PARAMETER);
  }
}

TEST_CASE("a deadline ends the comparison of cuts: the seams make a disk, and the report says so")
{
  for(int seconds : {-1, 3600}) {
    const Surface_mesh mesh = make_mesh<Surface_mesh>(ellipsoid(3, 2));
    Seams<Surface_mesh> seams;
    Seam_options options;
    options.deadline = std::chrono::steady_clock::now() + std::chrono::seconds(seconds);
    const Seam_result result = mark_seams(mesh, seams.edge_map(), seams.vertex_map(), parameters::options(options));
    REQUIRE(result.status == SMP::OK);
    CHECK(result.cut.is_cancelled == (seconds < 0));
    CHECK(is_disk(cut_along_seams(mesh, seams.edge_map())));
  }
}

TEST_CASE("edges that are marked before stay seams")
{
  const Surface_mesh mesh = make_mesh<Surface_mesh>(torus(16, 9));
  Seams<Surface_mesh> seams;
  std::vector<Surface_mesh::Edge_index> given; // the whole of one small circle
  for(auto e : edges(mesh))
    if(source(e, mesh).idx() < 9 && target(e, mesh).idx() < 9)
      given.push_back(e);
  REQUIRE(given.size() == 9);
  for(auto e : given)
    seams.edges[e] = true;
  const Seam_result result = mark_seams(mesh, seams.edge_map(), seams.vertex_map());
  REQUIRE(result.status == SMP::OK);
  CHECK(result.cut.history.empty());
  for(auto e : given)
    CHECK(seams.edges[e]);
  CHECK(result.cut.seam_edges >= 9 + 16);
  CHECK(is_disk(cut_along_seams(mesh, seams.edge_map())));

  for(auto e : edges(mesh))
    seams.edges[e] = true;
  CHECK_THAT(mark_seams(mesh, seams.edge_map(), seams.vertex_map()).message, Contains("pieces"));
}

TEST_CASE("what is no connected manifold triangle surface gets no seams")
{
  Seams<Surface_mesh> seams;
  const auto refusal = [&](const Surface_mesh& mesh) {
    const Seam_result result = mark_seams(mesh, seams.edge_map(), seams.vertex_map());
    CHECK(result.status != SMP::OK);
    return result.message;
  };
  CHECK_THAT(refusal(Surface_mesh()), Contains("no faces"));

  Surface_mesh cube; // of quadrilaterals
  CGAL::make_hexahedron(Kernel::Point_3(0, 0, 0), Kernel::Point_3(1, 0, 0), Kernel::Point_3(1, 1, 0),
                        Kernel::Point_3(0, 1, 0), Kernel::Point_3(0, 1, 1), Kernel::Point_3(0, 0, 1),
                        Kernel::Point_3(1, 0, 1), Kernel::Point_3(1, 1, 1), cube);
  CHECK_THAT(refusal(cube), Contains("6 faces are not triangles"));

  Closed_mesh two = tetrahedron(); // one beside the other
  for(const Eigen::Vector3d& p : tetrahedron().points)
    two.points.push_back(p + Eigen::Vector3d(5, 0, 0));
  for(const auto& [a, b, c] : tetrahedron().triangles)
    two.triangles.push_back({a + 4, b + 4, c + 4});
  CHECK_THAT(refusal(make_mesh<Surface_mesh>(two)), Contains("more than one connected component"));
}

TEST_CASE("a mesh with its seams serves as CGAL's Seam_mesh")
{
  Surface_mesh mesh = make_mesh<Surface_mesh>(some_surface("genus 2"));
  const Edge_map seam_edges = mesh.add_property_map<Surface_mesh::Edge_index, bool>("e:seam", false).first;
  const Vertex_map seam_vertices = mesh.add_property_map<Surface_mesh::Vertex_index, bool>("v:seam", false).first;
  REQUIRE(mark_seams(mesh, seam_edges, seam_vertices).status == SMP::OK);
  CHECK(split_seam_chords(mesh, seam_edges, seam_vertices) > 0);
  CHECK(split_seam_chords(mesh, seam_edges, seam_vertices) == 0);
  CHECK(CGAL::is_valid_polygon_mesh(mesh));
  Surface_mesh cut = cut_along_seams(mesh, seam_edges);
  CHECK(split_chords(cut) == 0);

  typedef CGAL::Seam_mesh<Surface_mesh, Edge_map, Vertex_map> Mesh;
  Mesh seam_mesh(mesh, seam_edges, seam_vertices);
  CHECK(num_vertices(seam_mesh) == cut.number_of_vertices());
  typedef SMP::Square_border_arc_length_parameterizer_3<Mesh> Border;
  typedef SMP::Mean_value_coordinates_parameterizer_3<Mesh, Border> Parameterizer;
  auto uv = mesh.add_property_map<Surface_mesh::Halfedge_index, Point_2>("h:uv").first;
  auto bhd = *halfedges(seam_mesh).begin();
  for(auto h : halfedges(seam_mesh))
    if(CGAL::is_border(h, seam_mesh))
      bhd = h;
  CHECK(SMP::parameterize(seam_mesh, Parameterizer(), bhd, uv) == SMP::OK);
}

TEST_CASE("a closed mesh is cut, split and mapped in one call")
{
  const Named_mesh named = GENERATE(from_range(many_surfaces()));
  CAPTURE(named.name);
  const Surface_mesh before = make_mesh<Surface_mesh>(named.mesh);
  Surface_mesh mesh = before;
  Square_map_options<Surface_mesh> options;
  options.search = First_candidate_corner_search();
  const auto [result, uv] = map_onto_square(mesh, options);
  REQUIRE(result.status == SMP::OK);
  CHECK(CGAL::is_valid_polygon_mesh(mesh));
  CHECK((result.cut.seam_edges == 0) == (named.genus == 0 && named.loops == 1));
  CHECK(result.border_edges == count_border_edges(before) + 2 * result.cut.seam_edges + result.border_edges_split);
  CHECK(result.measures.flipped_faces == 0);
  CHECK(mesh.number_of_vertices() ==
        before.number_of_vertices() + result.copies.size() + result.border_edges_split + result.chords_split);
  for(const auto& [copy, original] : result.copies) {
    CHECK(original.idx() < before.number_of_vertices());
    CHECK(mesh.point(copy) == before.point(original));
  }
  for(auto v : before.vertices())
    CHECK(mesh.point(v) == before.point(v));

  // the same as step by step
  Seams<Surface_mesh> seams;
  REQUIRE(mark_seams(before, seams.edge_map(), seams.vertex_map()).status == SMP::OK);
  Surface_mesh cut = cut_along_seams(before, seams.edge_map());
  CHECK(map_onto_square(cut, options).uv == uv);
}

TEST_CASE("a disk is cut in one call as step by step, if that is asked for")
{
  const Surface_mesh before = make_mesh<Surface_mesh>(without_triangles(ellipsoid(2), {7}));
  Surface_mesh whole = before, mesh = before;
  Square_map_options<Surface_mesh> options;
  const double whole_l2 = map_onto_square(whole, options).result.measures.l2;
  options.cut.cuts_disk = true;
  const auto [result, uv] = map_onto_square(mesh, options);
  REQUIRE(result.status == SMP::OK);
  CHECK(result.copies.size() >= 1);
  CHECK(result.border_edges == count_border_edges(before) + 2 * result.cut.seam_edges + result.border_edges_split);
  CHECK(result.measures.flipped_faces == 0);
  CHECK(result.measures.l2 + 0.05 * result.cut.cut_length < whole_l2);

  Seams<Surface_mesh> seams;
  REQUIRE(
      mark_seams(before, seams.edge_map(), seams.vertex_map(), parameters::options(Seam_options(options.cut))).status ==
      SMP::OK);
  Surface_mesh cut = cut_along_seams(before, seams.edge_map());
  CHECK(map_onto_square(cut, Square_map_options<Surface_mesh>()).uv == uv);
}

TEST_CASE("a closed mesh is cut along given seams, or refused")
{
  Surface_mesh mesh = make_mesh<Surface_mesh>(ellipsoid(1));
  Square_map_options<Surface_mesh> options;
  options.cut.mode = Cut_mode::NONE;
  CHECK_THAT(map_onto_square(mesh, options).result.message, Contains("not a disk") && Contains("closed"));
  CHECK(mesh.number_of_vertices() == 18);
  options.seams = {mesh.edge(mesh.halfedge(Surface_mesh::Vertex_index(0)))};
  const auto result = map_onto_square(mesh, options).result;
  CHECK(result.status == SMP::OK);
  CHECK(result.cut.seam_edges >= 2); // one edge alone would leave a border of two vertices

  options.cut.cut_weight = -1;
  CHECK(map_onto_square(mesh, options).result.status == SMP::ERROR_WRONG_PARAMETER);
}

TEST_CASE("the ends of the seam of a cylinder are two corners each: the cylinder is unrolled by an isometry")
{
  constexpr int N = 12; // around and along; a prism with square faces
  typedef Surface_mesh::Vertex_index Vertex;
  const double radius = 0.5 / std::sin(PI / N);
  Closed_mesh cylinder;
  for(int j = 0; j <= N; ++j)
    for(int i = 0; i < N; ++i)
      cylinder.points.push_back({radius * std::cos(2 * PI * i / N), radius * std::sin(2 * PI * i / N), double(j)});
  for(int j = 0; j < N; ++j)
    for(int i = 0; i < N; ++i) {
      const int a = i + N * j, b = (i + 1) % N + N * j;
      cylinder.triangles.insert(cylinder.triangles.end(), {{a, b, b + N}, {a, b + N, a + N}});
    }
  const Vertex bottom(0), top(N * N);
  const auto seam_of = [&](const Surface_mesh& mesh) {
    std::vector<Surface_mesh::Edge_index> seam;
    for(int j = 0; j < N; ++j)
      seam.push_back(mesh.edge(mesh.halfedge(Vertex(N * j), Vertex(N * (j + 1)))));
    return seam;
  };
  for(const auto& corners : {std::array<Vertex, 4>{bottom, bottom, top, top}, {bottom, top, top, bottom}}) {
    Surface_mesh mesh = make_mesh<Surface_mesh>(cylinder);
    Square_map_options<Surface_mesh> options;
    options.seams = seam_of(mesh);
    options.corners = corners;
    const auto [result, uv] = map_onto_square(mesh, options);
    REQUIRE(result.status == SMP::OK);
    CHECK(result.measures.l2 == Approx(1).epsilon(1e-3)); // the minimizer ends near the isometry
    for(int k = 0; k < 4; ++k)
      CHECK(mesh.point(result.corners[k]) == mesh.point(corners[k]));
  }
  Surface_mesh mesh = make_mesh<Surface_mesh>(cylinder);
  Square_map_options<Surface_mesh> options;
  options.seams = seam_of(mesh);
  options.corners = {bottom, bottom, bottom, top}; // there are but two copies
  CHECK(map_onto_square(mesh, options).result.status == SMP::ERROR_WRONG_PARAMETER);
  CHECK(mesh.number_of_vertices() == cylinder.points.size()); // a failed call leaves the mesh as it was
  CHECK(mesh.number_of_edges() == 3 * N * N + N);
}

TEST_CASE("the cut and the stretch do not depend on the scale")
{
  const Closed_mesh mesh = ellipsoid(2, 2);
  Surface_mesh first = make_mesh<Surface_mesh>(mesh);
  const auto expected = map_onto_square(first, {});
  REQUIRE(expected.result.status == SMP::OK);
  for(int exponent : {-660, -500, -27, 27, 500, 660}) { // powers of two: no rounding; squares underflow and overflow
    CAPTURE(exponent);
    Closed_mesh scaled = mesh;
    for(Eigen::Vector3d& p : scaled.points)
      p *= std::ldexp(1., exponent);
    Surface_mesh cut = make_mesh<Surface_mesh>(scaled);
    const auto [result, uv] = map_onto_square(cut, {});
    REQUIRE(result.status == SMP::OK);
    CHECK(result.cut.cut_length == expected.result.cut.cut_length);
    CHECK(result.measures.l2 == expected.result.measures.l2);
    CHECK(uv == expected.uv);
  }
}
