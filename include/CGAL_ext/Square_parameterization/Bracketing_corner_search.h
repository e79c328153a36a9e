// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_BRACKETING_CORNER_SEARCH_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_BRACKETING_CORNER_SEARCH_H

#include <CGAL_ext/Square_parameterization/internal/common/Minimizer_numbers.h>
#include <CGAL_ext/Square_parameterization/internal/search/Candidate_ring.h>
#include <CGAL_ext/Square_parameterization/internal/search/search_work.h>

#include <cmath>
#include <optional>
#include <set>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {

/// \ingroup PkgSquareParameterizationSearches
///
/// maps the first candidate, then even samples of the ring of the quarter, and closes in on the best: each sample that is
/// not higher than its neighbors brackets a valley; the valley with the lowest bottom, by the parabola through its three
/// samples, is sampled again, until no valley promises less than the best candidate known. On a curve with several
/// valleys the largest gaps are sampled, too. Maps start from those of their neighbors.
///
/// Where the problem has sketches, as for meshes of 7000 vertices and more, these are searched instead: 32 even samples,
/// then about as many between the best of them and its neighbors, and so on. It settles for the candidate with the best
/// sketch, which is the only one that is mapped.
///
/// Where the corners move afterwards (`Corner_search_problem::is_refined_by_moves`) the neighbors of the best candidate are
/// told apart by the moves: it closes in but once, or until a candidate has a map that is not hopeless, and sketches the even
/// samples alone. Of these the one that is best by rough maps is the only one that is mapped, if its map is not hopeless, where
/// there are such maps, as for meshes of more than 2000 vertices.
///
/// Where a map takes long, as on surfaces with long protrusions, fewer candidates are sampled, and none any more when
/// the maps and sketches have cost as much as those of fifty candidates of an even surface, or of twenty-five on 5000 vertices
/// or more (10000 while none has a map). On a mesh of 2500 vertices and more the first candidate, or the best by rough
/// maps, is the only one when its map costs as much as those of nineteen, and where there are sketches the first, when its
/// sketch is stretched tens of thousands of times, or a hundred times and costs as much as twelve.
///
/// At most \f$ \max(12, 2 \log_2 m + 4) \f$ evaluations of \f$ m \f$ candidates; 32 sketches or rough maps, or, where corners stay, about
/// 32 sketches for each factor of 16 in \f$ m \f$. Deterministic; finds the optimum of curves that are smooth on the scale of the
/// samples, as the balanced energy is on most meshes, or, where corners move afterwards, a candidate near it.
/// \cgalModels `CornerSearch`
class Bracketing_corner_search
{
public:
  /// evaluates five candidates first
  Bracketing_corner_search() : Bracketing_corner_search(5) {}

  /// \param samples number of candidates evaluated first, 3 or more
  explicit Bracketing_corner_search(int samples) : m_samples(samples) {}

  /// indicates whether the number of samples is in its range. With one that is not, a search is refused with
  /// `ERROR_WRONG_PARAMETER`.
  bool is_valid() const { return m_samples >= 3; }

  Candidate_set candidate_set() const { return Candidate_set::QUARTER; }

  void operator()(const Corner_search_problem& problem) const
  {
    if(const std::optional<int> sketched = best_sketch(problem)) {
      problem.settle_for(*sketched);
      return;
    }
    const std::optional<int> rough = best_rough_candidate(problem);
    Samples samples(problem);
    samples.evaluate({rough.value_or(0)});
    if(samples.work_of_first() > internal::MOST_WORK_OF_FIRST_MAP || (rough && samples.may_corners_move()))
      return;
    const std::vector<int> even = samples.ring.even_candidates(affordable_samples(samples));
    samples.evaluate({even.begin(), even.end()});
    close_in(samples);
  }

private:
  static constexpr int SAMPLES = 32; // even ones by coarse maps, and round the best of them

  /// indicates whether the first sketch, whose work is known by now, tells that all are stretched beyond comparison
  static bool is_first_sketch_lost(const Corner_search_problem& problem, double objective)
  {
    typedef internal::Minimizer_numbers Numbers;
    const bool is_costly = problem.work && problem.work() > internal::MOST_WORK_OF_HOPELESS_SKETCH;
    return std::isfinite(objective) && objective > (is_costly ? Numbers::HOPELESS_SKETCH : Numbers::HOPELESS_RESULT);
  }

  /// what a search may cost of which the ring knows some candidates
  static double most_work(const Corner_search_problem& problem, const internal::Candidate_ring& ring)
  {
    return internal::most_search_work(problem.number_of_vertices, std::isfinite(ring.objective(ring.best())));
  }

  /// indicates whether no more is to be spent on the search
  static bool has_cost_too_much(const Corner_search_problem& problem, const internal::Candidate_ring& ring)
  {
    return problem.work && problem.work() > most_work(problem, ring);
  }

