// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_MINIMIZER_LEVELS_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_MINIMIZER_LEVELS_H

#include <CGAL_ext/Square_parameterization/internal/coarsening/Patch_sequence.h>
#include <CGAL_ext/Square_parameterization/internal/common/Minimizer_numbers.h>
#include <CGAL_ext/Square_parameterization/internal/iteration/Stretch_iteration.h>
#include <CGAL_ext/Square_parameterization/internal/iteration/transport_map.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/Balanced_minimizer.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/is_to_be_factored.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <deque>
#include <memory>
#include <optional>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// a patch, ever coarser copies of it, and what minimises maps of each; level 0 is the patch itself.
///
/// The first map of a patch with long protrusions or passages, as many holes and handles leave them, has triangles too
/// tiny for floating-point numbers, and folded surfaces are not made coarse enough to avoid that. Then patches follow
/// that do not keep the shape of the surface, down to one whose first map is sound: all that is needed from them is a
/// start.
///
/// Constant after construction. The patches and their minimizers depend neither on the places of the border vertices nor on
/// how first maps are made, and serve all maps.
class Minimizer_levels
{
public:
  /// the memory of one thread
  struct Workspace
  {
    std::deque<Stretch_iteration::Workspace> starts;  // they cannot be moved
    std::deque<Balanced_minimizer::Workspace> levels; // nor these
    std::vector<Map_transport::Workspace> transports;
  };

  /// \param may_coarsen_border false for maps onto other borders than the unit square, too
  /// \param deadline when it has passed no patch is minimised any more
  Minimizer_levels(const Patch& patch, const Balanced_minimization& options, bool may_coarsen_border,
                   const Deadline& deadline, Coarsening coarsening)
    : m_patches(patch, may_coarsen_border && options.border == Border_motion::SLIDING, coarsening)
  {
    m_coarse_balance = (std::max)(options.balance, Minimizer_numbers::LEAST_COARSE_BALANCE);
    make_levels(options, deadline);
    Thread_team::current()(m_patches.size(), [this](std::size_t level) {
      if(!is_factored(level))
        m_minimizers[level]->set_coarser(m_patches.coarse(level + 1), *m_minimizers[level + 1]);
    });
    m_transports.resize(m_patches.size());
    for(std::size_t level : carried_over())
      if(!m_transports[level])
        m_transports[level] = std::make_unique<Map_transport>(m_patches[level]);
    for(std::size_t level = 1; level < m_patches.size(); ++level)
      if(m_minimizers[level]->has_own_faces() && !m_transports[level] && !is_start(level))
        m_patches.forget_faces(level);
  }

  const Patch_sequence& patches() const { return m_patches; }
  const Balanced_minimizer& minimizer(std::size_t level) const { return *m_minimizers[level]; }

  /// indicates whether first maps are made of the patch
  bool is_start(std::size_t level) const
  {
    return std::find(m_starts.begin(), m_starts.end(), level) != m_starts.end();
  }

  /// the patch whose maps are warm starts
  std::size_t warm() const { return m_warm; }

  /// the patch on which candidates are compared
  std::size_t sketched() const { return m_sketched; }

  /// a patch so small that hundreds of maps of it are compared
  std::size_t rough() const { return m_rough; }

  /// the patch on which corners are moved first: the rough one, or, where they are moved twice, a smaller one
  std::size_t first_moves() const { return m_first_moves; }

  /// these levels: their maps are carried over to other borders
  std::array<std::size_t, 4> carried_over() const { return {m_warm, m_sketched, m_rough, m_first_moves}; }

  /// carries maps of one of these levels over
  const Map_transport& transport(std::size_t level) const { return *m_transports[level]; }

  /// the levels of first maps: the coarsest patch that keeps its shape, and the coarsest
  const std::vector<std::size_t>& starts() const { return m_starts; }

  /// of the energy that is minimised on coarse patches
  double coarse_balance() const { return m_coarse_balance; }

  /// indicates whether the matrices of a patch are factored; else the coarser patches take the place of factors
  bool is_factored(std::size_t level) const { return m_minimizers[level]->is_factored(); }

  /// what the steps on the map that is delivered may cost, in vertices visited, where it is hopeless
  long most_final_work() const { return final_work_of((std::max)(number_of_vertices(), least_final_vertices())); }

  /// the same where much was spent before
  long least_final_work() const
  {
    return final_work_of((std::max)(number_of_vertices(), long(Minimizer_numbers::FINAL_VERTICES))) / 4;
  }

  /// the same where it is not hopeless
  long usual_final_work() const
  {
    const long more = (std::max)(number_of_vertices() - Minimizer_numbers::FINAL_VERTICES, 0L);
    return final_work_of(least_final_vertices()) + Minimizer_numbers::MOST_FINAL_SWEEPS_OF_MORE * more;
  }

  /// what a map may cost that is hopeless, in vertices visited, until few steps are spent on it
  long most_hopeless_work() const
  {
    const long sweeps = Minimizer_numbers::MOST_HOPELESS_SWEEPS * number_of_vertices();
    return (std::min)(most_final_work(), (std::max)(sweeps, Minimizer_numbers::LEAST_HOPELESS_WORK));
  }

