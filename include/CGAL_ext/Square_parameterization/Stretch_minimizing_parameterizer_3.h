// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_STRETCH_MINIMIZING_PARAMETERIZER_3_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_STRETCH_MINIMIZING_PARAMETERIZER_3_H

#include <CGAL_ext/Square_parameterization/Hybrid_square_border_parameterizer_3.h>
#include <CGAL_ext/Square_parameterization/internal/iteration/Cgal_linear_solver.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/make_iteration_minimizer.h>
#include <CGAL_ext/Square_parameterization/internal/plug_in/parameterize_with.h>

#include <CGAL/Default.h>

#include <memory>
#include <optional>
#include <type_traits>
#include <utility>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {

/// \ingroup PkgSquareParameterizationParameterizers
///
/// computes a one-to-one map of a disk onto a convex planar domain that has little L2 stretch, by the iteration of
/// Yoshizawa, Belyaev and Seidel \cgalCite{yoshizawa2004fast}.
///
/// The interior is first mapped by convex combinations with the base weights; then, again and again, the stretch
/// \f$ \sigma_j \f$ of every vertex is measured (Sander et al. \cgalCite{cgal:ssgh-tmpm-01}), the weight of every
/// neighbor \f$ j \f$ is divided by \f$ \sigma_j^\eta \f$, and the system is solved anew. The iterate of least stretch
/// is kept. It deviates from the paper in its defaults: `eta` is 0.3, not 1, after first exponents of 0.7, 0.49 and
/// 0.343, and one iterate may fail to be lower. These defaults, and the blended weights, were chosen by measurement;
/// the manual has the table.
///
/// With positive base weights the map is one-to-one, unless an interior edge has both ends on one side of the square
/// (`split_chords()` removes these); with `Harmonic_weights` a one-to-one map is *not* guaranteed. The result is
/// checked by exact predicates in any case: `OK` means one-to-one.
///
/// With a border parameterizer of this package that searches the corners, each candidate is mapped by this
/// parameterizer, and the best map found is the result. A border parameterizer of CGAL is taken as it is; when it
/// mirrors the border, as CGAL's square borders do, the map is mirrored.
///
/// `parameterize()` returns `OK`, an error of the border parameterizer, `ERROR_NON_CONVEX_BORDER`,
/// `ERROR_CANNOT_SOLVE_LINEAR_SYSTEM` (with a border that does not search), `ERROR_NO_1_TO_1_MAPPING` (also when no
/// face has an area), `ERROR_BORDER_TOO_SHORT` for fewer than four border vertices,
/// `ERROR_NON_TRIANGULAR_MESH` or `ERROR_NO_TOPOLOGICAL_DISC` when the connected component at the border halfedge is
/// not a triangulated disk, or `ERROR_WRONG_PARAMETER` when a coordinate is not finite, when `eta` or a number of the
/// search is out of range, when the base weights do not fit the disk, or when the search asks for a candidate that does
/// not exist, or for none. The uv map is written only on `OK`, but for border vertices when the border parameterizer
/// does not search.
///
/// The course of the search and of the minimization is told to the visitor of the border parameterizer's
/// `Square_search_options`. A border that does not search has no visitor: `measure_stretch()` measures the map.
///
/// Thread safety: copies of one object may map at the same time, also different components of one mesh, if border,
/// weights and visitor may be used so, and the property maps may be written so.
///
/// Complexity: per iteration a sparse Cholesky factorization (LU for weights that are not symmetric), about
/// \f$ V^{1.5} \f$ operations; the symbolic analysis is done once.
///
/// \cgalModels `Parameterizer_3`
///
/// \tparam TriangleMesh_ must be a model of `FaceGraph`. Coordinates are read as `double`.
/// \tparam BorderParameterizer_ must be a model of `Parameterizer_3` with a convex border.
///         <b>%Default:</b> `Hybrid_square_border_parameterizer_3<TriangleMesh_>`
/// \tparam BaseWeights_ must be a model of `BaseWeights`. <b>%Default:</b> `Blended_weights`
/// \tparam SolverTraits_ must be a model of `SparseLinearAlgebraTraits_d`; a solver for symmetric matrices needs
///         symmetric weights. <b>%Default:</b> a direct solver that suits the weights and keeps its symbolic analysis
///
/// \sa `CGAL_ext::parameterize_onto_square()`
template <class TriangleMesh_, class BorderParameterizer_ = CGAL::Default, class BaseWeights_ = CGAL::Default,
          class SolverTraits_ = CGAL::Default>
