// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_BALANCED_MINIMIZER_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_BALANCED_MINIMIZER_H

#include <CGAL_ext/Square_parameterization/Balanced_minimization.h>
#include <CGAL_ext/Square_parameterization/internal/common/Deadline.h>
#include <CGAL_ext/Square_parameterization/internal/common/Minimizer_numbers.h>
#include <CGAL_ext/Square_parameterization/internal/energy/stretch_kernel.h>
#include <CGAL_ext/Square_parameterization/internal/iteration/Minimized_map.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/Multigrid_preconditioner.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/Secant_memory.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/Vertex_sweep.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/rows_by_ranges.h>
#include <CGAL_ext/Square_parameterization/internal/patch/Patch_division.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// minimises the balanced energy from a map without flips, and never leaves the maps without flips: L-BFGS with the
/// blocks of the Hessian as preconditioner, and one sweep over the vertices after each step.
///
/// A step goes at most nine tenths of the way to the first triangle without area; the line search halves. The sweep
/// then mends the triangles that stood in the way, which would keep the next steps short, too.
///
/// Works with the threads of the current team; the result does not depend on their number. A patch that is large enough to
/// be divided is worked on in the order of its division, where neighbors are near in memory.
class Balanced_minimizer
{
public:
  /// the memory of one thread
  struct Workspace
  {
    Multigrid_preconditioner::Memory preconditioner;
    Uv_coordinates gradient, previous_gradient, direction, trial;

    /// frees what no minimizer of a finer patch needs
    void end_steps()
    {
      for(Uv_coordinates* of_step : {&gradient, &previous_gradient, &direction, &trial})
        of_step->resize(0, 2);
    }
  };

  /// where a minimization ends, if it does not converge before
  struct Limits
  {
    unsigned int iterations;                        ///< largest number of steps, with those that the map has behind it
    long work = (std::numeric_limits<long>::max)(); ///< of these steps, in vertices visited

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
                     const Balanced_minimization& options, const Deadline& deadline)
    : m_given_patch(patch),
      m_ordered_patch(division.is_divided() ? in_order_of(division, patch) : Patch()),
      m_patch(division.is_divided() ? m_ordered_patch : patch),
      m_order(division.order()),
      m_division(division.is_divided() ? division.in_order() : division),
      m_energy(m_patch, options.balance, options.aspect, &m_division),
      m_preconditioner(has_coarser ? Multigrid_preconditioner::of_large(m_patch, m_division)
                                   : Multigrid_preconditioner(m_patch, m_division)),
      m_sweep(m_patch, m_division, options.balance),
      m_options(options),
      m_deadline(deadline)
  {
    // the matrices alone need them, while they are made; `= {}` would keep the memory
    m_ordered_patch.edges = std::vector<std::array<int, 2>>();
  }

  Balanced_minimizer(const Balanced_minimizer&) = delete;
  Balanced_minimizer& operator=(const Balanced_minimizer&) = delete;

  /// tells a minimizer of a large patch of the next coarser one, and what minimises it
  void set_coarser(const Coarse_patch& to_coarser, const Balanced_minimizer& coarser)
  {
    std::vector<int> rank(m_order.size());
    for(std::size_t i = 0; i < rank.size(); ++i)
      rank[m_order[i]] = static_cast<int>(i);
    m_preconditioner.set_coarser(Vertex_interpolation(m_given_patch, to_coarser, rank, coarser.m_order),
                                 coarser.m_preconditioner);
  }

  /// indicates whether the faces and edges of the patch that was given are not needed any more: those of a large patch are
  /// kept in another order
  bool has_own_faces() const { return m_division.is_divided(); }

  /// the patch as it was given
  const Patch& patch() const { return m_given_patch; }

  /// what takes the unit square to the rectangle of a map: see `scale_to_rectangle()`
  Eigen::RowVector2d scale(const Uv_coordinates& uv) const { return m_energy.scale(in_order(uv)); }

