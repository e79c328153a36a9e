// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_MAKE_MINIMIZER_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_MAKE_MINIMIZER_H

#include <CGAL_ext/Square_parameterization/Minimization.h>
#include <CGAL_ext/Square_parameterization/internal/coarsening/Coarsening.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/make_iteration_minimizer.h>

#include <memory>

namespace CGAL_ext {
namespace internal {

/// makes the minimizer that the options ask for. It refers to the patch, which must live as long.
/// \param deadline when it has passed, minimizations end with the map so far, also those that begin later: each map
///        comes soon then, and is one-to-one, but not the least
/// \pre the options are valid
std::shared_ptr<const Map_minimizer> make_minimizer(const Patch& patch, const Minimization& minimization,
                                                    const Deadline& deadline = {});

/// the balanced energy from coarse to fine
std::shared_ptr<const Map_minimizer> make_minimizer(const Patch& patch, const Balanced_minimization& minimization,
                                                    const Deadline& deadline = {},
                                                    Coarsening coarsening = Coarsening::BY_HALVES);

} // namespace internal
} // namespace CGAL_ext

#ifndef CGAL_EXT_COMPILED_CORE
#include <CGAL_ext/Square_parameterization/internal/minimization/make_minimizer_impl.h>
#endif

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_MAKE_MINIMIZER_H
