// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PIPELINE_MAP_PATCH_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PIPELINE_MAP_PATCH_H

#include <CGAL_ext/Square_parameterization/Square_map_options.h>
#include <CGAL_ext/Square_parameterization/Square_map_result.h>
#include <CGAL_ext/Square_parameterization/internal/common/Deadline.h>
#include <CGAL_ext/Square_parameterization/internal/common/Minimizer_numbers.h>
#include <CGAL_ext/Square_parameterization/internal/common/Unmappable.h>
#include <CGAL_ext/Square_parameterization/internal/pipeline/other_starts.h>
#include <CGAL_ext/Square_parameterization/internal/search/search_work.h>
#include <CGAL_ext/Square_parameterization/internal/search/square_search.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// how long a map is sought where there is none
enum class Persistence
{
  WITHIN_WORK, ///< until the starts have cost what they may where there is a map
  TO_THE_END   ///< until all starts have failed, and a longer search
};

/// no map was found, but not all that may lead to one was tried
class Unmappable_within_work : public Unmappable
{
public:
  using Unmappable::Unmappable;
};

/// the search has found no map
template <class Exception = Unmappable>
[[noreturn]] inline void refuse_without_map(const Search_report& report)
{
  const std::string evaluations = std::to_string(report.evaluations);
  const std::string candidates = report.evaluations == 1 ? " candidate" : " candidates";
  throw Exception(CGAL::Surface_mesh_parameterization::ERROR_NO_1_TO_1_MAPPING,
                  report.is_cancelled
                      ? "the search was stopped after " + evaluations + candidates + ", none with a one-to-one map"
                      : "none of " + evaluations + " evaluated" + candidates + " has a one-to-one map");
}

/// maps the patch with the given corners, or with those of a search, as well as comparing needs
inline Search_outcome map_from_start(const Patch& patch, const Map_minimizer& minimizer,
                                     const std::optional<Corners>& corners, const Square_map_settings& settings)
{
  return corners ? map_with_corners(patch, minimizer, *corners)
                 : search_corners(patch, minimizer, settings.search, settings.search_options);
}

/// indicates whether the search has found a map
inline bool has_map(const Search_outcome& outcome)
{
  return outcome.map.uv.rows() > 0;
}

/// indicates whether the search has found no map, or one whose energy is `least` or more
inline bool is_poor(const Search_outcome& outcome, double least)
{
  return !(outcome.map.report.objective < least);
}

/// indicates whether two starts have led to maps of one energy, which is then the fault of the surface. Lost maps, which are
/// far from any minimum, tell nothing.
inline bool do_agree(const Search_outcome& a, const Search_outcome& b)
{
  const double difference = std::abs(a.map.report.objective - b.map.report.objective);
  return !is_poor(a, Minimizer_numbers::LOST_RESULT) && !is_poor(b, Minimizer_numbers::LOST_RESULT) &&
         difference <= Minimizer_numbers::AGREEMENT_OF_STARTS * b.map.report.objective;
}

/// what came of other starts
struct Tried_starts
{
  Map_start best = Map_start::AS_CHOSEN;
  bool are_all = true; ///< false when some were left untried though none has a map
};

/// tries the other starts until one is not poor; when there is a map, until all have cost too much, or will with the
/// next, but `least_other_starts()` in any case, or one agrees with the best. Where the first has a map and has cost too
/// much, there are none. `finish_map()` is to follow.
/// \param minimizer of the first start, made of the patch by `make_minimizer()` with the settings
/// \param best the outcome of the first start; it becomes the best of all, with the work of all
/// \return where the best began, and whether starts were left untried though none has a map
inline Tried_starts try_other_starts(const Patch& patch, const Map_minimizer& minimizer,
                                     const std::optional<Corners>& corners, const Square_map_settings& settings,
                                     Search_outcome& best, Persistence persistence = Persistence::TO_THE_END)
{
  Tried_starts tried;
  const auto* balanced = std::get_if<Balanced_minimization>(&settings.minimization);
  const int vertices = patch.number_of_vertices();
  const bool is_costly = has_map(best) && best.work > most_work_of_first_start(vertices);
  if(balanced == nullptr || is_costly)
    return tried;
  const Deadline& deadline = settings.search_options.deadline;
  const double most_work = (std::max)(most_work_of_starts(vertices), best.work);
  double work = best.work;
  int others = 0;
  bool is_cancelled = false, is_enough = false;
  std::vector<Other_start> starts = other_starts(patch, *balanced, deadline, &minimizer);
  for(Other_start& other : starts) {
    if(!is_poor(best, least_poor_objective(vertices)) || is_cancelled || has_passed(deadline))
      break;
    if(is_enough && (has_map(best) || persistence == Persistence::WITHIN_WORK)) {
      tried.are_all = has_map(best);
      break;
    }
    // the last of those that share coarse patches frees their memory
    const auto make_minimizer_once = std::exchange(other.make_minimizer, nullptr);
    Search_outcome next = map_from_start(patch, *make_minimizer_once(), corners, settings);
    is_cancelled = next.report.is_cancelled;
    work += next.work;
    ++others;
    const double work_with_next = work + work / (1 + others);
    const bool is_too_much = work > most_work || work_with_next > MOST_EXCESS_OF_STARTS * most_work;
    is_enough = do_agree(best, next) || (is_too_much && others >= least_other_starts(vertices));
    if(next.map.report.objective < best.map.report.objective) {
      best = std::move(next);
      tried.best = other.start;
    }
  }
  best.report.is_cancelled = is_cancelled || has_passed(deadline);
  if(work > best.work)
    best.map.work_of_starts = static_cast<long>(work);
  best.work = work;
  return tried;
}

