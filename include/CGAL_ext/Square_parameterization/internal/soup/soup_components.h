// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SOUP_SOUP_COMPONENTS_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SOUP_SOUP_COMPONENTS_H

#include <CGAL_ext/Square_parameterization/internal/common/Complaint.h>
#include <CGAL_ext/Square_parameterization/internal/common/Disjoint_sets.h>
#include <CGAL_ext/Square_parameterization/internal/soup/Surface_soup.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// the connected components of a soup: faces joined by edges, ascending in each. Most faces first, then lowest face
/// first. CGAL's `connected_components()` asks for a mesh, which a soup need not be.
/// \param sides of the soup by edge
inline std::vector<std::vector<std::size_t>> components_of(const Surface_soup& soup,
                                                           const std::vector<Soup_side>& sides)
{
  Disjoint_sets joined(soup.faces.size());
  for_each_edge(sides, [&joined](auto begin, auto end) {
    for(auto side = std::next(begin); side != end; ++side)
      joined.union_set(begin->face, side->face);
  });
  std::vector<std::size_t> number(soup.faces.size(), soup.faces.size());
  std::vector<std::vector<std::size_t>> components;
  for(std::size_t f = 0; f < soup.faces.size(); ++f) {
    std::size_t& component = number[joined.find_set(f)];
    if(component == soup.faces.size()) {
      component = components.size();
      components.emplace_back();
    }
    components[component].push_back(f);
  }
  std::stable_sort(components.begin(), components.end(),
                   [](const auto& a, const auto& b) { return a.size() > b.size(); });
  return components;
}

/// keeps the faces of one component, in their order, and of the sides by edge those of its faces
inline void keep_component(const std::vector<std::size_t>& component, Surface_soup& soup, std::vector<Soup_side>& sides)
{
  const std::size_t dropped = soup.faces.size();
  std::vector<std::size_t> new_index(soup.faces.size(), dropped);
  std::vector<std::vector<std::size_t>> faces;
  for(std::size_t f : component) {
    new_index[f] = faces.size();
    faces.push_back(std::move(soup.faces[f]));
  }
  soup.faces = std::move(faces);
  for(Soup_side& side : sides)
    side.face = static_cast<std::uint32_t>(new_index[side.face]);
  sides.erase(
      std::remove_if(sides.begin(), sides.end(), [dropped](const Soup_side& side) { return side.face == dropped; }),
      sides.end());
}

/// adds that there are several components, with the sizes of the first few
inline void complain_about_components(const std::vector<std::vector<std::size_t>>& components, Complaint& complaint)
{
  if(components.size() < 2)
    return;
  std::vector<std::string> sizes;
  for(std::size_t k = 0; k < (std::min)(components.size(), NAMED_PLACES); ++k)
    sizes.push_back(std::to_string(k) + " has " + std::to_string(components[k].size()) +
                    (components[k].size() == 1 ? " face" : " faces"));
  complaint.add(components.size(), "", "connected components, of which one can be chosen with --component", sizes);
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SOUP_SOUP_COMPONENTS_H
