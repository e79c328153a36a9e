// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_CORNER_RULE_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_CORNER_RULE_H

namespace CGAL_ext {

/// \ingroup PkgSquareParameterizationEnums
///
/// says at which border vertices the sides of the square end, once a first corner is chosen. Let `q` be a quarter of
/// the border length. With either rule each side has at least one edge.
enum class Corner_rule
{
  AUTHOR, ///< a side ends where its length first reaches `q`, or one edge earlier if that length would be 1.1 `q` or
          ///< more; the fourth side takes the rest. This rule reproduces the published tables.
  NEAREST ///< the corners are the vertices nearest in arc length to `q`, `2q` and `3q` from the first corner
};

/// \ingroup PkgSquareParameterizationEnums
///
/// the direction in which candidates are counted and sides are closed. It has no influence on the orientation of the
/// map, which is never mirrored.
enum class Walk
{
  COUNTER_CLOCKWISE, ///< along the faces: the surface is on the left
  CLOCKWISE          ///< against the faces
};

} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_CORNER_RULE_H
