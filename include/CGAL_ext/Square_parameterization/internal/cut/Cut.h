// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_CUT_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_CUT_H

#include <CGAL_ext/Square_parameterization/internal/surface/Triangle_surface.h>

#include <algorithm>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// interior edges of a surface along which it is to be cut, and the vertices that the cut must reach.
///
/// Every operation of this package keeps the complement of the cut a disk: `initial_cut()` makes it one.
class Cut
{
public:
  explicit Cut(const Triangle_surface& surface)
    : m_is_cut(surface.edges.size(), false),
      m_is_fixed(surface.edges.size(), false),
      m_is_terminal(surface.points.size(), false),
      m_degrees(surface.points.size(), 0)
  {}

  bool contains(int e) const { return m_is_cut[e]; }
  bool is_fixed(int e) const { return m_is_fixed[e]; }
  bool is_terminal(int v) const { return m_is_terminal[v]; }

  /// number of edges of the cut at a vertex
  int degree(int v) const { return m_degrees[v]; }

  /// vertices that the cut must reach, in the order in which they were added
  const std::vector<int>& terminals() const { return m_terminals; }

  void insert(const Triangle_surface& surface, int e) { change(surface, e, true); }
  void erase(const Triangle_surface& surface, int e) { change(surface, e, false); }

  /// an edge that stays in the cut whatever happens
  void fix(const Triangle_surface& surface, int e)
  {
    insert(surface, e);
    m_is_fixed[e] = true;
  }

  void add_terminal(int v)
  {
    if(!m_is_terminal[v])
      m_terminals.push_back(v);
    m_is_terminal[v] = true;
  }

  void remove_terminal(int v)
  {
    m_terminals.erase(std::remove(m_terminals.begin(), m_terminals.end(), v), m_terminals.end());
    m_is_terminal[v] = false;
  }

  /// the edges, ascending
  std::vector<int> edges() const
  {
    std::vector<int> result;
    for(std::size_t e = 0; e < m_is_cut.size(); ++e)
      if(m_is_cut[e])
        result.push_back(static_cast<int>(e));
    return result;
  }

  /// sum of the lengths of the edges, each once
  double length(const Triangle_surface& surface) const
  {
    double length = 0;
    for(int e : edges())
      length += surface.lengths[e];
    return length;
  }

  /// indicates whether a path of the cut ends at `v`: a branch, a leaf, a border vertex, a terminal, or an end of fixed
  /// edges
  bool is_node(const Triangle_surface& surface, int v) const
  {
    if(m_degrees[v] != 2 || m_is_terminal[v] || surface.is_border_vertex[v])
      return true;
    const auto incident = surface.vertex_edges[v];
    return std::any_of(incident.begin(), incident.end(), [this](int e) { return m_is_fixed[e]; });
  }

private:
  void change(const Triangle_surface& surface, int e, bool is_cut)
  {
    if(m_is_cut[e] == is_cut)
      return;
    m_is_cut[e] = is_cut;
    for(int v : surface.edges[e])
      m_degrees[v] += is_cut ? 1 : -1;
  }

  std::vector<bool> m_is_cut, m_is_fixed; // #E
  std::vector<bool> m_is_terminal;        // #V
  std::vector<int> m_degrees;             // #V
  std::vector<int> m_terminals;
};

/// removes the edges that end at nothing: no terminal, no border, no fixed edge
inline void prune(const Triangle_surface& surface, Cut& cut)
{
  const auto is_loose = [&](int v) {
    return cut.degree(v) == 1 && !cut.is_terminal(v) && !surface.is_border_vertex[v];
  };
  for(int leaf = 0; leaf < surface.number_of_vertices(); ++leaf)
    for(int v = leaf; is_loose(v);) {
      const auto incident = surface.vertex_edges[v];
      const int e = *std::find_if(incident.begin(), incident.end(), [&cut](int edge) { return cut.contains(edge); });
      if(cut.is_fixed(e))
        break;
      cut.erase(surface, e);
      v = surface.other_end(e, v);
    }
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_CUT_H
