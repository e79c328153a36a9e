// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Part of the library CGAL_ext_core (see internal/common/compiled_core.h): the conditioning of polygon soups.

#include <CGAL_ext/Square_parameterization/internal/soup/condition_soup_impl.h>
