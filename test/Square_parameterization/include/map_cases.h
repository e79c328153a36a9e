// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_MAP_CASES_H
#define CGAL_EXT_MAP_CASES_H

#include <CGAL_ext/Square_parameterization/internal/border/border_curves.h>

/// the border of the patch on the unit square, the border vertex with the number \p candidate at (0, 0)
inline CGAL_ext::internal::Uv_coordinates square_border_of(const CGAL_ext::internal::Patch& patch, int candidate)
{
  using namespace CGAL_ext;
  using namespace CGAL_ext::internal;
  const Border_walk walk(patch.border_lengths, Walk::COUNTER_CLOCKWISE);
  return square_border(walk, corners_of_candidate(walk, candidate, Corner_rule::NEAREST)).uv;
}

#endif // CGAL_EXT_MAP_CASES_H
