// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_MAP_MINIMIZER_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_MAP_MINIMIZER_H

#include <CGAL_ext/Square_parameterization/Stretch_minimization.h>
#include <CGAL_ext/Square_parameterization/internal/iteration/Minimized_map.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/Coarse_maps.h>

#include <functional>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL_ext {
namespace internal {

/// maps one patch onto the unit square for any border there, with the least objective that it can find. What is
/// minimised is `Minimization_report::objective`.
///
/// Constant after construction: each thread has a worker of its own. Refers to the patch, which must live as long.
class Map_minimizer
{
public:
  static constexpr double NO_LIMIT = std::numeric_limits<double>::infinity(); ///< of objectives

  /// maps for one border (#B by 2). The result has no uv, and an infinite objective, unless the map is one-to-one by
  /// exact arithmetic. A minimizer may start from the warm start of a map for a similar border; null for none.
  typedef std::function<Minimized_map(const Uv_coordinates& border_uv, const Uv_coordinates* warm_start)> Worker;

  /// maps a coarse patch for one border, without uv, so that borders can be compared: from the warm start of a map of the
  /// same patch, which may be null, and no further than is needed to see that the objective stays above the limit. Such
  /// an objective is about what it would come to.
  typedef std::function<Minimized_map(const Uv_coordinates& border_uv, const Uv_coordinates* warm_start, double limit)>
      Comparing_worker;

  /// a worker that compares by maps, which go on above any limit
  static Comparing_worker without_limit(Worker map_for)
  {
    return [map_for = std::move(map_for)](const Uv_coordinates& border_uv, const Uv_coordinates* warm_start, double) {
      return map_for(border_uv, warm_start);
    };
  }

  virtual ~Map_minimizer() = default;

  /// makes the worker of a thread; it refers to the minimizer
  virtual Worker make_worker() const = 0;

  /// indicates whether the minimizer has coarse patches
  virtual bool has_coarse_maps() const = 0;

  /// indicates whether all candidates are to be sketched: the patch is large, and that of sketches much smaller
  virtual bool has_sketches() const = 0;

  /// a worker that makes maps of a coarse patch, without uv, whose objectives are comparable among themselves.
  /// \pre `has_coarse_maps()`
  virtual Comparing_worker make_comparing_worker(Coarse_maps kind) const = 0;

  /// the patch that such a worker maps: the very patch of the minimizer where that is small, or cannot be made coarser.
  /// \pre `has_coarse_maps()`
  virtual const Patch& coarse_patch(Coarse_maps kind) const = 0;

  /// the map to deliver, made of the best map of a worker: candidates are mapped no better than needed to compare them
  /// \param limit one whose objective stays above it may come back as it is, or on its way to be finished by another call;
  ///        its objective is then about what it would come to
  virtual Minimized_map finish(Minimized_map map, double limit = NO_LIMIT) const = 0;

  /// a minimizer that does the same on the same coarse patches, but for the weights and the iteration of first maps. Null when
  /// there are no coarse patches.
  virtual std::shared_ptr<const Map_minimizer> with_first_maps(const Stretch_minimization& start) const = 0;

  /// maps for one border (#B by 2) that is any convex polygon, also a clockwise one: then through its mirror image
  virtual Minimized_map map_border(const Uv_coordinates& border_uv) const = 0;

  /// the stretch of the border vertices, in the order of the border loop, when the patch is mapped onto a circle of
  /// area 1; empty when it cannot be
  virtual std::vector<double> circle_stretch() const = 0;

protected:
  Map_minimizer() = default;
  Map_minimizer(const Map_minimizer&) = delete;
  Map_minimizer& operator=(const Map_minimizer&) = delete;
};

} // namespace internal
} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_MAP_MINIMIZER_H
