// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_CUT_TO_DISK_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_CUT_TO_DISK_H

#include <CGAL_ext/Square_parameterization/Cut_options.h>
#include <CGAL_ext/Square_parameterization/Cut_report.h>
#include <CGAL_ext/Square_parameterization/internal/common/Unmappable.h>
#include <CGAL_ext/Square_parameterization/internal/cut/Cut.h>

#include <array>
#include <string>
#include <vector>

namespace CGAL_ext {
namespace internal {

/// refuses options that are out of range
inline void check_cut_options(const Cut_options& options)
{
  if(!options.is_valid())
    throw Unmappable(CGAL::Surface_mesh_parameterization::ERROR_WRONG_PARAMETER,
                     "the weight or the greatest length of the cut is negative, or its balance is not in [0, 1]");
}

/// refuses a seam from vertex \p a to vertex \p b that is not an edge
[[noreturn]] inline void refuse_seam(std::size_t a, std::size_t b)
{
  throw Unmappable(CGAL::Surface_mesh_parameterization::ERROR_WRONG_PARAMETER,
                   "the seam from vertex " + std::to_string(a) + " to vertex " + std::to_string(b) +
                       " is not an edge of the surface");
}

/// decides how the surface is cut to a disk: along the given seams and what they lack, or by the mode of the options.
/// A disk is not cut, except along given seams, or where the options ask for it and it pays. Deterministic.
///
/// Throws `Unmappable` when nothing is to be cut and the surface is no disk, and for seams that make no sense.
Cut cut_to_disk(const Triangle_surface& surface, const std::vector<std::array<int, 2>>& seams,
                const Cut_options& options, Cut_report& report);

} // namespace internal
} // namespace CGAL_ext

#ifndef CGAL_EXT_COMPILED_CORE
#include <CGAL_ext/Square_parameterization/internal/cut/cut_to_disk_impl.h>
#endif

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_CUT_TO_DISK_H
