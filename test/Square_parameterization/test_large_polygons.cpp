// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "test_meshes.h"

#include <CGAL_ext/Square_parameterization/internal/soup/Polygon_quadtree.h>
#include <CGAL_ext/Square_parameterization/internal/soup/condition_soup.h>

#include <Eigen/Geometry>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

using namespace CGAL_ext::internal;

namespace {

typedef std::vector<Eigen::Vector2d> Planar_polygon;

/// a polygon round the origin: corner k at the radius that \p radius_of gives
Planar_polygon polygon_of_radii(int n, const std::function<double(int)>& radius_of)
{
  Planar_polygon polygon;
  for(int k = 0; k < n; ++k) {
    const double angle = 2 * PI * k / n;
    polygon.emplace_back(radius_of(k) * std::cos(angle), radius_of(k) * std::sin(angle));
  }
  return polygon;
}

Planar_polygon circle(int n)
{
  return polygon_of_radii(n, [](int) { return 1.; });
}

/// teeth on a base whose sides are long
Planar_polygon comb(int teeth)
{
  Planar_polygon polygon{{-1, -5}, {2. * teeth, -5}};
  for(int i = teeth; i-- > 0;)
    for(const auto& [x, y] : {std::pair(1, 0), {1, 2}, {0, 2}, {0, 0}})
      polygon.emplace_back(2. * i + x, double(y));
  return polygon;
}

/// a hundred corners of a circle, of which a quarter lie within 1e-9 of each other
Planar_polygon clustered()
{
  Planar_polygon polygon = circle(75);
  for(int k = 0; k < 25; ++k)
    polygon.emplace_back(1 - 1e-9 * (1 - std::cos(0.1 * k)), -1e-9 * (2.6 - 0.1 * k));
  return polygon;
}

std::vector<Planar_polygon> polygons()
{
  Random_numbers random(11);
  std::vector<double> radii(200);
  for(double& radius : radii)
    radius = random(0.2, 1);
  return {circle(50),
          circle(700),
          comb(60),
          clustered(),
          polygon_of_radii(400, [](int k) { return k % 2 ? 0.9 : 1; }),
          polygon_of_radii(200, [&radii](int k) { return radii[k]; })};
}

/// one face, on the plane that two vectors span
Surface_soup soup_of(const Planar_polygon& polygon, const Eigen::Vector3d& u = {3, 1, -1},
                     const Eigen::Vector3d& v = {2, 0, 1}, const Eigen::Vector3d& origin = {5, 7, -2})
{
  Surface_soup soup;
  for(const Eigen::Vector2d& p : polygon)
    soup.points.push_back(origin + p.x() * u + p.y() * v);
  soup.faces.emplace_back(polygon.size());
  std::iota(soup.faces[0].begin(), soup.faces[0].end(), std::size_t(0));
  return soup;
}

Conditioning_report split(Surface_soup& soup, Topology topology = Topology::DISK)
{
  Conditioning_options options;
  options.triangulate = true;
  options.topology = topology;
  return condition_soup(soup, options);
}

double area(const Planar_polygon& polygon)
{
  double sum = 0;
  for(std::size_t k = 0; k < polygon.size(); ++k) {
    const Eigen::Vector2d &p = polygon[k], &q = polygon[(k + 1) % polygon.size()];
    sum += (p.x() * q.y() - q.x() * p.y()) / 2;
  }
  return sum;
}

/// triangles at the vertex that has most of them
int largest_valence(const Surface_soup& soup)
{
  std::vector<int> valences(soup.points.size(), 0);
  for(const auto& face : soup.faces)
    for(std::size_t v : face)
      ++valences[v];
  return *std::max_element(valences.begin(), valences.end());
}

/// how often the sides of faces are run through, from the first to the second vertex
std::map<std::pair<std::size_t, std::size_t>, int> sides_of(const Surface_soup& soup)
{
  std::map<std::pair<std::size_t, std::size_t>, int> sides;
  for(const auto& face : soup.faces)
    for(std::size_t k = 0; k < face.size(); ++k)
      ++sides[{face[k], face[(k + 1) % face.size()]}];
  return sides;
}

} // namespace

TEST_CASE("a flat polygon of many corners is covered once by triangles, whose corners are its own and points inside")
{
  for(const Planar_polygon& polygon : polygons())
    for(double scale : {1e-8, 1., 1e8})
      for(bool is_reversed : {false, true}) {
        Surface_soup soup = soup_of(polygon, scale * Eigen::Vector3d(3, 1, -1), scale * Eigen::Vector3d(2, 0, 1),
                                    scale * Eigen::Vector3d(5, 7, -2));
        if(is_reversed)
          std::reverse(soup.faces[0].begin(), soup.faces[0].end());
        const std::vector<Eigen::Vector3d> corners = soup.points;
        const Conditioning_report report = split(soup);
        const std::size_t n = corners.size(), added = report.vertices_added;
        CHECK(report.polygons_triangulated == 1);
        REQUIRE(soup.points.size() == n + added);
        CHECK(std::equal(corners.begin(), corners.end(), soup.points.begin()));
        CHECK(soup.faces.size() == n - 2 + 2 * added); // a disk without holes
        CHECK(added <= 8 * n);
        const Eigen::Vector3d normal =
            Eigen::Vector3d(3, 1, -1).cross(Eigen::Vector3d(2, 0, 1)) * (is_reversed ? -1 : 1);
        double sum = 0, least = 1;
        for(const auto& face : soup.faces) {
          const Eigen::Vector3d a = (soup.points[face[1]] - soup.points[face[0]]) / scale,
                                b = (soup.points[face[2]] - soup.points[face[0]]) / scale;
          const double part = a.cross(b).dot(normal) / (2 * normal.squaredNorm());
          least = (std::min)(least, part);
          sum += part;
        }
        CHECK(least > -1e-15); // rounding, among corners that are 1e-9 apart
        CHECK(sum == Approx(area(polygon)).epsilon(1e-12));
        for(const auto& [side, count] : sides_of(soup))
          CHECK(count == 1);
        double size = 0;
        for(const Eigen::Vector3d& p : corners)
          size = (std::max)(size, p.norm() / scale);
        for(std::size_t v = n; v < soup.points.size(); ++v)
          CHECK(std::abs((soup.points[v] / scale - Eigen::Vector3d(5, 7, -2)).dot(normal.normalized())) < 1e-14 * size);
      }
}