  /// a ring of which no more candidates are evaluated than the bound, and none when those before were too costly
  struct Samples
  {
    explicit Samples(const Corner_search_problem& problem_to_solve)
      : problem(problem_to_solve),
        ring(problem_to_solve),
        work_before(problem_to_solve.work ? problem_to_solve.work() : 0),
        bound((std::max)(12, static_cast<int>(2 * std::log2(double(problem_to_solve.number_of_candidates))) + 4))
    {
      ring.start_from_neighbors();
    }

    /// evaluates those of the candidates that are unknown, in order, as far as the bound allows; false when there are
    /// none
    bool evaluate(const std::set<int>& candidates)
    {
      if(is_exhausted())
        return false;
      std::vector<int> batch;
      for(int candidate : candidates)
        if(ring.number_of_known() + static_cast<int>(batch.size()) < bound && !ring.is_known(candidate))
          batch.push_back(candidate);
      if(!batch.empty())
        ring.evaluate(batch);
      return !batch.empty();
    }

    bool are_all() const { return ring.number_of_known() == (std::min)(bound, ring.size()) || is_exhausted(); }

    /// indicates whether corners may move after the search from the best candidate, whose map is not hopeless then
    bool may_corners_move() const
    {
      return problem.is_refined_by_moves && ring.objective(ring.best()) < internal::Minimizer_numbers::HOPELESS_RESULT;
    }

    bool is_exhausted() const { return ring.number_of_known() > 0 && has_cost_too_much(problem, ring); }

    /// what maps have cost so far
    double work() const { return problem.work ? problem.work() - work_before : 0; }

    /// the same for the first one, of which those of small meshes are soon made. \pre no other is known
    double work_of_first() const
    {
      return work() * (std::min)(1., double(problem.number_of_vertices) / internal::LEAST_VERTICES_OF_COSTLY_MAP);
    }

    const Corner_search_problem& problem;
    internal::Candidate_ring ring;
    double work_before; ///< of coarse maps
    int bound;
  };

  /// as many samples as the work for the first candidate allows, which is known by now
  int affordable_samples(const Samples& samples) const
  {
    const double work = samples.work();
    const double most = most_work(samples.problem, samples.ring);
    return work * m_samples > most ? static_cast<int>(most / work) : m_samples;
  }

  /// samples valley by valley; where corners move afterwards but once, if a candidate has a map from which they do. Not at all:
  /// surfaces with fins and nails are stretched up to 3 % more.
  static void close_in(Samples& samples)
  {
    bool goes_on = true;
    while(goes_on && !samples.are_all()) {
      const std::optional<Valley> valley = most_promising(samples.ring);
      if(!valley && !has_several_valleys(samples.ring))
        break;
      samples.evaluate(valley ? next_samples(*valley, samples.ring) : middle_of_largest_gap(samples.ring));
      goes_on = !samples.may_corners_move();
    }
  }

  /// the best of even samples by rough maps; none when there are no rough maps
  static std::optional<int> best_rough_candidate(const Corner_search_problem& problem)
  {
    if(!problem.rough_objective_of)
      return {};
    internal::Candidate_ring ring(problem, problem.rough_objective_of);
    ring.evaluate({0}); // the others start from it
    sample_evenly(problem, ring);
    return std::isfinite(ring.objective(ring.best())) ? std::optional(ring.best()) : std::nullopt;
  }

  /// evaluates even candidates, ever more of them, each from one of those before. \pre the first is known
  static void sample_evenly(const Corner_search_problem& problem, internal::Candidate_ring& ring)
  {
    constexpr int FIRST_SAMPLES = 4;
    for(int samples = FIRST_SAMPLES; samples <= SAMPLES; samples *= 2)
      if(!has_cost_too_much(problem, ring))
        ring.evaluate(ring.even_candidates(samples));
  }

  /// the best candidate of a coarser mesh: of even samples, and ever finer ones round the best; none when there is no
  /// such mesh or it has no map
  static std::optional<int> best_sketch(const Corner_search_problem& problem)
  {
    if(!problem.sketched_objective_of)
      return {};
    internal::Candidate_ring ring(problem, problem.sketched_objective_of);
    ring.evaluate({0}); // the others start from it
    if(is_first_sketch_lost(problem, ring.objective(0)))
      return 0;
    sample_evenly(problem, ring);
    if(!std::isfinite(ring.objective(ring.best())))
      return {};
    if(problem.is_refined_by_moves)
      return ring.best();
    for(std::set<int> finer;
        !has_cost_too_much(problem, ring) && !(finer = samples_around_best(ring, SAMPLES)).empty();)
      ring.evaluate({finer.begin(), finer.end()});
    return ring.best();
  }

