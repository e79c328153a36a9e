// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_MULTILEVEL_MINIMIZER_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_MULTILEVEL_MINIMIZER_H

#include <CGAL_ext/Square_parameterization/internal/border/shift_border.h>
#include <CGAL_ext/Square_parameterization/internal/coarsening/Patch_sequence.h>
#include <CGAL_ext/Square_parameterization/internal/coarsening/insert_vertices.h>
#include <CGAL_ext/Square_parameterization/internal/common/Minimizer_numbers.h>
#include <CGAL_ext/Square_parameterization/internal/iteration/Stretch_iteration.h>
#include <CGAL_ext/Square_parameterization/internal/iteration/transport_map.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/Balanced_minimizer.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/make_level_minimizers.h>

#include <algorithm>
#include <cstddef>
#include <deque>
#include <initializer_list>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// minimises the balanced energy from coarse to fine: maps the coarsest of a sequence of ever coarser patches by the
/// iteration of Yoshizawa et al.; then, patch by patch, minimises, puts vertices back, and smooths by sweeps.
///
/// The first map of a patch with long protrusions or passages, as many holes and handles leave them, has triangles too
/// tiny for floating-point numbers, and folded surfaces are not made coarse enough to avoid that. Then patches follow
/// that do not keep the shape of the surface, down to one whose first map is sound: all that is needed from them is a
/// start.
///
/// Constant after construction: several threads may call `minimize()`, each with a workspace of its own. The patches do
/// not depend on the places of the border vertices, and serve all maps.
class Multilevel_minimizer
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
  /// \param deadline when it has passed no patch is minimised any more: a map that is begun goes down to the finest
  ///        patch by sweeps alone
  explicit Multilevel_minimizer(const Patch& patch, const Balanced_minimization& options = {},
                                bool may_coarsen_border = true, const Deadline& deadline = {},
                                Coarsening coarsening = Coarsening::BY_HALVES)
    : m_patches(patch, may_coarsen_border && options.border == Border_motion::SLIDING, coarsening),
      m_options(options),
      m_deadline(deadline)
  {
    Balanced_minimization coarse_options = options;
    coarse_options.balance = (std::max)(options.balance, Minimizer_numbers::LEAST_COARSE_BALANCE);
    coarse_options.maximum_iterations = Minimizer_numbers::COARSE_ITERATIONS;
    m_coarse_balance = coarse_options.balance;
    Coarse_patch_stream stream;
    Thread_team::current()(2, [&](std::size_t i) { // the second waits for the first
      if(i == 0)
        make_patches(stream);
      else
        m_minimizers = make_level_minimizers(patch, stream, options, coarse_options, deadline);
    });
    Thread_team::current()(m_patches.size(), [this](std::size_t level) {
      if(is_large(level))
        m_minimizers[level]->set_coarser(m_patches.coarse(level + 1), *m_minimizers[level + 1]);
    });
    m_transports.resize(m_patches.size());
    for(std::size_t level : {m_warm_level, m_sketch_level, m_rough_level})
      if(!m_transports[level])
        m_transports[level] = std::make_unique<Map_transport>(m_patches[level]);
    for(std::size_t level = 1; level < m_patches.size(); ++level)
      if(m_minimizers[level]->has_own_faces() && !m_transports[level] && !is_start(level))
        m_patches.forget_faces(level);
  }

  /// maps for the border \p border_uv (#B by 2), to the tolerance of a search. The result has no uv when no map without
  /// flips was found to start from: for want of room, too, where the corners are close together and `keeps_border()` is
  /// false.
  /// \pre the border is on the unit square, or `keeps_border()`
  /// \param warm_start of a map or a sketch for a similar border, the map of one of the coarse patches; it saves the
  ///        coarser ones. May be null.
  Minimized_map minimize(const Uv_coordinates& border_uv, Workspace& workspace,
                         const Uv_coordinates* warm_start = nullptr) const
  {
    Uv_coordinates uv;
    Descent descent;
    prepare(workspace);
    const Patch_sequence::Borders borders = m_patches.borders(border_uv);
    if(const std::optional<std::size_t> level = warm_start != nullptr ? level_of(*warm_start) : std::nullopt;
       level && *level < borders.size())
      uv =
          refine(*level, 0, transport(*level, *warm_start, borders[*level].uv, workspace), borders, workspace, descent);
    if(uv.rows() == 0)
      uv = start(borders, 0, workspace, descent);
    if(uv.rows() == 0 && m_patches.size() > 1 && !has_passed(m_deadline)) { // some coarse triangle was lost in rounding
      Stretch_iteration::Workspace iteration_workspace;
      uv = first_map(Stretch_iteration(m_patches[0], m_options.start), border_uv, iteration_workspace, descent);
    }
    if(uv.rows() == 0)
      return without_map(descent);
    Minimized_map map = map_to_compare(0, std::move(uv), workspace, descent);
    map.warm_start = m_warm_level == 0 ? map.uv : std::move(descent.warm_start);
    return map;
  }

  /// indicates whether the coarse patches have the border of the patch
  bool keeps_border() const { return m_patches.keeps_border(); }

  /// indicates whether the patch is so large that sketches save time
  bool has_sketches() const
  {
    const int vertices = m_patches[0].number_of_vertices();
    const int sketched = m_patches[m_sketch_level].number_of_vertices();
    return vertices >= Minimizer_numbers::SMALLEST_SKETCHED &&
           Minimizer_numbers::LEAST_SKETCH_RATIO * sketched <= vertices;
  }

  /// the patch whose maps are sketches
  std::size_t sketch_level() const { return m_sketch_level; }

  /// the patch on which corners are moved: its maps cost little
  std::size_t rough_level() const { return m_rough_level; }

  /// the least energy of one of the patches for the border \p border_uv, by which borders can be compared: what
  /// the finer patches save is much the same for all. Without uv, and infinite when no map was found.
  /// \param level the one of sketches or the one of rough maps
  /// \param warm_start of a sketch of the same level for a similar border; may be null
  /// \param limit an energy above it is found less exactly
  Minimized_map sketch(std::size_t level, const Uv_coordinates& border_uv, Workspace& workspace,
                       const Uv_coordinates* warm_start = nullptr,
                       double limit = std::numeric_limits<double>::infinity()) const
  {
    prepare(workspace);
    const Patch_sequence::Borders borders = m_patches.borders(border_uv);
    Minimized_map map;
    if(warm_start != nullptr && level < borders.size())
      map = sketch_from(level, *warm_start, limit, borders[level].uv, workspace);
    if(map.uv.rows() == 0) {
      Descent descent;
      Uv_coordinates uv = start(borders, level, workspace, descent);
      if(uv.rows() == 0)
        return without_map(descent);
      map = map_to_compare(level, std::move(uv), workspace, descent);
    }
    map.warm_start = std::move(map.uv);
    map.uv.resize(0, 2);
    return map;
  }

  /// continues with a map of `minimize()`, to the tolerance of the map that is delivered, and settles it
  Minimized_map finish(Minimized_map map) const
  {
    if(!is_large(0)) {
      Balanced_minimizer::Workspace workspace;
      map = m_minimizers[0]->minimize(std::move(map), m_options.tolerance,
                                      {m_options.maximum_iterations, most_final_work()}, workspace);
    }
    m_minimizers[0]->settle(map);
    return map;
  }

  /// what is minimised, of a map
  double energy(const Uv_coordinates& uv) const
  {
    return Balanced_energy(m_patches[0], m_options.balance, m_options.aspect)(uv);
  }

