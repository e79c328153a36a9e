// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MAP_MINIMIZER_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MAP_MINIMIZER_H

#include <CGAL_ext/Square_parameterization/internal/Balanced_minimizer.h>
#include <CGAL_ext/Square_parameterization/internal/Stretch_iteration.h>
#include <CGAL_ext/Square_parameterization/internal/exact_orientation.h>

#include <functional>
#include <memory>
#include <utility>

namespace CGAL_ext {
namespace internal {

/// indicates whether an interior edge has both ends on one side of the square: its triangles would have no area
inline bool has_chord_on_a_side(const Patch& patch, const Uv_coordinates& border_uv)
{
  if(patch.chords.empty())
    return false;
  std::vector<int> position(patch.points.size(), -1);
  for(std::size_t k = 0; k < patch.border.size(); ++k)
    position[patch.border[k]] = static_cast<int>(k);
  for(const auto& [a, b] : patch.chords)
    for(int axis = 0; axis < 2; ++axis) {
      const double x = border_uv(position[a], axis);
      if(x == border_uv(position[b], axis) && (x == 0 || x == 1))
        return true;
    }
  return false;
}

/// maps one patch onto the unit square for any border there: the iteration of Yoshizawa et al., and, when a balance is
/// given, from its map on to the minimum of the balanced energy.
///
/// Constant after construction: each thread has a worker of its own. What is minimised is `Minimization_report::objective`.
class Map_minimizer
{
public:
  /// maps for one border (#B by 2). The result has no uv, and an infinite objective, unless the map is one-to-one by
  /// exact arithmetic.
  typedef std::function<Minimized_map(const Uv_coordinates& border_uv)> Worker;

  Map_minimizer(const Patch& patch, Stretch_iteration iteration) : m_patch(patch), m_iteration(std::move(iteration)) {}

  Map_minimizer(const Patch& patch, Stretch_iteration start, const Balanced_options& options)
    : m_patch(patch), m_iteration(std::move(start)), m_balanced(std::make_unique<Balanced_minimizer>(patch, options))
  {}

  Worker make_worker() const
  {
    return [this, workspace = std::make_shared<Workspace>()](const Uv_coordinates& border_uv) {
      if(has_chord_on_a_side(m_patch, border_uv))
        return Minimized_map();
      Minimized_map map = m_iteration.minimize(border_uv, 1, workspace->iteration);
      if(m_balanced && map.uv.rows() > 0)
        map = m_balanced->minimize(std::move(map.uv), workspace->balanced);
      if(map.uv.rows() > 0 && number_of_flipped_faces(m_patch.triangles, map.uv) > 0) {
        map.uv.resize(0, 2);
        map.report.l2 = map.report.objective = std::numeric_limits<double>::infinity();
      }
      return map;
    };
  }

  /// the iteration alone, for borders that are not on the square
  const Stretch_iteration& iteration() const { return m_iteration; }

private:
  struct Workspace
  {
    Stretch_iteration::Workspace iteration;
    Balanced_minimizer::Workspace balanced;
  };

  const Patch& m_patch;
  Stretch_iteration m_iteration;
  std::unique_ptr<Balanced_minimizer> m_balanced; // none for the iteration alone
};

} // namespace internal
} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MAP_MINIMIZER_H