  /// sweeps over a map until a sweep gains little: what an interpolated map needs before `minimize()`. Returns what it
  /// cost, in vertices visited.
  /// \param most the largest number of sweeps
  long relax(Uv_coordinates& given_uv, int most = Minimizer_numbers::MAXIMUM_SWEEPS) const
  {
    Uv_coordinates uv = in_order(std::move(given_uv));
    const Free_coordinates is_free = free_coordinates(m_patch, uv, is_border_sliding());
    double energy = m_energy(uv);
    int sweeps = 0;
    for(bool gains = true; gains && sweeps < most; ++sweeps) {
      m_sweep(is_free, m_energy.scale(uv), uv);
      const double reached = m_energy(uv);
      gains = energy - reached >= Minimizer_numbers::LEAST_SWEEP_GAIN * energy && !has_passed(m_deadline);
      energy = reached;
    }
    given_uv = in_given_order(std::move(uv));
    return static_cast<long>(sweeps) * given_uv.rows();
  }

  /// minimises, with the largest number of iterations of the options
  Minimized_map minimize(Minimized_map map, double tolerance, Workspace& workspace) const
  {
    return minimize(std::move(map), tolerance, {m_options.maximum_iterations}, workspace);
  }

  /// \param tolerance relative: ends when a step promises less, or the last five steps together gained less, or after many
  ///        steps the last thirty less than 200 times as much
  /// \pre the map has no flips and its border lies on the unit square; a map of this minimizer is continued, its
  ///      iterations and its history, too
  Minimized_map minimize(Minimized_map map, double tolerance, const Limits& limits, Workspace& workspace) const
  {
    map.uv = in_order(std::move(map.uv));
    const Free_coordinates is_free = free_coordinates(m_patch, map.uv, is_border_sliding());
    Minimization_report& report = map.report;
    Secant_memory memory(Minimizer_numbers::SECANT_PAIRS);
    report.objective = gradient_at(map.uv, is_free, workspace.gradient);
    if(report.history.empty())
      report.history.push_back(report.objective);
    const unsigned int first_iteration = report.iterations;
    unsigned int age = 0; // of the factors
    long roundabouts = 0;
    while(true) {
      if(report.iterations >= limits.iterations ||
         work_of(report.iterations - first_iteration, roundabouts) > limits.work) {
        report.stop_reason = Stop_reason::MAXIMUM_ITERATIONS;
        break;
      }
      if(has_passed(m_deadline)) {
        report.stop_reason = Stop_reason::DEADLINE;
        break;
      }
      if(age == 0 && !m_preconditioner.factorize(m_energy, map.uv, is_free, workspace.preconditioner)) {
        report.stop_reason = Stop_reason::CANNOT_SOLVE;
        break;
      }
      double slope = find_direction(memory, workspace);
      if(-slope / 2 <= tolerance * report.objective || gains_little(report.history, tolerance)) {
        report.stop_reason = Stop_reason::CONVERGED;
        break;
      }
      if(report.iterations > first_iteration && stays_above(limits.energy, report.history, slope)) {
        report.stop_reason = Stop_reason::CONVERGED;
        report.objective = (std::max)(report.objective + slope / 2, limits.energy);
        break;
      }
      double feasible = largest_step(m_patch, map.uv, workspace.direction);
      const int tries = go_round_blocked(is_free, age == 0, memory, map.uv, workspace, slope, feasible);
      const bool goes_round = tries > 0;
      roundabouts += tries;
      if(!search_line(report.objective, slope, feasible, map.uv, workspace)) {
        if(age == 0 && memory.is_empty()) {
          report.stop_reason = Stop_reason::NO_LOWER_MAP;
          break;
        }
        memory.clear();
        age = 0;
        continue;
      }
      report.objective = step(is_free, memory, map.uv, workspace);
      report.best_iteration = ++report.iterations;
      report.history.push_back(report.objective);
      age = goes_round ? 0 : (age + 1) % lifetime_of_factors(report.iterations);
      if(goes_round)
        memory.clear(); // of a step that was none of the whole mesh
    }
    map.work += work_of(report.iterations - first_iteration, roundabouts);
    report.gradient_norm = std::sqrt(dot(workspace.gradient, workspace.gradient));
    measure_stretch(map);
    map.uv = in_given_order(std::move(map.uv));
    return map;
  }

