// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_BRACKETING_SQUARE_BORDER_PARAMETERIZER_3_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_BRACKETING_SQUARE_BORDER_PARAMETERIZER_3_H

#include <CGAL_ext/Square_parameterization/Bracketing_corner_search.h>
#include <CGAL_ext/Square_parameterization/internal/plug_in/Square_border_search_parameterizer_3.h>

namespace CGAL_ext {

/// \ingroup PkgSquareParameterizationBorderParameterizers
///
/// parameterizes the border of a disk onto the unit square by arc length, with corners found by bracketing: even
/// samples, then ever closer ones around the most promising valley.
///
/// What the border parameterizers that search have in common, and what `parameterize()` returns, is said at
/// `Brute_force_square_border_parameterizer_3`.
///
/// \cgalModels `Parameterizer_3`
///
/// \tparam TriangleMesh_ must be a model of `FaceGraph`. Coordinates are read as `double`.
///
/// \sa `CGAL_ext::Bracketing_corner_search`
template <class TriangleMesh_>
class Bracketing_square_border_parameterizer_3
  : public internal::Square_border_search_parameterizer_3<TriangleMesh_, Bracketing_corner_search>
{
  typedef internal::Square_border_search_parameterizer_3<TriangleMesh_, Bracketing_corner_search> Base;

public:
  /// constructs the parameterizer.
  /// \param samples number of candidates evaluated first, 3 or more
  /// \param options options that all searches share
  /// \param objective what is minimised when another parameterizer than `Stretch_minimizing_parameterizer_3` uses this
  ///        border
  explicit Bracketing_square_border_parameterizer_3(int samples = 5, Square_search_options options = {},
                                                    Stretch_minimization objective = {})
    : Base(Bracketing_corner_search(samples), std::move(options), std::move(objective))
  {}
};

} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_BRACKETING_SQUARE_BORDER_PARAMETERIZER_3_H
