// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Part of the library CGAL_ext_core (see internal/common/compiled_core.h): the search for the corners of the square.

#include <CGAL_ext/Square_parameterization/internal/search/square_search_impl.h>
