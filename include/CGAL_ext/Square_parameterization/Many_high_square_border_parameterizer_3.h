// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_MANY_HIGH_SQUARE_BORDER_PARAMETERIZER_3_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_MANY_HIGH_SQUARE_BORDER_PARAMETERIZER_3_H

#include <CGAL_ext/Square_parameterization/circle_corner_searches.h>
#include <CGAL_ext/Square_parameterization/internal/plug_in/Square_border_search_parameterizer_3.h>

namespace CGAL_ext {

/// \ingroup PkgSquareParameterizationBorderParameterizers
///
/// parameterizes the border of a disk onto the unit square by arc length, with corners found by one prediction: the
/// border vertices of high stretch on the circle gather around the corners.
///
/// What the border parameterizers that search have in common, and what `parameterize()` returns, is said at
/// `Brute_force_square_border_parameterizer_3`.
///
/// \cgalModels `Parameterizer_3`
///
/// \tparam TriangleMesh_ must be a model of `FaceGraph`. Coordinates are read as `double`.
///
/// \sa `CGAL_ext::Many_high_corner_search`
template <class TriangleMesh_>
class Many_high_square_border_parameterizer_3
  : public internal::Square_border_search_parameterizer_3<TriangleMesh_, Many_high_corner_search>
{
  typedef internal::Square_border_search_parameterizer_3<TriangleMesh_, Many_high_corner_search> Base;

public:
  /// constructs the parameterizer.
  /// \param options options that all searches share
  /// \param objective what is minimised when another parameterizer than `Stretch_minimizing_parameterizer_3` uses this
  ///        border
  explicit Many_high_square_border_parameterizer_3(Square_search_options options = {},
                                                   Stretch_minimization objective = {})
    : Base(Many_high_corner_search(), std::move(options), std::move(objective))
  {}
};

} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_MANY_HIGH_SQUARE_BORDER_PARAMETERIZER_3_H
