// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_SQUARE_MAP_OPTIONS_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_SQUARE_MAP_OPTIONS_H

#include <CGAL_ext/Square_parameterization/Bracketing_corner_search.h>
#include <CGAL_ext/Square_parameterization/Chords.h>
#include <CGAL_ext/Square_parameterization/Cut_options.h>
#include <CGAL_ext/Square_parameterization/Grid_size.h>
#include <CGAL_ext/Square_parameterization/Minimization.h>
#include <CGAL_ext/Square_parameterization/Square_search_options.h>
#include <CGAL_ext/Square_parameterization/corner_searches.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <optional>
#include <vector>

namespace CGAL_ext {

/// \ingroup PkgSquareParameterizationFunctions
///
/// what `parameterize_onto_square()` is to do with a mesh of any type. Every member has a default.
struct Square_map_settings
{
  /// chooses the corners: any model of `CornerSearch`
  Corner_search search = Bracketing_corner_search();
  Minimization minimization = Balanced_minimization(); ///< how each candidate is mapped
  Square_search_options search_options;                ///< corner rule, walk, threads, visitor and callback
  /// whether other starts are tried where that of the minimization leads to no map or to a poor one (`Map_start`).
  /// Without them the curve of a search is that of one start. The same for the shortest cut, where the best one leaves no
  /// good map (`Cut_report::is_replaced`).
  bool tries_other_starts = true;
  Chords chords = Chords::ALL; ///< which chords are split
  /// how the surface is cut to a disk. Cuts are judged with the balance of the minimization, where that has one, on as
  /// many threads as the search.
  Cut_options cut;

  /// a grid of samples that both sides of every seam are to have in common, so that a surface rebuilt from the samples
  /// closes there: the border of the best map is then moved along the square and fixed, and the map minimised again. No
  /// effect on a surface that needs no cut.
  std::optional<Grid_size> seam_grid;
  bool fits_seam_grid = false; ///< the grid is `Grid_size::fitted_to()` the rectangle that was minimised on
};

/// \ingroup PkgSquareParameterizationFunctions
///
/// what `parameterize_onto_square()` is to do. Every member has a default.
/// \tparam TriangleMesh_ the mesh
template <class TriangleMesh_>
struct Square_map_options : Square_map_settings
{
  typedef typename boost::graph_traits<TriangleMesh_>::vertex_descriptor vertex_descriptor;
  typedef typename boost::graph_traits<TriangleMesh_>::edge_descriptor edge_descriptor;

  /// edges to cut along in any case; what they lack to make the surface a disk is added. Border edges need no cut.
  std::vector<edge_descriptor> seams;

  /// four border vertices for (0, 0), (1, 0), (1, 1) and (0, 1), counter-clockwise; none: the corners are searched. A
  /// vertex that is cut stands for its copies, and may be given more than once, as the ends of a seam along a cylinder:
  /// of the copies in order those are taken that leave the longest shortest side.
  std::optional<std::array<vertex_descriptor, 4>> corners;
};

} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_SQUARE_MAP_OPTIONS_H
