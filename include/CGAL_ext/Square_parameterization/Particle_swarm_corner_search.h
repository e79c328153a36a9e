// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_PARTICLE_SWARM_CORNER_SEARCH_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_PARTICLE_SWARM_CORNER_SEARCH_H

#include <CGAL_ext/Square_parameterization/internal/search/Candidate_ring.h>

#include <CGAL/Random.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {

/// \ingroup PkgSquareParameterizationSearches
///
/// lets a swarm of particles fly over the ring of candidates of the quarter (Kennedy and Eberhart
/// \cgalCite{kennedy1995particle}, with the constriction constants of Clerc and Kennedy): each is drawn to the best
/// candidate it has seen and to the best that all have seen. The particles of one iteration are evaluated together.
///
/// At most `particles` times `iterations` + 1 evaluations, fewer since candidates repeat. The answer depends on the
/// seed, and is the same whenever the seed is; there is no guarantee.
/// \cgalModels `CornerSearch`
class Particle_swarm_corner_search
{
public:
  /// lets \f$ \max(4, \sqrt m) \f$ particles fly over \f$ m \f$ candidates
  Particle_swarm_corner_search() : Particle_swarm_corner_search(0) {}

  /// \param particles size of the swarm, 1 or more; 0 for \f$ \max(4, \sqrt m) \f$ with \f$ m \f$ candidates
  /// \param iterations largest number of moves of the swarm, not negative
  /// \param patience number of moves in a row without a better candidate after which the search ends, 1 or more
  /// \param seed of the pseudo-random numbers of `CGAL::Random`
  explicit Particle_swarm_corner_search(int particles, int iterations = 20, int patience = 3, unsigned int seed = 0)
    : m_particles(particles), m_iterations(iterations), m_patience(patience), m_seed(seed)
  {}

  /// indicates whether the numbers are in their ranges. With one that is not, a search is refused with
  /// `ERROR_WRONG_PARAMETER`.
  bool is_valid() const { return m_particles >= 0 && m_iterations >= 0 && m_patience >= 1; }

  Candidate_set candidate_set() const { return Candidate_set::QUARTER; }

  void operator()(const Corner_search_problem& problem) const
  {
    internal::Candidate_ring ring(problem);
    CGAL::Random random(m_seed);
    std::vector<Particle> swarm = scatter(ring, random);
    evaluate(swarm, ring);
    int failures = 0;
    for(int i = 0; i < m_iterations && failures < m_patience; ++i) {
      const double best_before = ring.objective(ring.best());
      for(Particle& particle : swarm)
        move(particle, ring, random);
      evaluate(swarm, ring);
      failures = ring.objective(ring.best()) < best_before ? 0 : failures + 1;
    }
  }

private:
  struct Particle
  {
    double position, velocity; ///< on the ring, in candidates
    int best;                  ///< best candidate this particle has seen, -1 before the first
  };

  std::vector<Particle> scatter(const internal::Candidate_ring& ring, CGAL::Random& random) const
  {
    const int size = m_particles > 0 ? m_particles : (std::max)(4, static_cast<int>(std::sqrt(double(ring.size()))));
    std::vector<Particle> swarm;
    for(int i = 0; i < size; ++i) { // one in each of equal arcs
      const double arc = double(ring.size()) / size;
      const double position = (i + random.get_double()) * arc;
      swarm.push_back({position, random.get_double(-1, 1) * arc, -1});
    }
    return swarm;
  }

  static int candidate_of(const Particle& particle, const internal::Candidate_ring& ring)
  {
    return ring.at(std::lround(particle.position));
  }

  static void evaluate(std::vector<Particle>& swarm, internal::Candidate_ring& ring)
  {
    std::vector<int> candidates;
    for(const Particle& particle : swarm)
      candidates.push_back(candidate_of(particle, ring));
    ring.evaluate(candidates);
    for(std::size_t i = 0; i < swarm.size(); ++i)
      if(swarm[i].best < 0 || ring.objective(candidates[i]) < ring.objective(swarm[i].best))
        swarm[i].best = candidates[i];
  }

  static void move(Particle& particle, const internal::Candidate_ring& ring, CGAL::Random& random)
  {
    constexpr double INERTIA = 0.7298, ATTRACTION = 1.49618;
    const double ring_size = ring.size();
    const auto way_to = [&](int target) { return std::remainder(target - particle.position, ring_size); };
    const double to_own_best = random.get_double() * way_to(particle.best);
    const double to_common_best = random.get_double() * way_to(ring.best());
    particle.velocity = INERTIA * particle.velocity + ATTRACTION * (to_own_best + to_common_best);
    particle.velocity = (std::max)(-ring_size / 2, (std::min)(particle.velocity, ring_size / 2));
    particle.position = std::fmod(particle.position + particle.velocity + ring_size, ring_size);
  }

  int m_particles, m_iterations, m_patience;
  unsigned int m_seed;
};

} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_PARTICLE_SWARM_CORNER_SEARCH_H
