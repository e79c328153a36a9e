// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_LIFT_CUT_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_LIFT_CUT_H

#include <CGAL_ext/Square_parameterization/internal/cut/Cut_numbers.h>
#include <CGAL_ext/Square_parameterization/internal/cut/Nearest_vertex.h>
#include <CGAL_ext/Square_parameterization/internal/cut/initial_cut.h>
#include <CGAL_ext/Square_parameterization/internal/cut/reroute_cut.h>

#include <utility>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// a cut of \p surface like the cut \p simple of a simplified copy of it: the same terminals, and round the same
/// handles and holes.
///
/// The faces far from the simple cut are unfolded first, so that what remains to be cut lies near it; rerouting then
/// straightens it, but stays near: another way may be shorter here, and leave more stretch than the cut that was
/// chosen. The topology is right even where the two surfaces differ.
inline Cut lift_cut(const Triangle_surface& simplified, const Cut& simple, const Triangle_surface& surface,
                    const Cut_numbers& numbers = {})
{
  if(simple.edges().empty())
    return Cut(surface);
  const Nearest_vertex nearest_vertex(surface);
  std::vector<int> near;
  for(int e : simple.edges()) {
    const auto& [a, b] = simplified.edges[e];
    for(int i = 0; i <= numbers.lift_samples; ++i) {
      const double t = static_cast<double>(i) / numbers.lift_samples;
      near.push_back(nearest_vertex((1 - t) * simplified.points[a] + t * simplified.points[b]));
    }
  }
  const Shortest_paths paths = shortest_paths(surface, near);
  Cut cut(surface);
  for(int terminal : simple.terminals())
    cut.add_terminal(nearest_vertex(simplified.points[terminal]));
  cut_beside_face_tree(surface, lengths_through_edges(surface, paths), std::vector<bool>(surface.edges.size(), false),
                       cut);
  if(surface.border_loops.empty() && cut.edges().size() < 2) {
    cut = Cut(surface);
    initial_cut(surface, 0, cut);
  }
  const double band = numbers.lift_band * simple.length(simplified) / static_cast<double>(simple.edges().size());
  std::vector<bool> is_near;
  for(double distance : paths.distances)
    is_near.push_back(distance <= band);
  reroute_cut(surface, cut, std::move(is_near));
  return cut;
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_LIFT_CUT_H
