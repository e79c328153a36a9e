// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_DECIDED_CUT_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_DECIDED_CUT_H

#include <CGAL_ext/Square_parameterization/Cut_report.h>
#include <CGAL_ext/Square_parameterization/internal/cut/Cut.h>

#include <limits>

namespace CGAL_ext {
namespace internal {

/// a cut that makes a surface a disk, and what the decision says that it is worth
struct Decided_cut
{
  Cut cut;
  double score = std::numeric_limits<double>::infinity();   ///< see `Cut_report`
  double stretch = std::numeric_limits<double>::infinity(); ///< see `Cut_report`
};

} // namespace internal
} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_DECIDED_CUT_H
