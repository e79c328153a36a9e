// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_BRACKETING_CORNER_SEARCH_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_BRACKETING_CORNER_SEARCH_H

#include <CGAL_ext/Square_parameterization/internal/Candidate_ring.h>

#include <optional>

namespace CGAL_ext {

/// \ingroup PkgSquareParameterizationSearches
///
/// samples the ring of candidates of the quarter evenly, and then closes in on the best: each sample that is not higher
/// than its neighbors brackets a valley; the valley with the lowest bottom, by the parabola through its three samples,
/// is sampled again, until no valley promises less than the best candidate known. On a curve with several valleys the
/// largest gaps are sampled, too. Maps start from those of their neighbors.
///
/// At most \f$ \max(12, 2 \log_2 m + 4) \f$ evaluations of \f$ m \f$ candidates. Deterministic; finds the
/// optimum of curves that are smooth on the scale of the samples, as the balanced energy is on most meshes.
/// \cgalModels `CornerSearch`
class Bracketing_corner_search
{
public:
  /// \param samples number of candidates evaluated first, 3 or more
  explicit Bracketing_corner_search(int samples = 5) : m_samples((std::max)(3, samples)) {}

  Candidate_set candidate_set() const { return Candidate_set::QUARTER; }

  void operator()(const Corner_search_problem& problem) const
  {
    internal::Candidate_ring ring(problem);
    ring.start_from_neighbors();
    const int n = ring.size();
    const std::size_t budget = (std::max)(12, static_cast<int>(2 * std::log2(double(n))) + 4);
    std::set<int> known;
    const auto evaluate = [&](const std::set<int>& batch) {
      ring.evaluate({batch.begin(), batch.end()});
      known.insert(batch.begin(), batch.end());
    };
    std::set<int> first;
    for(int i = 0; i < (std::min)(m_samples, n); ++i)
      first.insert(static_cast<int>(static_cast<long>(i) * n / (std::min)(m_samples, n)));
    evaluate(first);
    while(known.size() < budget && static_cast<int>(known.size()) < n) {
      const std::optional<Valley> valley = most_promising(ring, known);
      if(!valley && !has_several_valleys(ring, known))
        break;
      std::set<int> batch = valley ? next_samples(*valley, ring) : middle_of_largest_gap(ring, known);
      while(known.size() + batch.size() > budget)
        batch.erase(std::prev(batch.end()));
      evaluate(batch);
    }
  }

private:
  /// a known candidate between two known ones that are not lower; positions on the unrolled ring
  struct Valley
  {
    long left, middle, right;
    double bottom;  ///< position of the lowest point of the parabola
    double promise; ///< its value
  };

  static Valley make_valley(const internal::Candidate_ring& ring, long left, long middle, long right)
  {
    const double a = ring.stretch(ring.at(left)), b = ring.stretch(ring.at(middle)), c = ring.stretch(ring.at(right));
    Valley valley{left, middle, right, double(middle), b};
    const double h = middle - left, k = right - middle;
    const double slope_left = (a - b) / h, slope_right = (c - b) / k; // both not negative
    const double curvature = (slope_left + slope_right) / (h + k);
    if(std::isfinite(curvature) && curvature > 0) {
      const double slope = (slope_right * h - slope_left * k) / (h + k); // of the parabola, in the middle
      valley.bottom = middle - slope / (2 * curvature);
      valley.promise = b - slope * slope / (4 * curvature);
    } else if(!std::isfinite(a) || !std::isfinite(c))
      valley.promise = -std::numeric_limits<double>::infinity(); // beside a region without maps nothing is known
    return valley;
  }

  /// indicates whether the curve is seen not to be unimodal: more samples are due then
  static bool has_several_valleys(const internal::Candidate_ring& ring, const std::set<int>& known)
  {
    const std::vector<int> positions(known.begin(), known.end());
    const std::size_t count = positions.size();
    int valleys = 0;
    for(std::size_t i = 0; i < count; ++i) {
      const double here = ring.stretch(positions[i]);
      if(here < ring.stretch(positions[(i + count - 1) % count]) && here < ring.stretch(positions[(i + 1) % count]))
        ++valleys;
    }
    return valleys > 1;
  }

  static std::set<int> middle_of_largest_gap(const internal::Candidate_ring& ring, const std::set<int>& known)
  {
    const std::vector<int> positions(known.begin(), known.end());
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
  static std::optional<Valley> most_promising(const internal::Candidate_ring& ring, const std::set<int>& known)
  {
    constexpr double NEGLIGIBLE = 1e-5; // relative: less than this is not worth an evaluation
    const std::vector<int> positions(known.begin(), known.end());
    const std::size_t count = positions.size();
    const double best = ring.stretch(ring.best());
    std::optional<Valley> found;
    for(std::size_t i = 0; i < count; ++i) {
      const long middle = positions[i];
      const long left = i > 0 ? positions[i - 1] : positions[count - 1] - ring.size();
      const long right = i + 1 < count ? positions[i + 1] : positions[0] + ring.size();
      const double here = ring.stretch(positions[i]);
      if(right - left <= 2 || here > ring.stretch(ring.at(left)) || here > ring.stretch(ring.at(right)))
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

  /// one new sample on each side of the middle: at the bottom of the parabola on its side, unless that is all but in the
  /// middle; else next to the middle
  static std::set<int> next_samples(const Valley& valley, const internal::Candidate_ring& ring)
  {
    constexpr double NEAR_MIDDLE = 0.75; // candidates
    const auto inside = [&valley](long low, long high) {
      return (std::max)(low + 1, (std::min)(std::lround(valley.bottom), high - 1));
    };
    std::set<int> samples;
    if(valley.middle - valley.left > 1)
      samples.insert(ring.at(valley.bottom <= valley.middle - NEAR_MIDDLE ? inside(valley.left, valley.middle)
                                                                          : valley.middle - 1));
    if(valley.right - valley.middle > 1)
      samples.insert(ring.at(valley.bottom >= valley.middle + NEAR_MIDDLE ? inside(valley.middle, valley.right)
                                                                          : valley.middle + 1));
    return samples;
  }

  int m_samples;
};

} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_BRACKETING_CORNER_SEARCH_H
