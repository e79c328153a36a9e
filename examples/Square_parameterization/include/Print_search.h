// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef EXAMPLES_PRINT_SEARCH_H
#define EXAMPLES_PRINT_SEARCH_H

#include <CGAL_ext/Square_parameterization/Search_visitor.h>

#include <iostream>

/// prints what a search found: parameterizers are copied, results come through a visitor
struct Print_search : CGAL_ext::Search_visitor
{
  void end_search(const CGAL_ext::Search_report& report) override
  {
    std::cout << report.evaluations << " of " << report.candidates << " candidates evaluated; L2 stretch "
              << report.best_objective << " with the corners at border positions";
    for(int corner : report.corners)
      std::cout << ' ' << corner;
    std::cout << '\n';
  }
};

#endif // EXAMPLES_PRINT_SEARCH_H
