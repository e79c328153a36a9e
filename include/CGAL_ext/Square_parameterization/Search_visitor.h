// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_SEARCH_VISITOR_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_SEARCH_VISITOR_H

#include <CGAL_ext/Square_parameterization/Minimization_report.h>
#include <CGAL_ext/Square_parameterization/Search_report.h>

#include <cstddef>

namespace CGAL_ext {

/// \ingroup PkgSquareParameterizationResults
///
/// is told how the choice of a cut, a search and a minimization proceed. Derive from it and override what you need; all
/// functions do nothing by default. It is given in `Square_search_options`, and only watches: to stop a search is for
/// `Square_search_options::callback`.
///
/// Parameterizers hold a pointer to the visitor, which must outlive them: they are copied, the visitor is not. The calls
/// for one map never overlap, but may come from different threads; a visitor of several maps that are made at the same
/// time has to guard itself. An exception that a visitor throws ends the search and comes out of `parameterize()` or
/// `parameterize_onto_square()`.
class Search_visitor
{
public:
  virtual ~Search_visitor() = default;

  /// called while cuts are compared, before everything else, with the share of that work that is done: an estimate, 0
  /// first, never less than before, 1 last. Not called where there is nothing to compare.
  virtual void cut_progress(double /* share */) {}

  /// called before the first evaluation, once, and again for each other start (see `Map_start`) that is tried, and for a
  /// second cut that all but ties with the best, or takes its place where that leaves no good map, with the number of candidates: an
  /// upper bound of the evaluations
  virtual void start_search(std::size_t /* candidates */) {}

  /// called after each sketch, the map of a candidate on a coarser mesh: see `Corner_search_problem`
  virtual void after_sketch(const Search_report::Sample& /* sample */) {}

  /// called after each evaluation, in the order in which they finish, which differs from run to run with several
  /// threads
  virtual void after_evaluation(const Search_report::Sample& /* sample */) {}

  /// called after each map that is made to move the corners on their own (`Square_search_options::moves_corners`), most of
  /// them of a coarser mesh; their number is not known before
  virtual void after_corner_move() {}

  /// called after all of these, before the best map is minimised to the end, unless a search is refused or left by an
  /// exception; once more where other starts are tried after that, and for a second cut
  virtual void start_minimization() {}

  /// called after that, as often, with the search that found the map; of a second cut it is the last one, though the map of
  /// the first may be the better
  virtual void end_search(const Search_report& /* report */) {}

  /// called once, after all of these, with the minimization that made the best map: the delivered one, unless another
  /// parameterizer takes the border alone from it. Not called where there is no map.
  virtual void end_minimization(const Minimization_report& /* report */) {}
};

} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_SEARCH_VISITOR_H
