// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_BRUTE_FORCE_SQUARE_BORDER_PARAMETERIZER_3_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_BRUTE_FORCE_SQUARE_BORDER_PARAMETERIZER_3_H

#include <CGAL_ext/Square_parameterization/corner_searches.h>
#include <CGAL_ext/Square_parameterization/internal/plug_in/Square_border_search_parameterizer_3.h>

namespace CGAL_ext {

/// \ingroup PkgSquareParameterizationBorderParameterizers
///
/// parameterizes the border of a disk onto the unit square by arc length, with the corners at which the stretch of the
/// map is least. The search maps all border vertices. It finds the optimum, with as many evaluations as there are
/// border vertices.
///
/// Candidates are counted from the source of the border halfedge given to `parameterize()`; they are mapped
/// concurrently, and the result does not depend on the number of threads. The mesh is not changed: a candidate that
/// puts both ends of an interior edge on one side of the square has infinite stretch (see `split_chords()`).
///
/// `parameterize()` returns
/// - `OK`,
/// - `ERROR_NO_1_TO_1_MAPPING` when no candidate has a one-to-one map, or no face has an area,
/// - `ERROR_BORDER_TOO_SHORT` when the border has fewer than four vertices,
/// - `ERROR_NON_TRIANGULAR_MESH`, `ERROR_NO_TOPOLOGICAL_DISC` when the connected component at the border halfedge is
///   not a triangulated disk,
/// - `ERROR_WRONG_PARAMETER` when a coordinate is not finite or a number of the objective is out of range.
///
/// \cgalModels `Parameterizer_3`
///
/// \tparam TriangleMesh_ must be a model of `FaceGraph`. Coordinates are read as `double`.
///
/// \sa `CGAL_ext::Stretch_minimizing_parameterizer_3`
template <class TriangleMesh_>
class Brute_force_square_border_parameterizer_3
  : public internal::Square_border_search_parameterizer_3<TriangleMesh_, Brute_force_corner_search>
{
  typedef internal::Square_border_search_parameterizer_3<TriangleMesh_, Brute_force_corner_search> Base;

public:
  /// constructs the parameterizer.
  /// \param options options that all searches share
  /// \param objective what is minimised when another parameterizer than `Stretch_minimizing_parameterizer_3` uses this
  ///        border
  explicit Brute_force_square_border_parameterizer_3(Square_search_options options = {},
                                                     Stretch_minimization objective = {})
    : Base({}, std::move(options), std::move(objective))
  {}
};

} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_BRUTE_FORCE_SQUARE_BORDER_PARAMETERIZER_3_H
