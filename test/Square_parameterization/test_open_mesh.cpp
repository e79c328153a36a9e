// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>

#include <CGAL/boost/graph/graph_traits_PolyMesh_ArrayKernelT.h>

#include "closed_meshes.h"
#include "mesh_types.h"

#include <CGAL_ext/Square_parameterization/parameterize_onto_square.h>

#include <catch2/catch.hpp>

namespace {

struct Double_traits : OpenMesh::DefaultTraits
{
  typedef OpenMesh::Vec3d Point;
};

/// CGAL's point map for OpenMesh writes single precision
Flat_mesh in_single_precision(const Flat_mesh& flat)
{
  return transformed(flat, [](const Eigen::Vector3d& p) -> Eigen::Vector3d { return p.cast<float>().cast<double>(); });
}

} // namespace

TEST_CASE("a mesh of OpenMesh has the map of a Surface_mesh")
{
  typedef OpenMesh::PolyMesh_ArrayKernelT<Double_traits> Open_mesh;
  for(const Flat_mesh& flat : {in_single_precision(saddle(7)), in_single_precision(hemisphere())}) {
    Surface_mesh mesh = make_mesh<Surface_mesh>(flat);
    Open_mesh open_mesh = make_mesh<Open_mesh>(flat);
    const Parameterization expected = parameterize(mesh, CGAL_ext::Stretch_minimizing_parameterizer_3<Surface_mesh>());
    const Parameterization result = parameterize(open_mesh, CGAL_ext::Stretch_minimizing_parameterizer_3<Open_mesh>());
    REQUIRE(is_one_to_one(expected, flat.triangles.size()));
    REQUIRE(is_one_to_one(result, flat.triangles.size()));
    CHECK(largest_difference(expected.uv, result.uv) < 1e-10);
  }
}

TEST_CASE("a closed mesh of OpenMesh is cut and mapped, and a failed call leaves it as it was")
{
  typedef OpenMesh::PolyMesh_ArrayKernelT<Double_traits> Open_mesh;
  const Closed_mesh torus_mesh = torus(16, 9);
  Open_mesh mesh = make_mesh<Open_mesh>(Flat_mesh{torus_mesh.points, torus_mesh.triangles, {}});
  const std::size_t edges = mesh.n_edges(), vertices = mesh.n_vertices();
  Uv_storage<Open_mesh, Point_2> storage;
  CGAL_ext::Square_map_options<Open_mesh> options;
  options.cut.mode = CGAL_ext::Cut_mode::NONE;
  CHECK(CGAL_ext::parameterize_onto_square(mesh, storage.map(), CGAL_ext::parameters::options(options)).status ==
        SMP::ERROR_NO_TOPOLOGICAL_DISC);
  options.cut.mode = CGAL_ext::Cut_mode::SHORTEST;
  options.search_options.callback = [](double) { return false; };
  CHECK(CGAL_ext::parameterize_onto_square(mesh, storage.map(), CGAL_ext::parameters::options(options)).status ==
        SMP::ERROR_NO_1_TO_1_MAPPING);
  CHECK(mesh.n_edges() == edges);
  CHECK(mesh.n_vertices() == vertices);

  options.search_options.callback = nullptr;
  const auto result = CGAL_ext::parameterize_onto_square(mesh, storage.map(), CGAL_ext::parameters::options(options));
  REQUIRE(result.status == SMP::OK);
  CHECK(mesh.n_vertices() == vertices + result.copies.size() + result.chords_split);
  CHECK(CGAL::is_valid_polygon_mesh(mesh));
  CHECK(count_orientations(mesh, storage).counterclockwise == mesh.n_faces());
}
