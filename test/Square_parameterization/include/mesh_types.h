// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_MESH_TYPES_H
#define CGAL_EXT_MESH_TYPES_H

#include "make_mesh.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>

#include <CGAL_ext/Square_parameterization/Stretch_minimizing_parameterizer_3.h>

namespace SMP = CGAL::Surface_mesh_parameterization;

typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_2 Point_2;
typedef CGAL::Surface_mesh<Kernel::Point_3> Surface_mesh;

/// status and uv, in the order of the vertices of the mesh; no uv unless the status is OK
struct Parameterization
{
  SMP::Error_code status;
  std::vector<Eigen::Vector2d> uv;
  Orientation_count orientations;
};

/// runs a parameterizer through CGAL's free function
template <class Point_2 = ::Point_2, class Mesh, class Parameterizer>
Parameterization parameterize(Mesh& mesh, const Parameterizer& parameterizer,
                              typename boost::graph_traits<Mesh>::halfedge_descriptor bhd)
{
  Uv_storage<Mesh, Point_2> storage;
  Parameterization result{SMP::parameterize(mesh, parameterizer, bhd, storage.map()), {}, {}};
  if(result.status == SMP::OK) {
    result.uv = storage.points(mesh);
    result.orientations = count_orientations(mesh, storage);
  }
  return result;
}

/// as above, with the border counted from its first vertex in the order of the mesh
template <class Point_2 = ::Point_2, class Mesh, class Parameterizer>
Parameterization parameterize(Mesh& mesh, const Parameterizer& parameterizer)
{
  return parameterize<Point_2>(mesh, parameterizer, first_border_halfedge_of(mesh));
}

inline double largest_difference(const std::vector<Eigen::Vector2d>& a, const std::vector<Eigen::Vector2d>& b)
{
  double largest = a.size() == b.size() ? 0 : 1e300;
  for(std::size_t v = 0; v < std::min(a.size(), b.size()); ++v)
    largest = std::max(largest, (a[v] - b[v]).cwiseAbs().maxCoeff());
  return largest;
}

/// a map of all faces that is one-to-one and not mirrored
inline bool is_one_to_one(const Parameterization& result, std::size_t number_of_faces)
{
  return result.status == SMP::OK && result.orientations.counterclockwise == number_of_faces;
}

#endif // CGAL_EXT_MESH_TYPES_H