  /// sweeps over a minimised map a few times: what is left in tiny triangles counts for nothing in the energy, but may
  /// be the largest stretch of all
  void settle(Minimized_map& map) const
  {
    map.uv = in_order(std::move(map.uv));
    const Free_coordinates is_free = free_coordinates(m_patch, map.uv, is_border_sliding());
    for(int i = 0; i < Minimizer_numbers::SETTLING_SWEEPS; ++i)
      m_sweep(is_free, m_energy.scale(map.uv), map.uv);
    Uv_coordinates gradient;
    map.report.objective = map.report.history.back() = gradient_at(map.uv, is_free, gradient);
    map.report.gradient_norm = std::sqrt(dot(gradient, gradient));
    measure_stretch(map);
    map.uv = in_given_order(std::move(map.uv));
  }

private:
  /// a map of the patch that was given (#V by 2) as one of the ordered one
  Uv_coordinates in_order(Uv_coordinates uv) const
  {
    if(!m_division.is_divided())
      return uv;
    Uv_coordinates result(uv.rows(), 2);
    for(std::size_t i = 0; i < m_order.size(); ++i)
      result.row(i) = uv.row(m_order[i]);
    return result;
  }

  /// and back
  Uv_coordinates in_given_order(Uv_coordinates uv) const
  {
    if(!m_division.is_divided())
      return uv;
    Uv_coordinates result(uv.rows(), 2);
    for(std::size_t i = 0; i < m_order.size(); ++i)
      result.row(m_order[i]) = uv.row(i);
    return result;
  }

  // what follows has the vertices of the ordered patch

  /// on the rectangle of the energy
  void measure_stretch(Minimized_map& map) const
  {
    map.aspect = m_energy.aspect(map.uv);
    map.report.l2 = std::sqrt(stretch_energy(m_patch, on_rectangle(map.uv, map.aspect)));
  }

  /// what steps and directions round triangles cost, in vertices visited
  long work_of(long steps, long roundabouts) const
  {
    return (Minimizer_numbers::STEP_WORK * steps + Minimizer_numbers::ROUNDABOUT_WORK * roundabouts) *
           m_patch.number_of_vertices();
  }

  bool is_border_sliding() const { return m_options.border == Border_motion::SLIDING; }

  /// far from the minimum the Hessian changes more from step to step
  static unsigned int lifetime_of_factors(unsigned int iterations)
  {
    return iterations <= Minimizer_numbers::EARLY_STEPS ? Minimizer_numbers::EARLY_LIFETIME
                                                        : Minimizer_numbers::LATE_LIFETIME;
  }

  static bool gains_little(const std::vector<double>& history, double tolerance)
  {
    const auto gains_less_in = [&history](std::size_t steps, double gain) {
      return history.size() > steps && history[history.size() - 1 - steps] - history.back() <= gain * history.back();
    };
    return gains_less_in(Minimizer_numbers::STEPS_COMPARED, tolerance) ||
           (history.size() > Minimizer_numbers::MANY_STEPS &&
            gains_less_in(Minimizer_numbers::LONG_RUN, Minimizer_numbers::TOLERANCES_OF_LONG_RUN * tolerance));
  }

  /// tells whether the energy will not fall to the limit, by what the next step promises and the last one gained
  static bool stays_above(double limit, const std::vector<double>& history, double slope)
  {
    const double last_gain = history[history.size() - 2] - history.back();
    return history.back() - (std::max)(Minimizer_numbers::MOST_PROMISES * -slope / 2, last_gain) > limit;
  }

  double gradient_at(const Uv_coordinates& uv, const Free_coordinates& is_free, Uv_coordinates& gradient) const
  {
    const double energy = m_energy.gradient(uv, gradient);
    set_rows(gradient, uv.rows(), [&](const auto& rows) { return rows(is_free).select(rows(gradient), 0.); });
    return energy;
  }

  /// sets the direction of descent and returns the slope along it; forgets the memory when that leads upwards
  double find_direction(Secant_memory& memory, Workspace& workspace) const
  {
    const auto precondition = [&](Uv_coordinates& x) { m_preconditioner.apply(workspace.preconditioner, x); };
    const auto descend_steepest = [&workspace] {
      set_rows(workspace.direction, workspace.gradient.rows(),
               [&](const auto& rows) { return -rows(workspace.gradient); });
    };
    descend_steepest();
    memory.apply(precondition, workspace.direction);
    double slope = dot(workspace.gradient, workspace.direction);
    if(!(slope < 0) && !memory.is_empty()) {
      memory.clear();
      descend_steepest();
      precondition(workspace.direction);
      slope = dot(workspace.gradient, workspace.direction);
    }
    return slope;
  }

