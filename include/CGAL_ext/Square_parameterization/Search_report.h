// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_SEARCH_REPORT_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_SEARCH_REPORT_H

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL_ext {

/// \ingroup PkgSquareParameterizationResults
///
/// what a search for the corners of the square has found. Candidate `j` puts the border vertex met `j` steps along the
/// walk from the start of the border onto the corner (0, 0).
struct Search_report
{
  /// a point of the curve of the objective over the candidates
  struct Sample
  {
    int candidate;
    double objective; ///< what the search minimises: L2 stretch or balanced energy; infinite without a map
    double l2;        ///< L2 stretch; infinite without a map
  };

  int candidates = 0;          ///< number of candidates the strategy could choose from
  std::size_t evaluations = 0; ///< number of candidates that were mapped, each counted once
  std::size_t sketches = 0; ///< number of candidates that were mapped on a coarser mesh, to choose those to be mapped
  std::optional<int> best_candidate;                               ///< none when none has a one-to-one map
  double best_objective = std::numeric_limits<double>::infinity(); ///< of the best candidate
  /// positions in the border loop of the vertices at (0,0), (1,0), (1,1), (0,1); 0 without a map
  std::array<int, 4> corners{};
  std::size_t corner_maps = 0;  ///< number of choices of four corners that were mapped beyond the candidates
  std::size_t corner_moves = 0; ///< number of choices of four corners that were compared on coarse maps
  /// the corners are not those of the best candidate: they moved on from there, to less energy or to where the two
  /// sides of all seams can have the same samples
  bool has_moved_corners = false;
  std::vector<Sample> curve;          ///< the evaluated candidates, in the order of the candidates
  std::vector<Sample> sketched_curve; ///< the sketched candidates; comparable among themselves only
  bool is_cancelled = false;          ///< the callback or the deadline stopped the search: the best so far is reported
};

} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_SEARCH_REPORT_H
