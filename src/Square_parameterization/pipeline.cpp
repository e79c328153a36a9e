// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Part of the library CGAL_ext_core (see internal/common/compiled_core.h): from the arrays of a mesh to its map.

#include <CGAL_ext/Square_parameterization/internal/pipeline/map_surface_impl.h>