  /// turns to another direction where triangles that lose their area on a small part of the way would keep the step
  /// short: their vertices stay, and the others move with regard to that. The sweep mends these triangles. Returns the
  /// number of directions that were tried; if there are any, the factors are of the last one alone.
  /// \param are_factors_new tells whether the factors are those at \p uv
  /// \param feasible the largest step in the direction
  int go_round_blocked(const Free_coordinates& is_free, bool are_factors_new, Secant_memory& memory,
                       const Uv_coordinates& uv, Workspace& workspace, double& slope, double& feasible) const
  {
    Free_coordinates moves = is_free;
    int tries = 0;
    while(tries < Minimizer_numbers::MAXIMUM_ROUNDABOUTS && is_blocked(feasible)) {
      ++tries;
      fix_blocked(uv, workspace.direction, moves);
      memory.clear();
      // at the same map the matrices only lose rows
      if(!(are_factors_new ? m_preconditioner.factorize_fewer(moves, workspace.preconditioner)
                           : m_preconditioner.factorize(m_energy, uv, moves, workspace.preconditioner)))
        break;
      are_factors_new = true;
      workspace.direction = moves.select(-workspace.gradient, 0.);
      m_preconditioner.apply(workspace.preconditioner, workspace.direction);
      slope = dot(workspace.gradient, workspace.direction);
      feasible = largest_step(m_patch, uv, workspace.direction);
    }
    return tries;
  }

  static bool is_blocked(double feasible)
  {
    return Minimizer_numbers::STEP_SAFETY * feasible < Minimizer_numbers::BLOCKED_STEP;
  }

  /// lets the vertices of triangles that stand in the way stay
  void fix_blocked(const Uv_coordinates& uv, const Uv_coordinates& direction, Free_coordinates& moves) const
  {
    for(const auto& t : m_patch.triangles)
      if(is_blocked(largest_step(t, uv, direction, Minimizer_numbers::BLOCKED_STEP / Minimizer_numbers::STEP_SAFETY)))
        for(int v : t)
          moves(v, 0) = moves(v, 1) = false;
  }

  /// sets the trial to a map of lower energy on the line from \p uv; false when there is none
  /// \param feasible the largest step in the direction
  bool search_line(double energy, double slope, double feasible, const Uv_coordinates& uv, Workspace& workspace) const
  {
    double length = (std::min)(1., Minimizer_numbers::STEP_SAFETY * feasible);
    for(int i = 0; i < Minimizer_numbers::MAXIMUM_STEP_HALVINGS; ++i, length /= 2) {
      set_rows(workspace.trial, uv.rows(),
               [&](const auto& rows) { return rows(uv) + length * rows(workspace.direction); });
      if(m_energy(workspace.trial) <= energy + Minimizer_numbers::SUFFICIENT_DECREASE * length * slope)
        return true;
    }
    return false;
  }

  /// sweeps over the trial, makes it the map, remembers the step, and returns the energy
  double step(const Free_coordinates& is_free, Secant_memory& memory, Uv_coordinates& uv, Workspace& workspace) const
  {
    m_sweep(is_free, m_energy.scale(workspace.trial), workspace.trial);
    workspace.previous_gradient.swap(workspace.gradient);
    const double energy = gradient_at(workspace.trial, is_free, workspace.gradient);
    uv.swap(workspace.trial);
    Uv_coordinates &change = workspace.trial, &gradient_change = workspace.previous_gradient; // in place
    set_rows(change, uv.rows(), [&](const auto& rows) { return rows(uv) - rows(change); });
    set_rows(gradient_change, uv.rows(),
             [&](const auto& rows) { return rows(workspace.gradient) - rows(gradient_change); });
    memory.add(change, gradient_change);
    return energy;
  }

  const Patch& m_given_patch;
  Patch m_ordered_patch;    // of a large patch
  const Patch& m_patch;     // that, or the given one
  std::vector<int> m_order; // per vertex of this, the one of the given patch
  Patch_division m_division;
  Balanced_energy m_energy;
  Multigrid_preconditioner m_preconditioner;
  Vertex_sweep m_sweep;
  Balanced_minimization m_options;
  Deadline m_deadline;
};

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_BALANCED_MINIMIZER_H
