// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_SEARCH_CUT_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_SEARCH_CUT_H

#include <CGAL_ext/Square_parameterization/Cut_options.h>
#include <CGAL_ext/Square_parameterization/Cut_report.h>
#include <CGAL_ext/Square_parameterization/internal/common/Deadline.h>
#include <CGAL_ext/Square_parameterization/internal/common/Thread_team.h>
#include <CGAL_ext/Square_parameterization/internal/cut/Cut_numbers.h>
#include <CGAL_ext/Square_parameterization/internal/cut/Decided_cut.h>
#include <CGAL_ext/Square_parameterization/internal/surface/Triangle_surface.h>

#include <vector>

namespace CGAL_ext {
namespace internal {

/// decides on a cut that leaves little stretch. A family of cuts of all lengths is grown on simple copies, for the same
/// weights whatever weight is wanted; its best members are scored again on a finer copy. On a small surface the best of them
/// at each of these weights is refined. The best at the weight that is wanted, and a few that come near it, are judged by
/// searched corners, and maps to the tolerance of a search: the cut for one weight is then hardly worse than that for
/// another. Where two all but tie, both are decided for, and their maps are to tell.
/// \param surface of any size: large ones are decided on by a simplified copy
/// \return the best cut, and then a second one where it all but ties
std::vector<Decided_cut> search_cut(const Triangle_surface& surface, const Seam_options& options, Thread_team& team,
                                    Cut_report& report, const Cut_numbers& numbers = {});

} // namespace internal
} // namespace CGAL_ext

#ifndef CGAL_EXT_COMPILED_CORE
#include <CGAL_ext/Square_parameterization/internal/cut/search_cut_impl.h>
#endif

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_SEARCH_CUT_H
