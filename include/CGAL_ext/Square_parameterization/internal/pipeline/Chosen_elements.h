// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PIPELINE_CHOSEN_ELEMENTS_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PIPELINE_CHOSEN_ELEMENTS_H

#include <array>
#include <optional>
#include <vector>

namespace CGAL_ext {
namespace internal {

/// what the caller of `map_surface()` chose, as vertices of the arrays
struct Chosen_elements
{
  std::vector<std::array<int, 2>> seams; ///< the ends of edges to cut along
  std::optional<std::array<int, 4>> corners;
};

} // namespace internal
} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PIPELINE_CHOSEN_ELEMENTS_H
