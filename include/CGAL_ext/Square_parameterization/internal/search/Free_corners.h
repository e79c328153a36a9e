// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SEARCH_FREE_CORNERS_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SEARCH_FREE_CORNERS_H

#include <CGAL_ext/Square_parameterization/internal/common/Minimizer_numbers.h>
#include <CGAL_ext/Square_parameterization/internal/search/Corner_evaluation.h>
#include <CGAL_ext/Square_parameterization/internal/search/Corner_moves.h>
#include <CGAL_ext/Square_parameterization/internal/search/search_work.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// four corners of their own: maps for them, on the patch and on coarse ones, and their moves
class Free_corners
{
public:
  /// \param may_map asked before each map of the patch, \p may_compare before each map of a coarse patch, by one thread
  ///        at a time; `false` stops
  Free_corners(const Patch& patch, const Map_minimizer& minimizer, Search_visitor* visitor,
               const std::function<bool()>& may_map, const std::function<bool()>& may_compare)
    : m_patch(patch),
      m_has_first_moves_on_patch(minimizer.has_coarse_maps() &&
                                 &minimizer.coarse_patch(Coarse_maps::FIRST_MOVES) == &patch),
      m_has_sketched_candidates(minimizer.has_sketches()),
      m_has_cheap_rough_maps(minimizer.has_coarse_maps() &&
                             Minimizer_numbers::LEAST_SKETCH_RATIO *
                                     minimizer.coarse_patch(Coarse_maps::FIRST_MOVES).number_of_vertices() <=
                                 patch.number_of_vertices()),
      m_maps([&minimizer] { return Map_minimizer::without_limit(minimizer.make_worker()); }, patch, visitor, may_map,
             most_maps_at_once(patch.number_of_vertices()))
  {
    // sketches tell corners apart better than rough maps, also where they save too little to compare all candidates, and
    // where they are maps of the patch itself
    const int n = patch.number_of_vertices();
    const int border = static_cast<int>(patch.border.size());
    const bool is_sketched = n > Minimizer_numbers::LARGEST_SKETCH || Minimizer_numbers::moves_corners_twice(n, border);
    if(minimizer.has_coarse_maps() && is_sketched)
      m_sketches.emplace(minimizer, Coarse_maps::SKETCHES, patch, visitor, may_compare);
    if(minimizer.has_coarse_maps())
      m_rough_maps.emplace(minimizer, Coarse_maps::FIRST_MOVES, patch, visitor, may_compare);
  }

  /// the objectives of choices of corners; see `Corner_search_problem`
  std::vector<double> map(const std::vector<Corners>& choices) { return m_maps(choices); }
  std::vector<double> map_roughly(const std::vector<Corners>& choices) { return (*m_rough_maps)(choices); }

  bool has_rough_maps() const { return m_rough_maps.has_value(); }

  /// indicates whether corners move on sketches at last, which tell them apart better than rough maps
  bool move_on_sketches() const { return m_sketches.has_value(); }

  /// indicates whether a rough map costs a small part of one of the patch
  bool has_cheap_rough_maps() const { return m_has_cheap_rough_maps; }

  const Minimized_map& best_map() const { return m_maps.best_map(); }
  const Corners& best_corners() const { return m_maps.best_corners(); }

  /// the number of choices that were mapped, or could not be
  std::size_t number_of_maps() const { return m_maps.number_of_choices(); }

  /// the number of choices that were mapped roughly
  std::size_t number_of_rough_maps() const { return has_rough_maps() ? m_rough_maps->number_of_choices() : 0; }

  bool is_cancelled() const { return m_is_cancelled; }

  /// frees the memory of the threads. \pre no more corners are mapped
  void release_workers()
  {
    m_maps.release_workers();
    m_sketches.reset();
    if(m_rough_maps)
      m_rough_maps->release_workers();
  }

  /// indicates whether the first rough map alone would cost more than all moves may: where it is one of the patch itself it
  /// costs as much as \p map, which is of the patch
  bool is_too_costly(const Minimized_map& map) const
  {
    return m_has_first_moves_on_patch &&
           double(map.work) > most_moving_work(map.aspect == 1, m_patch.number_of_vertices());
  }

  /// moves the four corners on rough maps, from the given ones and, where the rectangle is not the square, from others,
  /// then on sketches, if there are some, and maps for what comes out. False when the given ones are to be mapped, too, since
  /// they may still be better, and that does not cost too much; and where they have no rough map to compare with, or a step
  /// would cost too much.
  /// \param sketch of the given ones, or where candidates are compared by rough maps, not on sketches, their rough map; without
  ///        either, which may be null, another valley is sought on the square
  bool move(const Corners& start, const Uv_coordinates* sketch)
  {
    try {
      double most_work = std::numeric_limits<double>::infinity(); // until the map of the start tells the aspect
      const auto is_exhausted = [this, &most_work] { return work_of_rough_maps() > most_work; };
      Corner_moves moves = moves_by_maps(m_patch, *m_rough_maps, is_exhausted);
      const Uv_coordinates* const rough_map = m_has_sketched_candidates ? nullptr : sketch;
      moves.add({start, (*m_rough_maps)({start}, {rough_map}).front()});
      if(!std::isfinite(moves.compare({start}).front().objective))
        return false;
      const bool is_square = m_rough_maps->best_map().aspect == 1;
      most_work = most_moving_work(is_square, m_patch.number_of_vertices());
      if(is_exhausted())
        return false;
      const bool may_have_other_valley = rough_map == nullptr && is_square && has_other_valleys();
      std::vector<Corners> ends = ends_of_moves(start, is_square, may_have_other_valley, is_exhausted, moves);
      const bool is_certain =
          m_sketches && keep_best_sketch(start, m_has_sketched_candidates ? sketch : nullptr, most_work, moves, ends);
      const long work_before = m_maps.work();
      map_ends(ends);
      const double sweeps = double(m_maps.work() - work_before) / m_patch.number_of_vertices();
      return (is_certain || sweeps > MOST_WORK_OF_FIRST_MAP) && best_map().uv.rows() > 0;
    } catch(const Search_cancelled&) {
      m_is_cancelled = true;
      return false;
    }
  }

private:
  static constexpr double CERTAIN = 4e-4; // of a lower sketch: sketches rank maps that differ by less wrongly, at times
  static constexpr double MUCH_LOWER = 2e-3; // of a rough map: another valley is worth its moves

