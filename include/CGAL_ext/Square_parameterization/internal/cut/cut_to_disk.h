// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_CUT_TO_DISK_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_CUT_TO_DISK_H

#include <CGAL_ext/Square_parameterization/Cut_options.h>
#include <CGAL_ext/Square_parameterization/Cut_report.h>
#include <CGAL_ext/Square_parameterization/internal/common/Thread_team.h>
#include <CGAL_ext/Square_parameterization/internal/cut/Decided_cut.h>

#include <array>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL_ext {
namespace internal {

/// decides how the surface is cut to a disk: along the given seams and what they lack, or by the mode of the options.
/// A disk is not cut, except along given seams, or where the options ask for it and it pays. Deterministic. Works with the
/// threads of the current team.
///
/// Throws `Unmappable` when nothing is to be cut and the surface is no disk, and for seams that make no sense.
/// \return the best cut, and then a second one where the decision hardly tells them apart
/// \param report what they have in common is set; `report_cut()` is to follow
std::vector<Decided_cut> cuts_to_disk(const Triangle_surface& surface, const std::vector<std::array<int, 2>>& seams,
                                      const Seam_options& options, Cut_report& report);

/// the cut to be tried where the best ones of `cuts_to_disk()` leave no disk that has a good map: the shortest, which is found on the
/// surface itself. None when it is one of these.
std::optional<Decided_cut> cut_instead(const Triangle_surface& surface, const std::vector<Decided_cut>& decided);

/// reports the cut that is taken
void report_cut(const Triangle_surface& surface, const Decided_cut& taken, Cut_report& report);

/// the best cut of `cuts_to_disk()`, with the threads of the options
inline Cut cut_to_disk(const Triangle_surface& surface, const std::vector<std::array<int, 2>>& seams,
                       const Seam_options& options, Cut_report& report)
{
  Thread_team team(options.number_of_threads);
  const Thread_team::Scope scope(team);
  std::vector<Decided_cut> cuts = cuts_to_disk(surface, seams, options, report);
  report_cut(surface, cuts.front(), report);
  return std::move(cuts.front().cut);
}

} // namespace internal
} // namespace CGAL_ext

#ifndef CGAL_EXT_COMPILED_CORE
#include <CGAL_ext/Square_parameterization/internal/cut/cut_to_disk_impl.h>
#endif

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_CUT_TO_DISK_H
