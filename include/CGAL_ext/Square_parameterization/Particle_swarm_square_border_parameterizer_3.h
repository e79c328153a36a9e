// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_PARTICLE_SWARM_SQUARE_BORDER_PARAMETERIZER_3_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_PARTICLE_SWARM_SQUARE_BORDER_PARAMETERIZER_3_H

#include <CGAL_ext/Square_parameterization/Particle_swarm_corner_search.h>
#include <CGAL_ext/Square_parameterization/internal/plug_in/Square_border_search_parameterizer_3.h>

namespace CGAL_ext {

/// \ingroup PkgSquareParameterizationBorderParameterizers
///
/// parameterizes the border of a disk onto the unit square by arc length, with corners found by a particle swarm.
///
/// What the border parameterizers that search have in common, and what `parameterize()` returns, is said at
/// `Brute_force_square_border_parameterizer_3`.
///
/// \cgalModels `Parameterizer_3`
///
/// \tparam TriangleMesh_ must be a model of `FaceGraph`. Coordinates are read as `double`.
///
/// \sa `CGAL_ext::Particle_swarm_corner_search`
template <class TriangleMesh_>
class Particle_swarm_square_border_parameterizer_3
  : public internal::Square_border_search_parameterizer_3<TriangleMesh_, Particle_swarm_corner_search>
{
  typedef internal::Square_border_search_parameterizer_3<TriangleMesh_, Particle_swarm_corner_search> Base;

public:
  /// constructs the parameterizer.
  /// \param particles size of the swarm; 0 for the default \f$ \max(4, \sqrt m) \f$ with \f$ m \f$ candidates
  /// \param iterations largest number of moves of the swarm
  /// \param patience number of moves in a row without a better candidate after which the search ends
  /// \param seed of the pseudo-random numbers
  /// \param options options that all searches share
  /// \param objective what is minimised when another parameterizer than `Stretch_minimizing_parameterizer_3` uses this
  ///        border
  explicit Particle_swarm_square_border_parameterizer_3(unsigned int particles = 0, unsigned int iterations = 20,
                                                        unsigned int patience = 3, unsigned int seed = 0,
                                                        Square_search_options options = {},
                                                        Stretch_minimization objective = {})
    : Base(Particle_swarm_corner_search(particles, iterations, patience, seed), std::move(options),
           std::move(objective))
  {}
};

} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_PARTICLE_SWARM_SQUARE_BORDER_PARAMETERIZER_3_H
