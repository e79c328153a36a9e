// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_CUT_REPORT_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_CUT_REPORT_H

#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL_ext {

/// \ingroup PkgSquareParameterizationResults
///
/// one step of the decision on a cut
struct Cut_step
{
  enum Kind
  {
    INITIAL, ///< a cut to begin with, as the topology needs it; later, one that was selected for refinement
    ADDED,   ///< a cut that was extended to a terminal
    DROPPED, ///< a cut that was freed from a terminal
    MOVED    ///< a cut of which a terminal gave way to another
  };

  Kind kind;
  int terminal;   ///< vertex of the surface that was decided on; -1 for none
  double score;   ///< `stretch` plus the weighted length; infinite when no one-to-one map was found
  double stretch; ///< L2 stretch of a quick map, for a few choices of corners: a few per cent above the least
  double length;  ///< of the cut, in units of the square root of the area
};

/// \ingroup PkgSquareParameterizationResults
///
/// what a cut costs and what it leaves
struct Cut_choice
{
  double length;  ///< of the cut, in units of the square root of the area
  double stretch; ///< L2 stretch that is left
};

/// \ingroup PkgSquareParameterizationResults
///
/// the cut that made a surface a disk, and how it was decided on
struct Cut_report
{
  std::size_t seam_edges = 0; ///< number of edges cut
  double cut_length = 0;      ///< in units of the square root of the area, every seam counted once
  /// of the cut that was taken: `stretch` plus the weighted `cut_length`; infinite when there was nothing to decide, and for a
  /// cut that replaces another one
  double score = std::numeric_limits<double>::infinity();
  double stretch = std::numeric_limits<double>::infinity(); ///< its L2 stretch, on the surface that was decided on
  std::vector<Cut_step> history; ///< steps of the decision; empty when there was nothing to decide

  /// the cuts that are best at some `Cut_options::cut_weight`, the shortest first, on the surface that was decided on.
  /// The best at the weight wanted, and at most two that come near it, were judged by a search of their corners; the stretch of
  /// the others is that of a few corners, up to 3 % more
  std::vector<Cut_choice> front;

  std::size_t decision_faces = 0; ///< faces of the surface decided on: fewer than the input's when that was simplified

  /// the cut that was decided on left no disk with a map, or one with an L2 stretch of many hundred, and the shortest cut was taken
  /// instead
  bool is_replaced = false;
  bool is_cancelled = false; ///< the deadline ended the comparison of cuts: this is the best so far
};

} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_CUT_REPORT_H
