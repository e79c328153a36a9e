// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "test_meshes.h"

#include <CGAL_ext/Square_parameterization/internal/soup/Planar_points.h>
#include <CGAL_ext/Square_parameterization/internal/soup/condition_soup.h>
#include <CGAL_ext/Square_parameterization/internal/soup/orient_soup.h>

#include <catch2/catch.hpp>

#include <map>
#include <tuple>
#include <utility>

namespace SMP = CGAL::Surface_mesh_parameterization;
using namespace CGAL_ext::internal;
using Catch::Matchers::Contains;

namespace {

typedef std::vector<std::vector<std::size_t>> Faces;

constexpr std::size_t DROPPED = Conditioning_report::DROPPED;

Surface_soup soup_of(const Flat_mesh& mesh)
{
  Surface_soup soup{mesh.points, {}};
  for(const auto& t : mesh.triangles)
    soup.faces.emplace_back(t.begin(), t.end());
  return soup;
}

/// points in no particular place: the conditioning looks at the faces alone
Surface_soup soup_of(std::size_t number_of_points, const Faces& faces)
{
  Surface_soup soup{{}, faces};
  for(std::size_t v = 0; v < number_of_points; ++v)
    soup.points.emplace_back(double(v), 0, 0);
  return soup;
}

/// the message with which the soup is refused; fails when the code is not the expected one
std::string refusal(Surface_soup soup, SMP::Error_code code = SMP::ERROR_NO_TOPOLOGICAL_DISC,
                    const Conditioning_options& options = {})
{
  try {
    condition_soup(soup, options);
  } catch(const Unmappable& error) {
    CHECK(error.code() == code);
    return error.what();
  }
  return "not refused";
}

/// every interior edge is run through once in each direction
bool is_oriented(const Surface_soup& soup)
{
  std::map<std::pair<std::size_t, std::size_t>, int> count;
  for(const auto& face : soup.faces)
    for(int k = 0; k < 3; ++k)
      if(++count[{face[k], face[(k + 1) % 3]}] > 1)
        return false;
  return true;
}

/// a ring of `n` quadrilaterals, each cut in two, closed with a twist or without
Faces band(std::size_t n, bool is_twisted)
{
  Faces faces;
  for(std::size_t i = 0; i < n; ++i) {
    const std::size_t a = 2 * i, b = 2 * i + 1;
    std::size_t c = 2 * ((i + 1) % n), d = c + 1;
    if(is_twisted && i + 1 == n)
      std::swap(c, d);
    faces.push_back({a, c, b});
    faces.push_back({b, c, d});
  }
  return faces;
}

/// a torus of m x n quadrilaterals, each cut in two
Faces torus(std::size_t m, std::size_t n)
{
  Faces faces;
  const auto index = [m, n](std::size_t i, std::size_t j) { return (i % m) * n + j % n; };
  for(std::size_t i = 0; i < m; ++i)
    for(std::size_t j = 0; j < n; ++j) {
      faces.push_back({index(i, j), index(i + 1, j), index(i + 1, j + 1)});
      faces.push_back({index(i, j), index(i + 1, j + 1), index(i, j + 1)});
    }
  return faces;
}

Faces without_first(Faces faces)
{
  faces.erase(faces.begin());
  return faces;
}

const Faces TETRAHEDRON{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};

} // namespace

TEST_CASE("an oriented disk is left alone")
{
  const Surface_soup original = soup_of(saddle(5));
  Surface_soup soup = original;
  const Conditioning_report report = condition_soup(soup);
  CHECK(report.faces_reoriented == 0);
  CHECK(report.vertices_dropped == 0);
  CHECK(soup.faces == original.faces);
  CHECK(soup.points == original.points);
  for(std::size_t v = 0; v < original.points.size(); ++v)
    CHECK(report.new_index[v] == v);
}

TEST_CASE("the minority of the faces is turned round")
{
  const Surface_soup original = soup_of(saddle(6));
  Surface_soup soup = original;
  Random_numbers random(31);
  std::size_t turned = 0;
  for(auto& face : soup.faces)
    if(random(0, 1) < 0.3) {
      std::reverse(face.begin(), face.end());
      ++turned;
    }
  const Conditioning_report report = condition_soup(soup);
  CHECK(report.faces_reoriented == turned);
  CHECK(soup.faces == original.faces);
}

