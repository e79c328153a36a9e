// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_ITERATION_MINIMIZER_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_ITERATION_MINIMIZER_H

#include <CGAL_ext/Square_parameterization/internal/minimization/Map_minimizer.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/check_maps.h>

#include <memory>
#include <utility>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// maps by the iteration of Yoshizawa et al.: the objective is the L2 stretch. Has neither sketches nor warm starts.
class Iteration_minimizer : public Map_minimizer
{
public:
  /// \param deadline see `make_minimizer()`
  Iteration_minimizer(const Patch& patch, const Stretch_minimization& minimization, const Deadline& deadline,
                      Linear_solver_factory make_solver)
    : m_patch(patch), m_iteration(patch, minimization, std::move(make_solver), deadline)
  {}

  Worker make_worker() const override
  {
    return [this, workspace = std::make_shared<Stretch_iteration::Workspace>()](const Uv_coordinates& border_uv,
                                                                                const Uv_coordinates*) {
      if(has_chord_on_a_side(m_patch, border_uv))
        return Minimized_map();
      return checked(m_iteration.minimize(border_uv, 1, *workspace));
    };
  }

  bool has_coarse_maps() const override { return false; }
  bool has_sketches() const override { return false; }
  Comparing_worker make_comparing_worker(Coarse_maps) const override { return {}; }
  const Patch& coarse_patch(Coarse_maps) const override { return m_patch; }

  /// a map of a worker is ready
  Minimized_map finish(Minimized_map map, double) const override { return map; }

  std::shared_ptr<const Map_minimizer> with_first_maps(const Stretch_minimization&) const override { return nullptr; }

  Minimized_map map_border(const Uv_coordinates& border_uv) const override
  {
    return map_any_border(
        m_patch, border_uv, [this](const Uv_coordinates& unit) { return make_worker()(unit, nullptr); },
        [this](Minimized_map map) { return checked(std::move(map)); });
  }

  std::vector<double> circle_stretch() const override { return internal::circle_stretch(m_patch, m_iteration); }

private:
  Minimized_map checked(Minimized_map map) const
  {
    return if_one_to_one(m_patch, std::move(map), [](const Uv_coordinates&, double l2) { return l2; });
  }

  const Patch& m_patch;
  Stretch_iteration m_iteration;
};

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_ITERATION_MINIMIZER_H
