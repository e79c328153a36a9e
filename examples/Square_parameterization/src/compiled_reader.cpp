// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../include/compiled_reader.h"

template bool CGAL::IO::read_polygon_mesh(const std::string&,
                                          CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>&,
                                          const CGAL::parameters::Default_named_parameters&);