TEST_CASE("when most faces are turned the others follow, the first face too")
{
  Surface_soup soup = soup_of(saddle(6));
  for(std::size_t f = 1; f < soup.faces.size(); ++f)
    std::reverse(soup.faces[f].begin(), soup.faces[f].end());
  const Faces expected_rest(soup.faces.begin() + 1, soup.faces.end());
  CHECK(condition_soup(soup).faces_reoriented == 1);
  CHECK(is_oriented(soup));
  CHECK(Faces(soup.faces.begin() + 1, soup.faces.end()) == expected_rest);
}

TEST_CASE("isolated vertices are dropped and the others keep their order")
{
  Surface_soup soup = soup_of(7, {{1, 3, 4}, {1, 4, 6}});
  const Conditioning_report report = condition_soup(soup);
  CHECK(report.vertices_dropped == 3);
  CHECK(report.new_index == std::vector<std::size_t>{DROPPED, 0, DROPPED, 1, 2, DROPPED, 3});
  CHECK(soup.faces == Faces{{0, 1, 2}, {0, 2, 3}});
  REQUIRE(soup.points.size() == 4);
  CHECK(soup.points[0].x() == 1);
  CHECK(soup.points[3].x() == 6);
}

TEST_CASE("a soup without faces is empty")
{
  CHECK_THAT(refusal(soup_of(3, {}), SMP::ERROR_EMPTY_MESH), Contains("no faces"));
}

TEST_CASE("faces that are not triangles are counted and named")
{
  const auto code = SMP::ERROR_NON_TRIANGULAR_MESH;
  CHECK_THAT(refusal(soup_of(6, {{0, 1, 2}, {2, 1, 3, 4}, {4, 3, 5}, {0, 2, 4, 5, 3}}), code),
             Contains("2 non-triangular faces (face 1 has 4 vertices, face 3 has 5 vertices)"));
  CHECK_THAT(refusal(soup_of(4, Faces(9, {0, 1, 2, 3})), code), Contains("9 non-triangular faces") && Contains("..."));
  CHECK_THAT(refusal(soup_of(3, {{0, 1, 2}, {1, 2}}), code), Contains("1 non-triangular face (face 1 has 2 vertices)"));
}

TEST_CASE("faces that repeat a vertex are counted and named")
{
  CHECK_THAT(refusal(soup_of(4, {{0, 1, 2}, {1, 1, 2}, {2, 3, 2}}), SMP::ERROR_NON_TRIANGULAR_MESH),
             Contains("2 faces that repeat a vertex (face 1, face 2)"));
}

TEST_CASE("non-manifold edges are counted, their vertices named")
{
  CHECK_THAT(refusal(soup_of(6, {{3, 5, 0}, {5, 3, 1}, {3, 5, 2}})),
             Contains("1 non-manifold edge (vertices 3 and 5)"));
}

TEST_CASE("a Moebius band is not orientable, a plain band is an annulus")
{
  CHECK_THAT(refusal(soup_of(10, band(5, true))), Contains("not orientable"));
  const std::string annulus = refusal(soup_of(10, band(5, false)));
  CHECK_THAT(annulus, Contains("2 border loops"));
  CHECK_THAT(annulus, !Contains("genus"));
}

TEST_CASE("components are counted, isolated vertices are none")
{
  CHECK_THAT(refusal(soup_of(11, {{0, 1, 2}, {4, 5, 6}, {7, 8, 9}})), Contains("3 connected components"));
}

TEST_CASE("a closed surface has no border, and its genus is told")
{
  const std::string sphere = refusal(soup_of(4, TETRAHEDRON));
  CHECK_THAT(sphere, Contains("closed: it has no border"));
  CHECK_THAT(sphere, !Contains("genus"));

  const std::string closed_torus = refusal(soup_of(20, torus(4, 5)));
  CHECK_THAT(closed_torus, Contains("closed: it has no border"));
  CHECK_THAT(closed_torus, Contains("genus 1"));

  const std::string open_torus = refusal(soup_of(20, without_first(torus(4, 5))));
  CHECK_THAT(open_torus, Contains("genus 1"));
  CHECK_THAT(open_torus, !Contains("border"));
}

