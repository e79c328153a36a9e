// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COARSENING_PATCH_COARSENER_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COARSENING_PATCH_COARSENER_H

#include <CGAL_ext/Square_parameterization/internal/coarsening/Coarse_patch.h>
#include <CGAL_ext/Square_parameterization/internal/coarsening/Vertex_collapses.h>
#include <CGAL_ext/Square_parameterization/internal/common/Minimizer_numbers.h>

#include <limits>
#include <optional>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// makes coarse patches, by `Vertex_collapses`: the surface stays a disk
class Patch_coarsener
{
public:
  /// \param least_shape_kept, \param keeps_border, \param most_waves see `Vertex_collapses`
  explicit Patch_coarsener(const Patch& fine, std::optional<double> least_shape_kept = Minimizer_numbers::SHAPE_KEPT,
                           bool keeps_border = true, const Most_waves& most_waves = {})
    : m_fine(fine), m_collapses(fine.points, fine.triangles, {fine.border}, least_shape_kept, keeps_border, most_waves)
  {}

  /// collapses until \p target vertices are left, or no vertex can go. To be called once.
  /// Throws `Unmappable` when the coarse patch is degenerate.
  /// \param curve, \param vertices_at_a_time see `Vertex_collapses`
  Coarse_patch operator()(int target, const std::vector<int>& curve = {},
                          int vertices_at_a_time = Minimizer_numbers::VERTICES_COARSENED_AT_A_TIME)
  {
    Coarse_patch coarse;
    m_collapses(target, curve, vertices_at_a_time, coarse);
    coarse.removals.shrink_to_fit();
    coarse.rings.shrink_to_fit();
    gather(coarse);
    coarse.waves = waves_of(coarse, m_fine.number_of_vertices());
    return coarse;
  }

private:
  void gather(Coarse_patch& coarse) const
  {
    const Collapsible_surface& left = m_collapses.surface();
    const std::vector<int> place = left.places();
    coarse.fine_vertex = left.vertices();
    coarse.patch = make_patch(left.points(), left.triangles(place), gather_border(place, coarse));
  }

  /// the border of the coarse patch; tells the patch of the fine one
  /// \param place of the vertices that are left, in the coarse patch
  std::vector<int> gather_border(const std::vector<int>& place, Coarse_patch& coarse) const
  {
    std::vector<int> border, place_on_border(m_fine.points.size(), -1), removal(m_fine.points.size(), -1);
    for(std::size_t k = 0; k < m_fine.border.size(); ++k)
      if(const int v = m_fine.border[k]; place[v] >= 0) {
        place_on_border[v] = static_cast<int>(border.size());
        border.push_back(place[v]);
        coarse.fine_places.push_back(static_cast<int>(k));
      }
    for(std::size_t i = 0; i < coarse.removals.size(); ++i)
      removal[coarse.removals[i].vertex] = static_cast<int>(i);
    for(int v : m_fine.border) // what it was collapsed into is left: a target stays
      coarse.fine_border.push_back(
          {place_on_border[removal[v] < 0 ? v : coarse.removals[removal[v]].target], removal[v]});
    return border;
  }

  const Patch& m_fine;
  Vertex_collapses m_collapses;
};

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COARSENING_PATCH_COARSENER_H
