// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_CHECK_MAPS_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_CHECK_MAPS_H

#include <CGAL_ext/Square_parameterization/internal/border/border_curves.h>
#include <CGAL_ext/Square_parameterization/internal/energy/rectangle.h>
#include <CGAL_ext/Square_parameterization/internal/energy/stretch_kernel.h>
#include <CGAL_ext/Square_parameterization/internal/iteration/Stretch_iteration.h>
#include <CGAL_ext/Square_parameterization/internal/iteration/repair_flips.h>
#include <CGAL_ext/Square_parameterization/internal/patch/exact_orientation.h>

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// indicates whether an interior edge has both ends on one side of the square: its triangles would have no area
inline bool has_chord_on_a_side(const Patch& patch, const Uv_coordinates& border_uv)
{
  if(patch.chords.empty())
    return false;
  std::vector<int> position(patch.points.size(), -1);
  for(std::size_t k = 0; k < patch.border.size(); ++k)
    position[patch.border[k]] = static_cast<int>(k);
  for(const auto& [a, b] : patch.chords)
    for(int axis = 0; axis < 2; ++axis) {
      const double x = border_uv(position[a], axis);
      if(x == border_uv(position[b], axis) && (x == 0 || x == 1))
        return true;
    }
  return false;
}

/// the map, repaired where rounding has left triangles flat or flipped; without uv when that fails
/// \param objective_of tells the objective of a repaired map (#V by 2) with the given L2 stretch
template <class ObjectiveOf>
Minimized_map if_one_to_one(const Patch& patch, Minimized_map map, const ObjectiveOf& objective_of)
{
  if(map.uv.rows() == 0 || number_of_flipped_faces(patch.triangles, map.uv) == 0)
    return map;
  Minimization_report& report = map.report;
  report.l2 = report.objective = std::numeric_limits<double>::infinity();
  if(repair_flips(patch, map.uv, map.work)) {
    report.l2 = std::sqrt(stretch_energy(patch, on_rectangle(map.uv, map.aspect)));
    report.objective = objective_of(map.uv, report.l2);
  } else
    map.uv.resize(0, 2);
  return map;
}

/// the area of a polygon (#B by 2); negative when it is clockwise
inline double signed_area(const Uv_coordinates& polygon)
{
  double area = 0;
  for(Eigen::Index k = 0; k < polygon.rows(); ++k) {
    const auto p = polygon.row(k), q = polygon.row((k + 1) % polygon.rows());
    area += (p.x() * q.y() - p.y() * q.x()) / 2;
  }
  return area;
}

/// maps for a border (#B by 2) that is any convex polygon, by a function that maps for counter-clockwise ones of area
/// 1, which is what the objectives suppose
/// \param map_unit_border the function
/// \param check what `if_one_to_one()` is for this minimizer: called where scaling has rounded a map
template <class MapUnitBorder, class Check>
Minimized_map map_any_border(const Patch& patch, Uv_coordinates border_uv, const MapUnitBorder& map_unit_border,
                             const Check& check)
{
  const double area = signed_area(border_uv);
  const bool is_mirrored = area < 0;
  if(is_mirrored)
    border_uv.col(0).swap(border_uv.col(1));
  // a unit square is left as it is
  const double scale = std::abs(std::abs(area) - 1) < 1e-12 ? 1 : 1 / std::sqrt(std::abs(area));
  Minimized_map map = map_unit_border(scale * border_uv);
  if(map.uv.rows() == 0)
    return map;
  if(scale != 1) {
    map.uv /= scale;
    for(std::size_t k = 0; k < patch.border.size(); ++k)
      map.uv.row(patch.border[k]) = border_uv.row(k); // as given, without the rounding of the scaling
    map = check(std::move(map));
  }
  if(is_mirrored && map.uv.rows() > 0)
    map.uv.col(0).swap(map.uv.col(1));
  return map;
}

/// see `Map_minimizer::circle_stretch()`
inline std::vector<double> circle_stretch(const Patch& patch, const Stretch_iteration& iteration)
{
  const Uv_coordinates border_uv = circular_border(patch.border_lengths, unit_area_radius());
  Stretch_iteration::Workspace workspace;
  const Minimized_map map = iteration.minimize(border_uv, 1, workspace);
  std::vector<double> sigma, result;
  if(map.uv.rows() == 0)
    return result;
  stretch_energy(patch, map.uv, sigma);
  for(int v : patch.border)
    result.push_back(sigma[v]);
  return result;
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_CHECK_MAPS_H
