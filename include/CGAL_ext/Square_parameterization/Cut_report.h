// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_CUT_REPORT_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_CUT_REPORT_H

#include <cstddef>
#include <vector>

namespace CGAL_ext {

/// \ingroup PkgSquareParameterizationResults
///
/// one step of the decision on a cut
struct Cut_step
{
  enum Kind
  {
    INITIAL, ///< the best of the cuts to begin with: those that the topology needs; later, those that were grown
    ADDED,   ///< the cut was extended to a terminal
    DROPPED, ///< the cut was freed from a terminal
    MOVED    ///< a terminal of the cut gave way to another
  };

  Kind kind;
  int terminal;   ///< vertex of the surface that was decided on; -1 for the initial cut
  double score;   ///< `stretch` plus the weighted length; infinite when no one-to-one map was found
  double stretch; ///< least L2 stretch found for the cut with a few corners
  double length;  ///< of the cut, in units of the square root of the area
};

/// \ingroup PkgSquareParameterizationResults
///
/// the cut that made a surface a disk, and how it was decided on
struct Cut_report
{
  std::size_t seam_edges = 0;     ///< number of edges cut
  double cut_length = 0;          ///< in units of the square root of the area, every seam counted once
  std::vector<Cut_step> history;  ///< steps of the decision; empty when there was nothing to decide
  std::size_t decision_faces = 0; ///< faces of the surface decided on: fewer than the input's when that was simplified
};

} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_CUT_REPORT_H