  /// about \p count even samples of the unknown candidates between the best one and its nearest known neighbors
  static std::set<int> samples_around_best(const internal::Candidate_ring& ring, int count)
  {
    const int left = ring.distance_to_known(-1), right = ring.distance_to_known(1);
    const int step = (std::max)(1, (left + right - 2 + count - 1) / count);
    std::set<int> samples;
    for(int offset = step - left; offset < right; offset += step)
      if(!ring.is_known(ring.at(ring.best() + offset)))
        samples.insert(ring.at(ring.best() + offset));
    return samples;
  }

  /// a known candidate between two known ones that are not lower; positions on the unrolled ring
  struct Valley
  {
    long left, middle, right;
    double bottom;  ///< position of the lowest point of the parabola
    double promise; ///< its value
  };

  static Valley make_valley(const internal::Candidate_ring& ring, long left, long middle, long right)
  {
    const double a = ring.objective(ring.at(left)), b = ring.objective(ring.at(middle)),
                 c = ring.objective(ring.at(right));
    Valley valley{left, middle, right, double(middle), b};
    const double h = double(middle - left), k = double(right - middle);
    const double slope_left = (a - b) / h, slope_right = (c - b) / k; // both not negative
    const double curvature = (slope_left + slope_right) / (h + k);
    if(std::isfinite(curvature) && curvature > 0) {
      const double slope = (slope_right * h - slope_left * k) / (h + k); // of the parabola, in the middle
      valley.bottom = double(middle) - slope / (2 * curvature);
      valley.promise = b - slope * slope / (4 * curvature);
    } else if(!std::isfinite(a) || !std::isfinite(c))
      valley.promise = -std::numeric_limits<double>::infinity(); // beside a region without maps nothing is known
    return valley;
  }

  /// indicates whether the curve is seen not to be unimodal: more samples are due then
  static bool has_several_valleys(const internal::Candidate_ring& ring)
  {
    const std::vector<int> positions = ring.known();
    const std::size_t count = positions.size();
    int valleys = 0;
    for(std::size_t i = 0; i < count; ++i) {
      const double here = ring.objective(positions[i]);
      if(here < ring.objective(positions[(i + count - 1) % count]) && here < ring.objective(positions[(i + 1) % count]))
        ++valleys;
    }
    return valleys > 1;
  }

  static std::set<int> middle_of_largest_gap(const internal::Candidate_ring& ring)
  {
    const std::vector<int> positions = ring.known();
    long largest = 0, middle = 0;
    for(std::size_t i = 0; i < positions.size(); ++i) {
      const long next = i + 1 < positions.size() ? positions[i + 1] : positions[0] + ring.size();
      if(next - positions[i] > largest) {
        largest = next - positions[i];
        middle = positions[i] + largest / 2;
      }
    }
    return {ring.at(middle)};
  }

  /// the valley with unknown candidates whose promise is lowest; none when none is worth a look
  static std::optional<Valley> most_promising(const internal::Candidate_ring& ring)
  {
    constexpr double NEGLIGIBLE = 1e-5; // relative: less than this is not worth an evaluation
    const std::vector<int> positions = ring.known();
    const std::size_t count = positions.size();
    const double best = ring.objective(ring.best());
    std::optional<Valley> found;
    for(std::size_t i = 0; i < count; ++i) {
      const long middle = positions[i];
      const long left = i > 0 ? positions[i - 1] : positions[count - 1] - ring.size();
      const long right = i + 1 < count ? positions[i + 1] : positions[0] + ring.size();
      const double here = ring.objective(positions[i]);
      if(right - left <= 2 || here > ring.objective(ring.at(left)) || here > ring.objective(ring.at(right)))
        continue;
      const Valley valley = make_valley(ring, left, middle, right);
      const bool is_best = ring.best() == positions[i];
      if(!is_best && !(valley.promise < best * (1 - NEGLIGIBLE)) && std::isfinite(here))
        continue;
      if(!found || valley.promise < found->promise)
        found = valley;
    }
    return found;
  }

  /// one new sample on each side of the middle: at the bottom of the parabola on its side, unless that is all but in
  /// the middle; else next to the middle
  static std::set<int> next_samples(const Valley& valley, const internal::Candidate_ring& ring)
  {
    constexpr double NEAR_MIDDLE = 0.75; // candidates
    const auto inside = [&valley](long low, long high) {
      return (std::max)(low + 1, (std::min)(std::lround(valley.bottom), high - 1));
    };
    std::set<int> samples;
    if(valley.middle - valley.left > 1)
      samples.insert(ring.at(valley.bottom <= double(valley.middle) - NEAR_MIDDLE ? inside(valley.left, valley.middle)
                                                                                  : valley.middle - 1));
    if(valley.right - valley.middle > 1)
      samples.insert(ring.at(valley.bottom >= double(valley.middle) + NEAR_MIDDLE ? inside(valley.middle, valley.right)
                                                                                  : valley.middle + 1));
    return samples;
  }

  int m_samples;
};

} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_BRACKETING_CORNER_SEARCH_H
