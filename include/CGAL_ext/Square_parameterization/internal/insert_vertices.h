// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_INSERT_VERTICES_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_INSERT_VERTICES_H

#include <CGAL_ext/Square_parameterization/internal/Coarse_patch.h>
#include <CGAL_ext/Square_parameterization/internal/Vertex_star.h>

#include <optional>
#include <vector>

namespace CGAL_ext {
namespace internal {

/// twice the signed area of triangle `pqr`
inline double twice_area(const Eigen::RowVector2d& p, const Eigen::RowVector2d& q, const Eigen::RowVector2d& r)
{
  return (q.x() - p.x()) * (r.y() - p.y()) - (q.y() - p.y()) * (r.x() - p.x());
}

/// a point well inside the kernel of a counter-clockwise polygon, the set of points that see all of it; none when the
/// kernel is lost in rounding
inline std::optional<Eigen::RowVector2d> point_in_kernel(const std::vector<Eigen::RowVector2d>& polygon)
{
  Eigen::AlignedBox2d box;
  for(const Eigen::RowVector2d& p : polygon)
    box.extend(p.transpose());
  const Eigen::Vector2d low = box.min(), high = box.max();
  std::vector<Eigen::RowVector2d> kernel{Eigen::RowVector2d(low.x(), low.y()), Eigen::RowVector2d(high.x(), low.y()),
                                         Eigen::RowVector2d(high.x(), high.y()), Eigen::RowVector2d(low.x(), high.y())};
  for(std::size_t i = 0; i < polygon.size(); ++i) { // cuts off what is right of side i
    const Eigen::RowVector2d &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    std::vector<Eigen::RowVector2d> rest;
    for(std::size_t j = 0; j < kernel.size(); ++j) {
      const Eigen::RowVector2d &p = kernel[j], &q = kernel[(j + 1) % kernel.size()];
      const double at_p = twice_area(a, b, p), at_q = twice_area(a, b, q);
      if(at_p >= 0)
        rest.push_back(p);
      if((at_p > 0 && at_q < 0) || (at_p < 0 && at_q > 0))
        rest.push_back(p + at_p / (at_p - at_q) * (q - p));
    }
    kernel.swap(rest);
    if(kernel.size() < 3)
      return {};
  }
  Eigen::RowVector2d center(0, 0);
  for(const Eigen::RowVector2d& p : kernel)
    center += p / kernel.size();
  return center;
}

/// puts the vertices that a coarse patch left out back into its map, in the reverse order: each into the middle of its
/// ring, or into the kernel of the ring, and then where the energy of its triangles is low. The kernel is never empty:
/// the vertex that took its place sees the whole ring.
///
/// \param coarse_uv a map of \p coarse without flips
/// \return a map of \p fine without flips; none when a kernel is lost in rounding
inline std::optional<Uv_coordinates> insert_vertices(const Patch& fine, const Coarse_patch& coarse,
                                                     const Uv_coordinates& coarse_uv, double balance)
{
  constexpr int LOCAL_STEPS = 8;
  Uv_coordinates uv(fine.number_of_vertices(), 2);
  for(std::size_t v = 0; v < coarse.fine_vertex.size(); ++v)
    uv.row(coarse.fine_vertex[v]) = coarse_uv.row(v);
  Vertex_star star(balance);
  std::vector<Eigen::RowVector2d> ring_uv;
  for(auto removal = coarse.removals.rbegin(); removal != coarse.removals.rend(); ++removal) {
    const std::vector<int>& ring = removal->ring;
    ring_uv.clear();
    star.clear(uv.row(ring[0]));
    Eigen::RowVector2d position(0, 0);
    for(std::size_t i = 0; i < ring.size(); ++i) {
      const int a = ring[i], b = ring[(i + 1) % ring.size()];
      ring_uv.push_back(uv.row(a));
      position += uv.row(a) / ring.size();
      const Flat_triangle shape = shape_between(fine, removal->vertex, a, b);
      star.add(corner_shape(shape, 0), uv.row(a), uv.row(b));
    }
    if(!std::isfinite(star.energy(position))) {
      const std::optional<Eigen::RowVector2d> seeing = point_in_kernel(ring_uv);
      if(!seeing || !std::isfinite(star.energy(*seeing)))
        return {};
      position = *seeing;
    }
    for(int i = 0; i < LOCAL_STEPS && star.improve(position, {true, true}); ++i) {
    }
    uv.row(removal->vertex) = position;
  }
  return uv;
}

} // namespace internal
} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_INSERT_VERTICES_H
