// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SAMPLING_GRID_BORDER_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SAMPLING_GRID_BORDER_H

#include <CGAL_ext/Square_parameterization/Grid_size.h>

#include <cstddef>

namespace CGAL_ext {
namespace internal {

/// number of samples on the border of a grid
inline int number_of_border_samples(const Grid_size& grid)
{
  return 2 * (grid.width - 1) + 2 * (grid.height - 1);
}

/// the number, row by row, of a sample of the border that is counted counter-clockwise from (0, 0)
inline std::size_t grid_sample(int border_sample, const Grid_size& grid)
{
  const int right = grid.width - 1, top = grid.height - 1;
  int i = border_sample, j = 0;
  if(border_sample >= 2 * right + top) {
    i = 0;
    j = number_of_border_samples(grid) - border_sample;
  } else if(border_sample >= right + top) {
    i = 2 * right + top - border_sample;
    j = top;
  } else if(border_sample >= right) {
    i = right;
    j = border_sample - right;
  }
  return static_cast<std::size_t>(j) * grid.width + i;
}

} // namespace internal
} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SAMPLING_GRID_BORDER_H
