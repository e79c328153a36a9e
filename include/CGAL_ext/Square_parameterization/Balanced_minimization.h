// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_BALANCED_MINIMIZATION_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_BALANCED_MINIMIZATION_H

#include <CGAL_ext/Square_parameterization/Stretch_minimization.h>

namespace CGAL_ext {

/// \ingroup PkgSquareParameterizationSearches
///
/// whether border vertices may move
enum class Border_motion
{
  FIXED,  ///< every border vertex stays where arc length puts it
  SLIDING ///< border vertices slide along their side of the square; the corners stay
};

/// \ingroup PkgSquareParameterizationSearches
///
/// the minimization of the balanced energy with its numbers.
///
/// Scaled to the area of the square, a face whose map into the square has the singular values \f$ s_1, s_2 \f$ contributes
/// its area times \f$ 1/s_1^2 + 1/s_2^2 + b (s_1^2 + s_2^2) \f$, with the balance \f$ b \f$: twice the squared L2 stretch,
/// and a share of its inverse. The L2 stretch alone does not see magnification: its minimum blows strips of triangles up a
/// hundredfold. A little balance removes that at little cost in L2.
///
/// The start is a few iterations of `Stretch_minimization`; then projected Newton steps follow.
struct Balanced_minimization
{
  double balance = 0.3; ///< dimensionless, in [0, 1]: 0 is pure L2 stretch, 1 the symmetric Dirichlet energy
  Border_motion border = Border_motion::SLIDING; ///< whether border vertices may move

  /// relative decrease of the energy, as a Newton step predicts it, below which the minimization ends; not negative
  double tolerance = 1e-4;

  unsigned int maximum_iterations = 200; ///< largest number of Newton steps

  /// indicates whether all numbers are in their range
  bool is_valid() const { return balance >= 0 && balance <= 1 && tolerance >= 0; }

  /// \cond SKIP_IN_MANUAL
  internal::Map_minimizer make_minimizer(const internal::Patch& patch) const
  {
    Stretch_minimization start;
    start.maximum_iterations = 5;
    return {patch, start.make_iteration(patch),
            internal::Balanced_options{balance, border == Border_motion::SLIDING, tolerance, maximum_iterations}};
  }
  /// \endcond
};

} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_BALANCED_MINIMIZATION_H
