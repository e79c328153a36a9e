// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SOUP_ORIENT_SOUP_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SOUP_ORIENT_SOUP_H

#include <CGAL_ext/Square_parameterization/internal/common/Unmappable.h>
#include <CGAL_ext/Square_parameterization/internal/soup/Surface_soup.h>

#include <algorithm>
#include <string>
#include <vector>

namespace CGAL_ext {
namespace internal {

/// turns faces round until neighbors agree, in each component as few as possible; returns how many it turned.
/// \p names holds the numbers of the faces for messages.
inline std::size_t orient_faces(Surface_soup& soup, const std::vector<std::size_t>& names)
{
  struct Neighbor
  {
    std::size_t face;
    bool is_opposed; ///< the two faces run through their edge in the same direction
  };
  std::vector<std::vector<Neighbor>> neighbors(soup.faces.size());
  for_each_edge(sides_by_edge(soup.faces), [&](auto begin, auto end) {
    if(end - begin != 2)
      return;
    const bool opposed = soup.faces[begin->face][begin->corner] == soup.faces[(begin + 1)->face][(begin + 1)->corner];
    neighbors[begin->face].push_back({(begin + 1)->face, opposed});
    neighbors[(begin + 1)->face].push_back({begin->face, opposed});
  });
  enum class Turn : char
  {
    UNKNOWN,
    NO,
    YES
  };
  std::vector<Turn> turns(soup.faces.size(), Turn::UNKNOWN);
  std::size_t turned = 0;
  for(std::size_t seed = 0; seed < soup.faces.size(); ++seed) {
    if(turns[seed] != Turn::UNKNOWN)
      continue;
    std::vector<std::size_t> component{seed};
    turns[seed] = Turn::NO;
    std::size_t to_turn = 0;
    for(std::size_t i = 0; i < component.size(); ++i)
      for(const Neighbor& neighbor : neighbors[component[i]]) {
        const bool turn = (turns[component[i]] == Turn::YES) != neighbor.is_opposed;
        Turn& known = turns[neighbor.face];
        if(known == Turn::UNKNOWN) {
          known = turn ? Turn::YES : Turn::NO;
          to_turn += turn ? 1 : 0;
          component.push_back(neighbor.face);
        } else if((known == Turn::YES) != turn)
          throw Unmappable(CGAL::Surface_mesh_parameterization::ERROR_NO_TOPOLOGICAL_DISC,
                           "the surface cannot be mapped: it is not orientable (faces " +
                               std::to_string(names[component[i]]) + " and " + std::to_string(names[neighbor.face]) +
                               " disagree)");
      }
    const Turn side_to_turn = 2 * to_turn > component.size() ? Turn::NO : Turn::YES;
    for(std::size_t f : component)
      if(turns[f] == side_to_turn) {
        std::reverse(soup.faces[f].begin(), soup.faces[f].end());
        ++turned;
      }
  }
  return turned;
}

} // namespace internal
} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SOUP_ORIENT_SOUP_H
