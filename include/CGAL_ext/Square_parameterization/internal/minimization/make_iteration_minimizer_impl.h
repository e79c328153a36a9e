// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_MAKE_ITERATION_MINIMIZER_IMPL_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_MAKE_ITERATION_MINIMIZER_IMPL_H

#include <CGAL_ext/Square_parameterization/internal/common/compiled_core.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/Iteration_minimizer.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/make_iteration_minimizer.h>

#include <memory>
#include <utility>

namespace CGAL_ext {
namespace internal {

CGAL_EXT_INLINE_FUNCTION std::shared_ptr<const Map_minimizer> make_minimizer(const Patch& patch,
                                                                             const Stretch_minimization& minimization,
                                                                             const Deadline& deadline,
                                                                             Linear_solver_factory make_solver)
{
  return std::make_shared<Iteration_minimizer>(patch, minimization, deadline, std::move(make_solver));
}

} // namespace internal
} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_MAKE_ITERATION_MINIMIZER_IMPL_H
