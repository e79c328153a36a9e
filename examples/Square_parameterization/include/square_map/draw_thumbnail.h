// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_DRAW_THUMBNAIL_H
#define SQUARE_MAP_DRAW_THUMBNAIL_H

#include "Flat_map.h"
#include "report.h"
#include "surface_view.h"

#include <CGAL_ext/Square_parameterization/internal/energy/rectangle.h>

#include <Eigen/Eigenvalues>

#include <utility>
#include <vector>

namespace square_map {

constexpr int THUMBNAIL_PIXELS = 160;

/// the direction from which a surface shows most: the front of one that is rather a sheet, which its normals tell; the
/// broad side of any other, a little from above and from the side, so that it looks solid
/// \param points of which the box has the diagonal 1
inline Eigen::Vector3d front_of(const std::vector<Eigen::Vector3d>& points,
                                const std::vector<std::array<int, 3>>& triangles)
{
  Eigen::Vector3d normal = Eigen::Vector3d::Zero(), center = Eigen::Vector3d::Zero();
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  double area = 0;
  for(const auto& [a, b, c] : triangles) {
    const Eigen::Vector3d n = (points[b] - points[a]).cross(points[c] - points[a]);
    const Eigen::Vector3d p = (points[a] + points[b] + points[c]) / 3;
    normal += n;
    area += n.norm();
    center += n.norm() * p;
    spread += n.norm() * p * p.transpose();
  }
  constexpr double LEAST_SHARE_OF_SHEET = 0.4; // a hemisphere has 0.5
  if(normal.norm() > LEAST_SHARE_OF_SHEET * area)
    return normal;
  if(!(area > 0))
    return Eigen::Vector3d::UnitZ();
  center /= area;
  Eigen::Matrix3d axes =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread / area - center * center.transpose()).eigenvectors();
  for(int k = 0; k < 3; ++k) // an axis has no sign; this one looks along the coordinates
    if(axes.col(k).sum() < 0)
      axes.col(k) *= -1;
  return axes.col(0) + 0.4 * axes.col(1) + 0.25 * axes.col(2);
}

/// draws the surface in a checkerboard of its map, in white surroundings: `THUMBNAIL_PIXELS` on each side
/// \param aspect of the rectangle that the square stands for
inline Picture<std::uint8_t> draw_thumbnail(const Flat_map& map, double aspect)
{
  const std::vector<Eigen::Vector3d> points = in_box(map.points, map.box());
  const Eigen::Vector3d front = front_of(points, map.triangles).normalized();
  const bool is_from_above = std::abs(front.y()) > 0.9;
  const Surface_view view(points, front, is_from_above ? Eigen::Vector3d::UnitZ() : Eigen::Vector3d::UnitY());
  std::vector<Place> places;
  for(const Eigen::Vector3d& p : points)
    places.push_back(view.place(p));
  constexpr int SQUARES = 12;
  const Eigen::RowVector2d scale = CGAL_ext::internal::scale_to_rectangle(aspect);
  Canvas canvas(THUMBNAIL_PIXELS, THUMBNAIL_PIXELS);
  for(const auto& t : map.triangles)
    canvas.draw_triangle({places[t[0]], places[t[1]], places[t[2]]}, [&](const auto& weights, double) {
      Eigen::Vector2d uv = Eigen::Vector2d::Zero();
      Eigen::Vector3d normal = Eigen::Vector3d::Zero();
      for(int k = 0; k < 3; ++k) {
        uv += weights[k] * map.uv.row(t[k]).transpose();
        normal += weights[k] * map.normals[t[k]];
      }
      return Eigen::Vector3d(view.light(normal.normalized()) *
                             checkerboard_at(uv.x() * scale.x(), uv.y() * scale.y(), SQUARES));
    });
  return canvas.picture();
}

} // namespace square_map

#endif // SQUARE_MAP_DRAW_THUMBNAIL_H
