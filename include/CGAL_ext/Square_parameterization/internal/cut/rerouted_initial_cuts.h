// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_REROUTED_INITIAL_CUTS_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_REROUTED_INITIAL_CUTS_H

#include <CGAL_ext/Square_parameterization/internal/common/Thread_team.h>
#include <CGAL_ext/Square_parameterization/internal/cut/Cut_numbers.h>
#include <CGAL_ext/Square_parameterization/internal/cut/initial_cut.h>
#include <CGAL_ext/Square_parameterization/internal/cut/reroute_cut.h>

#include <algorithm>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// the cuts to begin with: one for each of several roots on a closed surface with handles, where the shortest is often
/// not the best; else one
inline std::vector<Cut> rerouted_initial_cuts(const Triangle_surface& surface, const Cut_numbers& numbers,
                                              Thread_team& team)
{
  const bool has_choice = surface.border_loops.empty() && surface.genus() > 0;
  const int count = has_choice
                        ? (std::max)(numbers.fewest_roots,
                                     (std::min)(numbers.most_roots, numbers.roots_times_handles / surface.genus()))
                        : 1;
  std::vector<int> roots{0};
  while(static_cast<int>(roots.size()) < count)
    roots.push_back(farthest_vertex(shortest_paths(surface, roots)));
  std::vector<Cut> cuts(roots.size(), Cut(surface));
  team(roots.size(), [&](std::size_t i) {
    initial_cut(surface, roots[i], cuts[i]);
    reroute_cut(surface, cuts[i]);
  });
  return cuts;
}

/// the shortest of them
inline Cut shortest_cut(const Triangle_surface& surface, Thread_team& team)
{
  const std::vector<Cut> cuts = rerouted_initial_cuts(surface, Cut_numbers(), team);
  return *std::min_element(cuts.begin(), cuts.end(),
                           [&surface](const Cut& a, const Cut& b) { return a.length(surface) < b.length(surface); });
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_REROUTED_INITIAL_CUTS_H
