// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SOUP_POLYGON_QUADTREE_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SOUP_POLYGON_QUADTREE_H

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// a quadtree over the corners of a polygon in the plane, of which neighboring leaves differ in their width by two times at
/// most (Bern, Eppstein and Gilbert, "Provably good mesh generation", 1994). The centers of the leaves that no side crosses are
/// points for a triangulation that is fine where the polygon is, and coarse in its middle.
///
/// CGAL has a quadtree, too, but not one whose leaves know what crosses them.
///
/// Complexity: n log n in the number of corners, but for sides that cross many leaves.
class Polygon_quadtree
{
public:
  typedef Eigen::Vector2d Point;

  /// \param corners of the polygon, in their order
  /// \param most_corners in a leaf
  Polygon_quadtree(const std::vector<Point>& corners, std::size_t most_corners)
    : m_corners(corners), m_most_corners(most_corners)
  {
    Point low = corners.front(), high = low;
    for(const Point& p : corners) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    m_width = WIDER * (high - low).maxCoeff();
    m_low = (low + high) / 2 - Point::Constant(m_width / 2);
    m_cells.push_back({});
    std::vector<int> all(corners.size());
    std::iota(all.begin(), all.end(), 0);
    split_where_dense(0, all);
    balance();
    for(std::size_t k = 0; k < corners.size(); ++k)
      mark_crossed(0, corners[k], corners[(k + 1) % corners.size()]);
  }

  /// the centers of the leaves that no side crosses, inside and outside: they are at least half of the width of the leaf away
  /// from the polygon
  std::vector<Point> free_centers() const
  {
    std::vector<Point> centers;
    for(const Cell& cell : m_cells)
      if(cell.first_child == NONE && !cell.is_crossed)
        centers.push_back(center(cell));
    return centers;
  }

private:
  static constexpr int NONE = -1;
  static constexpr int DEEPEST = 26;        // level: so that the places of all cells are exact
  static constexpr double WIDER = 1 + 1e-4; // the box of all, and cells that are asked for what crosses them: rounding

  struct Cell
  {
    int level = 0;              ///< 0 is the box of all, of which a cell of level l is the 2^-l-th part in width
    std::uint32_t x = 0, y = 0; ///< column and row among the cells of its level
    int first_child = NONE;     ///< of four that follow each other
    bool is_crossed = false;    ///< of a leaf: by a side, or nearly
  };

  double width(const Cell& cell) const { return std::ldexp(m_width, -cell.level); }

  Point center(const Cell& cell) const { return m_low + width(cell) * Point(cell.x + 0.5, cell.y + 0.5); }

  void split(int i)
  {
    m_cells[i].first_child = static_cast<int>(m_cells.size());
    const Cell cell = m_cells[i];
    for(std::uint32_t k = 0; k < 4; ++k)
      m_cells.push_back({cell.level + 1, 2 * cell.x + k % 2, 2 * cell.y + k / 2, NONE, false});
  }

  /// \param corners that lie in the cell
  void split_where_dense(int i, const std::vector<int>& corners)
  {
    if(corners.size() <= m_most_corners || m_cells[i].level >= DEEPEST)
      return;
    split(i);
    const int first_child = m_cells[i].first_child;
    const Point middle = center(m_cells[i]);
    std::array<std::vector<int>, 4> parts;
    for(int k : corners)
      parts[(m_corners[k].x() >= middle.x() ? 1 : 0) + (m_corners[k].y() >= middle.y() ? 2 : 0)].push_back(k);
    for(int k = 0; k < 4; ++k)
      split_where_dense(first_child + k, parts[k]);
  }

  /// splits leaves that are more than twice as wide as one beside them
  void balance()
  {
    std::vector<int> waiting(m_cells.size());
    std::iota(waiting.begin(), waiting.end(), 0);
    while(!waiting.empty()) {
      const int i = waiting.back();
      waiting.pop_back();
      if(m_cells[i].first_child != NONE)
        continue;
      const Cell cell = m_cells[i];
      for(const auto& [right, up] : {std::array<int, 2>{1, 0}, {-1, 0}, {0, 1}, {0, -1}})
        for(int beside = find(cell, right, up); is_much_wider(beside, cell); beside = find(cell, right, up)) {
          split(beside);
          for(int k = 0; k < 4; ++k)
            waiting.push_back(m_cells[beside].first_child + k);
        }
    }
  }

  bool is_much_wider(int i, const Cell& than) const
  {
    return i != NONE && m_cells[i].first_child == NONE && m_cells[i].level < than.level - 1;
  }

  /// the cell of the same level beside another one, or the leaf that holds it; none outside
  int find(const Cell& cell, int right, int up) const
  {
    const std::int64_t x = std::int64_t(cell.x) + right, y = std::int64_t(cell.y) + up,
                       end = std::int64_t(1) << cell.level;
    if(x < 0 || y < 0 || x >= end || y >= end)
      return NONE;
    int i = 0;
    for(int bit = cell.level - 1; bit >= 0 && m_cells[i].first_child != NONE; --bit)
      i = m_cells[i].first_child + static_cast<int>((x >> bit) % 2 + 2 * ((y >> bit) % 2));
    return i;
  }

  void mark_crossed(int i, const Point& a, const Point& b)
  {
    if(!is_crossed(m_cells[i], a, b))
      return;
    if(m_cells[i].first_child == NONE)
      m_cells[i].is_crossed = true;
    else
      for(int k = 0; k < 4; ++k)
        mark_crossed(m_cells[i].first_child + k, a, b);
  }

  /// indicates whether a segment meets a cell: neither an axis nor the normal of the segment parts them
  bool is_crossed(const Cell& cell, const Point& a, const Point& b) const
  {
    const double half = WIDER * width(cell) / 2;
    const Point p = a - center(cell), q = b - center(cell), along = b - a;
    if((p.cwiseMin(q).array() > half).any() || (p.cwiseMax(q).array() < -half).any())
      return false;
    return std::abs(along.x() * p.y() - along.y() * p.x()) <= half * (std::abs(along.x()) + std::abs(along.y()));
  }

  const std::vector<Point>& m_corners;
  std::size_t m_most_corners;
  double m_width = 0; // of the box of all
  Point m_low;        // its corner
  std::vector<Cell> m_cells;
};

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SOUP_POLYGON_QUADTREE_H
