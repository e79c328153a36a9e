// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SEARCH_SEARCH_WORK_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SEARCH_SEARCH_WORK_H

#include <CGAL_ext/Square_parameterization/internal/common/Minimizer_numbers.h>

#include <algorithm>
#include <limits>

namespace CGAL_ext {
namespace internal {

/// sweeps over the mesh that maps and sketches may cost until a search makes no more of them: those of fifty candidates of
/// an even surface
constexpr double MOST_SEARCH_WORK = 1200;

/// the same by the size of the mesh: half as much on 5000 vertices or more; while there is no map, on 10000. More: strips,
/// and sheets with fins and nails, take up to half as long again, for the same corners. Less on smaller meshes: a knot is
/// stretched 1 % more, and surfaces with spikes by more than that; while there is no map: some have none in the end.
inline double most_search_work(int number_of_vertices, bool has_map)
{
  const double small = has_map ? 2500 : 5000; // vertices
  return MOST_SEARCH_WORK * (std::clamp)(small / number_of_vertices, 0.5, 1.);
}

/// sweeps over the mesh that the map of the first candidate, or one for corners that have moved, may cost for others to be
/// mapped, too, where no rough maps tell which one is best: surfaces of the usual kinds take up to 410, those that are nearly
/// all fins, nails or coils 470 to 890. Other corners lower the L2 of these by 1 % at most.
constexpr double MOST_WORK_OF_FIRST_MAP = 450;

/// vertices that such a sweep counts for, at least: maps of smaller meshes are soon made
constexpr int LEAST_VERTICES_OF_COSTLY_MAP = 2500;

/// sweeps over the mesh that the first sketch may cost for others to be made, too, when it is hopeless: those of polygons with
/// thousands of spikes cost 230 to 830, and all sketches of these are alike
constexpr double MOST_WORK_OF_HOPELESS_SKETCH = 200;

/// sweeps over the mesh that a map or sketch may cost, in the mean, for corners to move, or the one map that is made where rough
/// maps tell which candidate is best: those of fifteen candidates of an even surface. Rough maps do not count. Maps that cost
/// more are too far from their minima when they are compared to tell corners apart.
constexpr double MOST_WORK_TO_MOVE = 300;

/// vertices that a sweep over the mesh counts for, at most, where sketches are counted, which are as small on all large
/// meshes
constexpr int MOST_VERTICES_OF_SKETCH = 5000;

/// the same where maps are counted for a search: of larger meshes that have no sketches fewer slow maps are made
constexpr int MOST_VERTICES_OF_MAP = 10000;

/// what the maps of a search may cost, in vertices visited, until it makes no more of them while it has none
inline double most_work_of_search(int number_of_vertices)
{
  return most_search_work(number_of_vertices, false) * (std::min)(number_of_vertices, MOST_VERTICES_OF_MAP);
}

/// the same where they are those of several starts, beyond what starts may cost on any surface
constexpr double MOST_WORK_OF_STARTS = 800;

/// the same of small meshes: closed surfaces of a thousand faces are to take no more than a second
constexpr double MOST_WORK_OF_STARTS_OF_SMALL = 4000;

/// what the candidates of all starts may cost together, in vertices visited, until no more starts are tried for a better
/// map; and those of the longer search when none has led to a map
inline double most_work_of_starts(int number_of_vertices)
{
  return (std::min)(1e6 + MOST_WORK_OF_STARTS_OF_SMALL * number_of_vertices,
                    6e6 + MOST_WORK_OF_STARTS * (std::min)(number_of_vertices, MOST_VERTICES_OF_MAP));
}

/// times as much that they may cost with one start more, which costs about as much as each before. Less: surfaces are left
/// with a map stretched ten times as much as that of the next start; more: polygons with thousands of spikes take more
/// than two seconds, in vain.
constexpr double MOST_EXCESS_OF_STARTS = 1.4;

/// vertices of a mesh, at most, on which other starts cost little. Larger: polygons of 5000 corners take 2.7 s, half as long
/// again, in vain.
constexpr int MOST_VERTICES_OF_CHEAP_STARTS = 2500;

constexpr bool has_cheap_starts(int number_of_vertices)
{
  return number_of_vertices <= MOST_VERTICES_OF_CHEAP_STARTS;
}

/// other starts that are tried whatever they cost where they are cheap: with other weights, and in small steps. With one of them
/// alone some surfaces are left with a map that the other leads out of a stretch of thousands.
constexpr int least_other_starts(int number_of_vertices)
{
  return has_cheap_starts(number_of_vertices) ? 2 : 1;
}

/// energy of a map that is to be delivered above which other starts are tried
constexpr double least_poor_objective(int number_of_vertices)
{
  return has_cheap_starts(number_of_vertices) ? Minimizer_numbers::POOR_RESULT : Minimizer_numbers::HOPELESS_RESULT;
}

/// sweeps over a mesh of more than `MOST_VERTICES_OF_MAP` vertices that the candidates of the first start may cost for others
/// to be tried, too: those of polygons with thousands of spikes cost 700 to 1300, and to make such a mesh coarse in
/// small steps takes half a second before the first map
constexpr double MOST_WORK_OF_FIRST_START = 600;

/// what the candidates of the first start may cost, in vertices visited, for others to be tried when they have a map
inline double most_work_of_first_start(int number_of_vertices)
{
  return number_of_vertices <= MOST_VERTICES_OF_MAP ? std::numeric_limits<double>::infinity()
                                                    : MOST_WORK_OF_FIRST_START * number_of_vertices;
}

/// what rough maps may cost, and sketches, in vertices visited, until the corners stay where they are on the square. More: cones
/// with teeth, whose rough maps have thousands of vertices, take half as long again for the same corners. Less, as 2e6: a
/// cheese with holes is stretched 0.5 % more.
constexpr double MOST_MOVING_WORK = 2.5e6;

/// the same by the size of the mesh: on the square no more than half of a search, for which it counts for
/// `LEAST_VERTICES_OF_COSTLY_MAP` at least. Less for small meshes: of 180 surfaces of 150 vertices and more five get more than 1 %
/// more energy, one ten times as much. A rectangle is sought from several places, with all moves.
inline double most_moving_work(bool is_square, int number_of_vertices)
{
  if(is_square)
    return (std::min)(MOST_MOVING_WORK,
                      MOST_SEARCH_WORK / 2 * (std::max)(number_of_vertices, LEAST_VERTICES_OF_COSTLY_MAP));
  return 5 * MOST_SEARCH_WORK * MOST_VERTICES_OF_SKETCH;
}

/// vertices of a disk that a cut leaves of a surface of a thousand faces, at most, as a rule
constexpr int MOST_VERTICES_OF_SMALL_DISK = 1000;

/// the same for one of several cuts that are judged. More for small disks: the cut of a surface of a thousand faces takes two
/// tenths of a second more. Less for larger ones: the cut for one weight is beaten by that for another.
inline double most_judging_work(bool is_square, int number_of_vertices)
{
  const double work = most_moving_work(is_square, MOST_VERTICES_OF_SKETCH);
  return number_of_vertices <= MOST_VERTICES_OF_SMALL_DISK ? work / 6 : work;
}

} // namespace internal
} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SEARCH_SEARCH_WORK_H
