// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COMMON_OPTIONS_PARAMETER_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COMMON_OPTIONS_PARAMETER_H

namespace CGAL_ext {
namespace internal {

/// tag of the named parameter that `parameters::options()` makes
enum options_t
{
  options
};

} // namespace internal
} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COMMON_OPTIONS_PARAMETER_H
