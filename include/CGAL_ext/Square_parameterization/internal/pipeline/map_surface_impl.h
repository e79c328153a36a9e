// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PIPELINE_MAP_SURFACE_IMPL_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PIPELINE_MAP_SURFACE_IMPL_H

#include <CGAL_ext/Square_parameterization/internal/border/place_corners.h>
#include <CGAL_ext/Square_parameterization/internal/common/Deadline.h>
#include <CGAL_ext/Square_parameterization/internal/common/compiled_core.h>
#include <CGAL_ext/Square_parameterization/internal/cut/cut_to_disk.h>
#include <CGAL_ext/Square_parameterization/internal/cut/open_disk.h>
#include <CGAL_ext/Square_parameterization/internal/energy/measure.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/make_minimizer.h>
#include <CGAL_ext/Square_parameterization/internal/pipeline/map_surface.h>
#include <CGAL_ext/Square_parameterization/internal/search/square_search.h>
#include <CGAL_ext/Square_parameterization/internal/surface/check_surface.h>

#include <array>
#include <chrono>
#include <optional>
#include <string>
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
  check_corner_search(settings.search);
}

/// how the surface is cut: with the balance that is minimised, if any, and the threads of the search
inline Seam_options seam_options(const Square_map_settings& settings)
{
  Seam_options options(settings.cut);
  options.number_of_threads = settings.search_options.number_of_threads;
  options.deadline = half_way_to(settings.search_options.deadline);
  if(const auto* balanced = std::get_if<Balanced_minimization>(&settings.minimization))
    options.balance = balanced->balance;
  return options;
}

/// positions in the border loop of a vertex of the surface and of its copies
inline std::vector<int> border_places(int v, const Patch& patch, const Surface_edits& edits, int surface_vertices)
{
  std::vector<int> places;
  for(std::size_t k = 0; k < patch.border.size(); ++k) {
    const int copy = patch.border[k] - surface_vertices;
    const bool is_copy = copy >= 0 && copy < static_cast<int>(edits.copies.size()) && edits.copies[copy] == v;
    if(patch.border[k] == v || is_copy)
      places.push_back(static_cast<int>(k));
  }
  return places;
}

/// positions in the border loop of four vertices of the surface. Throws `Unmappable` when one is not on the border, and
/// when they are not distinct and in counter-clockwise order.
inline Corners border_positions(const std::array<int, 4>& corners, const Surface_arrays& surface, const Patch& patch,
                                const Surface_edits& edits, Square_map_report& report)
{
  namespace SMP = CGAL::Surface_mesh_parameterization;
  std::array<std::vector<int>, 4> places;
  for(int k = 0; k < 4; ++k) {
    places[k] = border_places(corners[k], patch, edits, static_cast<int>(surface.points.size()));
    if(places[k].empty()) {
      report.wrong_corner = k;
      throw Unmappable(SMP::ERROR_WRONG_PARAMETER,
                       "corner vertex " + std::to_string(surface.place(corners[k])) + " is not on the border");
    }
  }
  const std::optional<Corners> positions = place_corners(patch.border_lengths, places);
  if(positions)
    return *positions;
  report.counter_clockwise_corners = counter_clockwise_order(patch.border_lengths, places);
  throw Unmappable(SMP::ERROR_WRONG_PARAMETER, report.counter_clockwise_corners
                                                   ? "the four corners are not in counter-clockwise order"
                                                   : "the four corners are not distinct border vertices");
}

/// the search has found no map
[[noreturn]] inline void refuse_without_map(const Search_report& report)
{
  const std::string evaluations = std::to_string(report.evaluations);
  const std::string candidates = report.evaluations == 1 ? " candidate" : " candidates";
  throw Unmappable(CGAL::Surface_mesh_parameterization::ERROR_NO_1_TO_1_MAPPING,
                   report.is_cancelled
                       ? "the search was stopped after " + evaluations + candidates + ", none with a one-to-one map"
                       : "none of " + evaluations + " evaluated" + candidates + " has a one-to-one map");
}

/// maps the patch with the given corners, or with those of a search. Throws `Unmappable` when there is no map.
inline Search_outcome map_patch(const Patch& patch, const Map_minimizer& minimizer,
                                const std::optional<Corners>& corners, const Square_map_settings& settings,
                                Square_map_report& report)
{
  Search_outcome outcome = corners ? map_with_corners(patch, minimizer, *corners)
                                   : search_square_map(patch, minimizer, settings.search, settings.search_options);
  report.search = outcome.report;
  report.minimization = outcome.map.report;
  if(settings.search_options.visitor != nullptr)
    settings.search_options.visitor->end_minimization(outcome.map.report);
  if(!outcome.report.best_candidate)
    refuse_without_map(outcome.report);
  return outcome;
}

CGAL_EXT_INLINE_FUNCTION Mapped_surface map_surface(const Surface_arrays& mesh, const Chosen_elements& chosen,
                                                    const Square_map_settings& settings, Square_map_report& report)
{
  typedef std::chrono::steady_clock Clock;
  const auto seconds_between = [](Clock::time_point from, Clock::time_point to) {
    return std::chrono::duration<double>(to - from).count();
  };
  const auto start = Clock::now();
  check_settings(settings);
  Triangle_surface surface = make_checked_surface(mesh);
  const Cut cut = cut_to_disk(surface, chosen.seams, seam_options(settings), report.cut);
  const auto condition_start = Clock::now();
  report.cut_seconds = seconds_between(start, condition_start);
  report.search.is_cancelled = has_passed(settings.search_options.deadline);
  if(report.search.is_cancelled)
    refuse_without_map(report.search);

  Opened_disk disk = open_disk(std::move(surface), cut, settings.chords);
  report.border_edges_split = disk.edits.border_splits;
  report.chords_split = disk.edits.splits.size() - disk.edits.border_splits;
  const Patch patch = patch_of_disk(disk.surface, points_after(disk.edits, mesh.points));
  report.border_edges = patch.border.size();
  report.degenerate_faces = patch.degenerate_faces.size();
  std::optional<Corners> corners;
  if(chosen.corners)
    corners = border_positions(*chosen.corners, mesh, patch, disk.edits, report);
  const auto minimizer = make_minimizer(patch, settings.minimization, settings.search_options.deadline);
  const auto search_start = Clock::now();
  report.condition_seconds = seconds_between(condition_start, search_start);

  const Search_outcome outcome = map_patch(patch, *minimizer, corners, settings, report);
  report.search_seconds = seconds_between(search_start, Clock::now());
  report.measures = measure(shapes_as_given(patch), patch.triangles, outcome.map.uv);
  Mapped_surface result{std::move(disk.edits), patch.triangles, outcome.map.uv, {}};
  for(int k = 0; k < 4; ++k)
    result.corners[k] = patch.border[outcome.report.corners[k]];
  return result;
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PIPELINE_MAP_SURFACE_IMPL_H
