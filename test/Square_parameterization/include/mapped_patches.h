// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_TEST_MAPPED_PATCHES_H
#define CGAL_EXT_TEST_MAPPED_PATCHES_H

#include "make_patch_of.h"
#include "map_cases.h"
#include "test_meshes.h"

#include <CGAL_ext/Square_parameterization/Stretch_minimization.h>
#include <CGAL_ext/Square_parameterization/internal/iteration/Stretch_iteration.h>

/// patches of several kinds
inline std::vector<CGAL_ext::internal::Patch> patches()
{
  return {make_patch_of(saddle(6)), make_patch_of(cone()), make_patch_of(noisy_height_field(6)),
          make_patch_of(long_strip(12))};
}

/// a map without flips that is no minimum of anything: the one of uniform weights
inline CGAL_ext::internal::Uv_coordinates some_map(const CGAL_ext::internal::Patch& patch, int candidate = 1)
{
  using namespace CGAL_ext;
  using namespace CGAL_ext::internal;
  Stretch_minimization uniform;
  uniform.weights = Uniform_weights();
  uniform.maximum_iterations = 0;
  Stretch_iteration::Workspace workspace;
  return Stretch_iteration(patch, uniform).minimize(square_border_of(patch, candidate), 1, workspace).uv;
}

#endif // CGAL_EXT_TEST_MAPPED_PATCHES_H
