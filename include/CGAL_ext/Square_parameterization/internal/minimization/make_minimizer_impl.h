// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_MAKE_MINIMIZER_IMPL_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_MAKE_MINIMIZER_IMPL_H

#include <CGAL_ext/Square_parameterization/internal/common/compiled_core.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/Coarse_to_fine_minimizer.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/make_minimizer.h>

#include <memory>
#include <variant>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

CGAL_EXT_INLINE_FUNCTION std::shared_ptr<const Map_minimizer> make_minimizer(const Patch& patch,
                                                                             const Balanced_minimization& minimization,
                                                                             const Deadline& deadline,
                                                                             Coarsening coarsening)
{
  return std::make_shared<Coarse_to_fine_minimizer>(patch, minimization, deadline, coarsening);
}

CGAL_EXT_INLINE_FUNCTION std::shared_ptr<const Map_minimizer>
make_minimizer(const Patch& patch, const Minimization& minimization, const Deadline& deadline)
{
  return std::visit([&](const auto& chosen) { return make_minimizer(patch, chosen, deadline); }, minimization);
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_MAKE_MINIMIZER_IMPL_H
