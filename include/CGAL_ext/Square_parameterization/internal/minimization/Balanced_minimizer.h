// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_BALANCED_MINIMIZER_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_BALANCED_MINIMIZER_H

#include <CGAL_ext/Square_parameterization/Balanced_minimization.h>
#include <CGAL_ext/Square_parameterization/internal/common/Deadline.h>
#include <CGAL_ext/Square_parameterization/internal/common/Minimizer_numbers.h>
#include <CGAL_ext/Square_parameterization/internal/energy/stretch_kernel.h>
#include <CGAL_ext/Square_parameterization/internal/iteration/Minimized_map.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/Balanced_steps.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/Multigrid_preconditioner.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/Vertex_sweep.h>
#include <CGAL_ext/Square_parameterization/internal/patch/Ordered_patch.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// minimises the balanced energy from a map without flips, and never leaves the maps without flips; see `Balanced_steps`
///
/// Works with the threads of the current team; the result does not depend on their number. A patch that is large enough to
/// be divided is worked on in the order of its division, where neighbors are near in memory.
class Balanced_minimizer
{
public:
  typedef Balanced_steps::Workspace Workspace;

  /// where a minimization ends, if it does not converge before
  struct Limits
  {
    unsigned int iterations; ///< largest number of steps, with those that the map has behind it
    /// of all these steps, and of directions round triangles that are tried now, in vertices visited; while the energy falls
    /// fast, up to `MOST_TIMES_WORK` times as much
    long work = (std::numeric_limits<long>::max)();

    /// ends, too, as soon as the energy will stay above it by all that steps promise; the objective is what it would come
    /// to then, and not below
    double energy = std::numeric_limits<double>::infinity();
  };

  /// of a small patch
  /// \param deadline when it has passed a minimization ends with the map so far
  Balanced_minimizer(const Patch& patch, const Balanced_minimization& options, const Deadline& deadline = {})
    : Balanced_minimizer(Patch_division(patch), false, patch, options, deadline)
  {}

  /// the same, with the patch divided already
  /// \param has_coarser for a large patch, of which coarser ones are minimised before: `set_coarser()` is to follow
  Balanced_minimizer(const Patch_division& division, bool has_coarser, const Patch& patch,
                     const Balanced_minimization& options, const Deadline& deadline);

  Balanced_minimizer(const Balanced_minimizer&) = delete;
  Balanced_minimizer& operator=(const Balanced_minimizer&) = delete;

  /// tells a minimizer of a large patch of the next coarser one, and what minimises it
  void set_coarser(const Coarse_patch& to_coarser, const Balanced_minimizer& coarser);

  /// indicates whether the faces and edges of the patch that was given are not needed any more: those of a large patch are
  /// kept in another order
  bool has_own_faces() const { return m_patch.is_reordered(); }

  /// indicates whether matrices are factored, so that no coarser patch is needed
  bool is_factored() const { return m_preconditioner.is_direct(); }

  /// the patch as it was given
  const Patch& patch() const { return m_patch.given(); }

  /// what takes the unit square to the rectangle of a map: see `scale_to_rectangle()`
  Eigen::RowVector2d scale(const Uv_coordinates& uv) const { return m_energy.scale(m_patch.in_order(uv)); }

  /// sweeps over a map until a sweep gains little: what an interpolated map needs before `minimize()`. Returns what it
  /// cost, in vertices visited.
  /// \param most the largest number of sweeps
  long relax(Uv_coordinates& given_uv, int most = Minimizer_numbers::MAXIMUM_SWEEPS) const;

  /// minimises, with the largest number of iterations of the options
  Minimized_map minimize(Minimized_map map, double tolerance, Workspace& workspace) const
  {
    return minimize(std::move(map), tolerance, {m_options.maximum_iterations}, workspace);
  }