TEST_CASE("two tori joined at a hole have genus two")
{
  // the second torus without its first face, glued along it to the first: its vertices 0, 5, 6 are those of the first
  Faces faces = without_first(torus(4, 5));
  for(auto face : without_first(torus(4, 5))) {
    for(std::size_t& v : face)
      v = v == 0 || v == 5 || v == 6 ? v : v + 20;
    std::reverse(face.begin(), face.end());
    faces.push_back(face);
  }
  CHECK_THAT(refusal(soup_of(40, faces)), Contains("genus 2"));
}

TEST_CASE("a mis-oriented tetrahedron without a face is a disk")
{
  Faces faces = without_first(TETRAHEDRON);
  std::reverse(faces[1].begin(), faces[1].end());
  Surface_soup soup = soup_of(4, faces);
  CHECK(condition_soup(soup).faces_reoriented == 1);
  CHECK(is_oriented(soup));
}

TEST_CASE("vertices where two fans meet are counted and named")
{
  // two triangles that share vertex 2 alone
  CHECK_THAT(refusal(soup_of(5, {{0, 1, 2}, {2, 3, 4}})), Contains("1 non-manifold vertex (vertex 2)"));
  // a ring of triangles closed at one vertex, 0: the border passes it twice
  CHECK_THAT(refusal(soup_of(6, {{0, 1, 2}, {2, 1, 3}, {2, 3, 4}, {4, 3, 5}, {4, 5, 0}})),
             Contains("1 non-manifold vertex (vertex 0)"));
  // two closed surfaces that touch in a point
  Faces two = TETRAHEDRON;
  for(auto face : TETRAHEDRON) {
    for(std::size_t& v : face)
      v = v == 0 ? 0 : v + 3;
    two.push_back(face);
  }
  CHECK_THAT(refusal(soup_of(7, two)), Contains("1 non-manifold vertex (vertex 0)"));
}

namespace {

Conditioning_options component(std::size_t number)
{
  Conditioning_options options;
  options.component = number;
  return options;
}

Conditioning_options triangulation()
{
  Conditioning_options options;
  options.triangulate = true;
  return options;
}

/// triangles apart from each other, sizes 1, 2, 3, 2, 1, with an isolated vertex in the middle
const Faces FIVE_COMPONENTS{{0, 1, 2},   {3, 4, 5},    {5, 4, 6},    {7, 8, 9},   {9, 8, 10},
                            {10, 8, 11}, {13, 14, 15}, {15, 14, 16}, {17, 18, 19}};

} // namespace

TEST_CASE("components are numbered by their number of faces, then by their first face")
{
  CHECK_THAT(refusal(soup_of(20, FIVE_COMPONENTS)),
             Contains("5 connected components") && Contains("(0 has 3 faces, 1 has 2 faces, 2 has 2 faces, ...)"));
  const std::vector<std::vector<std::size_t>> points{
      {7, 8, 9, 10, 11}, {3, 4, 5, 6}, {13, 14, 15, 16}, {0, 1, 2}, {17, 18, 19}};
  for(std::size_t k = 0; k < points.size(); ++k) {
    Surface_soup soup = soup_of(20, FIVE_COMPONENTS);
    const Conditioning_report report = condition_soup(soup, component(k));
    CHECK(report.components == 5);
    CHECK(report.component == k);
    CHECK(report.faces_dropped == 9 - soup.faces.size());
    CHECK(report.vertices_dropped == 20 - points[k].size());
    REQUIRE(soup.points.size() == points[k].size());
    for(std::size_t v = 0; v < soup.points.size(); ++v) {
      CHECK(soup.points[v].x() == double(points[k][v]));
      CHECK(report.new_index[points[k][v]] == v);
    }
  }
  CHECK_THAT(refusal(soup_of(20, FIVE_COMPONENTS), SMP::ERROR_WRONG_PARAMETER, component(5)),
             Contains("no component 5: the surface has 5"));
}

