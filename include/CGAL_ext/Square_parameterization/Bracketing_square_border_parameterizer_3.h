// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_BRACKETING_SQUARE_BORDER_PARAMETERIZER_3_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_BRACKETING_SQUARE_BORDER_PARAMETERIZER_3_H

#include <CGAL_ext/Square_parameterization/Bracketing_corner_search.h>
#include <CGAL_ext/Square_parameterization/Square_border_corner_search_parameterizer_3.h>

namespace CGAL_ext {

/// \ingroup PkgSquareParameterizationBorderParameterizers
///
/// parameterizes the border of a disk onto the unit square by arc length, with corners found by bracketing: even
/// samples, then ever closer ones around the most promising valley.
///
/// Constructor, errors and thread safety are those of `Square_border_corner_search_parameterizer_3`; the numbers of the
/// search are those of its object.
///
/// \cgalModels `Parameterizer_3`
///
/// \tparam TriangleMesh_ must be a model of `FaceGraph`. Coordinates are read as `double`.
///
/// \sa `CGAL_ext::Bracketing_corner_search`
template <class TriangleMesh_>
using Bracketing_square_border_parameterizer_3 =
    Square_border_corner_search_parameterizer_3<TriangleMesh_, Bracketing_corner_search>;

} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_BRACKETING_SQUARE_BORDER_PARAMETERIZER_3_H
