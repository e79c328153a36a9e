// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "make_patch_of.h"
#include "reference_stretch.h"

#include <CGAL_ext/Square_parameterization/internal/energy/measure.h>
#include <CGAL_ext/Square_parameterization/internal/energy/rectangle.h>
#include <CGAL_ext/Square_parameterization/internal/energy/stretch_kernel.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

using namespace CGAL_ext::internal;

namespace {

const std::array<int, 3> FIRST_THREE{0, 1, 2};

Uv_coordinates as_uv(const std::array<Eigen::Vector2d, 3>& p)
{
  Uv_coordinates uv(3, 2);
  for(int k = 0; k < 3; ++k)
    uv.row(k) = p[k].transpose();
  return uv;
}

/// x and y of the mesh as its map
Uv_coordinates xy_of(const Flat_mesh& mesh)
{
  Uv_coordinates uv(mesh.points.size(), 2);
  for(std::size_t v = 0; v < mesh.points.size(); ++v)
    uv.row(v) = mesh.points[v].head<2>().transpose();
  return uv;
}

/// product of two sides over the area: how much the rounding of coordinates is magnified
template <class Point>
double magnification(const std::array<Point, 3>& p, double area)
{
  const double longest = std::max({(p[1] - p[0]).norm(), (p[2] - p[1]).norm(), (p[0] - p[2]).norm()});
  return longest * longest / area;
}

} // namespace

TEST_CASE("the identity of a flat square has stretch one")
{
  const Flat_mesh mesh = unit_square(8);
  std::vector<double> sigma;
  CHECK(stretch_energy(make_patch_of(mesh), xy_of(mesh), sigma) == Approx(1).epsilon(1e-13));
  for(double s : sigma)
    CHECK(s == Approx(1).epsilon(1e-13));
}

TEST_CASE("a square from a rectangle s times as long has the stretch of its two singular values")
{
  const double s = GENERATE(1e-3, 0.5, 3., 1e4);
  const Flat_mesh square = unit_square(6);
  const Patch patch =
      make_patch_of(transformed(square, [s](const auto& p) { return Eigen::Vector3d(s * p.x(), p.y(), 0); }));
  const Uv_coordinates uv = xy_of(square);
  // singular values s and 1, both divided by the root of the area s
  CHECK(std::sqrt(stretch_energy(patch, uv)) == Approx(std::sqrt((s * s + 1) / (2 * s))).epsilon(1e-12));
  for(int f = 0; f < patch.number_of_faces(); ++f) {
    const Triangle_stretch stretch = triangle_stretch(patch.shapes[f], uv, patch.triangles[f]);
    CHECK(stretch.linf == Approx(std::max(s, 1.) / std::sqrt(s)).epsilon(1e-10));
  }
}

TEST_CASE("the stretch of random triangles is that of the formula, slivers included")
{
  Random_numbers random(11);
  int checked = 0;
  for(int trial = 0; trial < 3000; ++trial) {
    const double flatness_3 = std::pow(10, random(-6, 0)), flatness_2 = std::pow(10, random(-6, 0));
    std::array<Eigen::Vector3d, 3> q;
    std::array<Eigen::Vector2d, 3> p;
    for(int k = 0; k < 3; ++k) {
      q[k] = {random(-1, 1), flatness_3 * random(-1, 1), flatness_3 * random(-1, 1)};
      p[k] = {random(-1, 1), flatness_2 * random(-1, 1)};
    }
    const Reference_triangle expected = reference_triangle(q, p);
    const Flat_triangle shape = flatten(q[0], q[1], q[2], 0);
    const Triangle_stretch stretch = triangle_stretch(shape, as_uv(p), FIRST_THREE);

    CHECK(stretch.uv_area == Approx(double(expected.uv_area)).epsilon(1e-11));
    if(expected.uv_area <= 0) {
      CHECK(stretch.l2_squared == std::numeric_limits<double>::infinity());
      continue;
    }
    const double tolerance = 1e-14 * (1 + magnification(q, double(expected.surface_area))) + 3e-11;
    if(tolerance > 1e-4)
      continue;
    CHECK(shape.area() == Approx(double(expected.surface_area)).epsilon(tolerance));
    CHECK(stretch.l2_squared == Approx(double(expected.l2_squared)).epsilon(tolerance));
    CHECK(stretch.linf == Approx(double(expected.linf)).epsilon(tolerance));
    ++checked;
  }
  CHECK(checked > 1000);
}

