// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COARSENING_COARSE_BORDER_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COARSENING_COARSE_BORDER_H

#include <CGAL_ext/Square_parameterization/internal/coarsening/Coarse_patch.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// the border of a patch of a sequence on the unit square
struct Coarse_border
{
  Uv_coordinates uv;        ///< #B by 2
  std::vector<int> corners; ///< places on the border of the vertices in the corners of the square
  std::vector<std::size_t>
      removed_corners; ///< places in `Coarse_patch::removals` of vertices that were corners, ascending
};

/// the border of the first patch of a sequence
/// \param uv #B by 2
inline Coarse_border finest_border(Uv_coordinates uv)
{
  const auto is_end = [](double x) { return x == 0 || x == 1; };
  Coarse_border result;
  for(Eigen::Index k = 0; k < uv.rows(); ++k)
    if(is_end(uv(k, 0)) && is_end(uv(k, 1)))
      result.corners.push_back(static_cast<int>(k));
  result.uv = std::move(uv);
  return result;
}

/// the border of a coarse patch when there is that of the fine one: the vertices keep their places, but for those that stand
/// for a corner of the square that was removed, each for the one that was collapsed into it. None when two corners fall
/// into one vertex.
inline std::optional<Coarse_border> coarse_border(const Coarse_patch& coarse, const Coarse_border& fine)
{
  Coarse_border result;
  result.uv.resize(coarse.patch.border.size(), 2);
  for(std::size_t i = 0; i < coarse.patch.border.size(); ++i)
    result.uv.row(i) = fine.uv.row(coarse.fine_places[i]);
  for(int k : fine.corners) {
    const auto& [stand_in, removal] = coarse.fine_border[k];
    if(std::find(result.corners.begin(), result.corners.end(), stand_in) != result.corners.end())
      return {};
    result.corners.push_back(stand_in);
    result.uv.row(stand_in) = fine.uv.row(k);
    if(removal >= 0)
      result.removed_corners.push_back(removal);
  }
  std::sort(result.removed_corners.begin(), result.removed_corners.end());
  return result;
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COARSENING_COARSE_BORDER_H
