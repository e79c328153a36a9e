// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_STRETCH_OPTIMAL_PARAMETERIZER_3_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_STRETCH_OPTIMAL_PARAMETERIZER_3_H

#include <CGAL_ext/Square_parameterization/Balanced_minimization.h>
#include <CGAL_ext/Square_parameterization/Bracketing_square_border_parameterizer_3.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/make_minimizer.h>
#include <CGAL_ext/Square_parameterization/internal/plug_in/parameterize_with.h>

#include <CGAL/Default.h>

#include <utility>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {

/// \ingroup PkgSquareParameterizationParameterizers
///
/// computes a one-to-one map of a disk onto a convex planar domain that minimises the balanced energy of
/// `Balanced_minimization`: L2 stretch with a little of its inverse, which keeps the map from tearing open. The border
/// stays, or slides along the sides of the unit square.
///
/// The minimization starts from a map without flips and never leaves the maps without flips; the result is checked by
/// exact predicates: `OK` means one-to-one. It is a local minimum.
///
/// With a border parameterizer of this package that searches the corners, each candidate is mapped by this
/// parameterizer, the search minimises the balanced energy, and the best map found is the result. Any other border
/// parameterizer is taken as it is; when it mirrors the border, as CGAL's square borders do, the map is mirrored. A
/// border that is not the unit square does not slide.
///
/// `parameterize()` returns what `Stretch_minimizing_parameterizer_3` returns, and `ERROR_WRONG_PARAMETER` also when the
/// balance or a tolerance is out of range. Its visitor and its thread safety are those of that class, too.
///
/// Complexity: about linear but for two sparse Cholesky factorizations per four to eight steps, about \f$ V^{1.5} \f$
/// operations each; the sequence of coarser meshes and the symbolic analysis are made once.
///
/// \cgalModels `Parameterizer_3`
///
/// \tparam TriangleMesh_ must be a model of `FaceGraph`. Coordinates are read as `double`.
/// \tparam BorderParameterizer_ must be a model of `Parameterizer_3` with a convex border.
///         <b>%Default:</b> `Bracketing_square_border_parameterizer_3<TriangleMesh_>`
///
/// \sa `CGAL_ext::parameterize_onto_square()`
template <class TriangleMesh_, class BorderParameterizer_ = CGAL::Default>
class Stretch_optimal_parameterizer_3
{
public:
  typedef TriangleMesh_ Triangle_mesh;
  typedef TriangleMesh_ TriangleMesh;
  typedef
      typename CGAL::Default::Get<BorderParameterizer_, Bracketing_square_border_parameterizer_3<TriangleMesh_>>::type
          Border_parameterizer;
  typedef typename boost::graph_traits<Triangle_mesh>::vertex_descriptor vertex_descriptor;
  typedef typename boost::graph_traits<Triangle_mesh>::halfedge_descriptor halfedge_descriptor;
  typedef CGAL::Surface_mesh_parameterization::Error_code Error_code;

  /// constructs the parameterizer.
  /// \param border maps the border
  /// \param minimization the balance, whether the border slides, and when to stop
  explicit Stretch_optimal_parameterizer_3(Border_parameterizer border = Border_parameterizer(),
                                           Balanced_minimization minimization = {})
    : m_border(std::move(border)), m_minimization(std::move(minimization))
  {}

  /// maps the connected component of \p mesh at the border halfedge \p bhd; see
  /// `Stretch_minimizing_parameterizer_3::parameterize()`.
  template <class VertexUVmap, class VertexIndexMap, class VertexParameterizedMap>
  Error_code parameterize(Triangle_mesh& mesh, halfedge_descriptor bhd, VertexUVmap uvmap, VertexIndexMap vimap,
                          VertexParameterizedMap vpmap)
  {
    if(!m_minimization.is_valid())
      return CGAL::Surface_mesh_parameterization::ERROR_WRONG_PARAMETER;
    const auto make_minimizer = [this](const internal::Patch& patch, const internal::Deadline& deadline) {
      return internal::make_minimizer(patch, m_minimization, deadline);
    };
    return internal::parameterize_with(make_minimizer, m_border, mesh, bhd, uvmap, vimap, vpmap);
  }

private:
  Border_parameterizer m_border;
  Balanced_minimization m_minimization;
};

} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_STRETCH_OPTIMAL_PARAMETERIZER_3_H
