// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_BALANCED_MINIMIZATION_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_BALANCED_MINIMIZATION_H

#include <CGAL_ext/Square_parameterization/Stretch_minimization.h>

#include <optional>

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
/// Scaled to the area of the square, a face whose map into the square has the singular values \f$ s_1, s_2 \f$
/// contributes its area times \f$ 1/s_1^2 + 1/s_2^2 + b (s_1^2 + s_2^2) \f$, with the balance \f$ b \f$: twice the
/// squared L2 stretch, and a share of its inverse. The L2 stretch alone does not see magnification: its minimum blows
/// strips of triangles up a hundredfold. A little balance removes that at little cost in L2.
///
/// The map is computed from coarse to fine: on a sequence of meshes of which each has half the vertices of the next,
/// L-BFGS with the blocks of the projected Hessian as preconditioner, and sweeps over the vertices.
struct Balanced_minimization
{
  double balance = 0.3; ///< dimensionless, in [0, 1]: 0 is pure L2 stretch, 1 the symmetric Dirichlet energy
  Border_motion border = Border_motion::SLIDING; ///< whether border vertices may move

  /// relative decrease of the energy, as promised by a step or made by the last five together, below which the
  /// minimization of the delivered map ends; not negative. After a hundred steps it ends, too, when the last thirty made
  /// less than 200 times as much.
  double tolerance = 1e-6;

  /// the same while candidates for the corners are compared; not negative
  double search_tolerance = 1e-4;

  /// largest number of steps on the mesh itself; there are fewer where they have taken half a second on a mesh of up to
  /// 20000 vertices, or in proportion on a larger one
  unsigned int maximum_iterations = 600;

  /// width over height of the rectangle that the energy is minimised on, in [1e-3, 1e3]; 1 is the square, and none the
  /// rectangle on which the energy is least. The map is given on the unit square in any case: the rectangle, of area 1,
  /// is that stretched by the root of the aspect in u, and shrunk as much in v.
  std::optional<double> aspect = 1;

  /// how the coarsest mesh is mapped: a few iterations, which little of the result depends on
  Stretch_minimization start = few_iterations();

  /// indicates whether all numbers are in their range
  bool is_valid() const
  {
    return balance >= 0 && balance <= 1 && tolerance >= 0 && search_tolerance >= 0 && has_valid_aspect(aspect) &&
           start.is_valid();
  }

  /// indicates whether an aspect is in its range, or none
  static bool has_valid_aspect(const std::optional<double>& aspect)
  {
    return !aspect || (*aspect >= 1e-3 && *aspect <= 1e3);
  }

private:
  static Stretch_minimization few_iterations()
  {
    Stretch_minimization iteration;
    iteration.maximum_iterations = 5;
    return iteration;
  }
};

} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_BALANCED_MINIMIZATION_H
