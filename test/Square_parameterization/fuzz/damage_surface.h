// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_FUZZ_DAMAGE_SURFACE_H
#define CGAL_EXT_FUZZ_DAMAGE_SURFACE_H

#include "grow_surface.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

// What goes wrong with surfaces: in their faces, and in their coordinates.

inline std::size_t random_vertex(Random_numbers& random, const Surface_soup& soup)
{
  return static_cast<std::size_t>(random.below(static_cast<int>(soup.points.size())));
}

/// of a cube; the order of the numbers is the same for every compiler
inline Eigen::Vector3d random_point(Random_numbers& random)
{
  const double x = random(-1, 1), y = random(-1, 1);
  return {x, y, random(-1, 1)};
}

/// a few, or up to all
inline int random_count(Random_numbers& random, std::size_t most)
{
  return static_cast<int>(random_magnitude(random, 1, 1 + double(most)));
}

/// removes faces here and there; mostly all those at a vertex, which leaves fewer pinched vertices
inline void make_holes(Random_numbers& random, Surface_soup& soup)
{
  for(int holes = random_count(random, soup.faces.size() / 8); holes > 0 && soup.faces.size() > 4; --holes) {
    const std::size_t f = random_face(random, soup), v = soup.faces[f][0];
    if(random(0, 1) < 0.2) {
      soup.faces.erase(soup.faces.begin() + static_cast<std::ptrdiff_t>(f));
      continue;
    }
    std::vector<Soup_face> left;
    std::copy_if(soup.faces.begin(), soup.faces.end(), std::back_inserter(left),
                 [v](const Soup_face& face) { return std::find(face.begin(), face.end(), v) == face.end(); });
    if(left.size() >= 4)
      soup.faces = std::move(left);
  }
}

/// turns some faces round
inline void turn_faces(Random_numbers& random, Surface_soup& soup)
{
  for(int count = random_count(random, soup.faces.size()); count > 0; --count) {
    Soup_face& face = soup.faces[random_face(random, soup)];
    std::reverse(face.begin(), face.end());
  }
}

/// has some faces twice, perhaps the other way round
inline void double_faces(Random_numbers& random, Surface_soup& soup)
{
  for(int count = 1 + random.below(3); count > 0; --count) {
    Soup_face face = soup.faces[random_face(random, soup)];
    if(random(0, 1) < 0.5)
      std::reverse(face.begin(), face.end());
    soup.faces.push_back(std::move(face));
  }
}

/// makes one vertex of two that have no face in common
inline void pinch(Random_numbers& random, Surface_soup& soup)
{
  for(int count = 1 + random.below(3); count > 0; --count) {
    const std::size_t v = random_vertex(random, soup), w = random_vertex(random, soup);
    const auto has = [](const Soup_face& face, std::size_t u) {
      return std::find(face.begin(), face.end(), u) != face.end();
    };
    if(std::any_of(soup.faces.begin(), soup.faces.end(),
                   [&](const Soup_face& face) { return has(face, v) && has(face, w); }))
      continue;
    for(Soup_face& face : soup.faces)
      std::replace(face.begin(), face.end(), v, w);
  }
}

/// gives some faces vertices of their own, as files of triangles without indices do
inline void tear(Random_numbers& random, Surface_soup& soup)
{
  for(int count = random_count(random, soup.faces.size() / 4); count > 0; --count) {
    std::size_t& v = soup.faces[random_face(random, soup)][0];
    const Eigen::Vector3d p = soup.points[v];
    v = soup.points.size();
    soup.points.push_back(p);
  }
}

/// rounds coordinates to a coarse grid: faces lose their area, and vertices meet
inline void snap(Random_numbers& random, Surface_soup& soup)
{
  const double step = extent_of(soup) * random_magnitude(random, 1e-3, 0.5);
  if(!(step > 0))
    return;
  for(Eigen::Vector3d& p : soup.points)
    p = ((p / step).array().round() * step).matrix();
}

/// moves some vertices far away from the others
inline void draw_out_spikes(Random_numbers& random, Surface_soup& soup)
{
  const double length = extent_of(soup) * random_magnitude(random, 0.1, 1e6);
  for(int count = random_count(random, soup.points.size() / 8); count > 0; --count)
    soup.points[random_vertex(random, soup)] += length * random_point(random);
}

/// moves some vertices onto neighbors, or near them
inline void move_together(Random_numbers& random, Surface_soup& soup)
{
  for(int count = random_count(random, soup.points.size() / 2); count > 0; --count) {
    const Soup_face& face = soup.faces[random_face(random, soup)];
    const double share = random(0, 1) < 0.3 ? 0 : random_magnitude(random, 1e-18, 1);
    const Eigen::Vector3d from = soup.points[face[0]], to = soup.points[face[1]];
    soup.points[face[0]] = to + share * (from - to);
  }
}

/// moves all vertices at random: the surface runs through itself
inline void crumple(Random_numbers& random, Surface_soup& soup)
{
  const double length = extent_of(soup) * random_magnitude(random, 1e-6, 1);
  for(Eigen::Vector3d& p : soup.points)
    p += length * random_point(random);
}

/// makes all triangles needles, or flat
inline void flatten(Random_numbers& random, Surface_soup& soup)
{
  const double factor = random(0, 1) < 0.2 ? 0 : random_magnitude(random, 1e-12, 1);
  const int axis = random.below(3);
  for(Eigen::Vector3d& p : soup.points)
    p[axis] *= factor;
}

/// makes all tiny or huge, or moves it far away
inline void scale(Random_numbers& random, Surface_soup& soup)
{
  const double factor = random(0, 1) < 0.3 ? 1 : random_magnitude(random, 1e-100, 1e100);
  const double distance = random(0, 1) < 0.5 ? 0 : factor * random_magnitude(random, 1, 1e18);
  for(Eigen::Vector3d& p : soup.points)
    p = factor * p + distance * Eigen::Vector3d(1, -0.3, 0.7);
}

/// splits polygons by diagonals from a random corner
inline void split_polygons(Random_numbers& random, Surface_soup& soup)
{
  std::vector<Soup_face> triangles;
  for(Soup_face& face : soup.faces) {
    std::rotate(face.begin(), face.begin() + random.below(static_cast<int>(face.size())), face.end());
    for(std::size_t k = 1; k + 1 < face.size(); ++k)
      triangles.push_back({face[0], face[k], face[k + 1]});
  }
  soup.faces = std::move(triangles);
}

#endif // CGAL_EXT_FUZZ_DAMAGE_SURFACE_H
