// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_BORDER_CORNERS_AT_SHARES_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_BORDER_CORNERS_AT_SHARES_H

#include <CGAL_ext/Square_parameterization/internal/border/border_curves.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <vector>

namespace CGAL_ext {
namespace internal {

/// the border vertices nearest to shares of the length of the border; none when two are one
/// \param lengths #B, edge k joins border vertices k and k + 1
inline std::optional<Corners> corners_at_shares(const std::vector<double>& lengths, const std::array<double, 4>& shares)
{
  const int size = static_cast<int>(lengths.size());
  const double total = std::accumulate(lengths.begin(), lengths.end(), 0.);
  Corners corners{};
  for(int k = 0; k < 4; ++k) {
    const double aim = (shares[k] - std::floor(shares[k])) * total;
    double before = 0, least = std::numeric_limits<double>::infinity();
    for(int v = 0; v < size; before += lengths[v++])
      if(const double distance = (std::min)(std::abs(before - aim), total - std::abs(before - aim)); distance < least) {
        least = distance;
        corners[k] = v;
      }
  }
  return are_corners_in_order(corners, size) ? std::optional<Corners>(corners) : std::nullopt;
}

} // namespace internal
} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_BORDER_CORNERS_AT_SHARES_H
