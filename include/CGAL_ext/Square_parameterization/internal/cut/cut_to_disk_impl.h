// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_CUT_TO_DISK_IMPL_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_CUT_TO_DISK_IMPL_H

#include <CGAL_ext/Square_parameterization/internal/common/Complaint.h>
#include <CGAL_ext/Square_parameterization/internal/common/Disjoint_sets.h>
#include <CGAL_ext/Square_parameterization/internal/common/compiled_core.h>
#include <CGAL_ext/Square_parameterization/internal/cut/cut_to_disk.h>
#include <CGAL_ext/Square_parameterization/internal/cut/rerouted_initial_cuts.h>
#include <CGAL_ext/Square_parameterization/internal/cut/search_cut.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// refuses options that are out of range
inline void check_seam_options(const Seam_options& options)
{
  if(!options.is_valid())
    throw Unmappable(CGAL::Surface_mesh_parameterization::ERROR_WRONG_PARAMETER,
                     "the weight or the greatest length of the cut is negative, its balance is not in [0, 1], or its "
                     "aspect not in [1e-3, 1e3]");
}

/// refuses a seam from vertex \p a to vertex \p b that is not an edge
[[noreturn]] inline void refuse_seam(std::size_t a, std::size_t b)
{
  throw Unmappable(CGAL::Surface_mesh_parameterization::ERROR_WRONG_PARAMETER,
                   "the seam from vertex " + std::to_string(a) + " to vertex " + std::to_string(b) +
                       " is not an edge of the surface");
}

/// refuses a surface that is not a disk, and says what it is
[[noreturn]] inline void refuse_uncut(const Triangle_surface& surface)
{
  Complaint complaint;
  if(surface.border_loops.empty())
    complaint.say("it is closed: it has no border");
  if(surface.border_loops.size() > 1)
    complaint.say("it has " + std::to_string(surface.border_loops.size()) + " borders");
  if(surface.genus() > 0)
    complaint.say("it has genus " + std::to_string(surface.genus()));
  throw Unmappable(CGAL::Surface_mesh_parameterization::ERROR_NO_TOPOLOGICAL_DISC,
                   "the surface is not a disk, and it is not to be cut: " + complaint.text());
}

/// puts seams given as pairs of vertices into the cut; border edges need no cut.
/// Throws `Unmappable` when a pair is not an edge, or the seams separate the surface.
inline void fix_seams(const Triangle_surface& surface, const std::vector<std::array<int, 2>>& seams, Cut& cut)
{
  namespace SMP = CGAL::Surface_mesh_parameterization;
  for(const auto& [a, b] : seams) {
    const std::array<int, 2> edge{(std::min)(a, b), (std::max)(a, b)};
    const auto found = std::lower_bound(surface.edges.begin(), surface.edges.end(), edge);
    if(found == surface.edges.end() || *found != edge)
      refuse_seam(a, b);
    const int e = static_cast<int>(found - surface.edges.begin());
    if(!surface.is_border_edge(e))
      cut.fix(surface, e);
  }
  Disjoint_sets faces(surface.triangles.size());
  int pieces = surface.number_of_faces();
  for(int h = 0; h < 3 * surface.number_of_faces(); ++h) {
    const int opposite = surface.opposites[h];
    if(opposite < h || cut.contains(surface.edge_of_halfedge[h]) ||
       faces.find_set(h / 3) == faces.find_set(opposite / 3))
      continue;
    faces.union_set(h / 3, opposite / 3);
    --pieces;
  }
  if(pieces > 1)
    throw Unmappable(SMP::ERROR_NO_TOPOLOGICAL_DISC,
                     "the seams cut the surface into " + std::to_string(pieces) + " pieces");
}

/// a cut that contains the given seams and what else makes the surface a disk
inline Cut complete_seams(const Triangle_surface& surface, const std::vector<std::array<int, 2>>& seams)
{
  Cut cut(surface);
  fix_seams(surface, seams, cut);
  initial_cut(surface, 0, cut);
  reroute_cut(surface, cut);
  return cut;
}

CGAL_EXT_INLINE_FUNCTION std::vector<Decided_cut> cuts_to_disk(const Triangle_surface& surface,
                                                               const std::vector<std::array<int, 2>>& seams,
                                                               const Seam_options& options, Cut_report& report)
{
  check_seam_options(options);
  Thread_team& team = Thread_team::current();
  if(!seams.empty())
    return {{complete_seams(surface, seams)}};
  if(surface.is_disk() && !options.may_cut_disk())
    return {{Cut(surface)}};
  if(options.mode == Cut_mode::NONE)
    refuse_uncut(surface);
  if(options.mode == Cut_mode::BEST)
    return search_cut(surface, options, team, report);
  return {{shortest_cut(surface, team)}};
}

CGAL_EXT_INLINE_FUNCTION std::optional<Decided_cut> cut_instead(const Triangle_surface& surface,
                                                                const std::vector<Decided_cut>& decided)
{
  Cut shortest = shortest_cut(surface, Thread_team::current());
  const auto is_shortest = [&](const Decided_cut& cut) { return cut.cut.edges() == shortest.edges(); };
  if(std::any_of(decided.begin(), decided.end(), is_shortest))
    return std::nullopt;
  return Decided_cut{std::move(shortest)};
}

CGAL_EXT_INLINE_FUNCTION void report_cut(const Triangle_surface& surface, const Decided_cut& taken, Cut_report& report)
{
  report.seam_edges = taken.cut.edges().size();
  report.cut_length = taken.cut.length(surface) / std::sqrt(surface.area);
  report.score = taken.score;
  report.stretch = taken.stretch;
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_CUT_TO_DISK_IMPL_H
