// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_SQUARE_MAP_OPTIONS_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_SQUARE_MAP_OPTIONS_H

#include <CGAL_ext/Square_parameterization/Bracketing_corner_search.h>
#include <CGAL_ext/Square_parameterization/Cut_options.h>
#include <CGAL_ext/Square_parameterization/Minimization.h>
#include <CGAL_ext/Square_parameterization/Square_search_options.h>
#include <CGAL_ext/Square_parameterization/corner_searches.h>
#include <CGAL_ext/Square_parameterization/split_chords.h>

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL_ext {

/// \ingroup PkgSquareParameterizationFunctions
///
/// what `parameterize_onto_square()` is to do. Every member has a default.
struct Square_map_options
{
  /// chooses the corners: any model of `CornerSearch`
  Corner_search search = Bracketing_corner_search();
  Minimization minimization = Balanced_minimization(); ///< how each candidate is mapped
  Square_search_options search_options;                ///< corner rule, walk, threads, visitor and callback
  Chords chords = Chords::ALL;                         ///< which chords are split
  /// how the surface is cut to a disk; its balance is that of `minimization`, where that has one, and its number of
  /// threads that of `search_options`
  Cut_options cut;

  /// edges to cut along in any case, each as two indices in the order of `vertices(mesh)`; what they lack is added
  std::vector<std::array<std::size_t, 2>> seams;

  /// four border vertices for (0, 0), (1, 0), (1, 1) and (0, 1), counter-clockwise, as indices in the order of
  /// `vertices(mesh)`; none: the corners are searched. A vertex that is cut stands for its copies, and may be given
  /// more than once, as the ends of a seam along a cylinder: of the copies in order those are taken that leave the
  /// longest shortest side.
  std::optional<std::array<std::size_t, 4>> corners;
};

} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_SQUARE_MAP_OPTIONS_H