private:
  /// how a coarse patch is mapped
  struct Start
  {
    std::size_t level;
    std::unique_ptr<Stretch_iteration> iteration;
  };

  /// the minimised map of the patch of one level
  struct Level_map
  {
    std::size_t level;
    Uv_coordinates uv;
    double energy;
  };

  /// a way from coarse to fine
  struct Descent
  {
    double largest_energy = Minimizer_numbers::HOPELESS;
    std::vector<Level_map> given_up; ///< maps whose energy was larger
    Uv_coordinates warm_start;       ///< the map of one of the patches on the way
    long work = 0;                   ///< in vertices visited
  };

  /// without uv when the map cannot be carried over
  Minimized_map sketch_from(std::size_t level, const Uv_coordinates& warm_start, double limit,
                            const Uv_coordinates& border_uv, Workspace& workspace) const
  {
    Uv_coordinates uv = transport(level, warm_start, border_uv, workspace);
    if(uv.rows() == 0)
      return Minimized_map();
    const Balanced_minimizer& minimizer = *m_minimizers[level];
    const long relaxation = minimizer.relax(uv, Minimizer_numbers::SWEEPS_OF_TRANSPORTED);
    const Balanced_minimizer::Limits limits{Minimizer_numbers::SEARCH_ITERATIONS, (std::numeric_limits<long>::max)(),
                                            limit};
    Minimized_map map =
        minimizer.minimize({std::move(uv), {}, {}}, m_options.search_tolerance, limits, workspace.levels[level]);
    map.work += relaxation;
    return map;
  }

  /// the level of a warm start, of which its size tells: each patch is smaller than the one before it
  std::optional<std::size_t> level_of(const Uv_coordinates& warm_start) const
  {
    for(const std::size_t level : {m_warm_level, m_sketch_level, m_rough_level})
      if(m_patches[level].number_of_vertices() == warm_start.rows())
        return level;
    return std::nullopt;
  }

  /// the map of the patch of one level for another border; without rows when rounding flips a triangle
  Uv_coordinates transport(std::size_t level, const Uv_coordinates& uv, const Uv_coordinates& border_uv,
                           Workspace& workspace) const
  {
    const Patch& patch = m_patches[level];
    const bool slides = m_options.border == Border_motion::SLIDING;
    const Uv_coordinates shifted = slides ? shift_border(patch, uv, border_uv) : border_uv;
    if(is_border_of(patch, shifted, uv))
      return uv;
    return (*m_transports[level])(uv, shifted, workspace.transports[level]);
  }

  static bool is_border_of(const Patch& patch, const Uv_coordinates& border_uv, const Uv_coordinates& uv)
  {
    for(std::size_t k = 0; k < patch.border.size(); ++k)
      if(border_uv.row(k) != uv.row(patch.border[k]))
        return false;
    return true;
  }

  /// makes the patches, from fine to coarse
  void make_patches(Coarse_patch_stream& stream)
  {
    struct End // also when an exception is thrown
    {
      explicit End(Coarse_patch_stream& of) : stream(of) {}
      ~End() { stream.end(); }
      Coarse_patch_stream& stream;
    };
    const End end(stream);
    coarsen({Minimizer_numbers::SHAPE_KEPT, Minimizer_numbers::LEAST_SHAPE_KEPT}, stream);
    m_warm_level = m_patches.finest_with(Minimizer_numbers::LARGEST_WARM_START);
    m_sketch_level = m_patches.finest_with(Minimizer_numbers::LARGEST_SKETCH);
    m_rough_level = finest_rough_level();
    coarsen({std::nullopt}, stream);
  }

  /// adds patches as long as they get coarser, and a start from the last of them
  void coarsen(Patch_sequence::Shapes_kept shapes_kept, Coarse_patch_stream& stream)
  {
    m_patches.coarsen(shapes_kept, [&stream](const Coarse_patch& coarse) { stream.add(coarse); });
    const std::size_t coarsest = m_patches.size() - 1;
    if(m_starts.empty() || m_starts.back().level < coarsest)
      m_starts.push_back({coarsest, std::make_unique<Stretch_iteration>(m_patches[coarsest], m_options.start,
                                                                        make_direct_solver, m_deadline)});
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

  /// of the steps on the map that is delivered, in vertices visited
  long most_final_work() const
  {
    return Minimizer_numbers::MOST_FINAL_SWEEPS *
           long((std::max)(m_patches[0].number_of_vertices(), Minimizer_numbers::LARGEST_FACTORED));
  }

  bool is_large(std::size_t level) const
  {
    return level + 1 < m_patches.size() && m_patches[level].number_of_vertices() > Minimizer_numbers::LARGEST_FACTORED;
  }

  /// indicates whether maps begin with the patch
  bool is_start(std::size_t level) const
  {
    return std::any_of(m_starts.begin(), m_starts.end(), [level](const Start& start) { return start.level == level; });
  }

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

  /// the map of an iteration, whose work is counted; without rows when there is none
  static Uv_coordinates first_map(const Stretch_iteration& iteration, const Uv_coordinates& border_uv,
                                  Stretch_iteration::Workspace& workspace, Descent& descent)
  {
    Minimized_map map = iteration.minimize(border_uv, 1, workspace);
    descent.work += map.work;
    return std::move(map.uv);
  }

  /// what is returned when no way leads to a map: searches count what they have cost, too
  static Minimized_map without_map(const Descent& descent)
  {
    Minimized_map map;
    map.work = descent.work;
    return map;
  }

  /// a map of the patch of level \p to, from the first start that works well, or else goes on with the best of those
  /// that were given up; without rows when none works
  Uv_coordinates start(const Patch_sequence::Borders& borders, std::size_t to, Workspace& workspace,
                       Descent& descent) const
  {
    Uv_coordinates uv;
    for(std::size_t i = 0; i < m_starts.size() && uv.rows() == 0 && m_starts[i].level < borders.size(); ++i) {
      const auto& [level, iteration] = m_starts[i];
      uv = refine(level, to, first_map(*iteration, borders[level].uv, workspace.starts[i], descent), borders, workspace,
                  descent);
    }
    return uv.rows() == 0 ? resume(to, borders, workspace, descent) : uv;
  }

  /// goes on from the maps that were given up, the best first, until one arrives
  Uv_coordinates resume(std::size_t to, const Patch_sequence::Borders& borders, Workspace& workspace,
                        Descent& descent) const
  {
    std::vector<Level_map> given_up = std::move(descent.given_up);
    std::stable_sort(given_up.begin(), given_up.end(),
                     [](const Level_map& a, const Level_map& b) { return a.energy < b.energy; });
    descent.largest_energy = std::numeric_limits<double>::infinity();
    Uv_coordinates uv;
    for(std::size_t i = 0; i < given_up.size() && uv.rows() == 0; ++i) {
      const std::size_t level = given_up[i].level;
      keep_warm_start(level, given_up[i].uv, descent);
      uv = refine(level - 1, to, insert(level, given_up[i].uv, borders), borders, workspace, descent);
    }
    return uv;
  }

  /// brings a map of the patch of one level to that of another, ready to be minimised; without rows when a triangle is
  /// lost in rounding, when the way is given up, or when \p uv has none
  Uv_coordinates refine(std::size_t level, std::size_t to, Uv_coordinates uv, const Patch_sequence::Borders& borders,
                        Workspace& workspace, Descent& descent) const
  {
    for(; level > to && uv.rows() > 0; --level) {
      if(!is_large(level) && level + 1 < m_patches.size()) // it is factored itself
        workspace.levels[level + 1].preconditioner.factors.reset();
      descent.work += m_minimizers[level]->relax(uv);
      Minimized_map map = m_minimizers[level]->minimize({std::move(uv), {}, {}}, Minimizer_numbers::COARSE_TOLERANCE,
                                                        workspace.levels[level]);
      workspace.levels[level].end_steps();
      descent.work += map.work;
      const bool is_early = m_patches[level].number_of_vertices() <
                            Minimizer_numbers::LARGEST_GIVEN_UP * m_patches[to].number_of_vertices();
      if(is_early && map.report.objective > descent.largest_energy) {
        descent.given_up.push_back({level, std::move(map.uv), map.report.objective});
        return Uv_coordinates();
      }
      keep_warm_start(level, map.uv, descent);
      uv = insert(level, map.uv, borders);
    }
    return uv;
  }

  void keep_warm_start(std::size_t level, const Uv_coordinates& uv, Descent& descent) const
  {
    if(level == m_warm_level)
      descent.warm_start = uv;
  }

  /// puts the vertices of the next finer patch back; without rows when a triangle is lost in rounding
  Uv_coordinates insert(std::size_t level, const Uv_coordinates& uv, const Patch_sequence::Borders& borders) const
  {
    auto finer = insert_vertices(m_patches[level - 1], m_patches.coarse(level), uv, borders[level].removed_corners,
                                 m_coarse_balance, m_minimizers[level]->scale(uv));
    return finer ? std::move(*finer) : Uv_coordinates();
  }

  /// the map of the patch of a level to the tolerance of a search, made of one that is ready to be minimised
  Minimized_map map_to_compare(std::size_t level, Uv_coordinates uv, Workspace& workspace, const Descent& descent) const
  {
    const Balanced_minimizer& minimizer = *m_minimizers[level];
    const long relaxation = minimizer.relax(uv);
    // of a large patch few maps are made, and the coarser ones are at hand now: the first minimization is the last
    const bool is_last = level == 0 && is_large(0);
    const unsigned int most = is_last ? m_options.maximum_iterations
                                      : (std::min)(m_options.maximum_iterations, Minimizer_numbers::SEARCH_ITERATIONS);
    Minimized_map map =
        minimizer.minimize({std::move(uv), {}, {}}, is_last ? m_options.tolerance : m_options.search_tolerance,
                           {most, most_final_work()}, workspace.levels[level]);
    map.work += relaxation + descent.work;
    return map;
  }

  Patch_sequence m_patches;
  std::vector<std::unique_ptr<Balanced_minimizer>> m_minimizers; // of each patch
  std::vector<std::unique_ptr<Map_transport>> m_transports;      // of the patches whose maps others start from
  std::vector<Start> m_starts; // from the coarsest that keeps its shape, and from the coarsest
  Balanced_minimization m_options;
  Deadline m_deadline;
  double m_coarse_balance = 0;
  std::size_t m_warm_level = 0;   // of the patch whose maps are warm starts
  std::size_t m_sketch_level = 0; // of the patch on which candidates are compared
  std::size_t m_rough_level = 0;  // of the patch on which corners are moved
};

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_MULTILEVEL_MINIMIZER_H