TEST_CASE("a map measured on a rectangle has the flips that it has on the square, and no others")
{
  const std::vector<std::array<int, 3>> triangles{FIRST_THREE};
  const std::vector<Flat_triangle> shapes{{1, 0.3, 0.5}};
  const double aspect = 0.985;
  Random_numbers random(1);
  int flipped_by_rounding = 0;
  for(int i = 0; i < 1000; ++i) {
    const auto point = [&] { return Eigen::Vector2d(random(0, 1), random(0, 1)); };
    const Eigen::Vector2d p = point(), q = point();
    Uv_coordinates uv = as_uv({p, q, i % 2 == 0 ? point() : Eigen::Vector2d(p + random(0, 1) * (q - p))});
    if(!is_counterclockwise(uv, FIRST_THREE))
      uv.row(0).swap(uv.row(1));
    if(!is_counterclockwise(uv, FIRST_THREE)) // flat
      continue;
    const CGAL_ext::Stretch_measures measures = measure(shapes, triangles, uv, scale_to_rectangle(aspect)),
                                     of_rounded = measure(shapes, triangles, on_rectangle(uv, aspect));
    CHECK(measures.flipped_faces == 0);
    CHECK(std::isfinite(measures.l2));
    flipped_by_rounding += static_cast<int>(of_rounded.flipped_faces);
    if(i % 2 == 0) {
      CHECK(measures.l2 == Approx(of_rounded.l2));
      CHECK(measures.linf == Approx(of_rounded.linf));
      CHECK(measures.symmetric_dirichlet == Approx(of_rounded.symmetric_dirichlet));
      CHECK(measures.uv_area == Approx(of_rounded.uv_area));
    }
  }
  CHECK(flipped_by_rounding > 50); // of about 500 slivers
}

TEST_CASE("a clockwise or flat uv triangle has infinite stretch")
{
  const Flat_triangle shape{1, 0.3, 0.8};
  const auto stretch = [&](const std::array<Eigen::Vector2d, 3>& p) {
    return triangle_stretch(shape, as_uv(p), FIRST_THREE);
  };
  const double infinity = std::numeric_limits<double>::infinity();
  const Triangle_stretch clockwise = stretch({Eigen::Vector2d(0, 0), {0, 1}, {1, 0}});
  CHECK(clockwise.l2_squared == infinity);
  CHECK(clockwise.linf == infinity);
  CHECK(clockwise.uv_area == -0.5);
  CHECK(stretch({Eigen::Vector2d(0, 0), {1, 1}, {2, 2}}).l2_squared == infinity);
  CHECK(stretch({Eigen::Vector2d(0, 0), {0, 0}, {0, 0}}).l2_squared == infinity);
}

TEST_CASE("the stretch of a map and of its vertices is the area mean of the triangles")
{
  const Flat_mesh mesh = noisy_height_field(7);
  const Patch patch = make_patch_of(mesh);
  const Uv_coordinates uv = xy_of(mesh);
  const Reference_stretch expected = reference_stretch(patch.points, mesh.triangles, as_points(uv));

  std::vector<double> sigma;
  const double energy = stretch_energy(patch, uv, sigma);
  CHECK(energy == stretch_energy(patch, uv));
  CHECK(std::sqrt(energy) == Approx(expected.l2).epsilon(1e-12));
  for(std::size_t v = 0; v < sigma.size(); ++v)
    CHECK(sigma[v] == Approx(expected.vertex_l2[v]).epsilon(1e-12));
}
