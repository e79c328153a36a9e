// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_CUT_OPTIONS_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_CUT_OPTIONS_H

#include <CGAL_ext/Square_parameterization/Balanced_minimization.h>
#include <CGAL_ext/Square_parameterization/Search_visitor.h>

#include <chrono>
#include <limits>
#include <optional>

namespace CGAL_ext {

/// \ingroup PkgSquareParameterizationConditioning
///
/// which cut turns a closed or holed surface into a disk
enum class Cut_mode
{
  NONE,     ///< no cut: such a surface is refused
  SHORTEST, ///< a short one
  BEST      ///< one that leaves little stretch on the square
};

/// \ingroup PkgSquareParameterizationConditioning
///
/// how a surface is cut to a disk
struct Cut_options
{
  Cut_mode mode = Cut_mode::BEST;

  /// `BEST`: L2 stretch that a cut as long as the square root of the area must save; not negative
  double cut_weight = 0.05;

  /// `BEST`: length, in units of the square root of the area, beyond which the cut is not extended. What the topology
  /// needs is cut in any case.
  double max_cut_length = std::numeric_limits<double>::infinity();

  /// `BEST`: whether a disk is cut, too, where the L2 stretch falls by more than the weighted length of the cut, as it
  /// does on a closed surface with a small hole. Both sides of the cut then lie on the border of the square, too. Cuts
  /// are judged by the least balanced energy with a sliding border and searched corners, whatever map is made
  /// afterwards. Without meaning where seams are given.
  bool cuts_disk = false;

  /// indicates whether a disk may be cut where no seams are given
  bool may_cut_disk() const { return cuts_disk && mode == Cut_mode::BEST; }

  /// indicates whether all numbers are in their range
  bool is_valid() const { return cut_weight >= 0 && max_cut_length >= 0; }
};

/// \ingroup PkgSquareParameterizationConditioning
///
/// what `mark_seams()` is to do: how the surface is cut, and what `parameterize_onto_square()` knows from its other
/// options
struct Seam_options : Cut_options
{
  Seam_options() = default;
  Seam_options(const Cut_options& cut) : Cut_options(cut) {}

  /// `BEST`: balance of the energy by which cuts are judged, in [0, 1]: see `Balanced_minimization`
  double balance = Balanced_minimization().balance;

  /// `BEST`: width over height of the rectangle on which cuts are judged, in [1e-3, 1e3]; none for the best of each cut
  std::optional<double> aspect = Balanced_minimization().aspect;

  /// `BEST`: whether the corners move on their own in the maps by which the last few cuts are judged, as in the map that
  /// is delivered: see `Square_search_options`
  bool moves_corners = true;

  unsigned int number_of_threads = 0; ///< 0 for all cores; the cut is the same for any number

  /// `BEST`: when it has passed, no more cuts are compared, and the best so far is taken; or any cut, when the surface
  /// could not even be simplified until then
  std::optional<std::chrono::steady_clock::time_point> deadline;

  Search_visitor* visitor = nullptr; ///< `BEST`: is told how the comparison of cuts proceeds; may be null

  /// indicates whether all numbers are in their range
  bool is_valid() const
  {
    return Cut_options::is_valid() && balance >= 0 && balance <= 1 && Balanced_minimization::has_valid_aspect(aspect);
  }
};

} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_CUT_OPTIONS_H
