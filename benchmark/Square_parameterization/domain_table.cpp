// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

// benchmark/Square_parameterization/domain_table.cpp
//
// Measures what free corners and the rectangle gain: the least balanced energy (balance 0.3, sliding border) and its L2
// stretch on the square with the best corners of the quarter, on the square with corners that move, and on the rectangle
// that the surface asks for. As a Markdown table.
//
//   domain_table build/data/meshes/patch-13.off build/data/meshes/three_peaks.off --generated

#include "include/models.h"

#include <CGAL_ext/Square_parameterization/Bracketing_corner_search.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/make_minimizer.h>
#include <CGAL_ext/Square_parameterization/internal/search/square_search.h>

#include <iomanip>
#include <iostream>

namespace {

using namespace CGAL_ext;

internal::Minimized_map map(const Patch& patch, const Balanced_minimization& minimization, bool moves_corners)
{
  Square_search_options options;
  options.moves_corners = moves_corners;
  const auto minimizer = internal::make_minimizer(patch, minimization);
  return internal::search_square_map(patch, *minimizer, Bracketing_corner_search(), options).map;
}

void print_row(const Model& model)
{
  Balanced_minimization square, rectangle;
  rectangle.aspect.reset();
  const internal::Minimized_map quarter = map(model.patch, square, false), free = map(model.patch, square, true),
                                best = map(model.patch, rectangle, true);
  std::cout << "| " << model.name << " (" << model.patch.number_of_faces() << ") | " << std::setprecision(4)
            << quarter.report.objective << " | " << quarter.report.l2 << " | " << free.report.objective << " | "
            << free.report.l2 << " | " << std::setprecision(2) << best.aspect << std::setprecision(4) << " | "
            << best.report.objective << " | " << best.report.l2 << " |" << std::endl;
}

} // namespace

int main(int argc, char** argv)
{
  std::cout << std::fixed
            << "| Mesh (faces) | square: energy | L2 | free corners: energy | L2 | rectangle: aspect | energy | L2 |\n"
               "| :--- | ---: | ---: | ---: | ---: | ---: | ---: | ---: |\n";
  for(const Model& model : read_models(argc, argv))
    print_row(model);
}
