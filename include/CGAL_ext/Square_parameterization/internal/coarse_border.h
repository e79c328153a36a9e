// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COARSE_BORDER_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COARSE_BORDER_H

#include <CGAL_ext/Square_parameterization/internal/Coarse_patch.h>

#include <optional>
#include <unordered_map>
#include <vector>

namespace CGAL_ext {
namespace internal {

/// follows the corners of the square from a patch to a coarse one: a corner that is removed is stood for by the vertex that
/// it was collapsed into
class Corner_tracking
{
public:
  /// \param border_uv #B by 2, of the fine patch
  Corner_tracking(const Patch& fine, const Uv_coordinates& border_uv)
  {
    for(Eigen::Index k = 0; k < border_uv.rows(); ++k) {
      const auto is_end = [](double x) { return x == 0 || x == 1; };
      if(is_end(border_uv(k, 0)) && is_end(border_uv(k, 1)))
        m_corners.emplace(fine.border[k], border_uv.row(k));
    }
  }

  /// the corners now: vertices of the fine patch and their uv
  const std::unordered_map<int, Eigen::RowVector2d>& corners() const { return m_corners; }

  /// indicates whether the removed vertex was a corner
  bool follow(const Coarse_patch::Removal& removal)
  {
    if(!removal.is_on_border())
      return false;
    const auto corner = m_corners.find(removal.vertex);
    if(corner == m_corners.end())
      return false;
    const Eigen::RowVector2d place = corner->second;
    m_corners.erase(corner);
    m_corners.emplace(removal.target, place); // two in one: then there are fewer
    return true;
  }

private:
  std::unordered_map<int, Eigen::RowVector2d> m_corners;
};

/// per removal, whether the vertex was a corner of the square then
inline std::vector<bool> find_removed_corners(const Patch& fine, const Coarse_patch& coarse,
                                              const Uv_coordinates& border_uv)
{
  Corner_tracking tracking(fine, border_uv);
  std::vector<bool> is_corner;
  for(const Coarse_patch::Removal& removal : coarse.removals)
    is_corner.push_back(tracking.follow(removal));
  return is_corner;
}

/// the border of a coarse patch (its #B by 2) when that of the fine one is \p border_uv: the vertices keep their places, but
/// for those that stand for a corner. None when two corners fall into one.
inline std::optional<Uv_coordinates> coarse_border(const Patch& fine, const Coarse_patch& coarse,
                                                   const Uv_coordinates& border_uv)
{
  if(coarse.patch.border.size() == fine.border.size())
    return border_uv;
  Corner_tracking tracking(fine, border_uv);
  const std::size_t corners = tracking.corners().size();
  for(const Coarse_patch::Removal& removal : coarse.removals)
    tracking.follow(removal);
  if(tracking.corners().size() < corners)
    return {};
  Uv_coordinates result(coarse.patch.border.size(), 2);
  std::size_t k = 0; // the coarse border keeps the order of the fine one
  for(std::size_t i = 0; i < coarse.patch.border.size(); ++i, ++k) {
    const int v = coarse.fine_vertex[coarse.patch.border[i]];
    while(fine.border[k] != v)
      ++k;
    const auto corner = tracking.corners().find(v);
    result.row(i) = corner == tracking.corners().end() ? Eigen::RowVector2d(border_uv.row(k)) : corner->second;
  }
  return result;
}

} // namespace internal
} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COARSE_BORDER_H
