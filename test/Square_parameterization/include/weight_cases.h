// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_WEIGHT_CASES_H
#define CGAL_EXT_WEIGHT_CASES_H

#include <CGAL_ext/Square_parameterization/base_weights.h>

#include <functional>
#include <string>
#include <vector>

/// base weights and what is known of them
struct Weight_case
{
  std::string name;
  std::function<CGAL_ext::internal::Edge_weights(const CGAL_ext::internal::Patch&)> weights;
  bool is_positive;
  bool has_linear_precision; ///< a planar mesh with its own border is mapped to itself
};

inline std::vector<Weight_case> all_weights()
{
  using namespace CGAL_ext;
  typedef Shape_preserving_weights::Average Average;
  return {{"uniform", Uniform_weights(), true, false},
          {"clamped cotangent", Clamped_cotangent_weights(), true, false},
          {"blended", Blended_weights(), true, false},
          {"harmonic", Harmonic_weights(), false, true},
          {"mean value", Mean_value_weights(), true, true},
          {"symmetric mean value", Symmetric_mean_value_weights(), true, false},
          {"shape-preserving, plain", Shape_preserving_weights(Average::PLAIN), true, true},
          {"shape-preserving, inverse distance", Shape_preserving_weights(Average::INVERSE_DISTANCE), true, true}};
}

inline std::vector<Weight_case> weights_with_linear_precision()
{
  std::vector<Weight_case> selected;
  for(const Weight_case& weight_case : all_weights())
    if(weight_case.has_linear_precision)
      selected.push_back(weight_case);
  return selected;
}

#endif // CGAL_EXT_WEIGHT_CASES_H
