// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_HYBRID_SQUARE_BORDER_PARAMETERIZER_3_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_HYBRID_SQUARE_BORDER_PARAMETERIZER_3_H

#include <CGAL_ext/Square_parameterization/Hybrid_corner_search.h>
#include <CGAL_ext/Square_parameterization/Square_border_corner_search_parameterizer_3.h>

namespace CGAL_ext {

/// \ingroup PkgSquareParameterizationBorderParameterizers
///
/// parameterizes the border of a disk onto the unit square by arc length, with corners found by the hybrid search: from
/// the better of two predictions it walks both ways, then looks at every candidate around the best.
///
/// Constructor, errors and thread safety are those of `Square_border_corner_search_parameterizer_3`; the numbers of the
/// search are those of its object.
///
/// \cgalModels `Parameterizer_3`
///
/// \tparam TriangleMesh_ must be a model of `FaceGraph`. Coordinates are read as `double`.
///
/// \sa `CGAL_ext::Hybrid_corner_search`
template <class TriangleMesh_>
using Hybrid_square_border_parameterizer_3 =
    Square_border_corner_search_parameterizer_3<TriangleMesh_, Hybrid_corner_search>;

} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_HYBRID_SQUARE_BORDER_PARAMETERIZER_3_H
