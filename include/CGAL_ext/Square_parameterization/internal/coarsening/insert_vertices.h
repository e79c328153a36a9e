// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COARSENING_INSERT_VERTICES_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COARSENING_INSERT_VERTICES_H

#include <CGAL_ext/Square_parameterization/internal/coarsening/Coarse_patch.h>
#include <CGAL_ext/Square_parameterization/internal/coarsening/mean_value_weights_in_ring.h>
#include <CGAL_ext/Square_parameterization/internal/common/Minimizer_numbers.h>
#include <CGAL_ext/Square_parameterization/internal/common/ranges.h>
#include <CGAL_ext/Square_parameterization/internal/energy/Vertex_star.h>
#include <CGAL_ext/Square_parameterization/internal/patch/point_in_kernel.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// puts a vertex where the energy of the triangles around it is low
class Vertex_insertion
{
public:
  /// \param may_use_mean_values false to begin in the middle of rings however bad that is
  Vertex_insertion(const Patch& patch, double balance, const Eigen::RowVector2d& to_rectangle, bool may_use_mean_values,
                   Uv_coordinates& uv)
    : m_patch(patch), m_star(balance, to_rectangle), m_may_use_mean_values(may_use_mean_values), m_uv(uv)
  {}

  /// puts an interior vertex into the middle of its ring, to its mean value coordinates where these are far better, as
  /// among slivers, or into the kernel of the ring, and then where the energy is low. Returns false when the kernel is
  /// lost in rounding.
  bool insert_inside(int vertex, const Vertex_ring& ring)
  {
    std::vector<Eigen::RowVector2d> ring_uv;
    Eigen::RowVector2d position(0, 0);
    set_star(vertex, ring, ring.size(), ring[0]);
    for(std::size_t i = 0; i < ring.size(); ++i) {
      ring_uv.push_back(m_uv.row(ring[i]));
      position += m_uv.row(ring[i]) / ring.size();
    }
    const double energy = m_star.energy(position);
    if(const auto better = far_better_mean_values(vertex, ring, energy))
      position = *better;
    else if(!std::isfinite(energy)) {
      const std::optional<Eigen::RowVector2d> seeing = point_in_kernel(ring_uv);
      if(!seeing || !std::isfinite(m_star.energy(*seeing)))
        return false;
      position = *seeing;
    }
    settle(vertex, position, {true, true});
    return true;
  }

  /// puts a border vertex on the side of the square between \p from, which sees all of \p ring when the vertex is close
  /// to it, and \p to: at its place by length, or nearer. Returns false when that is lost in rounding.
  bool insert_on_side(int vertex, const Vertex_ring& ring, int from, int to)
  {
    constexpr double LEAST_SHARE = Minimizer_numbers::LEAST_SHARE_OF_SIDE;
    set_star(vertex, ring, ring.size() - 1, from);
    const double length_from = (m_patch.points[from] - m_patch.points[vertex]).norm();
    const double length_to = (m_patch.points[to] - m_patch.points[vertex]).norm();
    const Eigen::RowVector2d side = m_uv.row(to) - m_uv.row(from);
    // the neighbors may be copies of the same vertex, on the two sides of a seam
    const double length = length_from + length_to;
    double share = length > 0 ? std::clamp(length_from / length, LEAST_SHARE, 1 - LEAST_SHARE) : 0.5;
    for(int i = 0; i < Minimizer_numbers::MAXIMUM_INSERTION_HALVINGS; ++i, share /= 2) {
      const Eigen::RowVector2d position = m_uv.row(from) + share * side;
      if(std::isfinite(m_star.energy(position))) {
        settle(vertex, position, {side.x() != 0, side.y() != 0});
        return true;
      }
    }
    return false;
  }

  /// indicates whether mean value coordinates were far better for one of the vertices
  bool has_used_mean_values() const { return m_has_used_mean_values; }

private:
  /// where the mean value coordinates of the vertex take it, if the energy is far below the given one there
  std::optional<Eigen::RowVector2d> far_better_mean_values(int vertex, const Vertex_ring& ring, double energy)
  {
    constexpr double FAR_BETTER = 0.5;
    if(!m_may_use_mean_values)
      return {};
    const Eigen::RowVector2d position = mean_value_position(vertex, ring);
    if(!(m_star.energy(position) < FAR_BETTER * energy))
      return {};
    m_has_used_mean_values = true;
    return position;
  }

  /// where the mean value coordinates of the vertex take it; not finite at a degenerate ring
  Eigen::RowVector2d mean_value_position(int vertex, const Vertex_ring& ring) const
  {
    const std::vector<double> weights = mean_value_weights_in_ring(m_patch.points, vertex, ring);
    Eigen::RowVector2d position(0, 0);
    double sum = 0;
    for(std::size_t i = 0; i < ring.size(); ++i) {
      position += weights[i] * m_uv.row(ring[i]);
      sum += weights[i];
    }
    return position / sum;
  }

  /// \param triangles the number of them between vertices of the ring that follow each other
  void set_star(int vertex, const Vertex_ring& ring, std::size_t triangles, int origin)
  {
    m_star.set(m_uv.row(origin), triangles, [&](std::size_t i) {
      const int a = ring[i], b = ring[(i + 1) % ring.size()];
      return Triangle_pair(corner_shape(shape_between(m_patch, vertex, a, b), 0), m_uv.row(a), m_uv.row(b));
    });
  }

