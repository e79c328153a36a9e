// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_WEIGHTS_OF_FAMILY_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_WEIGHTS_OF_FAMILY_H

#include <cmath>
#include <vector>

namespace CGAL_ext {
namespace internal {

/// see `weights_of_family()`
constexpr double HEAVIEST_OF_FAMILY = 0.2;
constexpr int FAMILY_WEIGHTS = 5; // each half of the one before
constexpr double MIDDLE_OF_FAMILY = HEAVIEST_OF_FAMILY / 4;

/// indicates whether a weight lies outside those of the family
inline bool is_outside_family(double weight)
{
  return weight > HEAVIEST_OF_FAMILY || weight < std::ldexp(HEAVIEST_OF_FAMILY, 1 - FAMILY_WEIGHTS);
}

/// the weights at which cuts are grown, the heaviest first: always the same, so that what is found does not depend on
/// the weight wanted; and that, where it lies outside
inline std::vector<double> weights_of_family(double wanted)
{
  std::vector<double> weights;
  for(int i = 0; i < FAMILY_WEIGHTS; ++i)
    weights.push_back(std::ldexp(HEAVIEST_OF_FAMILY, -i));
  if(wanted > weights.front())
    weights.insert(weights.begin(), wanted);
  if(wanted < weights.back())
    weights.push_back(wanted);
  return weights;
}

} // namespace internal
} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_WEIGHTS_OF_FAMILY_H
