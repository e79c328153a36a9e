// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SEARCH_FEW_CORNERS_SEARCH_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SEARCH_FEW_CORNERS_SEARCH_H

#include <CGAL_ext/Square_parameterization/internal/search/Candidate_ring.h>

namespace CGAL_ext {
namespace internal {

/// comes near the best candidate with eight maps at most: of four spread evenly over the ring, and then, twice, of
/// those half way from the best to the known ones on either side. Enough to compare surfaces, where each has an error
/// anyway. Deterministic.
class Few_corners_search
{
public:
  Candidate_set candidate_set() const { return Candidate_set::QUARTER; }

  void operator()(const Corner_search_problem& problem) const
  {
    constexpr int SAMPLES = 4, HALVINGS = 2;
    Candidate_ring ring(problem);
    ring.start_from_neighbors();
    ring.evaluate(ring.even_candidates(SAMPLES));
    for(int i = 0; i < HALVINGS; ++i)
      ring.evaluate({half_way(ring, -1), half_way(ring, 1)}); // known ones cost nothing
  }

private:
  /// the candidate between the best and the nearest known one in direction 1 or -1; one of them when there is none
  static int half_way(const Candidate_ring& ring, int direction)
  {
    return ring.at(ring.best() + direction * (ring.distance_to_known(direction) / 2));
  }
};

} // namespace internal
} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SEARCH_FEW_CORNERS_SEARCH_H
