// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PIPELINE_OTHER_STARTS_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PIPELINE_OTHER_STARTS_H

#include <CGAL_ext/Square_parameterization/Balanced_minimization.h>
#include <CGAL_ext/Square_parameterization/Square_map_result.h>
#include <CGAL_ext/Square_parameterization/base_weights.h>
#include <CGAL_ext/Square_parameterization/internal/common/Deadline.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/make_minimizer.h>
#include <CGAL_ext/Square_parameterization/internal/search/search_work.h>

#include <functional>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// another way to begin, and the minimizer that does. What it finds is minimised to the end as that of the first start is.
struct Other_start
{
  Map_start start;
  std::function<std::shared_ptr<const Map_minimizer>()> make_minimizer;
};

/// weights of a first map, and the starts that begin with them
struct Other_weights
{
  std::function<Edge_weights(const Patch&)> weights;
  Map_start usual, gradual, fixed_first;
};

/// the weights that other starts try, in this order, but for those that were chosen: two or three
inline std::vector<Other_weights> other_weights(const Balanced_minimization& chosen)
{
  std::vector<Other_weights> others;
  const auto add = [&](const auto& weights, Map_start usual, Map_start gradual, Map_start fixed_first) {
    if(chosen.start.weights.target<std::decay_t<decltype(weights)>>() == nullptr)
      others.push_back({weights, usual, gradual, fixed_first});
  };
  add(Blended_weights(), Map_start::BLENDED_WEIGHTS, Map_start::GRADUAL_COARSENING_BLENDED_WEIGHTS,
      Map_start::FIXED_BORDER_FIRST_BLENDED_WEIGHTS);
  add(Uniform_weights(), Map_start::UNIFORM_WEIGHTS, Map_start::GRADUAL_COARSENING_UNIFORM_WEIGHTS,
      Map_start::FIXED_BORDER_FIRST_UNIFORM_WEIGHTS);
  add(Mean_value_weights(), Map_start::MEAN_VALUE_WEIGHTS, Map_start::GRADUAL_COARSENING_MEAN_VALUE_WEIGHTS,
      Map_start::FIXED_BORDER_FIRST_MEAN_VALUE_WEIGHTS);
  return others;
}

/// the starts that are left when that of the options has failed, in the order in which they are tried. Where they are cheap
/// other weights are the first, as they are seldom lost on the same surface; in small steps most maps are found that are
/// lost in rounding whatever the weights, and these take the place of the first where few starts can be tried. With a fixed
/// border, the last, halves are tried alone: most of what is left is lost in small steps either way.
inline std::vector<Other_start> other_starts(const Patch& patch, const Balanced_minimization& chosen,
                                             const Deadline& deadline)
{
  const std::vector<Other_weights> others = other_weights(chosen);
  std::vector<Other_start> starts;
  const auto add = [&](Map_start start, Balanced_minimization minimization,
                       const std::function<Edge_weights(const Patch&)>& weights, Coarsening coarsening) {
    minimization.start.weights = weights;
    starts.push_back({start, [&patch, minimization, deadline, coarsening] {
                        return make_minimizer(patch, minimization, deadline, coarsening);
                      }});
  };
  add(others.front().usual, chosen, others.front().weights, Coarsening::BY_HALVES);
  add(Map_start::GRADUAL_COARSENING, chosen, chosen.start.weights, Coarsening::BY_EIGHTHS);
  if(!has_cheap_starts(patch.number_of_vertices()))
    std::swap(starts[0], starts[1]);
  for(auto other = others.begin() + 1; other != others.end(); ++other)
    add(other->usual, chosen, other->weights, Coarsening::BY_HALVES);
  for(const Other_weights& other : others)
    add(other.gradual, chosen, other.weights, Coarsening::BY_EIGHTHS);
  const bool can_slide = patch.border.size() > 4; // else all border vertices are corners, and stay
  if(chosen.border != Border_motion::FIXED && can_slide) {
    Balanced_minimization fixed = chosen;
    fixed.border = Border_motion::FIXED;
    add(Map_start::FIXED_BORDER_FIRST, fixed, chosen.start.weights, Coarsening::BY_HALVES);
    for(const Other_weights& other : others)
      add(other.fixed_first, fixed, other.weights, Coarsening::BY_HALVES);
  }
  return starts;
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PIPELINE_OTHER_STARTS_H
