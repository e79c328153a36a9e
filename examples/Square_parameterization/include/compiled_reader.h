// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef EXAMPLES_COMPILED_READER_H
#define EXAMPLES_COMPILED_READER_H

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <string>

// CGAL's readers of all formats are more than half of what an example costs to compile. They are compiled once, in
// src/compiled_reader.cpp; the examples do not know it, since the build puts this header in front of them. Benchmarks and
// the figures of the manual include it.
extern template bool CGAL::IO::read_polygon_mesh(const std::string&,
                                                 CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>&,
                                                 const CGAL::parameters::Default_named_parameters&);

#endif // EXAMPLES_COMPILED_READER_H
