// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_MAP_CASES_H
#define CGAL_EXT_MAP_CASES_H

#include <CGAL_ext/Square_parameterization/internal/border/border_curves.h>

/// the border of the patch on the unit square, its first vertex at (0, 0)
inline CGAL_ext::internal::Uv_coordinates first_square_border(const CGAL_ext::internal::Patch& patch)
{
  using namespace CGAL_ext;
  const internal::Border_walk walk(patch.border_lengths, Walk::COUNTER_CLOCKWISE);
  return internal::square_border(walk, internal::corners_of_candidate(walk, 0, Corner_rule::NEAREST)).uv;
}

#endif // CGAL_EXT_MAP_CASES_H
