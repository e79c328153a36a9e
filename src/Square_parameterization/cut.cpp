// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Part of the library CGAL_ext_core (see internal/common/compiled_core.h): the decision where a surface is cut to a disk.

#include <CGAL_ext/Square_parameterization/internal/cut/cut_to_disk_impl.h>
#include <CGAL_ext/Square_parameterization/internal/cut/search_cut_impl.h>
