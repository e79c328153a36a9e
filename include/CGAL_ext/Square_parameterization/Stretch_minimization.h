// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_STRETCH_MINIMIZATION_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_STRETCH_MINIMIZATION_H

#include <CGAL_ext/Square_parameterization/base_weights.h>

#include <functional>

namespace CGAL_ext {

/// \ingroup PkgSquareParameterizationSearches
///
/// the stretch-minimizing parameterization (Yoshizawa, Belyaev and Seidel 2004) with its numbers: what
/// `Stretch_minimizing_parameterizer_3` does, what a search minimises when its border parameterizer serves a
/// parameterizer of CGAL, and what `parameterize_onto_square()` does instead of its default, `Balanced_minimization`,
/// when its options say so. `Hybrid_corner_search` suits it.
struct Stretch_minimization
{
  /// the weights of the first system: any model of `BaseWeights`
  std::function<Edge_weights(const Patch&)> weights = Blended_weights();

  /// exponent of the stretch by which weights are divided; dimensionless, in ]0, 1]; 1 is the paper's. The first
  /// iterations take 0.7, 0.49, ... where `eta` is less. The smaller, the more iterations and, by 0 to 1 %, the lower
  /// the stretch.
  double eta = 0.3;

  /// number of iterates in a row that may fail to be lower before the iteration stops; 0 is the paper's rule
  unsigned int patience = 1;

  /// largest number of linear systems solved after the first
  unsigned int maximum_iterations = 100;

  /// indicates whether weights are given and `eta` is in its range
  bool is_valid() const { return weights && eta > 0 && eta <= 1; }
};

} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_STRETCH_MINIMIZATION_H
