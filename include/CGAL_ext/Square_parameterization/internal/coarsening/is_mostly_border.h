// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COARSENING_IS_MOSTLY_BORDER_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COARSENING_IS_MOSTLY_BORDER_H

#include <CGAL_ext/Square_parameterization/internal/common/Minimizer_numbers.h>
#include <CGAL_ext/Square_parameterization/internal/patch/Patch.h>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// indicates whether so much of a patch is border, as of a polygon or a strip, that to remove the other vertices leaves most of it
inline bool is_mostly_border(const Patch& patch)
{
  const auto border = static_cast<double>(patch.border.size());
  return border >= Minimizer_numbers::LARGEST_BORDER * (patch.number_of_vertices() - border);
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COARSENING_IS_MOSTLY_BORDER_H
