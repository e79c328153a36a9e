// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SURFACE_INCIDENT_EDGES_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SURFACE_INCIDENT_EDGES_H

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL_ext {
namespace internal {

/// the edges that meet at each vertex, ascending, in one array: a list per vertex would take three times the memory
class Incident_edges
{
public:
  /// the edges of one vertex
  class Range
  {
  public:
    Range(const int* begin, const int* end) : m_begin(begin), m_end(end) {}
    const int* begin() const { return m_begin; }
    const int* end() const { return m_end; }

  private:
    const int *m_begin, *m_end;
  };

  Incident_edges() = default;

  /// \param edges #E, the ends of each
  Incident_edges(std::size_t vertices, const std::vector<std::array<int, 2>>& edges)
    : m_first(vertices + 1, 0), m_edges(2 * edges.size())
  {
    for(const auto& ends : edges)
      for(int v : ends)
        ++m_first[v];
    for(std::size_t v = 0, end = 0; v <= vertices; ++v)
      m_first[v] = end += m_first[v]; // one past the last edge of the vertex
    for(std::size_t e = edges.size(); e-- > 0;)
      for(int v : edges[e])
        m_edges[--m_first[v]] = static_cast<int>(e);
  }

  Range operator[](int v) const { return {m_edges.data() + m_first[v], m_edges.data() + m_first[v + 1]}; }

private:
  std::vector<std::size_t> m_first; // #V + 1
  std::vector<int> m_edges;         // 2 #E
};

} // namespace internal
} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SURFACE_INCIDENT_EDGES_H
