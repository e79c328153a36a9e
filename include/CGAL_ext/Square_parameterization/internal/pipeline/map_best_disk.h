// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PIPELINE_MAP_BEST_DISK_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PIPELINE_MAP_BEST_DISK_H

#include <CGAL_ext/Square_parameterization/Bracketing_corner_search.h>
#include <CGAL_ext/Square_parameterization/internal/common/Deadline.h>
#include <CGAL_ext/Square_parameterization/internal/cut/Cut_numbers.h>
#include <CGAL_ext/Square_parameterization/internal/cut/cut_to_disk.h>
#include <CGAL_ext/Square_parameterization/internal/pipeline/map_disk.h>
#include <CGAL_ext/Square_parameterization/internal/surface/check_surface.h>

#include <exception>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

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

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PIPELINE_MAP_BEST_DISK_H
