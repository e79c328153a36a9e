// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef EXAMPLES_PRINT_SEARCH_H
#define EXAMPLES_PRINT_SEARCH_H

#include <CGAL_ext/Square_parameterization/Search_visitor.h>

#include <iostream>

/// prints what a search found, and how good its best map is: parameterizers are copied, results come through a visitor
struct Print_search : CGAL_ext::Search_visitor
{
  void end_search(const CGAL_ext::Search_report& report) override
  {
    std::cout << report.evaluations << " of " << report.candidates << " candidates evaluated, " << report.sketches
              << " sketched; the corners are at border positions";
    for(int corner : report.corners)
      std::cout << ' ' << corner;
    std::cout << '\n';
  }

  void end_minimization(const CGAL_ext::Minimization_report& report) override
  {
    std::cout << "L2 stretch of the best map: " << report.l2 << '\n';
  }
};

#endif // EXAMPLES_PRINT_SEARCH_H
