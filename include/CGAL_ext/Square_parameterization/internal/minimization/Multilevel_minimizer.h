// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_MULTILEVEL_MINIMIZER_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_MULTILEVEL_MINIMIZER_H

#include <CGAL_ext/Square_parameterization/internal/border/shift_border.h>
#include <CGAL_ext/Square_parameterization/internal/common/Minimizer_numbers.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/Coarse_maps.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/Minimizer_levels.h>

#include <cstddef>
#include <deque>
#include <limits>
#include <memory>
#include <optional>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

class Coarse_to_fine_descent;

/// minimises the balanced energy from coarse to fine: maps the coarsest of a sequence of ever coarser patches by the
/// iteration of Yoshizawa et al.; then, patch by patch, minimises, puts vertices back, and smooths by sweeps.
///
/// Constant after construction: several threads may call `minimize()`, each with a workspace of its own.
class Multilevel_minimizer
{
public:
  /// the memory of one thread
  typedef Minimizer_levels::Workspace Workspace;

  /// \param may_coarsen_border false for maps onto other borders than the unit square, too
  /// \param deadline when it has passed no patch is minimised any more: a map that is begun goes down to the finest
  ///        patch by sweeps alone
  explicit Multilevel_minimizer(const Patch& patch, const Balanced_minimization& options = {},
                                bool may_coarsen_border = true, const Deadline& deadline = {},
                                Coarsening coarsening = Coarsening::BY_HALVES);

  /// the same on patches that other minimizers use, too
  /// \pre these were made with the same options but for the start
  Multilevel_minimizer(std::shared_ptr<const Minimizer_levels> levels, const Balanced_minimization& options,
                       const Deadline& deadline);

  /// maps for the border \p border_uv (#B by 2), to the tolerance of a search. The result has no uv when no map without
  /// flips was found to start from: for want of room, too, where the corners are close together and `keeps_border()` is
  /// false.
  /// \pre the border is on the unit square, or `keeps_border()`
  /// \param warm_start of a map or a sketch for a similar border, the map of one of the coarse patches; it saves the
  ///        coarser ones. May be null.
  /// \param work_before what a map for this border has cost in vain, in vertices visited
  Minimized_map minimize(const Uv_coordinates& border_uv, Workspace& workspace,
                         const Uv_coordinates* warm_start = nullptr, long work_before = 0) const;

  /// indicates whether the coarse patches have the border of the patch
  bool keeps_border() const { return patches().keeps_border(); }

  /// indicates whether the patch is so large that sketches save time
  bool has_sketches() const
  {
    const int vertices = patches()[0].number_of_vertices();
    const int sketched = patches()[m_levels->sketched()].number_of_vertices();
    return vertices >= Minimizer_numbers::SMALLEST_SKETCHED &&
           Minimizer_numbers::LEAST_SKETCH_RATIO * sketched <= vertices;
  }

  /// the patch that is mapped to compare borders: the very one that was given where it is small, or cannot be made coarser
  const Patch& coarse_patch(Coarse_maps kind) const { return patches()[level_of(kind)]; }

  /// the least energy of one of the patches for the border \p border_uv, by which borders can be compared: what
  /// the finer patches save is much the same for all. Without uv, and infinite when no map was found.
  /// \param warm_start of such a map of the same kind for a similar border; may be null
  /// \param limit an energy above it is found less exactly
  Minimized_map compare(Coarse_maps kind, const Uv_coordinates& border_uv, Workspace& workspace,
                        const Uv_coordinates* warm_start = nullptr,
                        double limit = std::numeric_limits<double>::infinity()) const;

  /// continues with a map of `minimize()`, to the tolerance of the map that is delivered, and settles it
  /// \param limit one whose energy will stay above it is left on its way; its energy is about what it would come to
  Minimized_map finish(Minimized_map map, double limit = std::numeric_limits<double>::infinity()) const;

  /// what is minimised, of a map
  double energy(const Uv_coordinates& uv) const
  {
    return Balanced_energy(patches()[0], m_options.balance, m_options.aspect)(uv);
  }

private:
  const Patch_sequence& patches() const { return m_levels->patches(); }

  /// indicates whether few maps are made of the patch: while the coarser ones are at hand, the first minimization is the last
  bool is_large() const { return patches()[0].number_of_vertices() > Minimizer_numbers::LARGEST_FACTORED; }

  std::size_t level_of(Coarse_maps kind) const
  {
    switch(kind) {
    case Coarse_maps::SKETCHES:
      return m_levels->sketched();
    case Coarse_maps::ROUGH:
      return m_levels->rough();
    default:
      return m_levels->first_moves();
    }
  }

  /// without uv when the map cannot be carried over
  Minimized_map compare_from(std::size_t level, const Uv_coordinates& warm_start, double limit,
                             const Uv_coordinates& border_uv, Workspace& workspace) const;

  /// the level of a warm start, of which its size tells: each patch is smaller than the one before it
  std::optional<std::size_t> level_of_warm_start(const Uv_coordinates& warm_start) const
  {
    for(const std::size_t level : m_levels->carried_over())
      if(patches()[level].number_of_vertices() == warm_start.rows())
        return level;
    return std::nullopt;
  }

  /// the map of the patch of one level for another border; without rows when rounding flips a triangle
  Uv_coordinates transport(std::size_t level, const Uv_coordinates& uv, const Uv_coordinates& border_uv,
                           Workspace& workspace) const
  {
    const Patch& patch = patches()[level];
    const bool slides = m_options.border == Border_motion::SLIDING;
    const Uv_coordinates shifted = slides ? shift_border(patch, uv, border_uv) : border_uv;
    if(is_border_of(patch, shifted, uv))
      return uv;
    return m_levels->transport(level)(uv, shifted, workspace.transports[level]);
  }

  static bool is_border_of(const Patch& patch, const Uv_coordinates& border_uv, const Uv_coordinates& uv)
  {
    for(std::size_t k = 0; k < patch.border.size(); ++k)
      if(border_uv.row(k) != uv.row(patch.border[k]))
        return false;
    return true;
  }

  /// what is returned when no way leads to a map: searches count what they have cost, too
  static Minimized_map without_map(const Coarse_to_fine_descent& descent);

  /// the map of the patch of a level to the tolerance of a search, made of one that is ready to be minimised
  Minimized_map map_to_compare(std::size_t level, Uv_coordinates uv, Workspace& workspace,
                               const Coarse_to_fine_descent& descent) const;

  std::shared_ptr<const Minimizer_levels> m_levels;
  std::deque<Stretch_iteration> m_first_maps; // of the patches where ways begin
  Balanced_minimization m_options;
  Deadline m_deadline;
};

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#ifndef CGAL_EXT_COMPILED_CORE
#include <CGAL_ext/Square_parameterization/internal/minimization/Multilevel_minimizer_impl.h>
#endif

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_MULTILEVEL_MINIMIZER_H
