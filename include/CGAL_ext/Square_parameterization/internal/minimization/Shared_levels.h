// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_SHARED_LEVELS_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_SHARED_LEVELS_H

#include <CGAL_ext/Square_parameterization/internal/minimization/Minimizer_levels.h>

#include <memory>
#include <mutex>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// the ever coarser copies of a patch that several minimizers share, which differ in how they make first maps: with a border
/// that may be made coarse, too, and, made when it is first asked for, with the whole one. It refers to the patch.
///
/// Several threads may call at a time.
class Shared_levels
{
public:
  Shared_levels(const Patch& patch, const Balanced_minimization& minimization, const Deadline& deadline,
                Coarsening coarsening)
    : m_patch(patch), m_minimization(minimization), m_deadline(deadline), m_coarsening(coarsening), m_usual(make(true))
  {}

  const std::shared_ptr<const Minimizer_levels>& usual() const { return m_usual; }

  const std::shared_ptr<const Minimizer_levels>& with_whole_border()
  {
    std::call_once(m_whole_border_made, [this] { m_whole_border = make(false); });
    return m_whole_border;
  }

private:
  std::shared_ptr<const Minimizer_levels> make(bool may_coarsen_border) const
  {
    return std::make_shared<const Minimizer_levels>(m_patch, m_minimization, may_coarsen_border, m_deadline,
                                                    m_coarsening);
  }

  const Patch& m_patch;
  const Balanced_minimization m_minimization;
  const Deadline m_deadline;
  const Coarsening m_coarsening;
  const std::shared_ptr<const Minimizer_levels> m_usual;
  std::once_flag m_whole_border_made;
  std::shared_ptr<const Minimizer_levels> m_whole_border;
};

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_SHARED_LEVELS_H
