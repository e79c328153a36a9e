// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_CANDIDATE_TERMINALS_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_CANDIDATE_TERMINALS_H

#include <CGAL_ext/Square_parameterization/internal/common/Thread_team.h>
#include <CGAL_ext/Square_parameterization/internal/cut/score_cut.h>
#include <CGAL_ext/Square_parameterization/internal/cut/shortest_paths.h>

#include <algorithm>
#include <limits>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// vertices far from the seams, each far from those before it, too
inline std::vector<int> successive_farthest_points(const Triangle_surface& surface, const Cut& cut, int count)
{
  std::vector<int> sources = seam_vertices(surface, cut), farthest;
  while(static_cast<int>(farthest.size()) < count) {
    const int v = farthest_vertex(shortest_paths(surface, sources));
    if(std::find(sources.begin(), sources.end(), v) != sources.end())
      break; // no vertex is left
    farthest.push_back(v);
    sources.push_back(v);
  }
  return farthest;
}

/// the vertices away from the seams where the map of the opened surface onto the circle stretches most: local maxima,
/// highest first
inline std::vector<int> circle_stretch_maxima(const Triangle_surface& surface, const Cut& cut,
                                              const Cut_numbers& numbers)
{
  std::vector<double> sigma;
  try {
    const Patch patch = patch_of_cut(surface, cut);
    Stretch_minimization minimization;
    minimization.maximum_iterations = numbers.circle_iterations;
    const Stretch_iteration iteration(patch, minimization);
    Stretch_iteration::Workspace workspace;
    const Minimized_map map =
        iteration.minimize(circular_border(patch.border_lengths, unit_area_radius()), 1, workspace);
    if(map.uv.rows() == 0)
      return {};
    stretch_energy(patch, map.uv, sigma);
  } catch(const Unmappable&) {
    return {};
  }
  const auto is_seam = [&](int v) { return cut.degree(v) > 0 || surface.is_border_vertex[v]; };
  std::vector<int> maxima;
  for(int v = 0; v < surface.number_of_vertices(); ++v) {
    const auto incident = surface.vertex_edges[v];
    if(!is_seam(v) && std::none_of(incident.begin(), incident.end(), [&](int e) {
         const int w = surface.other_end(e, v);
         return !is_seam(w) && sigma[w] > sigma[v];
       }))
      maxima.push_back(v);
  }
  std::stable_sort(maxima.begin(), maxima.end(), [&sigma](int a, int b) { return sigma[a] > sigma[b]; });
  maxima.resize((std::min)(maxima.size(), static_cast<std::size_t>(numbers.candidates)));
  return maxima;
}

/// vertices that the cut might reach to leave less stretch: up to `numbers.candidates` of either kind
inline std::vector<int> candidate_terminals(const Triangle_surface& surface, const Cut& cut, const Cut_numbers& numbers)
{
  std::vector<int> candidates, maxima;
  Thread_team::current()(2, [&](std::size_t i) {
    if(i == 0)
      maxima = circle_stretch_maxima(surface, cut, numbers); // takes longer
    else
      candidates = successive_farthest_points(surface, cut, numbers.candidates);
  });
  for(int v : maxima)
    if(std::find(candidates.begin(), candidates.end(), v) == candidates.end())
      candidates.push_back(v);
  return candidates;
}

/// vertices at \p distance from a terminal of the cut, all round it: first the one on the cut, if any, then \p count
/// others, each far from those before it
inline std::vector<int> nearby_places(const Triangle_surface& surface, const Cut& cut, int terminal, double distance,
                                      int count)
{
  const Shortest_paths paths = shortest_paths(surface, {terminal});
  std::vector<int> circle, places;
  for(int v = 0; v < surface.number_of_vertices(); ++v) {
    const int e = paths.parent_edges[v];
    if(e >= 0 && paths.distances[v] >= distance && paths.distances[v] - surface.lengths[e] < distance)
      circle.push_back(v);
  }
  for(int v : circle)
    if(places.empty() && cut.degree(v) > 0)
      places.push_back(v);
  const auto gap = [&](int v) {
    double least = std::numeric_limits<double>::infinity();
    for(int place : places)
      least = (std::min)(least, (surface.points[v] - surface.points[place]).squaredNorm());
    return least;
  };
  for(int i = 0; i < count && !circle.empty(); ++i) {
    const int v = *std::max_element(circle.begin(), circle.end(), [&](int p, int q) { return gap(p) < gap(q); });
    if(gap(v) > 0)
      places.push_back(v);
  }
  return places;
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_CANDIDATE_TERMINALS_H
