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

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// minimises the balanced energy from a map without flips, and never leaves the maps without flips: L-BFGS with the
/// blocks of the Hessian as preconditioner, and one sweep over the vertices after each step.
///
/// A step goes at most nine tenths of the way to the first triangle without area; the line search halves. The sweep
/// then mends the triangles that stood in the way, which would keep the next steps short, too.
class Balanced_minimizer
{
public:
  /// the memory of one thread
  struct Workspace
  {
    Multigrid_preconditioner::Memory preconditioner;
    Uv_coordinates gradient, previous_gradient, direction, trial;
  };

  /// of a small patch
  /// \param deadline when it has passed a minimization ends with the map so far
  Balanced_minimizer(const Patch& patch, const Balanced_minimization& options, const Deadline& deadline = {})
    : Balanced_minimizer(patch, options, deadline, Multigrid_preconditioner(patch))
  {}

  /// of a large patch, of which coarser ones have been minimised
  Balanced_minimizer(const Patch& patch, const Coarse_patch& to_coarser, const Balanced_minimizer& coarser,
                     const Balanced_minimization& options, const Deadline& deadline)
    : Balanced_minimizer(patch, options, deadline,
                         Multigrid_preconditioner(patch, to_coarser, coarser.m_preconditioner))
  {}

  const Patch& patch() const { return m_energy.patch(); }

  /// what takes the unit square to the rectangle of a map: see `scale_to_rectangle()`
  Eigen::RowVector2d scale(const Uv_coordinates& uv) const { return m_energy.scale(uv); }

  /// sweeps over \p uv until a sweep gains little: what an interpolated map needs before `minimize()`. Returns what it
  /// cost, in vertices visited.
  /// \param most the largest number of sweeps
  long relax(Uv_coordinates& uv, int most = Minimizer_numbers::MAXIMUM_SWEEPS) const
  {
    const Free_coordinates is_free = free_coordinates(patch(), uv, is_border_sliding());
    double energy = m_energy(uv);
    int sweeps = 0;
    for(bool gains = true; gains && sweeps < most; ++sweeps) {
      m_sweep(is_free, m_energy.scale(uv), uv);
      const double reached = m_energy(uv);
      gains = energy - reached >= Minimizer_numbers::LEAST_SWEEP_GAIN * energy && !has_passed(m_deadline);
      energy = reached;
    }
    return static_cast<long>(sweeps) * uv.rows();
  }

  /// minimises, with the largest number of iterations of the options
  Minimized_map minimize(Minimized_map map, double tolerance, Workspace& workspace) const
  {
    return minimize(std::move(map), tolerance, m_options.maximum_iterations, workspace);
  }

