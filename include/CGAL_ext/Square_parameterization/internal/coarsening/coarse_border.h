// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COARSENING_COARSE_BORDER_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COARSENING_COARSE_BORDER_H

#include <CGAL_ext/Square_parameterization/internal/coarsening/Coarse_patch.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// the border of a coarse patch on the unit square
struct Coarse_border
{
  Uv_coordinates uv; ///< #B by 2
  std::vector<std::size_t>
      removed_corners; ///< places in `Coarse_patch::removals` of vertices that were corners, ascending
};

/// the border of a coarse patch when that of the fine one is \p border_uv (#B by 2): the vertices keep their places,
/// but for those that stand for a corner of the square that was removed, each for the one that was collapsed into it.
/// None when two corners fall into one vertex.
inline std::optional<Coarse_border> coarse_border(const Patch& fine, const Coarse_patch& coarse,
                                                  const Uv_coordinates& border_uv)
{
  if(coarse.patch.border.size() == fine.border.size())
    return Coarse_border{border_uv, {}};
  std::vector<std::pair<int, Eigen::RowVector2d>> corners; // vertices of the fine patch and their uv
  const auto find = [&corners](int v) {
    return std::find_if(corners.begin(), corners.end(), [v](const auto& corner) { return corner.first == v; });
  };
  const auto is_end = [](double x) { return x == 0 || x == 1; };
  for(Eigen::Index k = 0; k < border_uv.rows(); ++k)
    if(is_end(border_uv(k, 0)) && is_end(border_uv(k, 1)))
      corners.emplace_back(fine.border[k], border_uv.row(k));
  Coarse_border result;
  for(std::size_t i = 0; i < coarse.removals.size(); ++i) {
    const auto corner = find(coarse.removals[i].vertex);
    if(corner == corners.end())
      continue;
    if(find(coarse.removals[i].target) != corners.end())
      return {};
    corner->first = coarse.removals[i].target;
    result.removed_corners.push_back(i);
  }
  result.uv.resize(coarse.patch.border.size(), 2);
  std::size_t k = 0; // the coarse border keeps the order of the fine one
  for(std::size_t i = 0; i < coarse.patch.border.size(); ++i, ++k) {
    const int v = coarse.fine_vertex[coarse.patch.border[i]];
    while(fine.border[k] != v)
      ++k;
    const auto corner = find(v);
    result.uv.row(i) = corner == corners.end() ? Eigen::RowVector2d(border_uv.row(k)) : corner->second;
  }
  return result;
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COARSENING_COARSE_BORDER_H