TEST_CASE("what is wrong with other components does not matter, what is wrong with the chosen one has its old number")
{
  Faces faces = FIVE_COMPONENTS;
  faces[7][0] = faces[7][1]; // repeats a vertex
  faces.insert(faces.end(),
               {{17, 18, 12}, {17, 18, 0}}); // a non-manifold edge, which also joins the first and the last
  Surface_soup soup = soup_of(20, faces);
  CHECK(condition_soup(soup, component(2)).faces_dropped == 9);
  CHECK_THAT(refusal(soup_of(20, faces), SMP::ERROR_NO_TOPOLOGICAL_DISC, component(1)),
             Contains("1 non-manifold edge (vertices 17 and 18)"));
  faces = {{0, 1, 2}, {3, 4, 5}, {5, 4, 6}, {6, 4, 4}};
  CHECK_THAT(refusal(soup_of(7, faces), SMP::ERROR_NON_TRIANGULAR_MESH, component(0)),
             Contains("1 face that repeats a vertex (face 3)"));
}

TEST_CASE("surfaces that touch in a vertex are components, of which one can be chosen")
{
  Surface_soup soup = soup_of(5, {{0, 1, 2}, {2, 3, 4}});
  CHECK(condition_soup(soup, component(1)).components == 2);
  CHECK(soup.points.size() == 3);
}

TEST_CASE("polygons are split without new vertices, in their place, and oriented with their neighbors")
{
  // a quadrilateral, a triangle that is turned, a pentagon with a reflex corner
  Surface_soup soup{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}, {1.5, 1.125, 0}, {0, 2, 0}},
                    {{0, 1, 4, 3}, {1, 4, 5}, {1, 2, 5}, {3, 4, 5, 6, 7}}};
  const std::vector<Eigen::Vector3d> points = soup.points;
  const Conditioning_report report = condition_soup(soup, triangulation());
  CHECK(report.polygons_triangulated == 2);
  CHECK(report.faces_reoriented == 1);
  CHECK(soup.points == points);
  REQUIRE(soup.faces.size() == 2 + 1 + 1 + 3);
  CHECK(soup.faces[2] == std::vector<std::size_t>{5, 4, 1});
  CHECK(is_oriented(soup));
  double area = 0;
  for(const auto& face : soup.faces) { // in the plane, counter-clockwise: the reflex corner is not cut off
    REQUIRE(face.size() == 3);
    const Eigen::Vector3d a = points[face[1]] - points[face[0]], b = points[face[2]] - points[face[0]];
    CHECK(a.cross(b).z() > 0);
    area += a.cross(b).z() / 2;
  }
  CHECK(area == Approx(2 + 0.875));
}

TEST_CASE("neighboring polygons do not get the same diagonal, which would have four faces")
{
  // two polygons that share two edges at vertex 1: each could be split between 0 and 2
  const std::vector<Eigen::Vector3d> points{{0, 0, 0}, {2, -0.1, 1}, {4, 0, 0}, {2, 3, 0}, {2, -3, 0}};
  Surface_soup soup{points, {{0, 1, 2, 3}, {2, 1, 0, 4}}};
  const Conditioning_report report = condition_soup(soup, triangulation());
  CHECK(report.polygons_triangulated == 2);
  CHECK(report.vertices_added == 0);
  CHECK(soup.faces.size() == 4);
  CHECK(is_oriented(soup));
  // the two sides of one quadrilateral, and of one hexagon
  for(const std::size_t n : {4, 6}) {
    Surface_soup pillow{{}, Faces(2)};
    for(std::size_t v = 0; v < n; ++v) {
      pillow.points.emplace_back(std::cos(2 * PI * double(v) / double(n)), std::sin(2 * PI * double(v) / double(n)), 0);
      pillow.faces[0].push_back(v);
      pillow.faces[1].push_back(n - 1 - v);
    }
    Conditioning_options options = triangulation();
    options.topology = Topology::CONNECTED;
    CHECK(condition_soup(pillow, options).vertices_added == 0);
    CHECK(pillow.faces.size() == 2 * (n - 2));
    CHECK(is_oriented(pillow));
  }
}

