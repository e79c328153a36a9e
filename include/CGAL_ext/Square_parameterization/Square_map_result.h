// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_SQUARE_MAP_RESULT_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_SQUARE_MAP_RESULT_H

#include <CGAL_ext/Square_parameterization/Cut_report.h>
#include <CGAL_ext/Square_parameterization/Grid_size.h>
#include <CGAL_ext/Square_parameterization/Minimization_report.h>
#include <CGAL_ext/Square_parameterization/Search_report.h>
#include <CGAL_ext/Square_parameterization/Stretch_measures.h>

#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL_ext {

/// \ingroup PkgSquareParameterizationResults
///
/// what the minimization of the balanced energy began with. Where the start of the options leads to no map, or to one
/// with an L2 stretch of some hundred, or thousand where the mesh has more than 2500 vertices, which is a start lost in
/// rounding more often than the surface, the others are tried, first `GRADUAL_COARSENING` and one with other weights, then
/// the others in this order, until one does better than that or, when there is a map, until they have cost too much, or one
/// leads to the energy of the best; the best map is delivered. Weights that are those of the options are not tried again.
/// Gradual coarsening takes an eighth of the vertices at a time away instead of half of them.
enum class Map_start
{
  AS_CHOSEN,                             ///< that of the options
  BLENDED_WEIGHTS,                       ///< a first map by `Blended_weights`
  UNIFORM_WEIGHTS,                       ///< a first map by `Uniform_weights`
  MEAN_VALUE_WEIGHTS,                    ///< a first map by `Mean_value_weights`
  GRADUAL_COARSENING,                    ///< that of the options, but in small steps
  GRADUAL_COARSENING_BLENDED_WEIGHTS,    ///< the same with a first map by `Blended_weights`
  GRADUAL_COARSENING_UNIFORM_WEIGHTS,    ///< the same with a first map by `Uniform_weights`
  GRADUAL_COARSENING_MEAN_VALUE_WEIGHTS, ///< the same with a first map by `Mean_value_weights`
  FIXED_BORDER_FIRST,                    ///< minimised with a fixed border, and only then with a sliding one
  FIXED_BORDER_FIRST_BLENDED_WEIGHTS,    ///< the same with a first map by `Blended_weights`
  FIXED_BORDER_FIRST_UNIFORM_WEIGHTS,    ///< the same with a first map by `Uniform_weights`
  FIXED_BORDER_FIRST_MEAN_VALUE_WEIGHTS  ///< the same with a first map by `Mean_value_weights`
};

/// \ingroup PkgSquareParameterizationResults
///
/// what `parameterize_onto_square()` did to a mesh of any type
struct Square_map_report
{
  /// `OK`, or why there is no map
  CGAL::Surface_mesh_parameterization::Error_code status = CGAL::Surface_mesh_parameterization::OK;
  std::string message;             ///< one sentence that names the condition and the place; empty on `OK`
  std::optional<int> wrong_corner; ///< of given corners the first, 0 to 3, that is not on the border
  /// of given corners that are distinct, but not counter-clockwise: their numbers, 0 to 3, in an order that is
  std::optional<std::array<int, 4>> counter_clockwise_corners;
  Cut_report cut;                         ///< without seams for a disk that stays whole
  std::size_t border_edges_split = 0;     ///< one when the border had three edges: a square needs four
  std::size_t chords_split = 0;           ///< number of edges that were split at their midpoint
  Search_report search;                   ///< candidates, evaluations and the curve of the objective
  Map_start start = Map_start::AS_CHOSEN; ///< what the delivered map began with; the searches are those from there
  Minimization_report minimization;       ///< iterations of the delivered map
  Stretch_measures measures;              ///< of the delivered map, on its rectangle
  double aspect = 1;            ///< width over height of the rectangle, of area 1, that the unit square stands for
  std::size_t border_edges = 0; ///< number of edges of the border
  /// with `Square_map_settings::seam_grid`, of a surface that was cut: the grid that the seams were to share
  std::optional<Grid_size> seam_grid;
  /// with a grid for the seams: pairs of samples of the border that are the same point of the surface,
  /// counted counter-clockwise from (0, 0). Empty when there is no seam, and when `seam_message` tells why they cannot be
  /// the same: then the map is as if there were no grid.
  std::vector<std::array<int, 2>> seam_samples;
  /// why the two sides of the seams have not the same samples, although that was asked for: half a sentence, for example
  /// that the grid has too few; else empty
  std::string seam_message;
  /// number of faces lower than 1e-8 sqrt(area) over their longest side. They are mapped as if they were as high as
  /// 1e-4 sqrt(area); the measures take them as they are.
  std::size_t degenerate_faces = 0;
  double cut_seconds = 0;       ///< reading the mesh and deciding on the cut
  double condition_seconds = 0; ///< opening the cut, splitting chords and the first factorization
  double search_seconds = 0;    ///< mapping all candidates
};

/// \ingroup PkgSquareParameterizationResults
///
/// what `parameterize_onto_square()` did. Unless the status is `OK` the mesh is as it was, and what the report counts
/// was not done to it.
template <class TriangleMesh_>
struct Square_map_result : Square_map_report
{
  typedef typename boost::graph_traits<TriangleMesh_>::vertex_descriptor vertex_descriptor;

  /// the vertices that the cut added, each with the vertex that it is a copy of
  std::vector<std::pair<vertex_descriptor, vertex_descriptor>> copies;
  std::vector<vertex_descriptor> corners; ///< the vertices at (0, 0), (1, 0), (1, 1) and (0, 1)
};

} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_SQUARE_MAP_RESULT_H
