// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SEARCH_SQUARE_SEARCH_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SEARCH_SQUARE_SEARCH_H

#include <CGAL_ext/Square_parameterization/Square_search_options.h>
#include <CGAL_ext/Square_parameterization/corner_searches.h>
#include <CGAL_ext/Square_parameterization/internal/border/border_curves.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/Map_minimizer.h>
#include <CGAL_ext/Square_parameterization/internal/search/Search_outcome.h>

namespace CGAL_ext {
namespace internal {

/// refuses a strategy of which a number is out of its range
inline void check_corner_search(const Corner_search& search)
{
  if(!search.is_valid())
    throw Unmappable(CGAL::Surface_mesh_parameterization::ERROR_WRONG_PARAMETER,
                     "a number of the corner search is out of its range");
}

/// searches the corners of the square among the candidates of \p search and maps the patch for the best of them, as well
/// as comparing needs, with the threads of the current team: `finish_map()` is to follow. Throws `Unmappable` for a
/// strategy with a number out of range, that asks for a candidate that does not exist, or for none.
/// \param work_factor times the work of an ordinary search that a strategy may take that ends early where maps cost much
Search_outcome search_corners(const Patch& patch, const Map_minimizer& minimizer, const Corner_search& search,
                              const Square_search_options& options, double work_factor = 1);

/// maps the patch for four corners chosen by the user, as well as a search would
/// \pre the positions are distinct and in counter-clockwise order
Search_outcome map_with_corners(const Patch& patch, const Map_minimizer& minimizer, const Corners& corners);

/// minimises the map, if there is one, to the tolerance of the one that is delivered
/// \param visitor told of it, and of the end of the search; may be null
/// \param limit one whose objective stays above it is left for a later call
void finish_map(const Map_minimizer& minimizer, Search_visitor* visitor, Search_outcome& outcome,
                double limit = Map_minimizer::NO_LIMIT);

/// `search_corners()` and `finish_map()` for callers that have no team: with as many threads as the options say
Search_outcome search_square_map(const Patch& patch, const Map_minimizer& minimizer, const Corner_search& search,
                                 const Square_search_options& options);

} // namespace internal
} // namespace CGAL_ext

#ifndef CGAL_EXT_COMPILED_CORE
#include <CGAL_ext/Square_parameterization/internal/search/square_search_impl.h>
#endif

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SEARCH_SQUARE_SEARCH_H
