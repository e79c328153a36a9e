// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_BASE_WEIGHTS_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_BASE_WEIGHTS_H

#include <CGAL_ext/Square_parameterization/base_weight_types.h>
#include <CGAL_ext/Square_parameterization/internal/iteration/edge_weights.h>

#include <CGAL/assertions.h>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {

/// \ingroup PkgSquareParameterizationWeights
///
/// gives every edge the weight 1 (Tutte \cgalCite{t-hdg-63}). Symmetric and positive: one-to-one whatever the mesh.
/// \cgalModels `BaseWeights`
struct Uniform_weights
{
  Edge_weights operator()(const Patch& patch) const { return Edge_weights(patch, 1, true); }
};

/// \ingroup PkgSquareParameterizationWeights
///
/// gives every edge half the sum of the cotangents of its two opposite angles, but at least a least weight.
/// Symmetric and positive: one-to-one whatever the mesh, and harmonic where the mesh is intrinsically Delaunay.
/// \cgalModels `BaseWeights`
class Clamped_cotangent_weights
{
public:
  /// \param least_weight positive, dimensionless (an equilateral mesh has weights 0.577)
  /// \pre `least_weight` is positive and finite
  explicit Clamped_cotangent_weights(double least_weight = 0.01) : m_least_weight(least_weight)
  {
    CGAL_precondition(least_weight > 0 && std::isfinite(least_weight));
  }

  Edge_weights operator()(const Patch& patch) const
  {
    Edge_weights weights = internal::cotangent_weights(patch);
    for(auto& pair : weights.values)
      pair = {(std::max)(pair[0], m_least_weight), (std::max)(pair[1], m_least_weight)};
    return weights;
  }

private:
  double m_least_weight;
};

/// \ingroup PkgSquareParameterizationWeights
///
/// gives every edge a blend of its cotangent weight, or 0 where that is negative, and of the geometric mean of the two
/// mean value coordinates of its ends. Cotangents alone see nothing of an edge between two right angles; the share of
/// mean value coordinates makes every weight positive and replaces the arbitrary least weight of a clamp.
/// Symmetric and positive: one-to-one whatever the mesh.
/// \cgalModels `BaseWeights`
class Blended_weights
{
public:
  /// \param mean_value_share share of the mean value coordinates, in ]0, 1], dimensionless
  /// \pre `mean_value_share` is in ]0, 1]
  explicit Blended_weights(double mean_value_share = 0.2) : m_mean_value_share(mean_value_share)
  {
    CGAL_precondition(mean_value_share > 0 && mean_value_share <= 1);
  }

  Edge_weights operator()(const Patch& patch) const
  {
    Edge_weights weights = internal::cotangent_weights(patch);
    const Edge_weights mean_value = internal::mean_value_weights(patch);
    // mean value coordinates have the unit 1 / length, and only their proportions at a vertex matter: at each vertex
    // they are scaled to the sum of the cotangent weights
    std::vector<double> cotangent_sum(patch.points.size(), 0.), mean_value_sum(patch.points.size(), 0.);
    for(std::size_t e = 0; e < patch.edges.size(); ++e)
      for(int end = 0; end < 2; ++end) {
        cotangent_sum[patch.edges[e][end]] += (std::max)(0., weights.values[e][0]);
        mean_value_sum[patch.edges[e][end]] += mean_value.values[e][end];
      }
    for(std::size_t e = 0; e < patch.edges.size(); ++e) {
      double product = 1;
      for(int end = 0; end < 2; ++end) {
        const int v = patch.edges[e][end];
        product *= mean_value.values[e][end] * cotangent_sum[v] / mean_value_sum[v];
      }
      const double blend =
          (1 - m_mean_value_share) * (std::max)(0., weights.values[e][0]) + m_mean_value_share * std::sqrt(product);
      weights.values[e] = {blend, blend};
    }
    return weights;
  }

private:
  double m_mean_value_share;
};

/// \ingroup PkgSquareParameterizationWeights
///
/// gives every edge half the sum of the cotangents of its two opposite angles (Eck et
/// al.\ \cgalCite{cgal:eddhls-maam-95}). Symmetric, but negative where the mesh is not Delaunay: a one-to-one map is
/// *not* guaranteed.
/// \cgalModels `BaseWeights`
struct Harmonic_weights
{
  Edge_weights operator()(const Patch& patch) const { return internal::cotangent_weights(patch); }
};

/// \ingroup PkgSquareParameterizationWeights
///
/// gives the mean value coordinates of Floater \cgalCite{cgal:f-mvc-03}. Positive, not symmetric: one-to-one whatever
/// the mesh.
/// \cgalModels `BaseWeights`
struct Mean_value_weights
{
  Edge_weights operator()(const Patch& patch) const { return internal::mean_value_weights(patch); }
};

/// \ingroup PkgSquareParameterizationWeights
///
/// gives every edge the mean of the two mean value coordinates of its ends. Symmetric and positive: one-to-one whatever
/// the mesh.
/// \cgalModels `BaseWeights`
struct Symmetric_mean_value_weights
{
  Edge_weights operator()(const Patch& patch) const
  {
    Edge_weights weights = internal::mean_value_weights(patch);
    for(auto& pair : weights.values)
      pair[0] = pair[1] = (pair[0] + pair[1]) / 2;
    weights.is_symmetric = true;
    return weights;
  }
};

/// \ingroup PkgSquareParameterizationWeights
///
/// gives the shape-preserving weights of Floater \cgalCite{f-pssts-97}, in one of two averages. Positive, not
/// symmetric: one-to-one whatever the mesh.
/// \cgalModels `BaseWeights`
class Shape_preserving_weights
{
public:
  /// how the barycentric coordinates found for the neighbors of a vertex are averaged
  enum class Average
  {
    PLAIN,           ///< each neighbor counts alike, as in Floater's paper
    INVERSE_DISTANCE ///< weighted by the squared inverse distance to the opposite ring edge: the published tables
  };

  explicit Shape_preserving_weights(Average average = Average::INVERSE_DISTANCE) : m_average(average) {}

  Edge_weights operator()(const Patch& patch) const
  {
    return internal::shape_preserving_weights(patch, m_average == Average::PLAIN ? 0 : 2);
  }

private:
  Average m_average;
};

} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_BASE_WEIGHTS_H
