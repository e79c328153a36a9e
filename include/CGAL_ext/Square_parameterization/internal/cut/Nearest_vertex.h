// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_NEAREST_VERTEX_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_NEAREST_VERTEX_H

#include <CGAL_ext/Square_parameterization/internal/surface/Triangle_surface.h>

#include <CGAL/Orthogonal_incremental_neighbor_search.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Search_traits_adapter.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/property_map.h>

#include <boost/iterator/counting_iterator.hpp>

#include <limits>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// finds the vertex of a surface that is nearest to a point; ties: lowest.
///
/// Linear to make, but for a logarithm; about logarithmic for each point. Answers are those of comparing the squared
/// distances to all vertices. The surface must outlive it.
class Nearest_vertex
{
public:
  explicit Nearest_vertex(const Triangle_surface& surface)
    : m_surface(surface),
      m_points(points_of(surface)),
      m_distance(CGAL::make_property_map(m_points)),
      m_tree(boost::counting_iterator<int>(0), boost::counting_iterator<int>(surface.number_of_vertices()),
             typename Search::Splitter(), Traits(CGAL::make_property_map(m_points)))
  {
    m_tree.build();
  }

  Nearest_vertex(const Nearest_vertex&) = delete; // the tree refers to the points
  Nearest_vertex& operator=(const Nearest_vertex&) = delete;

  int operator()(const Eigen::Vector3d& p) const
  {
    // the search rounds in another order: all that come as near, but for rounding, are compared again
    constexpr double ROUNDING = 1e-12;
    const Search search(m_tree, Kernel::Point_3(p.x(), p.y(), p.z()), 0, true, m_distance);
    const double limit = (1 + ROUNDING) * search.begin()->second + (std::numeric_limits<double>::min)();
    int nearest = -1;
    double least = std::numeric_limits<double>::infinity();
    for(const auto& [v, squared_by_search] : search) {
      if(squared_by_search > limit)
        break;
      const double squared = (m_surface.points[v] - p).squaredNorm();
      if(squared < least || (squared == least && v < nearest)) {
        least = squared;
        nearest = v;
      }
    }
    return nearest;
  }

private:
  typedef CGAL::Simple_cartesian<double> Kernel;
  typedef CGAL::Pointer_property_map<Kernel::Point_3>::type Point_map;
  typedef CGAL::Search_traits_adapter<int, Point_map, CGAL::Search_traits_3<Kernel>> Traits;
  typedef CGAL::Orthogonal_incremental_neighbor_search<Traits> Search;

  static std::vector<Kernel::Point_3> points_of(const Triangle_surface& surface)
  {
    std::vector<Kernel::Point_3> points;
    points.reserve(surface.points.size());
    for(const Eigen::Vector3d& p : surface.points)
      points.emplace_back(p.x(), p.y(), p.z());
    return points;
  }

  const Triangle_surface& m_surface;
  std::vector<Kernel::Point_3> m_points; // #V
  Search::Distance m_distance;
  Search::Tree m_tree;
};

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_NEAREST_VERTEX_H
