// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_CUT_TO_DISK_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_CUT_TO_DISK_H

#include <CGAL_ext/Square_parameterization/Cut_options.h>
#include <CGAL_ext/Square_parameterization/Cut_report.h>
#include <CGAL_ext/Square_parameterization/internal/cut/Cut.h>

#include <array>
#include <vector>

namespace CGAL_ext {
namespace internal {

/// decides how the surface is cut to a disk: along the given seams and what they lack, or by the mode of the options.
/// A disk is not cut, except along given seams, or where the options ask for it and it pays. Deterministic.
///
/// Throws `Unmappable` when nothing is to be cut and the surface is no disk, and for seams that make no sense.
Cut cut_to_disk(const Triangle_surface& surface, const std::vector<std::array<int, 2>>& seams,
                const Seam_options& options, Cut_report& report);

} // namespace internal
} // namespace CGAL_ext

#ifndef CGAL_EXT_COMPILED_CORE
#include <CGAL_ext/Square_parameterization/internal/cut/cut_to_disk_impl.h>
#endif

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_CUT_TO_DISK_H
