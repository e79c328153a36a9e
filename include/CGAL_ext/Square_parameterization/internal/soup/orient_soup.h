// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SOUP_ORIENT_SOUP_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SOUP_ORIENT_SOUP_H

#include <CGAL_ext/Square_parameterization/internal/common/Unmappable.h>
#include <CGAL_ext/Square_parameterization/internal/soup/Surface_soup.h>

#include <algorithm>
#include <iterator>
#include <numeric>
#include <string>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// the faces beside each face, across edges with two faces, in the order of the edges
class Face_neighbors
{
public:
  struct Neighbor
  {
    std::size_t face;
    bool is_opposed; ///< the two faces run through their edge in the same direction
  };

  /// \param sides of the soup by edge
  Face_neighbors(const Surface_soup& soup, const std::vector<Soup_side>& sides) : m_ends(soup.faces.size() + 1, 0)
  {
    for_each_edge(sides, [this](auto begin, auto end) {
      if(end - begin == 2)
        for(auto side = begin; side != end; ++side)
          ++m_ends[side->face + 1];
    });
    std::partial_sum(m_ends.begin(), m_ends.end(), m_ends.begin());
    m_neighbors.resize(m_ends.back());
    for_each_edge(sides, [this, &soup](auto begin, auto end) {
      if(end - begin != 2)
        return;
      const Soup_side &a = *begin, &b = *std::next(begin);
      const bool opposed = soup.faces[a.face][a.corner] == soup.faces[b.face][b.corner];
      m_neighbors[m_ends[a.face]++] = {b.face, opposed};
      m_neighbors[m_ends[b.face]++] = {a.face, opposed};
    });
  }

  /// calls `visit(neighbor)` with those of a face
  template <class Visit>
  void for_each(std::size_t face, Visit visit) const
  {
    for(std::size_t i = face == 0 ? 0 : m_ends[face - 1]; i < m_ends[face]; ++i)
      visit(m_neighbors[i]);
  }

private:
  std::vector<std::size_t> m_ends; // #F + 1, where the neighbors of each face end
  std::vector<Neighbor> m_neighbors;
};

/// decides which faces to turn round for neighbors to agree, in each component as few as possible. Throws `Unmappable`
/// when they cannot agree. \p names holds the numbers of the faces for messages.
inline std::vector<bool> faces_to_turn(const Face_neighbors& neighbors, const std::vector<std::size_t>& names)
{
  std::vector<bool> is_known(names.size(), false), turns(names.size(), false);
  std::vector<std::size_t> component;
  for(std::size_t seed = 0; seed < names.size(); ++seed) {
    if(is_known[seed])
      continue;
    component.assign(1, seed);
    is_known[seed] = true;
    std::size_t to_turn = 0;
    for(std::size_t i = 0; i < component.size(); ++i)
      neighbors.for_each(component[i], [&, f = component[i]](const Face_neighbors::Neighbor& neighbor) {
        const bool turn = turns[f] != neighbor.is_opposed;
        if(!is_known[neighbor.face]) {
          is_known[neighbor.face] = true;
          turns[neighbor.face] = turn;
          to_turn += turn ? 1 : 0;
          component.push_back(neighbor.face);
        } else if(turns[neighbor.face] != turn)
          throw Unmappable(CGAL::Surface_mesh_parameterization::ERROR_NO_TOPOLOGICAL_DISC,
                           "the surface cannot be mapped: it is not orientable (faces " + std::to_string(names[f]) +
                               " and " + std::to_string(names[neighbor.face]) + " disagree)");
      });
    if(2 * to_turn > component.size())
      for(std::size_t f : component)
        turns[f] = !turns[f];
  }
  return turns;
}

/// indicates whether all faces agree with their neighbors, as those of most files do
inline bool do_faces_agree(const Surface_soup& soup, const std::vector<Soup_side>& sides)
{
  bool do_agree = true;
  for_each_edge(sides, [&](auto begin, auto end) {
    if(end - begin == 2)
      do_agree &=
          soup.faces[begin->face][begin->corner] != soup.faces[std::next(begin)->face][std::next(begin)->corner];
  });
  return do_agree;
}

/// turns faces round until neighbors agree, in each component as few as possible; returns how many it turned.
/// \p names holds the numbers of the faces for messages, \p sides those of the soup by edge, which stay so.
///
/// CGAL's `orient_polygon_soup()` duplicates vertices where neighbors cannot agree, so that a Moebius strip would be
/// mapped cut open without a word: ours refuses it.
/// \pre no face repeats a vertex
inline std::size_t orient_faces(Surface_soup& soup, std::vector<Soup_side>& sides,
                                const std::vector<std::size_t>& names)
{
  if(do_faces_agree(soup, sides))
    return 0;
  const std::vector<bool> turns = faces_to_turn(Face_neighbors(soup, sides), names);
  std::size_t turned = 0;
  for(std::size_t f = 0; f < soup.faces.size(); ++f)
    if(turns[f]) {
      std::reverse(soup.faces[f].begin(), soup.faces[f].end());
      ++turned;
    }
  for(Soup_side& side : sides)
    if(turns[side.face]) { // it begins where it ended
      const int last = static_cast<int>(soup.faces[side.face].size()) - 1;
      side.corner = side.corner == last ? last : last - 1 - side.corner;
    }
  return turned;
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SOUP_ORIENT_SOUP_H
