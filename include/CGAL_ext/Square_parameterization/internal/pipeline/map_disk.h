// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PIPELINE_MAP_DISK_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PIPELINE_MAP_DISK_H

#include <CGAL_ext/Square_parameterization/Square_map_options.h>
#include <CGAL_ext/Square_parameterization/Square_map_result.h>
#include <CGAL_ext/Square_parameterization/internal/border/place_corners.h>
#include <CGAL_ext/Square_parameterization/internal/cut/open_disk.h>
#include <CGAL_ext/Square_parameterization/internal/energy/measure.h>
#include <CGAL_ext/Square_parameterization/internal/energy/rectangle.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/make_minimizer.h>
#include <CGAL_ext/Square_parameterization/internal/pipeline/Chosen_elements.h>
#include <CGAL_ext/Square_parameterization/internal/pipeline/map_patch.h>
#include <CGAL_ext/Square_parameterization/internal/surface/Surface_arrays.h>
#include <CGAL_ext/Square_parameterization/internal/surface/Surface_edits.h>

#include <array>
#include <chrono>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

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

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PIPELINE_MAP_DISK_H
