// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_CUT_HISTORY_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_CUT_HISTORY_H

#include <CGAL_ext/Square_parameterization/Cut_report.h>
#include <CGAL_ext/Square_parameterization/internal/cut/Cut_pool.h>

namespace CGAL_ext {
namespace internal {

/// puts the steps of a decision into its report, with their scores at the weight of the decision
class Cut_history
{
public:
  Cut_history(double weight, Cut_report& report) : m_weight(weight), m_report(report) {}

  void add(const Scored_cut& cut)
  {
    const Cut_score& score = cut.score;
    m_report.history.push_back({cut.kind, cut.terminal, score.at(m_weight), score.stretch, score.length});
  }

private:
  double m_weight;
  Cut_report& m_report;
};

} // namespace internal
} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_CUT_HISTORY_H
