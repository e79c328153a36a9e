// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SEARCH_SEARCH_OUTCOME_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SEARCH_SEARCH_OUTCOME_H

#include <CGAL_ext/Square_parameterization/Square_search_options.h>
#include <CGAL_ext/Square_parameterization/internal/iteration/Minimized_map.h>

namespace CGAL_ext {
namespace internal {

/// the delivered map and the search that found it
struct Search_outcome
{
  Minimized_map map;
  Search_report report;
  double work = 0;         ///< of maps and sketches for its candidates, in vertices visited
  bool heeds_work = false; ///< the strategy was told what maps cost, and may have ended early for that
};

} // namespace internal
} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SEARCH_SEARCH_OUTCOME_H
