// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_MAKE_ITERATION_MINIMIZER_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_MAKE_ITERATION_MINIMIZER_H

#include <CGAL_ext/Square_parameterization/Stretch_minimization.h>
#include <CGAL_ext/Square_parameterization/internal/common/Deadline.h>
#include <CGAL_ext/Square_parameterization/internal/iteration/linear_solvers.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/Map_minimizer.h>

#include <memory>

namespace CGAL_ext {
namespace internal {

/// makes the iteration of Yoshizawa et al. It refers to the patch, which must live as long. In a header of its own: what
/// iterates alone need not compile the other minimizer.
/// \param deadline when it has passed, no iteration begins: maps are the best so far
/// \param make_solver makes the solver of its linear systems
/// \pre the options are valid
std::shared_ptr<const Map_minimizer> make_minimizer(const Patch& patch, const Stretch_minimization& minimization,
                                                    const Deadline& deadline = {},
                                                    Linear_solver_factory make_solver = make_direct_solver);

} // namespace internal
} // namespace CGAL_ext

#ifndef CGAL_EXT_COMPILED_CORE
#include <CGAL_ext/Square_parameterization/internal/minimization/make_iteration_minimizer_impl.h>
#endif

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_MAKE_ITERATION_MINIMIZER_H
