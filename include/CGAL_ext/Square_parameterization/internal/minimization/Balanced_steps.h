// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_BALANCED_STEPS_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_BALANCED_STEPS_H

#include <CGAL_ext/Square_parameterization/internal/common/Minimizer_numbers.h>
#include <CGAL_ext/Square_parameterization/internal/energy/Balanced_energy.h>
#include <CGAL_ext/Square_parameterization/internal/energy/feasible_step.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/Multigrid_preconditioner.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/Secant_memory.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/Vertex_sweep.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/rows_by_ranges.h>

#include <algorithm>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// the steps of one minimization: L-BFGS with the blocks of the Hessian as preconditioner, and one sweep over the vertices
/// after each step.
///
/// A step goes at most nine tenths of the way to the first triangle without area; the line search halves. The sweep
/// then mends the triangles that stood in the way, which would keep the next steps short, too.
class Balanced_steps
{
public:
  /// the memory of one thread
  struct Workspace
  {
    Multigrid_preconditioner::Memory preconditioner;
    Uv_coordinates gradient, previous_gradient, direction, trial;

    /// frees what no steps on a finer patch need
    void end_steps()
    {
      for(Uv_coordinates* of_step : {&gradient, &previous_gradient, &direction, &trial})
        of_step->resize(0, 2);
    }
  };

  /// \param steps_before those that have led to the map
  Balanced_steps(const Patch& patch, const Balanced_energy& energy, const Multigrid_preconditioner& preconditioner,
                 const Vertex_sweep& sweep, const Free_coordinates& is_free, unsigned int steps_before,
                 Workspace& workspace)
    : m_patch(patch),
      m_energy(energy),
      m_preconditioner(preconditioner),
      m_sweep(sweep),
      m_is_free(is_free),
      m_workspace(workspace),
      m_steps(steps_before)
  {}

  /// sets the gradient, and returns the energy
  double look_at(const Uv_coordinates& uv)
  {
    m_reached = m_energy.gradient(uv, m_workspace.gradient);
    set_rows(m_workspace.gradient, uv.rows(),
             [&](const auto& rows) { return rows(m_is_free).select(rows(m_workspace.gradient), 0.); });
    return m_reached;
  }

  /// takes the factors anew when they have come of age; false when that fails
  bool refresh_factors(const Uv_coordinates& uv) { return m_age > 0 || factorize(uv, m_is_free); }

  /// sets the direction of descent and returns the slope along it; forgets the memory when that leads upwards
  double find_direction()
  {
    const auto precondition = [&](Uv_coordinates& x) { m_preconditioner.apply(m_workspace.preconditioner, x); };
    const auto descend_steepest = [this] {
      set_rows(m_workspace.direction, m_workspace.gradient.rows(),
               [&](const auto& rows) { return -rows(m_workspace.gradient); });
    };
    descend_steepest();
    m_memory.apply(precondition, m_workspace.direction);
    double slope = dot(m_workspace.gradient, m_workspace.direction);
    if(!(slope < 0) && !m_memory.is_empty()) {
      m_memory.clear();
      descend_steepest();
      precondition(m_workspace.direction);
      slope = dot(m_workspace.gradient, m_workspace.direction);
    }
    return slope;
  }

  /// sets the trial to a map of lower energy in the direction, or in another one that leads round what stands in the
  /// way; false when there is none
  bool try_step(double energy, double slope, const Uv_coordinates& uv)
  {
    double feasible = largest_step(m_patch, uv, m_workspace.direction);
    m_has_gone_round = go_round_blocked(uv, slope, feasible);
    return search_line(energy, slope, feasible, uv);
  }

  /// after a step that failed: prepares for one by the Hessian alone, taken anew; false when it was such a step
  bool start_afresh()
  {
    if(m_age == 0 && m_memory.is_empty())
      return false;
    m_memory.clear();
    m_age = 0;
    return true;
  }

  /// sweeps over the trial, makes it the map, remembers the step, and returns the energy
  double take_step(Uv_coordinates& uv)
  {
    ++m_steps;
    m_sweep(m_is_free, m_energy.scale(m_workspace.trial), m_workspace.trial);
    m_workspace.previous_gradient.swap(m_workspace.gradient);
    const double energy = look_at(m_workspace.trial);
    uv.swap(m_workspace.trial);
    Uv_coordinates &change = m_workspace.trial, &gradient_change = m_workspace.previous_gradient; // in place
    set_rows(change, uv.rows(), [&](const auto& rows) { return rows(uv) - rows(change); });
    set_rows(gradient_change, uv.rows(),
             [&](const auto& rows) { return rows(m_workspace.gradient) - rows(gradient_change); });
    m_memory.add(change, gradient_change);
    m_age = m_has_gone_round ? 0 : (m_age + 1) % lifetime_of_factors(m_steps);
    if(m_has_gone_round)
      m_memory.clear(); // of a step that was none of the whole mesh
    return energy;
  }

