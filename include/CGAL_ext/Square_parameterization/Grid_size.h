// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_GRID_SIZE_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_GRID_SIZE_H

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL_ext {

/// \ingroup PkgSquareParameterizationSampling
///
/// the size of a grid of samples of the unit square. Sample (`i`, `j`) lies at (`i` / (`width` - 1), `j` / (`height` -
/// 1)): samples lie on all four sides, and on the corners.
struct Grid_size
{
  int width = 0;  ///< number of samples along u; at least 2 and at most 65536
  int height = 0; ///< number of samples along v; at least 2 and at most 65536

  /// indicates whether both numbers are in their range
  bool is_valid() const { return width >= 2 && height >= 2 && width <= 65536 && height <= 65536; }

  /// the grid of about as many squares whose numbers of intervals are to each other as the sides of a rectangle
  /// \param aspect width over height of the rectangle, positive
  Grid_size fitted_to(double aspect) const
  {
    const double intervals = std::sqrt((width - 1.) * (height - 1.));
    const auto samples = [](double n) { return 1 + static_cast<int>(std::lround((std::clamp)(n, 1., 65535.))); };
    return {samples(intervals * std::sqrt(aspect)), samples(intervals / std::sqrt(aspect))};
  }

  /// number of samples
  std::size_t number_of_samples() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
};

} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_GRID_SIZE_H
