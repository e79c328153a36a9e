// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SURFACE_LOW_DEGREE_COLLAPSES_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SURFACE_LOW_DEGREE_COLLAPSES_H

#include <CGAL/boost/graph/iterator.h>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// where CGAL's simplification puts the vertex that an edge is collapsed to: none for an edge whose ends have more neighbors
/// than a number, those of both counted twice, which is not collapsed then unless it has no length. On a flat lid of thousands of vertices all collapses cost nothing; if
/// one vertex swallowed the others, each collapse would take time with the square of their number.
/// \tparam Placement a model of `GetPlacement`
template <class Placement>
class Placement_of_low_degree
{
public:
  Placement_of_low_degree(const Placement& placement, int most_neighbors)
    : m_placement(placement), m_most_neighbors(most_neighbors)
  {}

  template <class Profile>
  auto operator()(const Profile& profile) const
  {
    auto place = decltype(m_placement(profile))();
    if(has_few_neighbors(profile))
      place = m_placement(profile);
    return place;
  }

private:
  /// counts no further than it has to
  template <class Profile>
  bool has_few_neighbors(const Profile& profile) const
  {
    const auto& mesh = profile.surface_mesh();
    int neighbors = 0;
    for(const auto v : {profile.v0(), profile.v1()}) {
      const auto edges = CGAL::halfedges_around_target(v, mesh);
      for(auto edge = edges.begin(); edge != edges.end(); ++edge)
        if(++neighbors > m_most_neighbors)
          return false;
    }
    return true;
  }

  Placement m_placement;
  int m_most_neighbors;
};

/// what a collapse costs: nothing is computed for one that has no placement. Not for costs that are told of collapses, such as
/// those of Garland and Heckbert.
/// \tparam Cost a model of `GetCost`
template <class Cost>
class Cost_of_placement
{
public:
  explicit Cost_of_placement(const Cost& cost) : m_cost(cost) {}

  template <class Profile, class Place>
  auto operator()(const Profile& profile, const Place& place) const
  {
    auto cost = decltype(m_cost(profile, place))();
    if(place)
      cost = m_cost(profile, place);
    return cost;
  }

private:
  Cost m_cost;
};

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SURFACE_LOW_DEGREE_COLLAPSES_H
