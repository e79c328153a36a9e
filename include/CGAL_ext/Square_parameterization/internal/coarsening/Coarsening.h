// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COARSENING_COARSENING_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COARSENING_COARSENING_H

namespace CGAL_ext {
namespace internal {

/// how many of its interior vertices each patch of a sequence has less than the one before it
enum class Coarsening
{
  BY_HALVES, ///< half of them
  BY_EIGHTHS ///< an eighth, but of large patches half, in few waves (`Most_waves`): four times as many patches. Where one map
             ///< after another makes room for the few vertices that come next, hardly any of them is lost in rounding.
};

} // namespace internal
} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COARSENING_COARSENING_H
