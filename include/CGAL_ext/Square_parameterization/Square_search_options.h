// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_SQUARE_SEARCH_OPTIONS_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_SQUARE_SEARCH_OPTIONS_H

#include <CGAL_ext/Square_parameterization/Corner_rule.h>
#include <CGAL_ext/Square_parameterization/Search_visitor.h>

#include <chrono>
#include <functional>
#include <optional>

namespace CGAL_ext {

/// \ingroup PkgSquareParameterizationSearches
///
/// options that all searches for the corners of the square share.
///
/// The callback and the visitor are called by one thread at a time, during one search; for the choice of a cut the
/// visitor alone.
/// Searches that run at the same time may share options without them.
struct Square_search_options
{
  Corner_rule corner_rule = Corner_rule::NEAREST; ///< where the sides of the square end
  Walk walk = Walk::COUNTER_CLOCKWISE;            ///< direction in which candidates are counted and sides are closed

  /// 0 for all cores. They map candidates side by side, of large surfaces as many as have room in about 2 GB (1 to 3 kB a
  /// vertex), and one candidate together where there are fewer. The result is the same for any number.
  unsigned int number_of_threads = 0;
  Search_visitor* visitor = nullptr; ///< is told of the cut, of the search and of the minimization; may be null

  /// whether after the search the four corners move on their own, all together, in pairs and alone, as long as that
  /// lowers the energy of a coarse map. A rectangle that is not the square is also sought from other shares of the sides
  /// than quarters. The best of what comes out and of the candidates is delivered; the curve tells of candidates
  /// alone, of which a strategy may map fewer then. Not where maps take so long that they are compared far from their minima. Has an effect with `Balanced_minimization`
  /// alone.
  bool moves_corners = true;

  /// when it has passed, no evaluation and no sketch begins, what is being minimised is left as it is, and the best
  /// candidate so far is delivered, marked as cancelled, as when the callback stops the search. Of the time until then
  /// `parameterize_onto_square()` spends three fifths on the decision where to cut, at most, and the search half of the
  /// rest on sketches; with `Square_map_settings::seam_grid` the search leaves a quarter of its time to the map for the
  /// seams. The result then depends on the speed of the machine.
  std::optional<std::chrono::steady_clock::time_point> deadline;

  /// asked before each evaluation, with the share of the candidates evaluated so far, in [0, 1], before each sketch, with
  /// 0, and whenever corners move, with 1. When it returns `false` the search stops within one evaluation per thread and
  /// the best candidate so far is delivered, marked as cancelled; without a candidate so far there is no map
  /// (`ERROR_NO_1_TO_1_MAPPING`). It and the deadline alone stop a search.
  ///
  /// The strategy is left by an exception that is not derived from `std::exception`: see `CornerSearch`.
  std::function<bool(double)> callback;
};

} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_SQUARE_SEARCH_OPTIONS_H