  /// \param tolerance relative: ends when a step promises less, or the last five steps together gained less
  /// \param maximum_iterations largest number of steps, with those that the map has behind it
  /// \param limit ends, too, as soon as the energy will stay above it by all that steps promise; the objective is what
  ///        it would come to then, and not below the limit
  /// \pre the map has no flips and its border lies on the unit square; a map of this minimizer is continued, its
  ///      iterations and its history, too
  Minimized_map minimize(Minimized_map map, double tolerance, unsigned int maximum_iterations, Workspace& workspace,
                         double limit = std::numeric_limits<double>::infinity()) const
  {
    const Free_coordinates is_free = free_coordinates(patch(), map.uv, is_border_sliding());
    Minimization_report& report = map.report;
    Secant_memory memory(Minimizer_numbers::SECANT_PAIRS);
    report.objective = gradient_at(map.uv, is_free, workspace.gradient);
    if(report.history.empty())
      report.history.push_back(report.objective);
    const unsigned int first_iteration = report.iterations;
    unsigned int age = 0; // of the factors
    while(true) {
      if(report.iterations >= maximum_iterations) {
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
      if(report.iterations > first_iteration && stays_above(limit, report.history, slope)) {
        report.stop_reason = Stop_reason::CONVERGED;
        report.objective = (std::max)(report.objective + slope / 2, limit);
        break;
      }
      const bool goes_round = go_round_blocked(is_free, memory, map.uv, workspace, slope);
      if(!search_line(report.objective, slope, map.uv, workspace)) {
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
    map.work += Minimizer_numbers::STEP_WORK * (report.iterations - first_iteration) * patch().number_of_vertices();
    report.gradient_norm = workspace.gradient.norm();
    measure_stretch(map);
    return map;
  }

  /// sweeps over a minimised map a few times: what is left in tiny triangles counts for nothing in the energy, but may
  /// be the largest stretch of all
  void settle(Minimized_map& map) const
  {
    const Free_coordinates is_free = free_coordinates(patch(), map.uv, is_border_sliding());
    for(int i = 0; i < Minimizer_numbers::SETTLING_SWEEPS; ++i)
      m_sweep(is_free, m_energy.scale(map.uv), map.uv);
    Uv_coordinates gradient;
    map.report.objective = map.report.history.back() = gradient_at(map.uv, is_free, gradient);
    map.report.gradient_norm = gradient.norm();
    measure_stretch(map);
  }

private:
  Balanced_minimizer(const Patch& patch, const Balanced_minimization& options, const Deadline& deadline,
                     Multigrid_preconditioner preconditioner)
    : m_energy(patch, options.balance, options.aspect),
      m_preconditioner(std::move(preconditioner)),
      m_sweep(patch, options.balance),
      m_options(options),
      m_deadline(deadline)
  {}

  /// on the rectangle of the energy
  void measure_stretch(Minimized_map& map) const
  {
    map.aspect = m_energy.aspect(map.uv);
    map.report.l2 = std::sqrt(stretch_energy(patch(), on_rectangle(map.uv, map.aspect)));
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
    constexpr std::size_t STEPS = Minimizer_numbers::STEPS_COMPARED;
    return history.size() > STEPS && history[history.size() - 1 - STEPS] - history.back() <= tolerance * history.back();
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
    gradient = is_free.select(gradient, 0.);
    return energy;
  }

  /// sets the direction of descent and returns the slope along it; forgets the memory when that leads upwards
  double find_direction(Secant_memory& memory, Workspace& workspace) const
  {
    const auto precondition = [&](Uv_coordinates& x) { m_preconditioner.apply(workspace.preconditioner, x); };
    workspace.direction = -workspace.gradient;
    memory.apply(precondition, workspace.direction);
    double slope = workspace.gradient.cwiseProduct(workspace.direction).sum();
    if(!(slope < 0) && !memory.is_empty()) {
      memory.clear();
      workspace.direction = -workspace.gradient;
      precondition(workspace.direction);
      slope = workspace.gradient.cwiseProduct(workspace.direction).sum();
    }
    return slope;
  }

  /// turns to another direction where triangles that lose their area on a small part of the way would keep the step
  /// short: their vertices stay, and the others move with regard to that. The sweep mends these triangles. Returns
  /// false when there are none; else the factors are of this direction alone.
  bool go_round_blocked(const Free_coordinates& is_free, Secant_memory& memory, const Uv_coordinates& uv,
                        Workspace& workspace, double& slope) const
  {
    Free_coordinates moves = is_free;
    bool goes_round = false;
    for(int i = 0; i < Minimizer_numbers::MAXIMUM_ROUNDABOUTS && fix_blocked(uv, workspace.direction, moves); ++i) {
      goes_round = true;
      memory.clear();
      if(!m_preconditioner.factorize(m_energy, uv, moves, workspace.preconditioner))
        break;
      workspace.direction = moves.select(-workspace.gradient, 0.);
      m_preconditioner.apply(workspace.preconditioner, workspace.direction);
      slope = workspace.gradient.cwiseProduct(workspace.direction).sum();
    }
    return goes_round;
  }

  /// lets the vertices of triangles that stand in the way stay; false when there are none
  bool fix_blocked(const Uv_coordinates& uv, const Uv_coordinates& direction, Free_coordinates& moves) const
  {
    bool is_any_blocked = false;
    for(const auto& t : patch().triangles)
      if(Minimizer_numbers::STEP_SAFETY * largest_step(t, uv, direction) < Minimizer_numbers::BLOCKED_STEP) {
        is_any_blocked = true;
        for(int v : t)
          moves(v, 0) = moves(v, 1) = false;
      }
    return is_any_blocked;
  }

  /// sets the trial to a map of lower energy on the line from \p uv; false when there is none
  bool search_line(double energy, double slope, const Uv_coordinates& uv, Workspace& workspace) const
  {
    double length = (std::min)(1., Minimizer_numbers::STEP_SAFETY * largest_step(patch(), uv, workspace.direction));
    for(int i = 0; i < Minimizer_numbers::MAXIMUM_STEP_HALVINGS; ++i, length /= 2) {
      workspace.trial = uv + length * workspace.direction;
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
    memory.add(workspace.trial - uv, workspace.gradient - workspace.previous_gradient);
    uv.swap(workspace.trial);
    return energy;
  }

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
