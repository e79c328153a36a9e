// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_CUT_PROGRESS_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_CUT_PROGRESS_H

#include <CGAL_ext/Square_parameterization/Search_visitor.h>

#include <algorithm>
#include <mutex>

namespace CGAL_ext {
namespace internal {

/// tells a visitor how far the decision on a cut is: parts one after the other, each of some work, which may end early
class Cut_progress
{
public:
  /// \param visitor may be null
  explicit Cut_progress(Search_visitor* visitor) : m_visitor(visitor) {}

  /// ends the part before and begins the next
  /// \param end the share of the whole that is done when the part is, in [0, 1]; not less than that of the part before
  /// \param work of the part, in any unit
  void begin_part(double end, double work)
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    m_begin = m_end;
    m_end = end;
    m_work = (std::max)(work, 1.);
    m_done = 0;
    tell();
  }

  /// \param work that is done, in the unit of the part; of several threads
  void advance(double work)
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    m_done += work;
    tell();
  }

private:
  void tell() const
  {
    if(m_visitor != nullptr)
      m_visitor->cut_progress(m_begin + (m_end - m_begin) * (std::min)(m_done / m_work, 1.));
  }

  Search_visitor* const m_visitor;
  std::mutex m_mutex;
  double m_begin = 0, m_end = 0, m_work = 1, m_done = 0;
};

} // namespace internal
} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_CUT_PROGRESS_H
