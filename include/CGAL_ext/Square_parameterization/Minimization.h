// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_MINIMIZATION_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_MINIMIZATION_H

#include <CGAL_ext/Square_parameterization/Balanced_minimization.h>
#include <CGAL_ext/Square_parameterization/Stretch_minimization.h>

#include <variant>

namespace CGAL_ext {

/// \ingroup PkgSquareParameterizationSearches
///
/// what is minimised, and how: the balanced energy from coarse to fine, or the L2 stretch by the iteration of Yoshizawa
/// et al. One of the two is in force, with its own numbers: assign the one that is wanted, as in
/// `options.minimization = CGAL_ext::Stretch_minimization();`.
typedef std::variant<Balanced_minimization, Stretch_minimization> Minimization;

} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_MINIMIZATION_H
