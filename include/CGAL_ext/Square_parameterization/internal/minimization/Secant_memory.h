// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_SECANT_MEMORY_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_SECANT_MEMORY_H

#include <CGAL_ext/Square_parameterization/internal/common/Minimizer_numbers.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/rows_by_ranges.h>
#include <CGAL_ext/Square_parameterization/internal/patch/Patch.h>

#include <cmath>
#include <cstddef>
#include <deque>
#include <utility>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// the last few steps of a minimization and what they did to the gradient: the memory of L-BFGS (Nocedal and Wright,
/// Numerical Optimization, algorithm 7.4), with any preconditioner as the initial inverse Hessian
class Secant_memory
{
public:
  explicit Secant_memory(std::size_t capacity) : m_capacity(capacity) {}

  bool is_empty() const { return m_pairs.empty(); }
  void clear() { m_pairs.clear(); }

  /// remembers a step and the change of the gradient, unless the curvature along the step is not positive
  void add(const Uv_coordinates& step, const Uv_coordinates& gradient_change)
  {
    const double curvature = dot(step, gradient_change);
    if(!(curvature > Minimizer_numbers::LEAST_CURVATURE_COSINE * std::sqrt(dot(step, step)) *
                         std::sqrt(dot(gradient_change, gradient_change))))
      return;
    if(m_pairs.size() == m_capacity) { // the oldest gives its memory to the newest
      m_pairs.push_back(std::move(m_pairs.front()));
      m_pairs.pop_front();
    } else
      m_pairs.emplace_back();
    set_rows(m_pairs.back().step, step.rows(), [&](const auto& rows) { return rows(step); });
    set_rows(m_pairs.back().gradient_change, step.rows(), [&](const auto& rows) { return rows(gradient_change); });
    m_pairs.back().inverse_curvature = 1 / curvature;
  }

  /// replaces \p x by the product of the inverse Hessian, as the memory and the preconditioner know it, with it
  template <class Preconditioner>
  void apply(const Preconditioner& precondition, Uv_coordinates& x) const
  {
    std::vector<double> shares(m_pairs.size());
    for(std::size_t i = m_pairs.size(); i-- > 0;) {
      const auto& [step, gradient_change, inverse_curvature] = m_pairs[i];
      shares[i] = inverse_curvature * dot(step, x);
      add_multiple(-shares[i], gradient_change, x);
    }
    precondition(x);
    for(std::size_t i = 0; i < m_pairs.size(); ++i) {
      const auto& [step, gradient_change, inverse_curvature] = m_pairs[i];
      add_multiple(shares[i] - inverse_curvature * dot(gradient_change, x), step, x);
    }
  }

private:
  struct Pair
  {
    Uv_coordinates step, gradient_change;
    double inverse_curvature = 0;
  };

  static void add_multiple(double factor, const Uv_coordinates& y, Uv_coordinates& x)
  {
    set_rows(x, x.rows(), [&](const auto& rows) { return rows(x) + factor * rows(y); });
  }

  std::size_t m_capacity;
  std::deque<Pair> m_pairs;
};

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_SECANT_MEMORY_H
