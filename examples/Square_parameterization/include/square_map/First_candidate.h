// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_FIRST_CANDIDATE_H
#define SQUARE_MAP_FIRST_CANDIDATE_H

#include "write_map.h"

#include <CGAL_ext/Square_parameterization/Stretch_measures.h>
#include <CGAL_ext/Square_parameterization/internal/patch/write_uv.h>

#include <string>
#include <vector>

namespace square_map {

/// the map of the first candidate, for those who look at the best one beside it
struct First_candidate
{
  std::string reason;                      ///< why there is no such map, a sentence; empty when there is one
  std::vector<Mesh::Vertex_index> corners; ///< of the cut mesh
  CGAL_ext::internal::Uv_coordinates uv;   ///< #V of the cut mesh by 2
  double aspect = 1;                       ///< of the rectangle that the unit square stands for
  CGAL_ext::Stretch_measures measures;
};

} // namespace square_map

#endif // SQUARE_MAP_FIRST_CANDIDATE_H
