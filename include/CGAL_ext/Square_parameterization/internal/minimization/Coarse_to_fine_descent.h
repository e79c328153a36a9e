// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_COARSE_TO_FINE_DESCENT_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_COARSE_TO_FINE_DESCENT_H

#include <CGAL_ext/Square_parameterization/internal/coarsening/insert_vertices.h>
#include <CGAL_ext/Square_parameterization/internal/common/Minimizer_numbers.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/Minimizer_levels.h>

#include <algorithm>
#include <cstddef>
#include <deque>
#include <limits>
#include <utility>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// one way from a coarse patch to the finest, or to a sketch: patch by patch minimises, puts vertices back, and smooths by
/// sweeps. Ways that lead to a hopeless map are given up, and taken up again when none is better; one that leads to a lost map
/// of a coarse border is abandoned.
class Coarse_to_fine_descent
{
public:
  /// \param first_maps of the patches of `levels.starts()`, in their order
  /// \param borders of the patches, for the map that is wanted
  /// \param workspace that is prepared
  /// \param work_before what the same map has cost in vain, in vertices visited
  Coarse_to_fine_descent(const Minimizer_levels& levels, const std::deque<Stretch_iteration>& first_maps,
                         const Patch_sequence::Borders& borders, Minimizer_levels::Workspace& workspace,
                         long work_before = 0)
    : m_levels(levels), m_first_maps(first_maps), m_borders(borders), m_workspace(workspace), m_work_before(work_before)
  {}

  /// what it has cost so far, in vertices visited
  long work() const { return m_work; }

  /// indicates whether the map has cost much, and is hopeless or a second try: few steps are spent on it
  bool is_lost() const
  {
    return (m_energy > Minimizer_numbers::HOPELESS || m_work_before > 0) &&
           m_work_before + m_work > m_levels.most_hopeless_work();
  }

  /// indicates whether it has come to a map that is lost, of a patch as fine as that of sketches: the one with the whole
  /// border may have one that is not
  bool is_abandoned() const { return m_is_abandoned; }

  /// the map of the warm level, if that was passed; it is moved out
  Uv_coordinates take_warm_start() { return std::move(m_warm_start); }

  /// a map of the patch of level \p to, from the first start that works well, or else goes on with the best of those
  /// that were given up; without rows when none works
  Uv_coordinates start(std::size_t to)
  {
    Uv_coordinates uv;
    const auto& starts = m_levels.starts();
    const auto may_start = [&](std::size_t i) { return i < starts.size() && starts[i] < m_borders.size(); };
    for(std::size_t i = 0; may_start(i) && uv.rows() == 0 && !m_is_abandoned; ++i)
      uv = refine(starts[i], to, first_map(m_first_maps[i], m_borders[starts[i]].uv, m_workspace.starts[i]));
    return uv.rows() == 0 && !m_is_abandoned ? resume(to) : uv;
  }

  /// the map of an iteration, whose work is counted; without rows when there is none
  Uv_coordinates first_map(const Stretch_iteration& iteration, const Uv_coordinates& border_uv,
                           Stretch_iteration::Workspace& workspace)
  {
    Minimized_map map = iteration.minimize(border_uv, 1, workspace);
    m_work += map.work;
    return std::move(map.uv);
  }

