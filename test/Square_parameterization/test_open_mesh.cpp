// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>

#include <CGAL/boost/graph/graph_traits_PolyMesh_ArrayKernelT.h>

#include "mesh_types.h"

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
