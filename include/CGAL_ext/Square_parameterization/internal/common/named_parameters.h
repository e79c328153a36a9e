// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COMMON_NAMED_PARAMETERS_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COMMON_NAMED_PARAMETERS_H

namespace CGAL_ext {
namespace internal {

// tags of the named parameters that this package adds to those of CGAL, whose list is closed

/// that of `parameters::options()`
enum options_t
{
  options
};

/// that of `parameters::chords()`
enum chords_t
{
  chords
};

/// that of `parameters::vertex_stretch_map()`
enum vertex_stretch_map_t
{
  vertex_stretch_map
};

} // namespace internal
} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COMMON_NAMED_PARAMETERS_H