  /// what rough maps have cost, in vertices visited; where there are sketches, with those of one more step at the same cost
  /// for each. \pre there is one
  double work_of_rough_maps() const
  {
    const double steps = double(Corner_moves::number_of_moves()) / double(m_rough_maps->number_of_choices());
    return double(m_rough_maps->work()) * (m_sketches ? 1 + steps : 1);
  }

  /// where the corners come to rest, but for the start itself
  std::vector<Corners> ends_of_moves(const Corners& start, bool is_square, bool may_have_other_valley,
                                     const std::function<bool()>& is_exhausted, Corner_moves& moves)
  {
    std::vector<Corners> starts{start};
    if(!is_square)
      for(const Corner_choice& choice : moves.best_of_spread())
        starts.push_back(choice.corners);
    std::set<Corners> ends;
    for(const Corners& corners : starts)
      ends.insert(moves.descend_from_afar(corners, is_square).corners);
    if(may_have_other_valley && !is_exhausted())
      if(const auto end = end_in_other_valley(moves.compare({start}).front(), is_exhausted))
        ends.insert(*end);
    ends.erase(start);
    return {ends.begin(), ends.end()};
  }

  /// indicates whether rough maps may know of a better valley than that of the best of a few candidates: not where many were
  /// compared on sketches, where the rough maps are those of the patch itself, and on small patches
  bool has_other_valleys() const
  {
    return !m_has_sketched_candidates && !m_has_first_moves_on_patch &&
           m_patch.number_of_vertices() > Minimizer_numbers::LARGEST_ROUGH;
  }

  /// where the corners of the candidate whose rough map is best come to rest, if that is much better than the start's. Its
  /// moves remember nothing of those of the start: objectives that are larger than the start's one are only near.
  std::optional<Corners> end_in_other_valley(const Corner_choice& start, const std::function<bool()>& is_exhausted)
  {
    Corner_moves moves = moves_by_maps(m_patch, *m_rough_maps, is_exhausted);
    const Corner_choice other = moves.compare(corners_of_spread_candidates(m_patch.border_lengths), &start).front();
    if(other.objective >= (1 - MUCH_LOWER) * start.objective)
      return {};
    return moves.descend_from_afar(other.corners, true).corners;
  }

  /// keeps the choice with the best sketch, moved to where the sketch is best, if that is better than the one of the
  /// start, and tells whether it is better for certain
  bool keep_best_sketch(const Corners& start, const Uv_coordinates* sketch, double most_work, Corner_moves& rough,
                        std::vector<Corners>& ends)
  {
    Corner_moves moves = moves_by_maps(
        m_patch, *m_sketches, [this, most_work] { return double(m_sketches->work()) > most_work; }, sketch);
    const Corner_choice first = moves.compare({start}).front();
    ends.push_back(start);
    const int step = static_cast<int>(m_patch.border.size()) / 32;
    const Corner_choice best = moves.descend_where_likely(moves.compare(ends).front().corners, step, rough);
    ends.clear();
    if(best.corners != start)
      ends.push_back(best.corners);
    return best.objective < (1 - CERTAIN) * first.objective;
  }

  /// maps from the sketches, or from the rough maps
  void map_ends(const std::vector<Corners>& ends)
  {
    const Corner_evaluation& coarse = m_sketches ? *m_sketches : *m_rough_maps;
    std::vector<const Uv_coordinates*> warm_starts;
    for(const Corners& corners : ends)
      warm_starts.push_back(coarse.warm_start(corners));
    release_coarse_maps(ends);
    m_maps(ends, warm_starts);
  }

  /// frees the memory for sketches and rough maps, and those of other corners than \p ends: what is mapped next needs more
  /// than they
  void release_coarse_maps(const std::vector<Corners>& ends)
  {
    for(std::optional<Corner_evaluation>* coarse : {&m_sketches, &m_rough_maps})
      if(*coarse) {
        (*coarse)->release_workers();
        (*coarse)->keep_warm_starts(ends);
      }
  }

  const Patch& m_patch;
  const bool m_has_first_moves_on_patch;
  const bool m_has_sketched_candidates;
  const bool m_has_cheap_rough_maps;
  Corner_evaluation m_maps;
  std::optional<Corner_evaluation> m_sketches, m_rough_maps;
  bool m_is_cancelled = false;
};

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SEARCH_FREE_CORNERS_H