  /// \param tolerance relative: ends when a step promises less, or the last five steps together gained less, or after many
  ///        steps the last thirty less than 200 times as much, or 1000 times where the map is stretched ten times or more and
  ///        is to be delivered
  /// \pre the map has no flips and its border lies on the unit square; a map of this minimizer is continued, its
  ///      iterations and its history, too
  Minimized_map minimize(Minimized_map map, double tolerance, const Limits& limits, Workspace& workspace) const;

  /// sweeps over a minimised map a few times: what is left in tiny triangles counts for nothing in the energy, but may
  /// be the largest stretch of all
  void settle(Minimized_map& map) const;

private:
  // what follows has the vertices of the ordered patch

  /// on the rectangle of the energy
  void measure_stretch(Minimized_map& map) const
  {
    map.aspect = m_energy.aspect(map.uv);
    map.report.l2 = std::sqrt(stretch_energy(*m_patch, on_rectangle(map.uv, map.aspect)));
  }

  /// what steps and directions round triangles cost, in vertices visited
  /// \param of_roundabout what one of these costs where the patch is small, in sweeps
  /// \param least_of_roundabout the same at least, wherever
  long work_of(long steps, long roundabouts, double of_roundabout, double least_of_roundabout = 0) const
  {
    const int vertices = m_patch->number_of_vertices();
    const double sweeps =
        (std::max)(least_of_roundabout, of_roundabout * Minimizer_numbers::growth_of_roundabouts(vertices));
    return Minimizer_numbers::STEP_WORK * steps * vertices +
           static_cast<long>(sweeps * static_cast<double>(roundabouts) * vertices);
  }

  bool is_border_sliding() const { return m_options.border == Border_motion::SLIDING; }

  /// indicates whether the last steps, of which there are so many, gained a share of the energy at most
  static bool gains_at_most(double share, const std::vector<double>& history, std::size_t steps)
  {
    return history.size() > steps && history[history.size() - 1 - steps] - history.back() <= share * history.back();
  }

  bool gains_little(const std::vector<double>& history, double tolerance) const
  {
    typedef Minimizer_numbers Numbers;
    const bool is_delivered = tolerance <= m_options.tolerance;
    const bool is_stretched = Numbers::is_stretched(history.back(), m_patch->number_of_vertices());
    return gains_at_most(tolerance, history, Numbers::STEPS_COMPARED) ||
           (history.size() > Numbers::MANY_STEPS &&
            gains_at_most(Numbers::TOLERANCES_OF_LONG_RUN * tolerance, history, Numbers::LONG_RUN)) ||
           (is_delivered && is_stretched &&
            gains_at_most(Numbers::TOLERANCES_OF_STRETCHED * tolerance, history, Numbers::LONG_RUN));
  }

  /// indicates whether a map has cost what it may, which is more while its energy falls fast and is not hopeless
  static bool has_cost_enough(long work, long most, const std::vector<double>& history)
  {
    const bool falls_fast = history.back() < Minimizer_numbers::HOPELESS_RESULT &&
                            history.size() > Minimizer_numbers::LONG_RUN &&
                            !gains_at_most(Minimizer_numbers::FAST_FALL, history, Minimizer_numbers::LONG_RUN);
    return work > most && !(falls_fast && work / Minimizer_numbers::MOST_TIMES_WORK <= most);
  }

  /// tells whether the energy will not fall to the limit, by what the next step promises and the last one gained
  static bool stays_above(double limit, const std::vector<double>& history, double slope)
  {
    const double last_gain = history[history.size() - 2] - history.back();
    return history.back() - (std::max)(Minimizer_numbers::MOST_PROMISES * -slope / 2, last_gain) > limit;
  }

  Ordered_patch m_patch;
  Balanced_energy m_energy;
  Multigrid_preconditioner m_preconditioner;
  Vertex_sweep m_sweep;
  Balanced_minimization m_options;
  Deadline m_deadline;
};

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#ifndef CGAL_EXT_COMPILED_CORE
#include <CGAL_ext/Square_parameterization/internal/minimization/Balanced_minimizer_impl.h>
#endif

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_BALANCED_MINIMIZER_H
