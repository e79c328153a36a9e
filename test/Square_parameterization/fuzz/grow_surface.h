// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_FUZZ_GROW_SURFACE_H
#define CGAL_EXT_FUZZ_GROW_SURFACE_H

#include "random_bodies.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <utility>
#include <vector>

// What grows on a surface of polygons: nails, handles, ears and other components. It stays as sound as it was.

typedef std::vector<std::size_t> Soup_face;

inline std::size_t random_face(Random_numbers& random, const Surface_soup& soup)
{
  return static_cast<std::size_t>(random.below(static_cast<int>(soup.faces.size())));
}

inline Eigen::Vector3d center_of(const Surface_soup& soup, const Soup_face& face)
{
  Eigen::Vector3d sum(0, 0, 0);
  for(std::size_t v : face)
    sum += soup.points[v];
  return sum / double(face.size());
}

/// the normal of a polygon, as long as twice its area
inline Eigen::Vector3d area_vector(const Surface_soup& soup, const Soup_face& face)
{
  Eigen::Vector3d sum(0, 0, 0);
  for(std::size_t k = 1; k + 1 < face.size(); ++k) {
    const Eigen::Vector3d& origin = soup.points[face[0]];
    sum += (soup.points[face[k]] - origin).cross(soup.points[face[k + 1]] - origin);
  }
  return sum;
}

/// the side of the diagonal of the box
inline double extent_of(const Surface_soup& soup)
{
  Eigen::Vector3d low = soup.points.front(), high = low;
  for(const Eigen::Vector3d& p : soup.points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return (high - low).norm();
}

/// quads between a face, which is taken away, and a ring of as many vertices
inline void join_ring(Surface_soup& soup, const Soup_face& face, const Soup_face& ring)
{
  for(std::size_t k = 0; k < face.size(); ++k) {
    const std::size_t next = (k + 1) % face.size();
    soup.faces.push_back({face[k], face[next], ring[next], ring[k]});
  }
}

/// puts rings onto a face, each smaller and higher than the last; the last carries the face
inline void grow_nail(Random_numbers& random, Surface_soup& soup, std::size_t f)
{
  const Eigen::Vector3d normal = area_vector(soup, soup.faces[f]);
  const double size = std::sqrt(normal.norm());
  if(!(size > 0))
    return;
  const int rings = 1 + random.below(8);
  const double height = size * random_magnitude(random, 0.1, 300) / rings,
               shrinking = random_magnitude(random, 0.2, 1.2);
  for(int i = 0; i < rings; ++i) {
    const Soup_face face = soup.faces[f];
    const Eigen::Vector3d center = center_of(soup, face);
    Soup_face ring;
    for(std::size_t v : face) {
      ring.push_back(soup.points.size());
      const Eigen::Vector3d p = center + shrinking * (soup.points[v] - center) + height * normal.normalized();
      soup.points.push_back(p);
    }
    join_ring(soup, face, ring);
    soup.faces[f] = std::move(ring);
  }
}

/// puts nails onto some faces, perhaps onto the ends or sides of other nails
inline void grow_nails(Random_numbers& random, Surface_soup& soup)
{
  for(int nails = 1 + random.below(6); nails > 0; --nails)
    grow_nail(random, soup, random(0, 1) < 0.3 ? soup.faces.size() - 1 : random_face(random, soup));
}

/// joins two faces by a tube, unless they have different numbers of sides, or neighbors in common
inline void add_handle(Random_numbers& random, Surface_soup& soup)
{
  const std::size_t f = random_face(random, soup), g = random_face(random, soup);
  const Soup_face a = soup.faces[f];
  Soup_face b = soup.faces[g];
  const auto touches = [](const Soup_face& face, const Soup_face& other) {
    return std::any_of(face.begin(), face.end(),
                       [&other](std::size_t v) { return std::find(other.begin(), other.end(), v) != other.end(); });
  };
  if(a.size() != b.size() || std::any_of(soup.faces.begin(), soup.faces.end(),
                                         [&](const Soup_face& face) { return touches(face, a) && touches(face, b); }))
    return;
  std::reverse(b.begin(), b.end());
  join_ring(soup, a, b);
  for(std::size_t gone : {(std::max)(f, g), (std::min)(f, g)})
    soup.faces.erase(soup.faces.begin() + static_cast<std::ptrdiff_t>(gone));
}

inline void add_handles(Random_numbers& random, Surface_soup& soup)
{
  for(int tries = static_cast<int>(random_magnitude(random, 2, 30)); tries > 0; --tries)
    add_handle(random, soup);
}

/// puts a triangle onto some border edges
inline void add_ears(Random_numbers& random, Surface_soup& soup)
{
  const double share = random_magnitude(random, 0.02, 1), height = random_magnitude(random, 1e-6, 10);
  const std::vector<CGAL_ext::internal::Soup_side> sides = CGAL_ext::internal::sides_by_edge(soup);
  CGAL_ext::internal::for_each_edge(sides, [&](auto begin, auto end) {
    if(end - begin != 1 || random(0, 1) >= share)
      return;
    const Soup_face& face = soup.faces[begin->face];
    const auto corner = static_cast<std::size_t>(begin->corner);
    const std::size_t a = face[corner], b = face[(corner + 1) % face.size()];
    const Eigen::Vector3d middle = (soup.points[a] + soup.points[b]) / 2;
    const Eigen::Vector3d tip = middle + height * (middle - center_of(soup, face));
    soup.faces.push_back({b, a, soup.points.size()});
    soup.points.push_back(tip);
  });
}

/// puts another surface beside this one
inline void add_component(Random_numbers& random, Surface_soup& soup)
{
  const Random_body& body =
      random_bodies()[static_cast<std::size_t>(random.below(static_cast<int>(random_bodies().size())))];
  const Surface_soup other = body.make(random, 4 + random.below(static_cast<int>(soup.faces.size()) + 4));
  const std::size_t first = soup.points.size();
  for(const Eigen::Vector3d& p : other.points)
    soup.points.push_back(p + Eigen::Vector3d(3, 0, 0));
  for(Soup_face face : other.faces) {
    for(std::size_t& v : face)
      v += first;
    soup.faces.push_back(std::move(face));
  }
}

#endif // CGAL_EXT_FUZZ_GROW_SURFACE_H
