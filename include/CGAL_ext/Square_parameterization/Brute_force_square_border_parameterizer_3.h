// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_BRUTE_FORCE_SQUARE_BORDER_PARAMETERIZER_3_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_BRUTE_FORCE_SQUARE_BORDER_PARAMETERIZER_3_H

#include <CGAL_ext/Square_parameterization/Square_border_corner_search_parameterizer_3.h>
#include <CGAL_ext/Square_parameterization/corner_searches.h>

namespace CGAL_ext {

/// \ingroup PkgSquareParameterizationBorderParameterizers
///
/// parameterizes the border of a disk onto the unit square by arc length, with the corners at which the stretch of
/// the map is least. The search maps all border vertices to (0, 0). It finds the optimum, with as many evaluations as
/// there are border vertices.
///
/// Constructor, errors and thread safety are those of `Square_border_corner_search_parameterizer_3`.
///
/// \cgalModels `Parameterizer_3`
///
/// \tparam TriangleMesh_ must be a model of `FaceGraph`. Coordinates are read as `double`.
///
/// \sa `CGAL_ext::Brute_force_corner_search`
template <class TriangleMesh_>
using Brute_force_square_border_parameterizer_3 =
    Square_border_corner_search_parameterizer_3<TriangleMesh_, Brute_force_corner_search>;

} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_BRUTE_FORCE_SQUARE_BORDER_PARAMETERIZER_3_H
