// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "mesh_types.h"

#include <CGAL_ext/Square_parameterization/parameterize_onto_square.h>
#include <CGAL_ext/Square_parameterization/sample_on_grid.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/graph_traits_Polyhedron_3.h>

#include <catch2/catch.hpp>

#include <iterator>
#include <vector>

namespace {

/// checks the samples of a surface against a walk over the mesh: the point and the uv that faces and barycentric
/// coordinates stand for
template <class Mesh>
void check_samples()
{
  Mesh mesh = make_mesh<Mesh>(saddle(8));
  Uv_storage<Mesh, Point_2> storage;
  REQUIRE(CGAL_ext::parameterize_onto_square(mesh, storage.map()).status == SMP::OK);
  constexpr int WIDTH = 13, HEIGHT = 21;
  std::vector<CGAL_ext::Grid_sample<Mesh>> samples;
  const auto result = CGAL_ext::sample_on_grid(mesh, storage.map(), WIDTH, HEIGHT, std::back_inserter(samples));
  CHECK(result.status == SMP::OK);
  CHECK(result.message.empty());
  REQUIRE(samples.size() == WIDTH * HEIGHT);
  const auto vpm = get(CGAL::vertex_point, mesh);
  for(std::size_t s = 0; s < samples.size(); ++s) {
    Eigen::Vector3d point(0, 0, 0);
    Eigen::Vector2d uv(0, 0);
    double sum = 0;
    auto h = halfedge(samples[s].face, mesh);
    for(double weight : samples[s].barycentric_coordinates) {
      const auto v = source(h, mesh);
      point += weight * CGAL_ext::internal::point_of(vpm, v);
      uv += weight *
            Eigen::Vector2d(CGAL::to_double(get(storage.map(), v).x()), CGAL::to_double(get(storage.map(), v).y()));
      sum += weight;
      h = next(h, mesh);
      CHECK(weight >= 0);
    }
    CHECK(sum == Approx(1).epsilon(1e-14));
    CHECK(uv.x() == Approx(static_cast<int>(s % WIDTH) / (WIDTH - 1.)).margin(1e-14));
    CHECK(uv.y() == Approx(static_cast<int>(s / WIDTH) / (HEIGHT - 1.)).margin(1e-14));
    const auto& p = samples[s].point;
    CHECK((Eigen::Vector3d(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())) - point).norm() <
          1e-12);
    CHECK(CGAL::to_double(samples[s].normal.squared_length()) == Approx(1).epsilon(1e-12));
  }
}

} // namespace

TEST_CASE("samples of meshes of all types")
{
  check_samples<Surface_mesh>();
  check_samples<CGAL::Polyhedron_3<Kernel>>();
}

TEST_CASE("what cannot be sampled is refused, and nothing comes out")
{
  Surface_mesh mesh = make_mesh<Surface_mesh>(unit_square(3));
  Uv_storage<Surface_mesh, Point_2> storage;
  std::vector<CGAL_ext::Grid_sample<Surface_mesh>> samples;
  const auto sample = [&](const Surface_mesh& surface, int width, int height) {
    return CGAL_ext::sample_on_grid(surface, storage.map(), width, height, std::back_inserter(samples));
  };
  for(auto v : mesh.vertices())
    put(storage.map(), v, Point_2(mesh.point(v).x(), mesh.point(v).y()));
  CHECK(sample(mesh, 2, 2).status == SMP::OK);
  samples.clear();
  CHECK(sample(mesh, 1, 9).message == "a grid has 2 to 65536 samples a side, not 1 by 9");
  CHECK(sample(mesh, 9, 0).status == SMP::ERROR_WRONG_PARAMETER);
  CHECK(sample(mesh, -5, 65537).status == SMP::ERROR_WRONG_PARAMETER);
  CHECK(sample(Surface_mesh(), 9, 9).status == SMP::ERROR_EMPTY_MESH);
  for(auto v : mesh.vertices())
    put(storage.map(), v, Point_2(mesh.point(v).x() / 2, mesh.point(v).y()));
  CHECK(sample(mesh, 9, 9).status == SMP::ERROR_NO_1_TO_1_MAPPING);
  for(auto v : mesh.vertices())
    put(storage.map(), v, Point_2(mesh.point(v).y(), mesh.point(v).x()));
  CHECK(sample(mesh, 9, 9).status == SMP::ERROR_NO_1_TO_1_MAPPING);
  CHECK(samples.empty());
}
