// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SEARCH_SEARCH_WORK_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SEARCH_SEARCH_WORK_H

namespace CGAL_ext {
namespace internal {

/// sweeps over the mesh that maps and sketches may cost until a search makes no more of them: those of fifty candidates of
/// an even surface
constexpr double MOST_SEARCH_WORK = 1200;

/// sweeps over the mesh that a map or sketch may cost, in the mean, for corners to move: those of fifteen candidates of an
/// even surface. Maps that cost more are too far from their minima when they are compared to tell corners apart.
constexpr double MOST_WORK_TO_MOVE = 300;

/// what rough maps may cost, in vertices visited, until the corners stay where they are: on the square no more than half of
/// a search, or a third of a second. A rectangle is sought from several places, with all moves.
inline double most_moving_work(int number_of_vertices, bool is_square)
{
  constexpr int SMALL = 5000; // vertices
  return (is_square ? 0.5 : 5) * MOST_SEARCH_WORK * (number_of_vertices > SMALL ? number_of_vertices : SMALL);
}

} // namespace internal
} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SEARCH_SEARCH_WORK_H
