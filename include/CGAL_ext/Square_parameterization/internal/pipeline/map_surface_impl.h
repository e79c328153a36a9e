// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PIPELINE_MAP_SURFACE_IMPL_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PIPELINE_MAP_SURFACE_IMPL_H

#include <CGAL_ext/Square_parameterization/internal/common/Deadline.h>
#include <CGAL_ext/Square_parameterization/internal/common/Thread_team.h>
#include <CGAL_ext/Square_parameterization/internal/common/compiled_core.h>
#include <CGAL_ext/Square_parameterization/internal/cut/cut_to_disk.h>
#include <CGAL_ext/Square_parameterization/internal/pipeline/map_best_disk.h>
#include <CGAL_ext/Square_parameterization/internal/pipeline/map_disk.h>
#include <CGAL_ext/Square_parameterization/internal/pipeline/map_patch.h>
#include <CGAL_ext/Square_parameterization/internal/pipeline/map_surface.h>
#include <CGAL_ext/Square_parameterization/internal/sampling/align_seams.h>
#include <CGAL_ext/Square_parameterization/internal/surface/check_surface.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>
#include <variant>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// refuses settings that are out of range
inline void check_settings(const Square_map_settings& settings)
{
  namespace SMP = CGAL::Surface_mesh_parameterization;
  if(const auto* balanced = std::get_if<Balanced_minimization>(&settings.minimization);
     balanced != nullptr && !balanced->is_valid())
    throw Unmappable(
        SMP::ERROR_WRONG_PARAMETER,
        "the balance is not in [0, 1], a tolerance is negative, or the weights or eta of the start are wrong");
  if(const auto* iteration = std::get_if<Stretch_minimization>(&settings.minimization);
     iteration != nullptr && !iteration->is_valid())
    throw Unmappable(SMP::ERROR_WRONG_PARAMETER, "the weights are missing, or eta is not in ]0, 1]");
  if(settings.seam_grid && !settings.seam_grid->is_valid())
    throw Unmappable(SMP::ERROR_WRONG_PARAMETER, "the grid for the seams has not 2 to 65536 samples a side");
  check_corner_search(settings.search);
}

/// how the surface is cut: with the balance and the rectangle that are minimised, if any, and the corners of the search. The
/// threads are those of the current team.
inline Seam_options seam_options(const Square_map_settings& settings)
{
  Seam_options options(settings.cut);
  // a larger share leaves large surfaces without a map, a smaller one with worse cuts, and time that is not used
  options.deadline = part_way_to(settings.search_options.deadline, 0.6);
  options.visitor = settings.search_options.visitor;
  const auto* balanced = std::get_if<Balanced_minimization>(&settings.minimization);
  if(balanced != nullptr) {
    options.balance = balanced->balance;
    options.aspect = balanced->aspect;
  }
  options.moves_corners = balanced != nullptr && settings.search_options.moves_corners;
  return options;
}

/// per vertex of the disk, the vertex of the surface that it is or is a copy of; itself for a midpoint
inline std::vector<int> originals_in_disk(const Surface_edits& edits, int surface_vertices, int disk_vertices)
{
  std::vector<int> originals(disk_vertices);
  std::iota(originals.begin(), originals.end(), 0);
  std::copy(edits.copies.begin(), edits.copies.end(), originals.begin() + surface_vertices);
  return originals;
}

/// the settings of the search, which leaves some of the time to the map for the seams
inline Square_map_settings with_time_for_seams(Square_map_settings settings)
{
  settings.search_options.deadline = part_way_to(settings.search_options.deadline, 0.75);
  return settings;
}

/// gives both sides of the seams the same samples of the grid that was asked for, where that is possible
inline void share_seam_samples(const Patch& patch, const std::vector<int>& originals,
                               const Square_map_settings& settings, Search_outcome& outcome, Square_map_report& report)
{
  report.seam_grid = settings.fits_seam_grid ? settings.seam_grid->fitted_to(outcome.map.aspect) : *settings.seam_grid;
  Aligned_map aligned = align_seams(patch, originals, outcome.map.uv, outcome.report.corners, *report.seam_grid,
                                    settings.minimization, settings.search_options.deadline);
  report.search.is_cancelled |= aligned.is_cancelled;
  report.seam_message = std::move(aligned.message);
  if(!report.seam_message.empty())
    return;
  outcome.map = std::move(aligned.map);
  report.search.has_moved_corners |= aligned.corners != outcome.report.corners;
  outcome.report.corners = report.search.corners = aligned.corners;
  report.seam_samples = std::move(aligned.seam_samples);
  report.minimization = outcome.map.report;
}

CGAL_EXT_INLINE_FUNCTION Mapped_surface map_surface(Surface_arrays mesh, const Chosen_elements& chosen,
                                                    const Square_map_settings& settings, Square_map_report& report)
{
  const auto start = Clock::now();
  check_settings(settings);
  Thread_team team(settings.search_options.number_of_threads);
  const Thread_team::Scope scope(team);
  const int surface_vertices = static_cast<int>(mesh.points.size());
  Triangle_surface surface = make_checked_surface(mesh);
  const std::vector<Decided_cut> cuts = cuts_to_disk(surface, chosen.seams, seam_options(settings), report.cut);
  report_cut(surface, cuts.front(), report.cut);
  report.cut_seconds = seconds_since(start);
  report.search.is_cancelled = has_passed(settings.search_options.deadline);
  if(report.search.is_cancelled)
    refuse_without_map(report.search);

  const bool is_cut =
      std::any_of(cuts.begin(), cuts.end(), [](const Decided_cut& c) { return !c.cut.edges().empty(); });
  const Square_map_settings of_maps = settings.seam_grid && is_cut ? with_time_for_seams(settings) : settings;
  const bool may_map_again =
      is_cut && may_compare_cuts(chosen, settings) && (cuts.size() > 1 || may_try_shortest_cut(chosen, settings));
  if(!may_map_again)
    mesh.triangles = std::vector<std::array<int, 3>>(); // from here on each has its memory as long as it is needed
  Mapped_disk disk = may_map_again ? map_best_disk(std::move(surface), mesh, cuts, chosen, of_maps, report)
                                   : map_disk(std::move(surface), std::move(mesh.points), cuts.front().cut, chosen,
                                              mesh, of_maps, Persistence::TO_THE_END, report);
  if(settings.search_options.visitor != nullptr)
    settings.search_options.visitor->end_minimization(disk.outcome.map.report);
  if(settings.seam_grid && !disk.edits.copies.empty()) {
    share_seam_samples(disk.patch, originals_in_disk(disk.edits, surface_vertices, disk.patch.number_of_vertices()),
                       settings, disk.outcome, report);
    report.measures = measure_disk(disk.patch, disk.outcome.map);
  }
  report.aspect = disk.outcome.map.aspect;
  Mapped_surface result{std::move(disk.edits), std::move(disk.patch.triangles), std::move(disk.outcome.map.uv), {}};
  for(int k = 0; k < 4; ++k)
    result.corners[k] = disk.patch.border[disk.outcome.report.corners[k]];
  return result;
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PIPELINE_MAP_SURFACE_IMPL_H
