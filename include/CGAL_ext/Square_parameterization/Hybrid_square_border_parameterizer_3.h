// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_HYBRID_SQUARE_BORDER_PARAMETERIZER_3_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_HYBRID_SQUARE_BORDER_PARAMETERIZER_3_H

#include <CGAL_ext/Square_parameterization/Hybrid_corner_search.h>
#include <CGAL_ext/Square_parameterization/internal/plug_in/Square_border_search_parameterizer_3.h>

namespace CGAL_ext {

/// \ingroup PkgSquareParameterizationBorderParameterizers
///
/// parameterizes the border of a disk onto the unit square by arc length, with corners found by the hybrid search: from
/// the better of two predictions it walks both ways, then looks at every candidate around the best.
///
/// What the border parameterizers that search have in common, and what `parameterize()` returns, is said at
/// `Brute_force_square_border_parameterizer_3`.
///
/// \cgalModels `Parameterizer_3`
///
/// \tparam TriangleMesh_ must be a model of `FaceGraph`. Coordinates are read as `double`.
///
/// \sa `CGAL_ext::Hybrid_corner_search`
template <class TriangleMesh_>
class Hybrid_square_border_parameterizer_3
  : public internal::Square_border_search_parameterizer_3<TriangleMesh_, Hybrid_corner_search>
{
  typedef internal::Square_border_search_parameterizer_3<TriangleMesh_, Hybrid_corner_search> Base;

public:
  /// constructs the parameterizer.
  /// \param interval stride of the walks, in candidates; 0 for the formula of the paper
  /// \param options options that all searches share
  /// \param objective what is minimised when another parameterizer than `Stretch_minimizing_parameterizer_3` uses this
  ///        border
  explicit Hybrid_square_border_parameterizer_3(int interval = 0, Square_search_options options = {},
                                                Stretch_minimization objective = {})
    : Base(Hybrid_corner_search(interval), std::move(options), std::move(objective))
  {}
};

} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_HYBRID_SQUARE_BORDER_PARAMETERIZER_3_H
