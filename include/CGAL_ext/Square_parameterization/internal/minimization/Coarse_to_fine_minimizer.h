// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_COARSE_TO_FINE_MINIMIZER_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_COARSE_TO_FINE_MINIMIZER_H

#include <CGAL_ext/Square_parameterization/internal/minimization/Map_minimizer.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/Multilevel_minimizer.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/Shared_levels.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/check_maps.h>

#include <algorithm>
#include <memory>
#include <mutex>
#include <utility>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// maps by minimising the balanced energy, the objective, from coarse to fine; see `Multilevel_minimizer`
class Coarse_to_fine_minimizer : public Map_minimizer
{
public:
  /// \param deadline see `make_minimizer()`
  Coarse_to_fine_minimizer(const Patch& patch, const Balanced_minimization& minimization, const Deadline& deadline,
                           Coarsening coarsening)
    : Coarse_to_fine_minimizer(patch, minimization, deadline,
                               std::make_shared<Shared_levels>(patch, minimization, deadline, coarsening))
  {}

  /// on coarse patches that other minimizers use, too
  /// \pre these were made of the patch, with the same minimization but for the start, and with the same deadline
  Coarse_to_fine_minimizer(const Patch& patch, const Balanced_minimization& minimization, const Deadline& deadline,
                           std::shared_ptr<Shared_levels> levels)
    : m_patch(patch),
      m_minimization(minimization),
      m_deadline(deadline),
      m_levels(std::move(levels)),
      m_minimizer(m_levels->usual(), minimization, deadline)
  {}

  Worker make_worker() const override
  {
    return [this, workspace = std::make_shared<Multilevel_minimizer::Workspace>()](const Uv_coordinates& border_uv,
                                                                                   const Uv_coordinates* warm_start) {
      if(has_chord_on_a_side(m_patch, border_uv))
        return Minimized_map();
      Minimized_map map = m_minimizer.minimize(border_uv, *workspace, warm_start);
      return checked(map.uv.rows() == 0 ? map_with_whole_border(border_uv, map.work) : std::move(map));
    };
  }

  bool has_coarse_maps() const override { return true; }

  bool has_sketches() const override { return m_minimizer.has_sketches(); }

  Comparing_worker make_comparing_worker(Coarse_maps kind) const override
  {
    return [this, kind, workspace = std::make_shared<Multilevel_minimizer::Workspace>()](
               const Uv_coordinates& border_uv, const Uv_coordinates* warm_start, double limit) {
      return has_chord_on_a_side(m_patch, border_uv)
                 ? Minimized_map()
                 : m_minimizer.compare(kind, border_uv, *workspace, warm_start, limit);
    };
  }

  const Patch& coarse_patch(Coarse_maps kind) const override { return m_minimizer.coarse_patch(kind); }

  Minimized_map finish(Minimized_map map, double limit) const override
  {
    if(map.uv.rows() == 0)
      return map;
    Minimized_map finished = checked(m_minimizer.finish(map, limit));
    return finished.uv.rows() > 0 ? finished : map;
  }

  std::shared_ptr<const Map_minimizer> with_first_maps(const Stretch_minimization& start) const override
  {
    Balanced_minimization minimization = m_minimization;
    minimization.start = start;
    return std::make_shared<Coarse_to_fine_minimizer>(m_patch, minimization, m_deadline, m_levels);
  }

  Minimized_map map_border(const Uv_coordinates& border_uv) const override
  {
    return map_any_border(
        m_patch, border_uv, [this](const Uv_coordinates& unit) { return map_unit_border(unit); },
        [this](Minimized_map map) { return checked(std::move(map)); });
  }

  std::vector<double> circle_stretch() const override
  {
    return internal::circle_stretch(m_patch, Stretch_iteration(m_patch, m_minimization.start));
  }

private:
  /// maps for a border of area 1; one that is not the unit square does not slide
  Minimized_map map_unit_border(const Uv_coordinates& border_uv) const
  {
    const auto rows = border_uv.rowwise();
    const bool is_square = std::all_of(rows.begin(), rows.end(), is_on_unit_square);
    return finish(is_square || m_minimizer.keeps_border() ? make_worker()(border_uv, nullptr)
                                                          : checked(map_with_whole_border(border_uv, 0)),
                  NO_LIMIT);
  }

  /// what a coarse border has no room for, or would let slide, is mapped without. Without uv where the border is kept
  /// anyway, and when there is no time
  /// \param work_before what was tried in vain has cost, in vertices visited
  Minimized_map map_with_whole_border(const Uv_coordinates& border_uv, long work_before) const
  {
    if(m_minimizer.keeps_border() || has_passed(m_deadline)) {
      Minimized_map none;
      none.work = work_before;
      return none;
    }
    std::call_once(m_whole_border_made, [this] {
      m_whole_border =
          std::make_unique<Multilevel_minimizer>(m_levels->with_whole_border(), m_minimization, m_deadline);
    });
    Multilevel_minimizer::Workspace workspace;
    Minimized_map map = m_whole_border->minimize(border_uv, workspace, nullptr, work_before);
    map.work += work_before;
    map.warm_start.resize(0, 2); // a map of a patch that is not among those of the others
    return map;
  }

  Minimized_map checked(Minimized_map map) const
  {
    return if_one_to_one(m_patch, std::move(map),
                         [this](const Uv_coordinates& uv, double) { return m_minimizer.energy(uv); });
  }

  const Patch& m_patch;
  Balanced_minimization m_minimization;
  Deadline m_deadline;
  std::shared_ptr<Shared_levels> m_levels;
  Multilevel_minimizer m_minimizer;
  mutable std::once_flag m_whole_border_made;
  mutable std::unique_ptr<const Multilevel_minimizer> m_whole_border; // made when needed
};

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_COARSE_TO_FINE_MINIMIZER_H
