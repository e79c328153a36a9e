// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_NUMBER_OF_LOOPS_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_NUMBER_OF_LOOPS_H

#include <CGAL_ext/Square_parameterization/internal/cut/Cut_numbers.h>
#include <CGAL_ext/Square_parameterization/internal/surface/Triangle_surface.h>

namespace CGAL_ext {
namespace internal {

/// the number of holes, and twice that of handles
inline int number_of_loops(const Triangle_surface& surface)
{
  return 2 * surface.genus() + static_cast<int>(surface.border_loops.size());
}

/// indicates whether the handles and holes make one cut much like another, and a terminal more or less nothing
inline bool has_many_loops(const Triangle_surface& surface, const Cut_numbers& numbers)
{
  return number_of_loops(surface) >= numbers.many_loops;
}

} // namespace internal
} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_NUMBER_OF_LOOPS_H
