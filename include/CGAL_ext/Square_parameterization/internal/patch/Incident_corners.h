// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PATCH_INCIDENT_CORNERS_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PATCH_INCIDENT_CORNERS_H

#include <CGAL_ext/Square_parameterization/internal/patch/Patch.h>

#include <numeric>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// the corners of triangles at each vertex of a patch, in the order of the triangles
class Incident_corners
{
public:
  /// a triangle and the number of its corner, 0 to 2
  struct Corner
  {
    int triangle, number;
  };

  /// the corners at one vertex
  class Range
  {
  public:
    Range(const Corner* begin, const Corner* end) : m_begin(begin), m_end(end) {}
    const Corner* begin() const { return m_begin; }
    const Corner* end() const { return m_end; }
    int size() const { return static_cast<int>(m_end - m_begin); }

  private:
    const Corner *m_begin, *m_end;
  };

  explicit Incident_corners(const Patch& patch)
    : m_first(patch.points.size() + 1, 0), m_corners(3 * patch.triangles.size())
  {
    for(const auto& t : patch.triangles)
      for(int v : t)
        ++m_first[v + 1];
    std::partial_sum(m_first.begin(), m_first.end(), m_first.begin());
    std::vector<int> next(m_first.begin(), m_first.end() - 1);
    for(int f = 0; f < patch.number_of_faces(); ++f)
      for(int k = 0; k < 3; ++k)
        m_corners[next[patch.triangles[f][k]]++] = {f, k};
  }

  Range operator[](int v) const { return {m_corners.data() + m_first[v], m_corners.data() + m_first[v + 1]}; }

private:
  std::vector<int> m_first; // #V + 1
  std::vector<Corner> m_corners;
};

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PATCH_INCIDENT_CORNERS_H
