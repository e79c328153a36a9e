// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_MINIMIZATION_REPORT_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_MINIMIZATION_REPORT_H

#include <limits>
#include <vector>

namespace CGAL_ext {

/// \ingroup PkgSquareParameterizationEnums
///
/// why a minimization ended
enum class Stop_reason
{
  STRETCH_GROWS,      ///< as many iterates in a row as the patience allows were not lower: the iteration's normal end
  CONVERGED,          ///< the next step promises, or the last five gained, less than the tolerance: the normal end of
                      ///< the minimizer of the balanced energy
  NO_LOWER_MAP,       ///< no step down the gradient is lower: rounding is reached
  MAXIMUM_ITERATIONS, ///< the given number of iterations was reached
  CANNOT_SOLVE,       ///< a linear system could not be solved; the best map before it, if any, is kept
  DEADLINE,           ///< the deadline of the search has passed: the map so far is kept
  INFEASIBLE_BORDER   ///< an interior edge has both ends on one side of the square: no one-to-one map exists
};

/// \ingroup PkgSquareParameterizationResults
///
/// says how a map was reached: by the iteration of `Stretch_minimization`, or by the minimizer of
/// `Balanced_minimization`
struct Minimization_report
{
  /// what was minimised, of the map that was kept: its L2 stretch, or its balanced energy; dimensionless
  double objective = std::numeric_limits<double>::infinity();
  double l2 = std::numeric_limits<double>::infinity(); ///< L2 stretch of the map that was kept; dimensionless, least 1

  /// number of linear systems that the iteration solved after the first, or of L-BFGS steps, each followed by a sweep
  /// over the vertices, that the minimizer of the balanced energy made on the mesh itself
  unsigned int iterations = 0;
  unsigned int best_iteration =
      0;                       ///< the one whose map was kept; 0 is the start, the last one with the balanced energy
  std::vector<double> history; ///< the objective at the start and after each iteration
  double gradient_norm = 0;    ///< of the balanced energy at the end; 0 for the iteration
  Stop_reason stop_reason = Stop_reason::INFEASIBLE_BORDER; ///< why the minimization ended
};

} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_MINIMIZATION_REPORT_H
