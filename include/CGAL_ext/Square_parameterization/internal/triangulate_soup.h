// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_TRIANGULATE_SOUP_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_TRIANGULATE_SOUP_H

#include <CGAL_ext/Square_parameterization/internal/Complaint.h>
#include <CGAL_ext/Square_parameterization/internal/Surface_soup.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Surface_mesh.h>

#include <string>
#include <utility>
#include <vector>

namespace CGAL_ext {
namespace internal {

/// the triangles of one polygon, found by CGAL's `triangulate_faces()`; empty when it finds none, as for a polygon that
/// meets itself. They are oriented as the polygon.
inline std::vector<std::vector<std::size_t>> triangles_of_polygon(const std::vector<Eigen::Vector3d>& points,
                                                                  const std::vector<std::size_t>& polygon)
{
  typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
  typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
  Mesh mesh;
  std::vector<Mesh::Vertex_index> corners;
  for(std::size_t v : polygon)
    corners.push_back(mesh.add_vertex(Kernel::Point_3(points[v].x(), points[v].y(), points[v].z())));
  mesh.add_face(corners);
  if(!CGAL::Polygon_mesh_processing::triangulate_faces(mesh))
    return {};
  std::vector<std::vector<std::size_t>> triangles;
  for(Mesh::Face_index f : mesh.faces()) {
    triangles.emplace_back();
    for(Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f)))
      triangles.back().push_back(polygon[v.idx()]);
  }
  return triangles;
}

/// splits the faces with more than three vertices; the triangles of a face take its place. \p names holds, per face,
/// its number for messages, and is brought up to date. Returns how many faces it split.
inline std::size_t triangulate_soup(Surface_soup& soup, std::vector<std::size_t>& names)
{
  std::vector<std::vector<std::size_t>> faces;
  std::vector<std::size_t> new_names;
  std::vector<std::string> unsplit;
  std::size_t polygons = 0, number_of_unsplit = 0;
  for(std::size_t f = 0; f < soup.faces.size(); ++f) {
    std::vector<std::vector<std::size_t>> parts{soup.faces[f]};
    if(soup.faces[f].size() > 3) {
      ++polygons;
      parts = triangles_of_polygon(soup.points, soup.faces[f]);
      if(parts.empty() && ++number_of_unsplit <= NAMED_PLACES)
        unsplit.push_back("face " + std::to_string(names[f]));
    }
    new_names.insert(new_names.end(), parts.size(), names[f]);
    for(auto& part : parts)
      faces.push_back(std::move(part));
  }
  Complaint complaint;
  complaint.add(number_of_unsplit, "polygon cannot be split into triangles", "polygons cannot be split into triangles",
                unsplit);
  complaint.throw_if_any(CGAL::Surface_mesh_parameterization::ERROR_NON_TRIANGULAR_MESH);
  soup.faces = std::move(faces);
  names = std::move(new_names);
  return polygons;
}

} // namespace internal
} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_TRIANGULATE_SOUP_H