  /// brings a map of the patch of one level to that of another, ready to be minimised; without rows when a triangle is
  /// lost in rounding, when the way is given up, or when \p uv has none
  Uv_coordinates refine(std::size_t level, std::size_t to, Uv_coordinates uv)
  {
    const Patch_sequence& patches = m_levels.patches();
    for(; level > to && uv.rows() > 0; --level) {
      if(m_levels.is_factored(level) && level + 1 < patches.size())
        m_workspace.levels[level + 1].preconditioner.factors.reset();
      const Balanced_minimizer& minimizer = m_levels.minimizer(level);
      m_work += minimizer.relax(uv);
      Minimized_map map = minimizer.minimize({std::move(uv), {}, {}}, Minimizer_numbers::COARSE_TOLERANCE,
                                             {most_iterations(level)}, m_workspace.levels[level]);
      m_workspace.levels[level].end_steps();
      m_work += map.work;
      m_energy = map.report.objective;
      const bool is_fine = level <= m_levels.sketched(); // coarser ones may be led out of it
      m_is_abandoned = is_fine && !patches.keeps_border() && m_energy > Minimizer_numbers::LOST_RESULT;
      if(m_is_abandoned)
        return Uv_coordinates();
      const bool is_early =
          patches[level].number_of_vertices() < Minimizer_numbers::LARGEST_GIVEN_UP * patches[to].number_of_vertices();
      if(is_early && m_energy > m_largest_energy) {
        m_given_up.push_back({level, std::move(map.uv), m_energy});
        return Uv_coordinates();
      }
      keep_warm_start(level, map.uv);
      uv = insert(level, map.uv);
    }
    return uv;
  }

private:
  /// the minimised map of the patch of one level
  struct Level_map
  {
    std::size_t level;
    Uv_coordinates uv;
    double energy;
  };

  /// steps on the patch of one level, at most
  unsigned int most_iterations(std::size_t level) const
  {
    const Patch_sequence& patches = m_levels.patches();
    if(is_lost())
      return Minimizer_numbers::ITERATIONS_OF_LOST_MAP;
    if(m_levels.is_start(level))
      return Minimizer_numbers::COARSE_ITERATIONS;
    const int coarser = patches[level + 1].number_of_vertices();
    const bool is_small_refinement =
        coarser >= Minimizer_numbers::LEAST_REFINED &&
        patches[level].number_of_vertices() < Minimizer_numbers::SMALL_REFINEMENT * coarser;
    return is_small_refinement ? Minimizer_numbers::ITERATIONS_OF_SMALL_REFINEMENT
                               : Minimizer_numbers::COARSE_ITERATIONS;
  }

  /// goes on from the maps that were given up, the best first, until one arrives
  Uv_coordinates resume(std::size_t to)
  {
    std::vector<Level_map> given_up = std::move(m_given_up);
    std::stable_sort(given_up.begin(), given_up.end(),
                     [](const Level_map& a, const Level_map& b) { return a.energy < b.energy; });
    m_largest_energy = std::numeric_limits<double>::infinity();
    Uv_coordinates uv;
    for(std::size_t i = 0; i < given_up.size() && uv.rows() == 0 && !m_is_abandoned; ++i) {
      const std::size_t level = given_up[i].level;
      keep_warm_start(level, given_up[i].uv);
      uv = refine(level - 1, to, insert(level, given_up[i].uv));
    }
    return uv;
  }

  void keep_warm_start(std::size_t level, const Uv_coordinates& uv)
  {
    if(level == m_levels.warm())
      m_warm_start = uv;
  }

  /// puts the vertices of the next finer patch back; without rows when a triangle is lost in rounding
  Uv_coordinates insert(std::size_t level, const Uv_coordinates& uv) const
  {
    const Patch_sequence& patches = m_levels.patches();
    auto finer = insert_vertices(patches[level - 1], patches.coarse(level), uv, m_borders[level].removed_corners,
                                 m_levels.coarse_balance(), m_levels.minimizer(level).scale(uv));
    return finer ? std::move(*finer) : Uv_coordinates();
  }

  const Minimizer_levels& m_levels;
  const std::deque<Stretch_iteration>& m_first_maps;
  const Patch_sequence::Borders& m_borders;
  Minimizer_levels::Workspace& m_workspace;
  double m_largest_energy = Minimizer_numbers::HOPELESS;
  std::vector<Level_map> m_given_up; // maps whose energy was larger
  Uv_coordinates m_warm_start;       // the map of one of the patches on the way
  double m_energy = 0;               // of the last map
  bool m_is_abandoned = false;
  const long m_work_before; // in vertices visited, as the next
  long m_work = 0;
};

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_COARSE_TO_FINE_DESCENT_H