  void settle(int vertex, Eigen::RowVector2d position, const std::array<bool, 2>& is_free)
  {
    for(int i = 0; i < Minimizer_numbers::INSERTION_STEPS && m_star.improve(position, is_free); ++i) {
    }
    m_uv.row(vertex) = position;
  }

  const Patch& m_patch;
  Vertex_star m_star;
  bool m_may_use_mean_values, m_has_used_mean_values = false;
  Uv_coordinates& m_uv;
};

/// puts the vertex of removal \p i back; false when it is lost in rounding. The removal is not that of a corner.
inline bool insert_vertex(const Coarse_patch& coarse, std::size_t i, Vertex_insertion& insertion)
{
  const Coarse_patch::Removal& removal = coarse.removals[i];
  const Vertex_ring ring = coarse.ring(removal);
  if(!removal.is_on_border())
    return insertion.insert_inside(removal.vertex, ring);
  return insertion.insert_on_side(removal.vertex, ring, removal.target,
                                  ring[0] == removal.target ? ring.back() : ring[0]);
}

/// the same for the removal of a corner: it gets its place back, and the vertex that stood there moves on
inline bool insert_corner(const Coarse_patch& coarse, std::size_t i, Vertex_insertion& insertion, Uv_coordinates& uv)
{
  const Coarse_patch::Removal& removal = coarse.removals[i];
  const Vertex_ring ring = coarse.target_ring(removal);
  uv.row(removal.vertex) = uv.row(removal.target);
  return insertion.insert_on_side(removal.target, ring, removal.vertex,
                                  ring[0] == removal.vertex ? ring.back() : ring[0]);
}

/// a map with all vertices put back, if none was lost in rounding
struct Insertion
{
  std::optional<Uv_coordinates> uv;
  bool has_used_mean_values;
};

/// `insert_vertices()`, with vertices at their mean value coordinates where these are far better, or without
inline Insertion try_to_insert_vertices(const Patch& fine, const Coarse_patch& coarse, const Uv_coordinates& coarse_uv,
                                        const std::vector<std::size_t>& removed_corners, double balance,
                                        const Eigen::RowVector2d& to_rectangle, bool may_use_mean_values)
{
  constexpr std::size_t VERTICES_AT_A_TIME = 512;
  Uv_coordinates uv(fine.number_of_vertices(), 2);
  for(std::size_t v = 0; v < coarse.fine_vertex.size(); ++v)
    uv.row(coarse.fine_vertex[v]) = coarse_uv.row(v);
  std::atomic<bool> is_lost{false}, has_used_mean_values{false};
  if(removed_corners.empty()) {
    for(std::size_t wave = 0; wave < coarse.waves.size() && !is_lost; ++wave) {
      const std::size_t first = coarse.waves.first[wave];
      for_ranges(
          coarse.waves.first[wave + 1] - first,
          [&](std::size_t begin, std::size_t end) {
            Vertex_insertion insertion(fine, balance, to_rectangle, may_use_mean_values, uv);
            for(std::size_t i = begin; i < end && !is_lost; ++i)
              if(!insert_vertex(coarse, coarse.waves.removals[first + i], insertion))
                is_lost = true;
            if(insertion.has_used_mean_values())
              has_used_mean_values = true;
          },
          VERTICES_AT_A_TIME);
    }
  } else {
    Vertex_insertion insertion(fine, balance, to_rectangle, may_use_mean_values, uv);
    for(std::size_t i = coarse.removals.size(); i-- > 0 && !is_lost;)
      is_lost = !(std::binary_search(removed_corners.begin(), removed_corners.end(), i)
                      ? insert_corner(coarse, i, insertion, uv)
                      : insert_vertex(coarse, i, insertion));
    has_used_mean_values = insertion.has_used_mean_values();
  }
  return {is_lost ? std::nullopt : std::optional(std::move(uv)), has_used_mean_values};
}

/// puts the vertices that a coarse patch left out back into its map, in the reverse order. That is always possible: the
/// vertex that took the place of another saw the whole ring. A corner of the square that was left out gets its place
/// back, and the vertex that stood there moves on.
///
/// Where no vertex moves on, those of a wave are put back at a time, by the threads of the current team. Where one is
/// lost in rounding all begin again without mean value coordinates, which may lead close to an edge.
///
/// \param coarse_uv a map of \p coarse without flips
/// \param to_rectangle what takes the unit square to the rectangle of the energy
/// \param removed_corners of the border of \p coarse: places in its removals, ascending
/// \return a map of \p fine without flips; none when one is lost in rounding
inline std::optional<Uv_coordinates> insert_vertices(const Patch& fine, const Coarse_patch& coarse,
                                                     const Uv_coordinates& coarse_uv,
                                                     const std::vector<std::size_t>& removed_corners, double balance,
                                                     const Eigen::RowVector2d& to_rectangle = {1, 1})
{
  const auto insert = [&](bool may_use_mean_values) {
    return try_to_insert_vertices(fine, coarse, coarse_uv, removed_corners, balance, to_rectangle, may_use_mean_values);
  };
  Insertion first = insert(true);
  return first.uv || !first.has_used_mean_values ? std::move(first.uv) : insert(false).uv;
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COARSENING_INSERT_VERTICES_H