class Stretch_minimizing_parameterizer_3
{
public:
  typedef TriangleMesh_ Triangle_mesh;
  typedef TriangleMesh_ TriangleMesh;
  typedef typename CGAL::Default::Get<BorderParameterizer_, Hybrid_square_border_parameterizer_3<TriangleMesh_>>::type
      Border_parameterizer;
  typedef typename CGAL::Default::Get<BaseWeights_, Blended_weights>::type Base_weights;
  typedef SolverTraits_ Solver_traits;
  typedef typename boost::graph_traits<Triangle_mesh>::vertex_descriptor vertex_descriptor;
  typedef typename boost::graph_traits<Triangle_mesh>::halfedge_descriptor halfedge_descriptor;
  typedef CGAL::Surface_mesh_parameterization::Error_code Error_code;

  /// constructs the parameterizer.
  /// \param border maps the border
  /// \param weights the weights of the first system
  /// \param eta exponent of the stretch by which weights are divided; dimensionless, in ]0, 1], 1 is the paper's
  /// \param patience number of iterates in a row that may fail to be lower before the iteration stops; 0 is the paper's
  /// \param maximum_iterations largest number of linear systems solved after the first
  /// \param sparse_la solves the linear systems; none: each system has a solver of its own. One that is given serves
  ///        one thread at a time, since its copies may share their state, as those of `CGAL::Eigen_solver_traits` do:
  ///        it makes a search on several threads slower. One that is parallel itself, by TBB, is not to be given to
  ///        parameterizers that run in tasks of TBB: a task that waits for it may be followed by another that wants it.
  explicit Stretch_minimizing_parameterizer_3(Border_parameterizer border = Border_parameterizer(),
                                              Base_weights weights = Base_weights(), double eta = 0.3,
                                              unsigned int patience = 1, unsigned int maximum_iterations = 100,
                                              std::optional<Solver_traits> sparse_la = std::nullopt)
    : m_border(std::move(border)), m_minimization{std::move(weights), eta, patience, maximum_iterations}
  {
    if(sparse_la)
      m_solver = std::make_shared<internal::Given_solver<Solver_traits>>(std::move(*sparse_la));
  }

  /// maps the connected component of \p mesh at the border halfedge \p bhd.
  ///
  /// \tparam VertexUVmap must be a model of `ReadWritePropertyMap` with `vertex_descriptor` as key type and a 2D point
  ///         as value type.
  /// \tparam VertexIndexMap must be a model of `ReadablePropertyMap` with `vertex_descriptor` as key type and a unique
  ///         integer as value type.
  /// \tparam VertexParameterizedMap must be a model of `ReadWritePropertyMap` with `vertex_descriptor` as key type and
  ///         a Boolean as value type.
  template <class VertexUVmap, class VertexIndexMap, class VertexParameterizedMap>
  Error_code parameterize(Triangle_mesh& mesh, halfedge_descriptor bhd, VertexUVmap uvmap, VertexIndexMap vimap,
                          VertexParameterizedMap vpmap)
  {
    if(!m_minimization.is_valid())
      return CGAL::Surface_mesh_parameterization::ERROR_WRONG_PARAMETER;
    const auto make_minimizer = [this](const internal::Patch& patch, const internal::Deadline& deadline) {
      return internal::make_minimizer(patch, m_minimization, deadline, solver_factory());
    };
    return internal::parameterize_with(make_minimizer, m_border, mesh, bhd, uvmap, vimap, vpmap);
  }

private:
  internal::Linear_solver_factory solver_factory() const
  {
    if constexpr(std::is_same_v<SolverTraits_, CGAL::Default>)
      return internal::make_direct_solver;
    else
      return [given = m_solver](bool is_symmetric) -> std::unique_ptr<internal::Linear_solver> {
        return std::make_unique<internal::Cgal_linear_solver<Solver_traits>>(is_symmetric, given);
      };
  }

  Border_parameterizer m_border;
  Stretch_minimization m_minimization;
  std::shared_ptr<internal::Given_solver<Solver_traits>> m_solver; // of all copies of this; null: one per system
};

} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_STRETCH_MINIMIZING_PARAMETERIZER_3_H
