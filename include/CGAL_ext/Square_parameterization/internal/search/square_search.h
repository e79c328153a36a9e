// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SEARCH_SQUARE_SEARCH_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SEARCH_SQUARE_SEARCH_H

#include <CGAL_ext/Square_parameterization/Square_search_options.h>
#include <CGAL_ext/Square_parameterization/corner_searches.h>
#include <CGAL_ext/Square_parameterization/internal/border/border_curves.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/Map_minimizer.h>

namespace CGAL_ext {
namespace internal {

/// the delivered map and the search that found it
struct Search_outcome
{
  Minimized_map map;
  Search_report report;
};

/// refuses a strategy of which a number is out of its range
inline void check_corner_search(const Corner_search& search)
{
  if(!search.is_valid())
    throw Unmappable(CGAL::Surface_mesh_parameterization::ERROR_WRONG_PARAMETER,
                     "a number of the corner search is out of its range");
}

/// searches the corners of the square among the candidates of \p search and maps the patch for the best of them.
/// Throws `Unmappable` for a strategy with a number out of range, that asks for a candidate that does not exist, or for
/// none.
Search_outcome search_square_map(const Patch& patch, const Map_minimizer& minimizer, const Corner_search& search,
                                 const Square_search_options& options);

/// maps the patch for four corners chosen by the user
/// \pre the positions are distinct and in counter-clockwise order
Search_outcome map_with_corners(const Patch& patch, const Map_minimizer& minimizer, const Corners& corners);

} // namespace internal
} // namespace CGAL_ext

#ifndef CGAL_EXT_COMPILED_CORE
#include <CGAL_ext/Square_parameterization/internal/search/square_search_impl.h>
#endif

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SEARCH_SQUARE_SEARCH_H
