// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_CHORDS_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_CHORDS_H

namespace CGAL_ext {

/// \ingroup PkgSquareParameterizationConditioning
///
/// which chords are split
enum class Chords
{
  ALL, ///< every chord: afterwards every choice of corners has a one-to-one map
  EARS ///< only those that cut off a single face, as the authors of the published tables did
};

} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_CHORDS_H
