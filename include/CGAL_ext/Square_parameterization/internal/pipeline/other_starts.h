// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PIPELINE_OTHER_STARTS_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PIPELINE_OTHER_STARTS_H

#include <CGAL_ext/Square_parameterization/Balanced_minimization.h>
#include <CGAL_ext/Square_parameterization/Square_map_result.h>
#include <CGAL_ext/Square_parameterization/base_weights.h>
#include <CGAL_ext/Square_parameterization/internal/common/Deadline.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/make_minimizer.h>

#include <functional>
#include <memory>
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

/// the starts that are left when that of the options has failed, in the order in which they are tried. All are coarsened
/// in small steps: most maps that are lost in rounding are found so.
inline std::vector<Other_start> other_starts(const Patch& patch, const Balanced_minimization& chosen,
                                             const Deadline& deadline)
{
  const auto with_weights = [&patch, &deadline](Balanced_minimization minimization,
                                                const std::function<Edge_weights(const Patch&)>& weights) {
    minimization.start.weights = weights;
    return [&patch, minimization, deadline] {
      return make_minimizer(patch, minimization, deadline, Coarsening::BY_EIGHTHS);
    };
  };
  std::vector<Other_start> starts{{Map_start::GRADUAL_COARSENING, with_weights(chosen, chosen.start.weights)}};
  if(chosen.start.weights.target<Blended_weights>() == nullptr)
    starts.push_back({Map_start::BLENDED_WEIGHTS, with_weights(chosen, Blended_weights())});
  starts.push_back({Map_start::UNIFORM_WEIGHTS, with_weights(chosen, Uniform_weights())});
  starts.push_back({Map_start::MEAN_VALUE_WEIGHTS, with_weights(chosen, Mean_value_weights())});
  const bool can_slide = patch.border.size() > 4; // else all border vertices are corners, and stay
  if(chosen.border != Border_motion::FIXED && can_slide) {
    Balanced_minimization fixed = chosen;
    fixed.border = Border_motion::FIXED;
    starts.push_back({Map_start::FIXED_BORDER_FIRST, with_weights(fixed, fixed.start.weights)});
    starts.push_back({Map_start::FIXED_BORDER_FIRST_UNIFORM_WEIGHTS, with_weights(fixed, Uniform_weights())});
    starts.push_back({Map_start::FIXED_BORDER_FIRST_MEAN_VALUE_WEIGHTS, with_weights(fixed, Mean_value_weights())});
  }
  return starts;
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PIPELINE_OTHER_STARTS_H
