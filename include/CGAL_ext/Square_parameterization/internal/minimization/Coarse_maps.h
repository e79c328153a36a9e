// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_COARSE_MAPS_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_COARSE_MAPS_H

namespace CGAL_ext {
namespace internal {

/// the maps of coarse patches by which borders are compared
enum class Coarse_maps
{
  SKETCHES,   ///< tell borders apart well
  ROUGH,      ///< of a patch so small that a map costs little: to compare hundreds of borders
  FIRST_MOVES ///< on which corners are moved first: rough ones, or on small patches rougher ones
};

} // namespace internal
} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_COARSE_MAPS_H