TEST_CASE("a polygon whose diagonals all are edges gets a vertex in its middle")
{
  // five quadrilaterals make a torus in which every two of the five vertices are joined
  Surface_soup soup{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}, {7, 7, 7}}, {}};
  for(std::size_t i = 0; i < 5; ++i)
    soup.faces.push_back({i, (i + 1) % 5, (i + 3) % 5, (i + 2) % 5});
  const std::vector<Eigen::Vector3d> points = soup.points;
  Conditioning_options options = triangulation();
  options.topology = Topology::CONNECTED;
  const Conditioning_report report = condition_soup(soup, options);
  CHECK(report.polygons_triangulated == 5);
  CHECK(report.vertices_added == 5);
  CHECK(report.vertices_dropped == 1);
  CHECK(report.new_index == std::vector<std::size_t>{0, 1, 2, 3, 4, DROPPED});
  CHECK(soup.faces.size() == 20);
  CHECK(is_oriented(soup));
  REQUIRE(soup.points.size() == 10);
  CHECK((soup.points[5] - (points[0] + points[1] + points[3] + points[2]) / 4).norm() < 1e-15);
}

TEST_CASE("a polygon is cut into triangles that do not overlap, also with many reflex corners and corners on its sides")
{
  for(const int n : {10, 41, 160}) {
    Surface_soup soup{{}, {{}}};
    double area = 0;
    for(int v = 0; v < n; ++v) { // a star, with the middles of its edges, in a plane that is far from level
      const double radii[2] = {v % 4 == 0 ? 1 : 0.4, v % 4 == 0 ? 0.4 : 1};
      const auto tip = [n](int k, double radius) {
        return Eigen::Vector3d(radius * std::cos(PI * k / n), radius * std::sin(PI * k / n), 0);
      };
      soup.points.push_back(v % 2 == 0 ? tip(2 * v, radii[0])
                                       : (tip(2 * v - 2, radii[1]) + tip(2 * v + 2, radii[0])) / 2);
      soup.faces[0].push_back(v);
    }
    for(Eigen::Vector3d& p : soup.points)
      p = {3 * p.x() + 2 * p.y(), p.x(), p.y() - p.x()};
    const Eigen::Vector3d normal = Eigen::Vector3d(3, 1, -1).cross(Eigen::Vector3d(2, 0, 1));
    for(int v = 0; v < n; ++v)
      area += soup.points[v].cross(soup.points[(v + 1) % n]).dot(normal) / 2;
    const std::size_t added = condition_soup(soup, triangulation()).vertices_added;
    CHECK((added > 0) == (n == 160));
    REQUIRE(soup.faces.size() == static_cast<std::size_t>(n - 2) + 2 * added);
    double sum = 0;
    for(const auto& face : soup.faces) {
      const Eigen::Vector3d a = soup.points[face[1]] - soup.points[face[0]];
      const double part = a.cross(soup.points[face[2]] - soup.points[face[0]]).dot(normal) / 2;
      CHECK(part > 0);
      sum += part;
    }
    CHECK(sum == Approx(area));
  }
}

TEST_CASE("a point in a triangle is found among those that are left, as by trying all")
{
  Random_numbers random(7);
  for(int n : {1, 7, 40, 500})
    for(int columns : {3, 9, 1000}) { // few columns: many points in one place, and on the sides of triangles
      const auto coordinate = [&] { return double(int(random(0, columns))); };
      std::vector<Planar_points::Point> points;
      for(int k = 0; k < n; ++k)
        points.emplace_back(coordinate(), coordinate());
      Planar_points tree(points);
      std::vector<bool> is_left(points.size(), true);
      for(int round = 0; round < n; ++round) {
        Planar_points::Triangle t{Planar_points::Point(coordinate(), coordinate()),
                                  {coordinate(), coordinate()},
                                  {coordinate(), coordinate()}};
        const CGAL::Orientation orientation = CGAL::orientation(t[0], t[1], t[2]);
        if(orientation == CGAL::RIGHT_TURN)
          std::swap(t[0], t[1]);
        bool is_any_in = false;
        for(int k = 0; k < n; ++k) {
          bool is_in = is_left[k];
          for(int side = 0; side < 3; ++side)
            is_in = is_in && points[k] != t[side] &&
                    CGAL::orientation(t[side], t[(side + 1) % 3], points[k]) != CGAL::RIGHT_TURN;
          is_any_in = is_any_in || is_in;
        }
        if(orientation != CGAL::COLLINEAR)
          CHECK(tree.is_any_in(t) == is_any_in);
        is_left[round] = false;
        tree.remove(round);
      }
    }
}

