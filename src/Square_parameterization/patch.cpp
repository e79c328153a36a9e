// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Part of the library CGAL_ext_core (see internal/common/compiled_core.h): disks as flat arrays, and exact orientation.

#include <CGAL_ext/Square_parameterization/internal/patch/Patch_impl.h>
#include <CGAL_ext/Square_parameterization/internal/patch/exact_orientation_impl.h>
#include <CGAL_ext/Square_parameterization/internal/patch/number_edges_impl.h>
