// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Part of the library CGAL_ext_core (see internal/common/compiled_core.h): simpler copies of a surface.

#include <CGAL_ext/Square_parameterization/internal/surface/decimate_surface_impl.h>
