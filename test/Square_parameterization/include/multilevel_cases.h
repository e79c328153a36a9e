// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_TEST_MULTILEVEL_CASES_H
#define CGAL_EXT_TEST_MULTILEVEL_CASES_H

#include "closed_meshes.h"
#include "mapped_patches.h"

#include <CGAL_ext/Square_parameterization/internal/cut/score_cut.h>

/// the iteration from which the coarsest patch starts
inline CGAL_ext::internal::Stretch_iteration start_of(const CGAL_ext::internal::Patch& patch)
{
  CGAL_ext::Stretch_minimization start;
  start.maximum_iterations = 5;
  return {patch, start};
}

/// a disk without chords
inline CGAL_ext::internal::Patch patch_without_chords(const Closed_mesh& disk)
{
  using namespace CGAL_ext::internal;
  const Triangle_surface surface = surface_of(disk);
  return patch_of_cut(surface, Cut(surface));
}

#endif // CGAL_EXT_TEST_MULTILEVEL_CASES_H
