// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COARSENING_PATCH_SEQUENCE_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COARSENING_PATCH_SEQUENCE_H

#include <CGAL_ext/Square_parameterization/internal/coarsening/Coarsening.h>
#include <CGAL_ext/Square_parameterization/internal/coarsening/Patch_coarsener.h>
#include <CGAL_ext/Square_parameterization/internal/coarsening/coarse_border.h>
#include <CGAL_ext/Square_parameterization/internal/coarsening/is_mostly_border.h>
#include <CGAL_ext/Square_parameterization/internal/common/Minimizer_numbers.h>
#include <CGAL_ext/Square_parameterization/internal/patch/Patch_division.h>
#include <CGAL_ext/Square_parameterization/internal/patch/vertices_along_curve.h>

#include <initializer_list>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// a patch and ever coarser ones, each with half the interior vertices of the one before it, or seven eighths.
///
/// The border stays. Only where it would soon be most of a large patch it is made coarse, too: the corners of the
/// square are then stood for by other vertices, and a vertex that is put back slides from its neighbor into place.
class Patch_sequence
{
public:
  /// shares of the shape that triangles may lose; the later are tried where the first allow too little
  typedef std::initializer_list<std::optional<double>> Shapes_kept;

  typedef std::vector<Coarse_border> Borders; ///< per patch

  Patch_sequence(const Patch& patch, bool may_coarsen_border, Coarsening coarsening = Coarsening::BY_HALVES)
    : m_patch(patch),
      m_may_coarsen_border(may_coarsen_border),
      m_coarsening(coarsening),
      m_curve(Patch_division::is_large(patch) ? vertices_along_curve(patch.points) : std::vector<int>())
  {}

  std::size_t size() const { return 1 + m_coarse.size(); }

  /// the patch of a level: 0 is the given one
  const Patch& operator[](std::size_t level) const { return level == 0 ? m_patch : m_coarse[level - 1]->patch; }

  /// how to get from a level to the one before it. \pre level > 0
  const Coarse_patch& coarse(std::size_t level) const { return *m_coarse[level - 1]; }

  const Patch& coarsest() const { return (*this)[size() - 1]; }

  /// the vertices of the coarsest patch, those that are near each other one after the other (see `Patch_division`); none
  /// when the first patch is not large
  const std::vector<int>& curve() const { return m_curve; }

  /// adds a coarser patch; false when there is none
  /// \param shapes_kept that the last patch may lose
  bool add_coarser(Shapes_kept shapes_kept)
  {
    std::unique_ptr<Coarse_patch> next = coarsened(coarsest(), shapes_kept);
    if(!next)
      return false;
    std::vector<int> curve = m_curve.empty() ? std::vector<int>() : coarse_curve(m_curve, *next);
    m_coarse.push_back(std::move(next));
    m_curve = std::move(curve);
    return true;
  }

  /// adds patches as long as they get coarser
  void coarsen(Shapes_kept shapes_kept)
  {
    while(add_coarser(shapes_kept)) {
    }
  }

  /// leaves of a coarse patch its points and its border, which is all that putting vertices back needs: the memory of
  /// the faces and the edges is freed. \pre level > 0, and the patch is not the coarsest
  void forget_faces(std::size_t level)
  {
    Patch& patch = m_coarse[level - 1]->patch;
    Patch kept;
    kept.points = std::move(patch.points);
    kept.border = std::move(patch.border);
    kept.border_lengths = std::move(patch.border_lengths);
    kept.chords = std::move(patch.chords);
    kept.least_height = patch.least_height;
    kept.widened_height = patch.widened_height;
    kept.rounding = patch.rounding;
    patch = std::move(kept);
  }

  /// indicates whether all patches have the whole border
  bool keeps_border() const { return coarsest().border.size() == m_patch.border.size(); }

  /// the finest level with at most so many vertices; the coarsest when all have more
  std::size_t finest_with(int vertices) const
  {
    std::size_t level = 0;
    while((*this)[level].number_of_vertices() > vertices && level + 1 < size())
      ++level;
    return level;
  }

  /// the borders of the patches when that of the first is \p border_uv (#B by 2), as far as the four corners stay apart
  Borders borders(const Uv_coordinates& border_uv) const
  {
    Borders result;
    result.push_back(finest_border(border_uv));
    while(result.size() < size()) {
      auto border = coarse_border(coarse(result.size()), result.back());
      if(!border)
        break;
      result.push_back(std::move(*border));
    }
    return result;
  }

private:
  /// none when the patch is small or cannot be made coarser
  std::unique_ptr<Coarse_patch> coarsened(const Patch& patch, Shapes_kept shapes_kept) const
  {
    const int border = static_cast<int>(patch.border.size()), interior = patch.number_of_vertices() - border;
    if(interior <= Minimizer_numbers::COARSEST)
      return nullptr;
    const bool is_worth_while = patch.number_of_vertices() > Minimizer_numbers::LARGE || !keeps_border();
    const bool keeps = !m_may_coarsen_border || !is_worth_while || !is_mostly_border(patch);
    const int removable = keeps ? interior : interior + border;
    const int removed = number_to_remove(patch.number_of_vertices(), removable);
    for(const std::optional<double>& least_shape_kept : shapes_kept)
      try {
        Patch_coarsener coarsener(patch, least_shape_kept, keeps, most_waves(patch));
        auto coarse = std::make_unique<Coarse_patch>(coarsener(patch.number_of_vertices() - removed, m_curve));
        if(double(coarse->removals.size()) >= Minimizer_numbers::LEAST_REMOVED * removed)
          return coarse;
      } catch(const Unmappable&) {
        // too degenerate to be a patch: the finer one does without
      }
    return nullptr;
  }

  Most_waves most_waves(const Patch& patch) const
  {
    typedef Minimizer_numbers Numbers;
    const bool is_gradual = m_coarsening == Coarsening::BY_EIGHTHS;
    const bool is_large_polygon =
        is_mostly_border(m_patch) && m_patch.number_of_vertices() >= Numbers::LEAST_OF_FEW_WAVES;
    Most_waves result;
    if(is_mostly_border(patch) && (is_large_polygon || is_gradual))
      result.on_rims = Numbers::MOST_WAVES;
    if(is_gradual && !is_large_polygon) // of which some are stretched ten times as much
      result.anywhere = Numbers::MOST_WAVES_OF_GRADUAL;
    return result;
  }

  /// of so many vertices, of which so many can be removed: half of those, or an eighth, but not so few that patch after
  /// patch is as large as the one before, as they would be where hardly any vertex is left but those of the border
  int number_to_remove(int vertices, int removable) const
  {
    const bool is_gradual = m_coarsening == Coarsening::BY_EIGHTHS && vertices <= Minimizer_numbers::LARGEST_FACTORED;
    const int few = (std::max)(removable / 8, vertices / Minimizer_numbers::LARGEST_PART_KEPT);
    return is_gradual ? (std::min)(few, removable / 2) : removable / 2;
  }

  const Patch& m_patch;
  bool m_may_coarsen_border;
  Coarsening m_coarsening;
  std::vector<int> m_curve;
  std::vector<std::unique_ptr<Coarse_patch>> m_coarse;
};

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COARSENING_PATCH_SEQUENCE_H
