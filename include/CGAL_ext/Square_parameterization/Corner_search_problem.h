// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_CORNER_SEARCH_PROBLEM_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_CORNER_SEARCH_PROBLEM_H

#include <array>
#include <functional>
#include <vector>

namespace CGAL_ext {

/// \ingroup PkgSquareParameterizationSearches
///
/// the only view that a search strategy has of its problem. Candidates are 0, 1, ..., `number_of_candidates` - 1 and
/// form a ring: the last and the first are neighbors.
///
/// Its functions are to be called by one thread at a time, and not after the strategy has ended; they use all threads
/// of the search themselves. They throw when they are asked for a candidate that is not one of these, and when the
/// search is cancelled: a strategy lets both through (see `CornerSearch`).
struct Corner_search_problem
{
  int number_of_candidates = 0; ///< at least 1

  /// maps the given candidates, concurrently, and returns their objectives in the same order; infinite for a candidate
  /// without a one-to-one map. A candidate asked for twice is mapped once. An empty batch is answered by an empty one.
  /// What the objective is, L2 stretch or balanced energy, is the minimizer's affair: it is positive and dimensionless,
  /// and the less the better.
  std::function<std::vector<double>(const std::vector<int>&)> objective_of;

  /// as `objective_of`, but each map starts from its rough map, if it has one, or from that of the nearest candidate evaluated
  /// by an earlier call, where the minimizer can: neighbors then end in the same local minimum. The objective of a candidate may depend, a little, on
  /// the calls before; not on the number of threads. May be empty.
  std::function<std::vector<double>(const std::vector<int>&)> objective_from_neighbors;

  /// the objective of the given candidates on a coarser mesh, concurrently: a fraction of the cost, comparable among such
  /// values only, and lowest near the candidate whose `objective_of` is lowest. Empty when the mesh has fewer than 7000
  /// vertices, and when the minimizer has no coarser meshes.
  std::function<std::vector<double>(const std::vector<int>&)> sketched_objective_of;

  /// the same on a mesh of a few hundred vertices, at most a quarter of those of the whole one: a small fraction of the cost, to
  /// choose the candidate from which the corners move. Empty unless they do (`is_refined_by_moves`), where there are sketches,
  /// and for meshes of 2000 vertices or fewer.
  std::function<std::vector<double>(const std::vector<int>&)> rough_objective_of;

  /// names the candidate that a strategy settles for by sketches alone. It is mapped after the search, with its own
  /// corners or with those to which they move; when it has no map, the strategy is asked again, without sketches. Empty
  /// where there are none.
  std::function<void(int)> settle_for;

  /// maps for choices of four corners of their own, concurrently, and returns their objectives: positions in the border
  /// loop of the vertices at (0,0), (1,0), (1,1), (0,1), distinct and in counter-clockwise order. The best of them is
  /// delivered when no candidate is as good.
  std::function<std::vector<double>(const std::vector<std::array<int, 4>>&)> objective_of_corners;

  /// the same on a coarse mesh of a few hundred vertices: a small fraction of the cost, comparable among such values
  /// only. Empty when the minimizer has no coarser meshes.
  std::function<std::vector<double>(const std::vector<std::array<int, 4>>&)> rough_objective_of_corners;

  std::vector<double> border_lengths; ///< one per border edge: edge k joins vertices k and k + 1 of the loop

  /// what all maps, sketches and rough maps of candidates so far have cost, in sweeps over the mesh: an even surface takes about twenty for an
  /// evaluation, one that is stretched tens of times hundreds. It does not depend on the number of threads nor on the speed
  /// of the machine; less is told of a search that is repeated since it found no map. Empty when the minimizer does not
  /// tell.
  std::function<double()> work;

  int number_of_vertices = 1; ///< of the mesh that is mapped
  int number_of_faces = 1;    ///< of the mesh that is mapped

  /// maps the mesh onto a circle and returns the L2 stretch of the border vertices there (dimensionless), one value per
  /// border vertex; empty when that map could not be computed. Costs about as much as an evaluation.
  std::function<std::vector<double>()> circle_stretch;

  /// the distance of every border vertex from the nearest corner if the given candidate were mapped, in half sides: 0
  /// at a corner, 1 in the middle of a side. Nothing is mapped: linear in the number of border vertices.
  std::function<std::vector<double>(int)> corner_distances;

  /// indicates whether the corners are to move from those of the best candidate when the search has ended, by maps that tell
  /// near corners apart: a strategy need not tell the best candidate from its neighbors. Where maps prove slow or hopeless
  /// the corners stay all the same.
  bool is_refined_by_moves = false;
};

/// \ingroup PkgSquareParameterizationSearches
///
/// which candidates a strategy chooses from
enum class Candidate_set
{
  FULL,   ///< every border vertex
  QUARTER ///< the border vertices nearer than a quarter of the border length to its start: rotating the square by a
          ///< right angle makes the others nearly equivalent
};

} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_CORNER_SEARCH_PROBLEM_H
