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

/// makes minimizers of one patch that share its coarser copies, and differ in the weights of first maps
class Minimizers_by_weights
{
public:
  /// \param other one of them that there is already, made of this patch with all that follows but for the weights; null to
  ///        make the first when it is asked for
  Minimizers_by_weights(const Patch& patch, Balanced_minimization minimization, const Deadline& deadline,
                        Coarsening coarsening, const Map_minimizer* other)
    : m_patch(patch),
      m_minimization(std::move(minimization)),
      m_deadline(deadline),
      m_coarsening(coarsening),
      m_other(other)
  {}

  std::shared_ptr<const Map_minimizer> operator()(const std::function<Edge_weights(const Patch&)>& weights)
  {
    m_minimization.start.weights = weights;
    if(m_other != nullptr)
      return m_other->with_first_maps(m_minimization.start);
    m_first = make_minimizer(m_patch, m_minimization, m_deadline, m_coarsening);
    m_other = m_first.get();
    return m_first;
  }

private:
  const Patch& m_patch;
  Balanced_minimization m_minimization;
  const Deadline m_deadline;
  const Coarsening m_coarsening;
  std::shared_ptr<const Map_minimizer> m_first;
  const Map_minimizer* m_other;
};

/// the starts that are left when that of the options has failed, in the order in which they are tried. Where they are cheap
/// other weights are the first, as they are seldom lost on the same surface; in small steps most maps are found that are
/// lost in rounding whatever the weights, and these take the place of the first where few starts can be tried. With a fixed
/// border, the last, halves are tried alone: most of what is left is lost in small steps either way.
/// \param first the minimizer of the start of the options, made of the patch with `chosen` and `deadline`, which must live as
///        long; null to make its coarse patches again
inline std::vector<Other_start> other_starts(const Patch& patch, const Balanced_minimization& chosen,
                                             const Deadline& deadline, const Map_minimizer* first = nullptr)
{
  const std::vector<Other_weights> others = other_weights(chosen);
  const auto minimizers = [&](const Balanced_minimization& minimization, Coarsening coarsening,
                              const Map_minimizer* other) {
    return std::make_shared<Minimizers_by_weights>(patch, minimization, deadline, coarsening, other);
  };
  std::vector<Other_start> starts;
  const auto add = [&](Map_start start, const std::shared_ptr<Minimizers_by_weights>& of,
                       const std::function<Edge_weights(const Patch&)>& weights) {
    starts.push_back({start, [of, weights] { return (*of)(weights); }});
  };
  const auto by_halves = minimizers(chosen, Coarsening::BY_HALVES, first);
  const auto by_eighths = minimizers(chosen, Coarsening::BY_EIGHTHS, nullptr);
  add(others.front().usual, by_halves, others.front().weights);
  add(Map_start::GRADUAL_COARSENING, by_eighths, chosen.start.weights);
  if(!has_cheap_starts(patch.number_of_vertices()))
    std::swap(starts[0], starts[1]);
  for(auto other = others.begin() + 1; other != others.end(); ++other)
    add(other->usual, by_halves, other->weights);
  for(const Other_weights& other : others)
    add(other.gradual, by_eighths, other.weights);
  const bool can_slide = patch.border.size() > 4; // else all border vertices are corners, and stay
  if(chosen.border != Border_motion::FIXED && can_slide) {
    Balanced_minimization fixed = chosen;
    fixed.border = Border_motion::FIXED;
    const auto with_fixed_border = minimizers(fixed, Coarsening::BY_HALVES, nullptr);
    add(Map_start::FIXED_BORDER_FIRST, with_fixed_border, chosen.start.weights);
    for(const Other_weights& other : others)
      add(other.fixed_first, with_fixed_border, other.weights);
  }
  return starts;
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PIPELINE_OTHER_STARTS_H
