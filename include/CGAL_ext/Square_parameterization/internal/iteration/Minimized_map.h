// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ITERATION_MINIMIZED_MAP_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ITERATION_MINIMIZED_MAP_H

#include <CGAL_ext/Square_parameterization/Minimization_report.h>
#include <CGAL_ext/Square_parameterization/internal/patch/Patch.h>

namespace CGAL_ext {
namespace internal {

/// a map of a patch and how it was reached
struct Minimized_map
{
  Uv_coordinates uv; ///< #V by 2; empty when no one-to-one map was found
  Minimization_report report;
  Uv_coordinates warm_start; ///< from which a similar border may be mapped; empty when the minimizer has none
  double aspect = 1;         ///< width over height of the rectangle that the map is measured on
  long work = 0;             ///< what it cost, in vertices visited by sweeps; a step over the mesh counts for several
  long work_of_starts = 0;   ///< the same of all starts, where it is hopeless or several were tried: the last steps may
                             ///< cost less then
};

} // namespace internal
} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ITERATION_MINIMIZED_MAP_H