/// indicates whether a search that has found no map would map more candidates if it had as much work as starts may have: it
/// would not where it has mapped all, or one more costs too much
inline bool would_go_on(const Patch& patch, const Search_outcome& outcome)
{
  const Search_report& report = outcome.report;
  const double work_of_one = outcome.work / double((std::max)(report.evaluations, std::size_t(1)));
  return !has_map(outcome) && outcome.heeds_work && report.evaluations < std::size_t(report.candidates) &&
         outcome.work + work_of_one <= most_work_of_starts(patch.number_of_vertices());
}

/// a longer search from the first start, for as much work as starts may cost, when none has led to a map: the few candidates
/// that each could afford may be the wrong ones
inline void search_longer(const Patch& patch, const Map_minimizer& minimizer, const Square_map_settings& settings,
                          Search_outcome& outcome)
{
  const int vertices = patch.number_of_vertices();
  const double work_factor = most_work_of_starts(vertices) / most_work_of_search(vertices); // more than one
  if(!has_map(outcome) && !outcome.report.is_cancelled)
    outcome = search_corners(patch, minimizer, settings.search, settings.search_options, work_factor);
}

/// maps the patch with the given corners, or with those of a search, from the first start that leads to a good map, which
/// is minimised to the end. Throws `Unmappable` when there is no map, and `Unmappable_within_work` when more may be tried.
inline Search_outcome map_patch(const Patch& patch, const Map_minimizer& minimizer,
                                const std::optional<Corners>& corners, const Square_map_settings& settings,
                                Persistence persistence, Square_map_report& report)
{
  Search_visitor* const visitor = corners ? nullptr : settings.search_options.visitor;
  const double least_poor = least_poor_objective(patch.number_of_vertices());
  report.start = Map_start::AS_CHOSEN;
  Search_outcome outcome = map_from_start(patch, minimizer, corners, settings);
  if(is_poor(outcome, Minimizer_numbers::HOPELESS_RESULT))
    outcome.map.work_of_starts = static_cast<long>(outcome.work);
  if(!is_poor(outcome, Minimizer_numbers::LOST_RESULT))
    finish_map(minimizer, visitor, outcome, least_poor);
  bool is_all_tried = true;
  if(settings.tries_other_starts && is_poor(outcome, least_poor) && !outcome.report.is_cancelled) {
    const bool may_go_on = would_go_on(patch, outcome), goes_on = may_go_on && persistence == Persistence::TO_THE_END;
    const Tried_starts tried = try_other_starts(patch, minimizer, corners, settings, outcome, persistence);
    report.start = tried.best;
    is_all_tried = tried.are_all && goes_on == may_go_on;
    if(goes_on)
      search_longer(patch, minimizer, settings, outcome);
  }
  if(is_poor(outcome, least_poor) || report.start != Map_start::AS_CHOSEN)
    finish_map(minimizer, visitor, outcome);
  report.search = outcome.report;
  report.minimization = outcome.map.report;
  if(!has_map(outcome) && !is_all_tried)
    refuse_without_map<Unmappable_within_work>(outcome.report);
  if(!has_map(outcome))
    refuse_without_map(outcome.report);
  return outcome;
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PIPELINE_MAP_PATCH_H
