// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PIPELINE_MAP_SURFACE_IMPL_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PIPELINE_MAP_SURFACE_IMPL_H

#include <CGAL_ext/Square_parameterization/Bracketing_corner_search.h>
#include <CGAL_ext/Square_parameterization/internal/border/place_corners.h>
#include <CGAL_ext/Square_parameterization/internal/common/Deadline.h>
#include <CGAL_ext/Square_parameterization/internal/common/Thread_team.h>
#include <CGAL_ext/Square_parameterization/internal/common/compiled_core.h>
#include <CGAL_ext/Square_parameterization/internal/cut/Cut_numbers.h>
#include <CGAL_ext/Square_parameterization/internal/cut/cut_to_disk.h>
#include <CGAL_ext/Square_parameterization/internal/cut/open_disk.h>
#include <CGAL_ext/Square_parameterization/internal/energy/measure.h>
#include <CGAL_ext/Square_parameterization/internal/energy/rectangle.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/make_minimizer.h>
#include <CGAL_ext/Square_parameterization/internal/pipeline/map_patch.h>
#include <CGAL_ext/Square_parameterization/internal/pipeline/map_surface.h>
#include <CGAL_ext/Square_parameterization/internal/sampling/align_seams.h>
#include <CGAL_ext/Square_parameterization/internal/search/square_search.h>
#include <CGAL_ext/Square_parameterization/internal/surface/check_surface.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <exception>
#include <numeric>
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
/// \param surface_vertices #V of the surface, before it was cut open
inline Corners border_positions(const std::array<int, 4>& corners, const Surface_arrays& surface, int surface_vertices,
                                const Patch& patch, const Surface_edits& edits, Square_map_report& report)
{
  namespace SMP = CGAL::Surface_mesh_parameterization;
  std::array<std::vector<int>, 4> places;
  for(int k = 0; k < 4; ++k) {
    places[k] = border_places(corners[k], patch, edits, surface_vertices);
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

/// a surface that was cut open and mapped
struct Mapped_disk
{
  Patch patch;
  Surface_edits edits;
  Search_outcome outcome;
};

typedef std::chrono::steady_clock Clock;

inline double seconds_since(Clock::time_point start)
{
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// adds the seconds of its scope to a sum, also where that is left by an exception
class Scope_timer
{
public:
  explicit Scope_timer(double& sum) : m_sum(sum) {}
  Scope_timer(const Scope_timer&) = delete;
  Scope_timer& operator=(const Scope_timer&) = delete;
  ~Scope_timer() { m_sum += seconds_since(m_start); }

private:
  double& m_sum;
  const Clock::time_point m_start = Clock::now();
};

/// measures the map of the disk, with the faces as they are
inline Stretch_measures measure_disk(const Patch& patch, const Minimized_map& map)
{
  return measure(shapes_as_given(patch), patch.triangles, map.uv, scale_to_rectangle(map.aspect));
}

/// opens the cut, maps the disk and measures the map
/// \param points of the vertices of the mesh
/// \param report its times are added to, the rest is of this disk, as far as it has come when `Unmappable` is thrown
inline Mapped_disk map_disk(Triangle_surface surface, std::vector<Eigen::Vector3d> points, const Cut& cut,
                            const Chosen_elements& chosen, const Surface_arrays& mesh,
                            const Square_map_settings& settings, Persistence persistence, Square_map_report& report)
{
  const auto condition_start = Clock::now();
  const int surface_vertices = surface.number_of_vertices();
  Opened_disk disk = open_disk(surface, cut, settings.chords);
  surface = Triangle_surface(); // its memory is for the map
  report.border_edges_split = disk.edits.border_splits;
  report.chords_split = disk.edits.splits.size() - disk.edits.border_splits;
  Patch patch = patch_of_disk(std::move(disk.triangles), points_after(disk.edits, std::move(points)));
  report.border_edges = patch.border.size();
  report.degenerate_faces = patch.degenerate_faces.size();
  std::optional<Corners> corners;
  if(chosen.corners)
    corners = border_positions(*chosen.corners, mesh, surface_vertices, patch, disk.edits, report);
  const auto minimizer = make_minimizer(patch, settings.minimization, settings.search_options.deadline);
  report.condition_seconds += seconds_since(condition_start);

  const auto search = [&] {
    const Scope_timer timer(report.search_seconds);
    return map_patch(patch, *minimizer, corners, settings, persistence, report);
  };
  Search_outcome outcome = search();
  report.measures = measure_disk(patch, outcome.map);
  return {std::move(patch), std::move(disk.edits), std::move(outcome)};
}

/// indicates whether the maps of several cuts may be compared: not where the corners are chosen, or searched in another way
/// than by a few maps, for all processes that share a search must have one disk
inline bool may_compare_cuts(const Chosen_elements& chosen, const Square_map_settings& settings)
{
  return !chosen.corners && settings.search.is_of_type<Bracketing_corner_search>() &&
         std::holds_alternative<Balanced_minimization>(settings.minimization);
}

/// indicates whether the shortest cut is tried where those that were decided on leave no good map. \pre a surface that is cut
inline bool may_try_shortest_cut(const Chosen_elements& chosen, const Square_map_settings& settings)
{
  return settings.tries_other_starts && settings.cut.mode == Cut_mode::BEST && chosen.seams.empty();
}

/// maps the disks that cuts leave, and keeps the best: with the lowest L2 stretch, of the faces as they are, plus weighted
/// length of the cut
class Best_disk
{
public:
  Best_disk(const Surface_arrays& mesh, const Chosen_elements& chosen, const Square_map_settings& settings)
    : m_mesh(mesh), m_chosen(chosen), m_settings(settings)
  {}

  /// \param surface of the mesh
  /// \param report of this disk; its times are those of all
  /// \return false when the disk has no map as yet, but more may be tried
  bool map(Triangle_surface surface, const Decided_cut& cut, Persistence persistence, Square_map_report& report)
  {
    report_cut(surface, cut, report.cut);
    try {
      Mapped_disk next =
          map_disk(std::move(surface), m_mesh.points, cut.cut, m_chosen, m_mesh, m_settings, persistence, report);
      if(!m_best || score(report) < score(m_report)) {
        m_best.emplace(std::move(next));
        m_report = report;
      }
    } catch(const Unmappable_within_work&) {
      m_failure = std::current_exception();
      return false;
    } catch(const Unmappable&) { // another one may have a map
      m_failure = std::current_exception();
    }
    return true;
  }

  bool has_map() const { return m_best.has_value(); }

  /// indicates whether there is no map, or one that only another cut can make much better
  bool is_hopeless() const { return !m_best || is_poor(m_best->outcome, Minimizer_numbers::HOPELESS_RESULT); }

  /// the best disk. Throws `Unmappable` when there is none.
  /// \param report that of the last one; it becomes that of the best, with the times of all
  Mapped_disk take(Square_map_report& report)
  {
    if(!m_best)
      std::rethrow_exception(m_failure);
    m_report.cut_seconds = report.cut_seconds;
    m_report.condition_seconds = report.condition_seconds;
    m_report.search_seconds = report.search_seconds;
    m_report.search.is_cancelled = report.search.is_cancelled;
    report = std::move(m_report);
    return std::move(*m_best);
  }

private:
  double score(const Square_map_report& of_disk) const
  {
    return of_disk.measures.l2 + m_settings.cut.cut_weight * of_disk.cut.cut_length;
  }

  const Surface_arrays& m_mesh;
  const Chosen_elements& m_chosen;
  const Square_map_settings& m_settings;
  std::optional<Mapped_disk> m_best;
  Square_map_report m_report; // of the best
  std::exception_ptr m_failure;
};

/// maps the disks that the cuts leave, and that of the shortest cut where their maps are hopeless, as far as there is time. It
/// is tried before the last starts of the others: where one start after the other has no map, another cut often has one at once.
/// \param report of the best disk, with the times of all
inline Mapped_disk map_best_disk(Triangle_surface surface, const Surface_arrays& mesh,
                                 const std::vector<Decided_cut>& cuts, const Chosen_elements& chosen,
                                 const Square_map_settings& settings, Square_map_report& report)
{
  const auto start = Clock::now();
  const Deadline& deadline = settings.search_options.deadline;
  const bool is_large = surface.number_of_faces() > Cut_numbers().largest_mapped_twice;
  const bool may_try_shortest = may_try_shortest_cut(chosen, settings);
  Best_disk best(mesh, chosen, settings);
  const auto may_go_on = [&] {
    return !report.search.is_cancelled && (best.has_map() ? has_time_again(start, deadline) : !has_passed(deadline));
  };
  std::vector<Decided_cut> unfinished; // which have no map as yet
  const auto map = [&](Triangle_surface copy, const Decided_cut& cut, Persistence persistence) {
    if(!best.map(std::move(copy), cut, persistence, report))
      unfinished.push_back(cut);
  };
  for(std::size_t i = 0; i < cuts.size() && (i == 0 || may_go_on()); ++i)
    map(i + 1 < cuts.size() ? surface : std::move(surface), cuts[i],
        may_try_shortest ? Persistence::WITHIN_WORK : Persistence::TO_THE_END);
  if(may_try_shortest && best.is_hopeless() && !(is_large && best.has_map()) && may_go_on()) {
    const auto cut_start = Clock::now();
    surface = make_checked_surface(mesh);
    const std::optional<Decided_cut> other = cut_instead(surface, cuts);
    report.cut_seconds += seconds_since(cut_start);
    if(other && may_go_on()) {
      report.cut.is_replaced = true;
      map(std::move(surface), *other, Persistence::TO_THE_END);
    }
  }
  for(std::size_t i = 0; i < unfinished.size() && !best.has_map() && may_go_on(); ++i) {
    report.cut.is_replaced = false;
    map(make_checked_surface(mesh), unfinished[i], Persistence::TO_THE_END);
  }
  return best.take(report);
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
