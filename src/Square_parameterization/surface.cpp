// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Part of the library CGAL_ext_core (see internal/common/compiled_core.h): surfaces as flat arrays, disks of them, and simpler
// copies.

#include <CGAL_ext/Square_parameterization/internal/surface/check_surface_impl.h>
#include <CGAL_ext/Square_parameterization/internal/surface/decimate_surface_impl.h>
#include <CGAL_ext/Square_parameterization/internal/surface/make_disk_patch_impl.h>
