// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_MAKE_PATCH_OF_H
#define CGAL_EXT_MAKE_PATCH_OF_H

#include "test_meshes.h"

#include <CGAL_ext/Square_parameterization/internal/patch/Patch.h>

inline CGAL_ext::internal::Patch make_patch_of(const Flat_mesh& mesh)
{
  return CGAL_ext::internal::make_patch(mesh.points, mesh.triangles, mesh.border);
}

#endif // CGAL_EXT_MAKE_PATCH_OF_H
