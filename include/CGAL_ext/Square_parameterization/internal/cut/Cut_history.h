// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_CUT_HISTORY_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_CUT_HISTORY_H

#include <CGAL_ext/Square_parameterization/Cut_report.h>
#include <CGAL_ext/Square_parameterization/internal/cut/Cut_pool.h>

#include <vector>

namespace CGAL_ext {
namespace internal {

/// the steps of a decision, with their scores at the weight of the decision
class Cut_history
{
public:
  explicit Cut_history(double weight) : m_weight(weight) {}

  void add(const Scored_cut& cut)
  {
    const Cut_score& score = cut.score;
    m_steps.push_back({cut.kind, cut.terminal, score.at(m_weight), score.stretch, score.length});
  }

  /// \param part of the decision that has a history of its own
  void add(const Cut_history& part) { m_steps.insert(m_steps.end(), part.m_steps.begin(), part.m_steps.end()); }

  const std::vector<Cut_step>& steps() const { return m_steps; }

private:
  double m_weight;
  std::vector<Cut_step> m_steps;
};

} // namespace internal
} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_CUT_HISTORY_H