TEST_CASE("polygons without area, with corners in one place, or that meet themselves are split, too")
{
  const std::vector<Eigen::Vector3d> line{{0, 0, 0}, {1, 1, 1}, {3, 3, 3}, {2, 2, 2}, {5, 5, 5}};
  const std::vector<Eigen::Vector3d> bow_tie{{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}, {2, 2, 2}};
  const std::vector<Eigen::Vector3d> doubled{{0, 0, 0}, {5, 1, 0}, {0, 1, 0}, {1, 0, 0}, {1, 0, 0}};
  for(const auto& points : {line, bow_tie, doubled, std::vector<Eigen::Vector3d>(5, {1, 2, 3})})
    for(double scale : {1., 1e300, 1e-300}) {
      Surface_soup soup{points, {{0, 4, 2, 1, 3}}};
      for(Eigen::Vector3d& p : soup.points)
        p *= scale;
      CHECK(condition_soup(soup, triangulation()).polygons_triangulated == 1);
      CHECK(soup.faces.size() == 3);
      CHECK(is_oriented(soup));
    }
}

TEST_CASE("polygons are refused unless they are to be split, and when they repeat a vertex")
{
  CHECK_THAT(refusal(soup_of(5, {{0, 1, 2, 3}, {2, 1, 4, 2}}), SMP::ERROR_NON_TRIANGULAR_MESH, triangulation()),
             Contains("1 face that repeats a vertex (face 1)"));
  CHECK_THAT(refusal(soup_of(4, Faces(9, {0, 1, 2, 3})), SMP::ERROR_NON_TRIANGULAR_MESH), Contains("--triangulate"));
}

TEST_CASE("a polygon that repeats a vertex is found at any length, wherever the vertex is")
{
  for(std::size_t n : {4, 8, 9, 40})
    for(std::size_t first = 0; first < n; ++first)
      for(std::size_t second = first + 1; second < n; ++second) {
        std::vector<std::size_t> polygon(n);
        for(std::size_t k = 0; k < n; ++k)
          polygon[k] = n - 1 - k;
        CHECK_FALSE(repeats_vertex(polygon));
        polygon[second] = polygon[first];
        CHECK(repeats_vertex(polygon));
      }
}

TEST_CASE("the list of sides stays that of the soup when faces are dropped and turned round")
{
  Random_numbers random(7);
  Faces faces;
  for(std::size_t i = 0; i < 12; ++i) // a strip of polygons of 4 to 7 corners, and a triangle before each
    faces.push_back({30 + 3 * i, 31 + 3 * i, 32 + 3 * i});
  std::size_t inner = 66;
  for(std::size_t i = 0; i < 12; ++i) {
    std::vector<std::size_t> polygon{2 * i};
    for(int extra = random.below(4); extra > 0; --extra)
      polygon.push_back(inner++);
    polygon.insert(polygon.end(), {2 * i + 2, 2 * i + 3, 2 * i + 1});
    std::rotate(polygon.begin(), polygon.begin() + random.below(4), polygon.end());
    if(i % 3 == 0)
      std::reverse(polygon.begin(), polygon.end());
    faces.push_back(polygon);
  }
  Surface_soup soup = soup_of(inner, faces);
  std::vector<Soup_side> sides = sides_by_edge(soup);
  const auto check_sides = [&] {
    const std::vector<Soup_side> expected = sides_by_edge(soup);
    REQUIRE(sides.size() == expected.size());
    for(std::size_t i = 0; i < sides.size(); ++i) {
      CHECK(std::tie(sides[i].low, sides[i].high, sides[i].face, sides[i].corner) ==
            std::tie(expected[i].low, expected[i].high, expected[i].face, expected[i].corner));
      const auto& face = soup.faces[sides[i].face];
      const auto k = static_cast<std::size_t>(sides[i].corner);
      CHECK(std::minmax({face[k], face[(k + 1) % face.size()]}) ==
            std::pair<std::size_t, std::size_t>(sides[i].low, sides[i].high));
    }
  };
  const auto components = components_of(soup, sides);
  REQUIRE(components.size() == 13);
  keep_component(components.front(), soup, sides);
  REQUIRE(soup.faces.size() == 12);
  check_sides();
  CHECK(orient_faces(soup, sides, components.front()) == 4);
  check_sides();
}