  /// makes room for a new map
  void prepare(Workspace& workspace) const
  {
    workspace.levels.resize(m_minimizers.size());
    for(std::size_t level = 0; level < m_minimizers.size(); ++level) {
      auto& memory = workspace.levels[level].preconditioner;
      memory.is_set = false;
      memory.coarser = level + 1 < m_minimizers.size() ? &workspace.levels[level + 1].preconditioner : nullptr;
    }
    workspace.starts.resize(m_starts.size());
    workspace.transports.resize(m_minimizers.size());
  }

private:
  /// of the mesh itself
  long number_of_vertices() const { return m_patches[0].number_of_vertices(); }

  static long final_work_of(long vertices) { return Minimizer_numbers::MOST_FINAL_SWEEPS * vertices; }

  /// vertices that a mesh counts for, at least, where the steps on the map that is delivered are counted
  long least_final_vertices() const
  {
    constexpr long LARGEST = Minimizer_numbers::FINAL_VERTICES;
    return (std::clamp)(Minimizer_numbers::MOST_TIMES_FINAL_VERTICES * number_of_vertices(), LARGEST / 4, LARGEST);
  }

  /// makes the patches, from fine to coarse, and minimizers
  void make_levels(const Balanced_minimization& options, const Deadline& deadline)
  {
    const auto coarsen = [&](Patch_sequence::Shapes_kept shapes_kept) {
      while(add_coarser(shapes_kept, options, deadline)) {
      }
      const std::size_t coarsest = m_patches.size() - 1;
      if(m_starts.empty() || m_starts.back() < coarsest)
        m_starts.push_back(coarsest);
    };
    coarsen({Minimizer_numbers::SHAPE_KEPT, Minimizer_numbers::LEAST_SHAPE_KEPT});
    m_warm = m_patches.finest_with(Minimizer_numbers::LARGEST_WARM_START);
    m_sketched = m_patches.finest_with(Minimizer_numbers::LARGEST_SKETCH);
    m_rough = finest_rough_level();
    m_first_moves = finest_of_first_moves();
    coarsen({std::nullopt});
    if(!is_to_be_factored(m_patches.coarsest())) // there was to be a coarser one
      m_minimizers.back() = minimizer_of_level(m_patches.coarsest(), m_patches.curve(), false, options, deadline);
  }

  /// adds a coarser patch, if there is one, and makes the minimizer of the coarsest as yet, if it has none, at a time
  bool add_coarser(Patch_sequence::Shapes_kept shapes_kept, const Balanced_minimization& options,
                   const Deadline& deadline)
  {
    const Patch& patch = m_patches.coarsest();
    const std::vector<int> curve = m_patches.curve();
    const bool has_minimizer = m_minimizers.size() == m_patches.size();
    bool is_added = false;
    Thread_team::current()(has_minimizer ? 1 : 2, [&](std::size_t i) {
      if(i == 0)
        is_added = m_patches.add_coarser(shapes_kept);
      else
        m_minimizers.push_back(minimizer_of_level(patch, curve, !is_to_be_factored(patch), options, deadline));
    });
    return is_added;
  }

  /// \param has_coarser indicates whether a coarser minimizer takes the place of factors
  std::unique_ptr<Balanced_minimizer> minimizer_of_level(const Patch& patch, const std::vector<int>& curve,
                                                         bool has_coarser, Balanced_minimization options,
                                                         const Deadline& deadline) const
  {
    if(&patch != &m_patches[0])
      options.balance = m_coarse_balance;
    return std::make_unique<Balanced_minimizer>(Patch_division(patch, curve), has_coarser, patch, options, deadline);
  }

  /// the finest patch that is small, or not much larger and half border; the coarsest when all are large
  std::size_t finest_rough_level() const
  {
    const std::size_t small = m_patches.finest_with(Minimizer_numbers::LARGEST_ROUGH);
    std::size_t level = m_patches.finest_with(2 * Minimizer_numbers::LARGEST_ROUGH);
    const auto interior = [this](std::size_t i) {
      return m_patches[i].number_of_vertices() - static_cast<int>(m_patches[i].border.size());
    };
    while(level < small && interior(level) > Minimizer_numbers::LARGEST_ROUGH_INTERIOR)
      ++level;
    return level;
  }

  /// a third of the patch where corners are moved twice, else the rough one
  std::size_t finest_of_first_moves() const
  {
    const int vertices = m_patches[0].number_of_vertices();
    if(!Minimizer_numbers::moves_corners_twice(vertices, static_cast<int>(m_patches[0].border.size())))
      return m_rough;
    return m_patches.finest_with(static_cast<int>(Minimizer_numbers::SHARE_OF_FIRST_MOVES * vertices));
  }

  Patch_sequence m_patches;
  std::vector<std::unique_ptr<Balanced_minimizer>> m_minimizers; // of each patch
  std::vector<std::unique_ptr<Map_transport>> m_transports;      // null where maps are not carried over
  std::vector<std::size_t> m_starts;
  double m_coarse_balance = 0;
  std::size_t m_warm = 0, m_sketched = 0, m_rough = 0, m_first_moves = 0; // levels
};

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_MINIMIZER_LEVELS_H
