// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_MAP_MINIMIZER_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_MAP_MINIMIZER_H

#include <CGAL_ext/Square_parameterization/internal/minimization/Multilevel_minimizer.h>
#include <CGAL_ext/Square_parameterization/internal/patch/exact_orientation.h>

#include <functional>
#include <memory>
#include <mutex>
#include <utility>

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

/// maps one patch onto the unit square for any border there: by the iteration of Yoshizawa et al., or by minimising the
/// balanced energy.
///
/// Constant after construction: each thread has a worker of its own. What is minimised is
/// `Minimization_report::objective`.
class Map_minimizer
{
public:
  /// maps for one border (#B by 2). The result has no uv, and an infinite objective, unless the map is one-to-one by
  /// exact arithmetic. The minimizer of the balanced energy may start from the warm start of a map for a similar
  /// border; null for none.
  typedef std::function<Minimized_map(const Uv_coordinates& border_uv, const Uv_coordinates* warm_start)> Worker;

  typedef Multilevel_minimizer::Iteration_factory Iteration_factory;

  /// \param make_iteration makes the iteration of Yoshizawa et al. for a patch
  Map_minimizer(const Patch& patch, Iteration_factory make_iteration)
    : m_patch(patch),
      m_make_iteration(std::move(make_iteration)),
      m_iteration(std::make_shared<Stretch_iteration>(m_make_iteration(patch)))
  {}

  /// \param make_start makes the iteration that maps the coarsest patch
  Map_minimizer(const Patch& patch, Iteration_factory make_start, const Balanced_options& options)
    : m_patch(patch),
      m_make_iteration(std::move(make_start)),
      m_balanced(std::make_unique<Multilevel_minimizer>(patch, m_make_iteration, options)),
      m_balanced_options(options)
  {}

  Worker make_worker() const
  {
    if(m_balanced)
      return [this, workspace = std::make_shared<Multilevel_minimizer::Workspace>()](const Uv_coordinates& border_uv,
                                                                                     const Uv_coordinates* warm_start) {
        if(has_chord_on_a_side(m_patch, border_uv))
          return Minimized_map();
        Minimized_map map = m_balanced->minimize(border_uv, *workspace, warm_start);
        return if_one_to_one(map.uv.rows() == 0 ? map_with_whole_border(border_uv) : std::move(map));
      };
    return [this, workspace = std::make_shared<Stretch_iteration::Workspace>()](const Uv_coordinates& border_uv,
                                                                                const Uv_coordinates*) {
      if(has_chord_on_a_side(m_patch, border_uv))
        return Minimized_map();
      return if_one_to_one(m_iteration->minimize(border_uv, 1, *workspace));
    };
  }

  /// indicates whether there are sketches: the patch is large, and the minimizer has coarser ones
  bool has_sketches() const { return m_balanced && m_balanced->has_sketches(); }

  /// a worker that makes maps of a coarse patch, without uv, whose objectives are comparable among themselves.
  /// \pre `has_sketches()`
  Worker make_sketching_worker() const
  {
    return [this, workspace = std::make_shared<Multilevel_minimizer::Workspace>()](const Uv_coordinates& border_uv,
                                                                                   const Uv_coordinates*) {
      return has_chord_on_a_side(m_patch, border_uv) ? Minimized_map() : m_balanced->sketch(border_uv, *workspace);
    };
  }

  /// the map to deliver, made of the best map of a worker: candidates are mapped no better than needed to compare them
  Minimized_map finish(Minimized_map map) const
  {
    if(!m_balanced || map.uv.rows() == 0)
      return map;
    Minimized_map finished = if_one_to_one(m_balanced->finish(map));
    return finished.uv.rows() > 0 ? finished : map;
  }

  /// maps for one border (#B by 2) that is any convex polygon, also a clockwise one: then through its mirror image
  Minimized_map map_border(Uv_coordinates border_uv) const
  {
    double area = 0;
    for(Eigen::Index k = 0; k < border_uv.rows(); ++k) {
      const auto p = border_uv.row(k), q = border_uv.row((k + 1) % border_uv.rows());
      area += (p.x() * q.y() - p.y() * q.x()) / 2;
    }
    const bool is_mirrored = area < 0;
    if(is_mirrored)
      border_uv.col(0).swap(border_uv.col(1));
    // what is minimised supposes the area 1; a unit square is left as it is
    const double scale = std::abs(std::abs(area) - 1) < 1e-12 ? 1 : 1 / std::sqrt(std::abs(area));
    Minimized_map map = map_convex_border(scale * border_uv);
    if(map.uv.rows() == 0)
      return map;
    if(scale != 1) {
      map.uv /= scale;
      for(std::size_t k = 0; k < m_patch.border.size(); ++k)
        map.uv.row(m_patch.border[k]) = border_uv.row(k); // as given, without the rounding of the scaling
      map = if_one_to_one(std::move(map));
    }
    if(is_mirrored && map.uv.rows() > 0)
      map.uv.col(0).swap(map.uv.col(1));
    return map;
  }

  /// the iteration for borders that are not on the square
  std::shared_ptr<const Stretch_iteration> iteration() const
  {
    return m_iteration ? m_iteration : std::make_shared<Stretch_iteration>(m_make_iteration(m_patch));
  }

private:
  /// maps for a border of area 1; one that is not the unit square does not slide
  Minimized_map map_convex_border(const Uv_coordinates& border_uv) const
  {
    const auto rows = border_uv.rowwise();
    const bool is_square = std::all_of(rows.begin(), rows.end(), is_on_unit_square);
    return finish(!m_balanced || is_square || m_balanced->keeps_border()
                      ? make_worker()(border_uv, nullptr)
                      : if_one_to_one(map_with_whole_border(border_uv)));
  }

  /// what a coarse border has no room for, or would let slide, is mapped without. Without uv where the border is kept
  /// anyway
  Minimized_map map_with_whole_border(const Uv_coordinates& border_uv) const
  {
    if(m_balanced->keeps_border())
      return Minimized_map();
    std::call_once(m_whole_border_made, [this] {
      m_whole_border = std::make_unique<Multilevel_minimizer>(m_patch, m_make_iteration, m_balanced_options, false);
    });
    Multilevel_minimizer::Workspace workspace;
    Minimized_map map = m_whole_border->minimize(border_uv, workspace);
    map.warm_start.resize(0, 2); // a map of a patch that is not among those of the others
    return map;
  }

  /// the map, repaired where rounding has left triangles flat or flipped; without uv when that fails
  Minimized_map if_one_to_one(Minimized_map map) const
  {
    if(map.uv.rows() == 0 || number_of_flipped_faces(m_patch.triangles, map.uv) == 0)
      return map;
    Minimization_report& report = map.report;
    report.l2 = report.objective = std::numeric_limits<double>::infinity();
    if(repair_flips(m_patch, map.uv)) {
      report.l2 = std::sqrt(stretch_energy(m_patch, map.uv));
      report.objective = m_balanced ? m_balanced->energy(map.uv) : report.l2;
    } else
      map.uv.resize(0, 2);
    return map;
  }

  const Patch& m_patch;
  Iteration_factory m_make_iteration;
  std::shared_ptr<const Stretch_iteration> m_iteration;   // one of these two
  std::unique_ptr<const Multilevel_minimizer> m_balanced; //
  Balanced_options m_balanced_options;
  mutable std::once_flag m_whole_border_made;
  mutable std::unique_ptr<const Multilevel_minimizer> m_whole_border; // made when needed
};

} // namespace internal
} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_MAP_MINIMIZER_H
