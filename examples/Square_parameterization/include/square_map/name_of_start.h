// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_NAME_OF_START_H
#define SQUARE_MAP_NAME_OF_START_H

#include <CGAL_ext/Square_parameterization/Square_map_result.h>

#include <string>

namespace square_map {

/// the start of a map in words
inline std::string name_of(CGAL_ext::Map_start start)
{
  switch(start) {
  case CGAL_ext::Map_start::BLENDED_WEIGHTS:
    return "blended weights";
  case CGAL_ext::Map_start::UNIFORM_WEIGHTS:
    return "uniform weights";
  case CGAL_ext::Map_start::MEAN_VALUE_WEIGHTS:
    return "mean value weights";
  case CGAL_ext::Map_start::GRADUAL_COARSENING:
    return "gradual coarsening";
  case CGAL_ext::Map_start::GRADUAL_COARSENING_BLENDED_WEIGHTS:
    return "gradual coarsening, blended weights";
  case CGAL_ext::Map_start::GRADUAL_COARSENING_UNIFORM_WEIGHTS:
    return "gradual coarsening, uniform weights";
  case CGAL_ext::Map_start::GRADUAL_COARSENING_MEAN_VALUE_WEIGHTS:
    return "gradual coarsening, mean value weights";
  case CGAL_ext::Map_start::FIXED_BORDER_FIRST:
    return "fixed border first";
  case CGAL_ext::Map_start::FIXED_BORDER_FIRST_BLENDED_WEIGHTS:
    return "fixed border first, blended weights";
  case CGAL_ext::Map_start::FIXED_BORDER_FIRST_UNIFORM_WEIGHTS:
    return "fixed border first, uniform weights";
  case CGAL_ext::Map_start::FIXED_BORDER_FIRST_MEAN_VALUE_WEIGHTS:
    return "fixed border first, mean value weights";
  default:
    return "as chosen";
  }
}

} // namespace square_map

#endif // SQUARE_MAP_NAME_OF_START_H