  /// the number of directions that were tried to go round triangles
  long roundabouts() const { return m_roundabouts; }

private:
  /// takes the matrices at \p uv. Those of a map that is stretched are of the energy and 2 L2^2 times the area, by
  /// which fewer eigenvalues are negative: sheets with fins, which are stretched thirty times, end 1 % lower.
  bool factorize(const Uv_coordinates& uv, const Free_coordinates& moves)
  {
    const bool is_stretched = Minimizer_numbers::is_stretched(m_reached, m_patch.number_of_vertices());
    return m_preconditioner.factorize(m_energy, uv, moves, m_workspace.preconditioner,
                                      is_stretched ? m_energy.twice_squared_l2(uv, m_energy.scale(uv))
                                                   : Balanced_energy::AREA_MULTIPLE);
  }

  /// far from the minimum the Hessian changes more from step to step
  static unsigned int lifetime_of_factors(unsigned int steps)
  {
    return steps <= Minimizer_numbers::EARLY_STEPS ? Minimizer_numbers::EARLY_LIFETIME
                                                   : Minimizer_numbers::LATE_LIFETIME;
  }

  /// turns to another direction where triangles that lose their area on a small part of the way would keep the step
  /// short: their vertices stay, and the others move with regard to that. The sweep mends these triangles. Tells whether
  /// another direction was tried; then the factors are of the last one alone.
  ///
  /// After more steps than a coarse map may take the matrices are those of the last factors, however old: they only lose rows,
  /// which costs a quarter as much as new ones, and maps are hardly worse for it. Some coarse maps would be lost by it.
  /// \param feasible the largest step in the direction
  bool go_round_blocked(const Uv_coordinates& uv, double& slope, double& feasible)
  {
    const double blocked = blocked_step();
    Free_coordinates moves = m_is_free;
    bool uses_last_factors = m_age == 0 || m_steps > Minimizer_numbers::COARSE_ITERATIONS;
    int tries = 0;
    while(tries < Minimizer_numbers::MAXIMUM_ROUNDABOUTS && is_blocked(feasible, blocked)) {
      ++tries;
      fix_blocked(uv, blocked, moves);
      m_memory.clear();
      if(!(uses_last_factors ? m_preconditioner.factorize_fewer(moves, m_workspace.preconditioner)
                             : factorize(uv, moves)))
        break;
      uses_last_factors = true;
      m_workspace.direction = moves.select(-m_workspace.gradient, 0.);
      m_preconditioner.apply(m_workspace.preconditioner, m_workspace.direction);
      slope = dot(m_workspace.gradient, m_workspace.direction);
      feasible = largest_step(m_patch, uv, m_workspace.direction);
    }
    m_roundabouts += tries;
    return tries > 0;
  }

  /// length of a step below which it is blocked: after many steps, where triangles still stand in the way, the less the
  /// more it costs to go round them
  double blocked_step() const
  {
    const bool is_late = m_steps > Minimizer_numbers::MANY_STEPS;
    return Minimizer_numbers::BLOCKED_STEP /
           (is_late ? Minimizer_numbers::growth_of_roundabouts(m_patch.number_of_vertices()) : 1);
  }

  static bool is_blocked(double feasible, double blocked)
  {
    return Minimizer_numbers::STEP_SAFETY * feasible < blocked;
  }

  /// lets the vertices of triangles that stand in the way stay
  void fix_blocked(const Uv_coordinates& uv, double blocked, Free_coordinates& moves) const
  {
    const double least = blocked / Minimizer_numbers::STEP_SAFETY;
    for(const auto& t : m_patch.triangles)
      if(is_blocked(largest_step(t, uv, m_workspace.direction, least), blocked))
        for(int v : t)
          moves(v, 0) = moves(v, 1) = false;
  }

  /// sets the trial to a map of lower energy on the line from \p uv; false when there is none
  /// \param feasible the largest step in the direction
  bool search_line(double energy, double slope, double feasible, const Uv_coordinates& uv)
  {
    double length = (std::min)(1., Minimizer_numbers::STEP_SAFETY * feasible);
    for(int i = 0; i < Minimizer_numbers::MAXIMUM_STEP_HALVINGS; ++i, length /= 2) {
      set_rows(m_workspace.trial, uv.rows(),
               [&](const auto& rows) { return rows(uv) + length * rows(m_workspace.direction); });
      if(m_energy(m_workspace.trial) <= energy + Minimizer_numbers::SUFFICIENT_DECREASE * length * slope)
        return true;
    }
    return false;
  }

  const Patch& m_patch;
  const Balanced_energy& m_energy;
  const Multigrid_preconditioner& m_preconditioner;
  const Vertex_sweep& m_sweep;
  const Free_coordinates& m_is_free;
  Workspace& m_workspace;
  unsigned int m_steps; // that have led to the map
  Secant_memory m_memory{Minimizer_numbers::SECANT_PAIRS};
  double m_reached = 0;   // the energy of the map
  unsigned int m_age = 0; // of the factors, in steps
  long m_roundabouts = 0;
  bool m_has_gone_round = false; // in the step that is tried
};

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_BALANCED_STEPS_H