TEST_CASE(
    "few triangles meet at each vertex of a large polygon, and they are of good shape where corners are spread evenly")
{
  Surface_soup soup = soup_of(circle(2000), Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY());
  const Conditioning_report report = split(soup);
  CHECK(report.vertices_added > 500);
  CHECK(largest_valence(soup) <= 16);
  for(const auto& face : soup.faces) {
    double longest = 0;
    for(int k = 0; k < 3; ++k)
      longest = (std::max)(longest, (soup.points[face[(k + 1) % 3]] - soup.points[face[k]]).norm());
    const Eigen::Vector3d a = soup.points[face[1]] - soup.points[face[0]],
                          b = soup.points[face[2]] - soup.points[face[0]];
    CHECK(a.cross(b).norm() / (longest * longest) > 0.04); // height over longest side
  }
}

TEST_CASE("points inside a polygon that is not flat lie on the harmonic surface that its corners span")
{
  const auto saddle = [](const Eigen::Vector3d& p) { return p.x() * p.x() - p.y() * p.y() + p.x() / 2; }; // harmonic
  double largest = 0;
  for(const int n : {250, 1000}) {
    Surface_soup soup = soup_of(circle(n), {1, 0, 0}, {0, 1, 0}, {0, 0, 0});
    for(Eigen::Vector3d& p : soup.points)
      p.z() = saddle(p);
    CHECK(split(soup).vertices_added > 50);
    const double before = largest;
    largest = 0;
    for(const Eigen::Vector3d& p : soup.points)
      largest = (std::max)(largest, std::abs(p.z() - saddle(p)));
    CHECK(largest < 0.01);
    if(before > 0)
      CHECK(largest < before); // finer triangles are nearer to it
  }
}

TEST_CASE("polygons that have few corners, meet themselves as they are seen, or are huge or tiny get no points inside")
{
  Planar_polygon eight; // a curve that crosses itself
  for(int k = 0; k < 200; ++k)
    eight.emplace_back(std::sin(2 * PI * k / 200), std::sin(4 * PI * k / 200 + 0.01));
  Planar_polygon doubled = circle(100);
  doubled.insert(doubled.begin() + 30, doubled[30]);
  for(Surface_soup soup : {soup_of(circle(49)), soup_of(eight), soup_of(doubled),
                           soup_of(circle(60), {1e200, 0, 0}, {0, 1e200, 0}, {0, 0, 0}),
                           soup_of(circle(60), {1e-200, 0, 0}, {0, 1e-200, 0}, {0, 0, 0}),
                           soup_of(circle(60), {0, 0, 0}, {0, 1, 0}, {0, 0, 0})}) {
    const std::size_t corners = soup.points.size();
    const Conditioning_report report = split(soup);
    CHECK(report.vertices_added == 0);
    CHECK(soup.faces.size() == corners - 2);
  }
}

TEST_CASE("the two sides of a large flat polygon share its sides alone")
{
  for(const Planar_polygon& polygon : {circle(300), comb(30)}) {
    Surface_soup pillow = soup_of(polygon);
    pillow.faces.push_back(pillow.faces[0]);
    std::reverse(pillow.faces[1].begin(), pillow.faces[1].end());
    CHECK(split(pillow, Topology::CONNECTED).polygons_triangulated == 2);
    const auto sides = sides_of(pillow);
    for(const auto& [side, count] : sides) {
      CHECK(count == 1);
      CHECK(sides.count({side.second, side.first}) == 1);
    }
  }
}

TEST_CASE("the free places of a quadtree are away from the polygon, and of the order of its corners")
{
  const Planar_polygon polygon = polygon_of_radii(1000, [](int k) { return 1 + 0.2 * std::sin(0.05 * k); });
  const std::vector<Eigen::Vector2d> places = Polygon_quadtree(polygon, 3).free_centers();
  CHECK(places.size() > polygon.size() / 2);
  CHECK(places.size() < 4 * polygon.size());
  const auto distance_to = [&polygon](const Eigen::Vector2d& p) {
    double least = 10;
    for(std::size_t k = 0; k < polygon.size(); ++k) {
      const Eigen::Vector2d a = polygon[k], side = polygon[(k + 1) % polygon.size()] - a;
      const double along = std::clamp((p - a).dot(side) / side.squaredNorm(), 0., 1.);
      least = (std::min)(least, (p - a - along * side).norm());
    }
    return least;
  };
  for(const Eigen::Vector2d& p : places) {
    double nearest = 10;
    for(const Eigen::Vector2d& q : places)
      if(q != p)
        nearest = (std::min)(nearest, (q - p).norm());
    CHECK(distance_to(p) > 0.24 * nearest); // half a width at least, and the nearest is at most two widths away
  }
  CHECK(Polygon_quadtree(polygon, polygon.size()).free_centers().empty());
}
