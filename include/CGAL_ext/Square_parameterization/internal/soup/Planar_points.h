// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SOUP_PLANAR_POINTS_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SOUP_PLANAR_POINTS_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// points in the plane that are asked whether one of them lies in a triangle, and removed one by one: a kd-tree that
/// counts the points that are left in each of its boxes. CGAL's has no search that ends at the first hit and passes
/// over what was removed.
///
/// Complexity: n log n to build, log n to remove a point, and for a question as many boxes as the sides of the triangle
/// cross, of the order of the square root of n for points that are spread evenly.
class Planar_points
{
public:
  typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
  typedef Kernel::Point_2 Point;
  typedef std::array<Point, 3> Triangle; ///< counter-clockwise

  explicit Planar_points(std::vector<Point> points) : m_points(std::move(points)), m_leaf_of(m_points.size())
  {
    m_order.resize(m_points.size());
    std::iota(m_order.begin(), m_order.end(), std::size_t(0));
    m_nodes.reserve(4 * (m_points.size() / LEAF_SIZE + 1));
    build(0, m_points.size(), NONE);
  }

  const Point& operator[](std::size_t i) const { return m_points[i]; }

  void remove(std::size_t i)
  {
    Node& leaf = m_nodes[m_leaf_of[i]];
    const auto begin = m_order.begin() + static_cast<std::ptrdiff_t>(leaf.begin);
    std::iter_swap(std::find(begin, begin + static_cast<std::ptrdiff_t>(leaf.count), i),
                   begin + static_cast<std::ptrdiff_t>(leaf.count - 1));
    for(std::size_t node = m_leaf_of[i]; node != NONE; node = m_nodes[node].parent)
      --m_nodes[node].count;
  }

  /// indicates whether one of the points lies in the triangle or on it, but for those in the place of one of its
  /// corners
  bool is_any_in(const Triangle& triangle) const { return is_any_in(triangle, 0); }

private:
  static constexpr std::size_t LEAF_SIZE = 8;
  static constexpr std::size_t NONE = static_cast<std::size_t>(-1);

  struct Node
  {
    Point low, high;       ///< corners of the box of the points that were there to begin with
    std::size_t begin;     ///< in the order, of a leaf
    std::size_t count;     ///< points that are left; in a leaf the first ones
    std::size_t parent;    ///< none of the root
    std::size_t right = 0; ///< the left child follows its parent; 0 for a leaf
  };

  std::size_t build(std::size_t begin, std::size_t end, std::size_t parent)
  {
    const std::size_t place = m_nodes.size();
    m_nodes.push_back({low_of(begin, end), high_of(begin, end), begin, end - begin, parent});
    const Point low = m_nodes[place].low, high = m_nodes[place].high;
    if(end - begin <= LEAF_SIZE || low == high) {
      for(std::size_t k = begin; k < end; ++k)
        m_leaf_of[m_order[k]] = place;
      return place;
    }
    const int axis = high.x() - low.x() >= high.y() - low.y() ? 0 : 1;
    const std::size_t middle = begin + (end - begin) / 2;
    const auto at = [this](std::size_t k) { return m_order.begin() + static_cast<std::ptrdiff_t>(k); };
    std::nth_element(at(begin), at(middle), at(end), [this, axis](std::size_t i, std::size_t j) {
      return std::make_pair(m_points[i][axis], i) < std::make_pair(m_points[j][axis], j);
    });
    build(begin, middle, place);
    const std::size_t right = build(middle, end, place);
    m_nodes[place].right = right;
    return place;
  }

  Point low_of(std::size_t begin, std::size_t end) const
  {
    return extreme(begin, end, [](double a, double b) { return (std::min)(a, b); });
  }

  Point high_of(std::size_t begin, std::size_t end) const
  {
    return extreme(begin, end, [](double a, double b) { return (std::max)(a, b); });
  }

  template <class Choose>
  Point extreme(std::size_t begin, std::size_t end, const Choose& choose) const
  {
    Point result = begin < end ? m_points[m_order[begin]] : Point(0, 0);
    for(std::size_t k = begin; k < end; ++k) {
      const Point& p = m_points[m_order[k]];
      result = Point(choose(result.x(), p.x()), choose(result.y(), p.y()));
    }
    return result;
  }

  bool is_any_in(const Triangle& triangle, std::size_t place) const
  {
    const Node& node = m_nodes[place];
    if(node.count == 0 || is_beside(triangle, node))
      return false;
    if(node.right != 0)
      return is_any_in(triangle, place + 1) || is_any_in(triangle, node.right);
    const auto is_in = [this, &triangle](std::size_t i) {
      return !is_corner(triangle, m_points[i]) && !is_beside(triangle, {m_points[i], m_points[i], 0, 0, NONE});
    };
    if(node.low == node.high)
      return is_in(m_order[node.begin]); // all in one place
    const auto begin = m_order.begin() + static_cast<std::ptrdiff_t>(node.begin);
    return std::any_of(begin, begin + static_cast<std::ptrdiff_t>(node.count), is_in);
  }

  static bool is_corner(const Triangle& triangle, const Point& p)
  {
    return std::find(triangle.begin(), triangle.end(), p) != triangle.end();
  }

  /// indicates whether all of the box lies on the outer side of a side of the triangle: the corner that lies farthest
  /// towards the inner side does
  static bool is_beside(const Triangle& triangle, const Node& box)
  {
    for(int side = 0; side < 3; ++side) {
      const Point &a = triangle[side], &b = triangle[(side + 1) % 3];
      const Point farthest(b.y() > a.y() ? box.low.x() : box.high.x(), b.x() > a.x() ? box.high.y() : box.low.y());
      if(CGAL::orientation(a, b, farthest) == CGAL::RIGHT_TURN)
        return true;
    }
    return false;
  }

  std::vector<Point> m_points;
  std::vector<std::size_t> m_order;   // the points, leaf by leaf
  std::vector<std::size_t> m_leaf_of; // per point
  std::vector<Node> m_nodes;
};

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SOUP_PLANAR_POINTS_H
