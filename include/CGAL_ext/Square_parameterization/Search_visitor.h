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
/// is told how a search and a minimization proceed. Derive from it and override what you need; all functions do nothing
/// by default. The parameterizers hold a pointer to the visitor, which must outlive them: they are copied, the visitor
/// is not. Calls never overlap, but may come from different threads.
class Search_visitor
{
public:
  virtual ~Search_visitor() = default;

  /// called once, before the first evaluation, with the number of candidates: an upper bound of the evaluations
  virtual void start_search(std::size_t /* candidates */) {}

  /// asked before each evaluation. When it returns `false` the search stops within one evaluation per thread, and the
  /// best candidate so far is delivered, marked as cancelled.
  virtual bool may_continue() { return true; }

  /// called after each evaluation, in the order in which they finish, which differs from run to run with several
  /// threads
  virtual void after_evaluation(const Search_report::Sample& /* sample */) {}

  /// called once, after the last evaluation
  virtual void end_search(const Search_report& /* report */) {}

  /// called by a parameterizer, or by `parameterize_onto_square()`, with the minimization that made the delivered map
  virtual void end_minimization(const Minimization_report& /* report */) {}
};

} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_SEARCH_VISITOR_H
