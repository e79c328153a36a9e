// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_FUZZ_RANDOM_BODIES_H
#define CGAL_EXT_FUZZ_RANDOM_BODIES_H

#include "test_meshes.h"

#include <CGAL_ext/Square_parameterization/internal/soup/Surface_soup.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

// Surfaces of quads and triangles with random shapes, of about as many faces as asked for. Each is sound: what makes it
// go wrong is done to it afterwards.

using CGAL_ext::internal::Surface_soup;

/// between two positive numbers, each power of ten as likely as another
inline double random_magnitude(Random_numbers& random, double low, double high)
{
  return low * std::pow(high / low, random(0, 1));
}

/// m times n quads, more of one than of the other
struct Grid_size
{
  int m, n;
};

inline Grid_size random_grid_size(Random_numbers& random, int faces, int least)
{
  const double quads = (std::max)(1., faces / 2.), ratio = random_magnitude(random, 1 / quads, quads);
  const int m = (std::max)(least, static_cast<int>(std::sqrt(quads * ratio)));
  return {m, (std::max)(least, static_cast<int>(quads / m))};
}

/// m times n quads; \p point takes the places (s, t) in [0, 1] x [0, 1] of their corners. Sides that are joined make it a
/// tube or a torus.
template <class Point>
Surface_soup quad_grid(Grid_size size, bool joins_s, bool joins_t, const Point& point)
{
  Surface_soup soup;
  const auto& [m, n] = size;
  const int rows = joins_s ? m : m + 1, columns = joins_t ? n : n + 1;
  for(int i = 0; i < rows; ++i)
    for(int j = 0; j < columns; ++j)
      soup.points.push_back(point(double(i) / m, double(j) / n));
  const auto index = [rows = rows, columns = columns](int i, int j) {
    return static_cast<std::size_t>((i % rows) * columns + j % columns);
  };
  for(int i = 0; i < m; ++i)
    for(int j = 0; j < n; ++j)
      soup.faces.push_back({index(i, j), index(i + 1, j), index(i + 1, j + 1), index(i, j + 1)});
  return soup;
}

/// a flat, wavy or rough rectangle
inline Surface_soup random_sheet(Random_numbers& random, int faces)
{
  const double width = random_magnitude(random, 0.01, 100), wave = random(0, 1) < 0.5 ? 0 : random(0, 1),
               noise = random(0, 1) < 0.5 ? 0 : random_magnitude(random, 1e-12, 1);
  return quad_grid(random_grid_size(random, faces, 1), false, false, [&](double s, double t) {
    return Eigen::Vector3d(width * s, t, wave * std::sin(9 * s) * std::cos(7 * t) + noise * random(-1, 1));
  });
}

/// a sheet folded up to fins, side by side or one within the other
inline Surface_soup random_fins(Random_numbers& random, int faces)
{
  const double height = random_magnitude(random, 0.1, 100), gap = random_magnitude(random, 1e-6, 1),
               growth = random(0, 1) < 0.5 ? 1 : random(0.5, 1.5);
  const Grid_size size = random_grid_size(random, faces, 2);
  return quad_grid(size, false, false, [&](double s, double t) {
    const int fold = static_cast<int>(std::lround(s * size.m));
    return Eigen::Vector3d(gap * fold, t, fold % 2 * height * std::pow(growth, (std::min)(fold, 40)));
  });
}

/// a strip wound up to a spiral, in a plane, or to a helix
inline Surface_soup random_spiral(Random_numbers& random, int faces)
{
  const double turns = random_magnitude(random, 0.5, 30), pitch = random(0, 1) < 0.5 ? 0 : random(0, 3),
               width = random_magnitude(random, 0.01, 0.9);
  Grid_size size = random_grid_size(random, faces, 1);
  size = {(std::max)(size.m, size.n), (std::min)(size.m, size.n)};
  return quad_grid(size, false, false, [&](double s, double t) {
    const double angle = 2 * PI * turns * s, radius = 1 + turns * s - width * t;
    return Eigen::Vector3d(radius * std::cos(angle), radius * std::sin(angle), pitch * angle);
  });
}

/// a tube, long or wide or conical or wavy, with open ends or with one or two that are closed by a fan
inline Surface_soup random_tube(Random_numbers& random, int faces)
{
  const double length = random_magnitude(random, 0.01, 1000), taper = random_magnitude(random, 1e-4, 1),
               wave = random(0, 1) < 0.5 ? 0 : random(0, 0.9);
  const Grid_size size = random_grid_size(random, faces, 3);
  Surface_soup soup = quad_grid(size, false, true, [&](double s, double t) {
    const double radius = std::pow(taper, s) * (1 + wave * std::sin(20 * s));
    return Eigen::Vector3d(radius * std::cos(2 * PI * t), radius * std::sin(2 * PI * t), length * s);
  });
  const int closed_ends = random.below(3);
  for(int end = 0; end < closed_ends; ++end) {
    const auto apex = soup.points.size(), first = static_cast<std::size_t>(end == 0 ? 0 : size.m * size.n);
    soup.points.emplace_back(0, 0, end == 0 ? 0 : length);
    for(int j = 0; j < size.n; ++j) {
      const std::size_t a = first + static_cast<std::size_t>(j), b = first + static_cast<std::size_t>((j + 1) % size.n);
      soup.faces.push_back(end == 0 ? std::vector<std::size_t>{apex, a, b} : std::vector<std::size_t>{b, a, apex});
    }
  }
  return soup;
}

/// a torus, thick or thin, round or drawn out
inline Surface_soup random_torus(Random_numbers& random, int faces)
{
  const double thickness = random_magnitude(random, 1e-6, 0.9), stretch = random_magnitude(random, 1, 1000);
  return quad_grid(random_grid_size(random, faces, 3), true, true, [&](double s, double t) {
    const double u = 2 * PI * s, v = 2 * PI * t, radius = 1 + thickness * std::cos(v);
    return Eigen::Vector3d(stretch * radius * std::cos(u), radius * std::sin(u), thickness * std::sin(v));
  });
}

/// triangles round a point, or round two as a closed surface; some reach far out
inline Surface_soup random_fan(Random_numbers& random, int faces)
{
  const bool is_double = random(0, 1) < 0.5;
  const std::size_t spokes = static_cast<std::size_t>((std::max)(3, is_double ? faces / 2 : faces));
  const double reach = random_magnitude(random, 1, 1e6), height = random_magnitude(random, 1e-9, 1e3);
  Surface_soup soup;
  for(std::size_t k = 0; k < spokes; ++k) {
    const double angle = 2 * PI * double(k) / double(spokes), radius = random_magnitude(random, 1, reach);
    soup.points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0);
  }
  soup.points.emplace_back(0, 0, height);
  if(is_double)
    soup.points.emplace_back(0, 0, -height);
  for(std::size_t k = 0; k < spokes; ++k) {
    soup.faces.push_back({spokes, k, (k + 1) % spokes});
    if(is_double)
      soup.faces.push_back({spokes + 1, (k + 1) % spokes, k});
  }
  return soup;
}

/// the surface of cubes in a box: a plate or a bar, whole or with holes, or a heap. It is not manifold where cubes meet
/// at an edge.
inline Surface_soup random_cubes(Random_numbers& random, int faces)
{
  const int longest = (std::max)(1, static_cast<int>(std::sqrt(faces / 4.)));
  std::array<int, 3> size;
  for(int& cubes : size)
    cubes = (std::min)(longest, 1 + random.below(random(0, 1) < 0.4 ? 1 : 12));
  // with what likelihood a cube is there; a lattice of holes leaves a plate manifold
  const double filling = random(0, 1) < 0.3 ? random(0.5, 1) : 1;
  const bool has_lattice = random(0, 1) < 0.4;
  std::map<std::array<int, 3>, bool> cubes;
  for(int x = 0; x < size[0]; ++x)
    for(int y = 0; y < size[1]; ++y)
      for(int z = 0; z < size[2]; ++z)
        cubes[{x, y, z}] = !(has_lattice && x % 2 == 1 && y % 2 == 1) && random(0, 1) < filling;
  cubes[{0, 0, 0}] = true;

  Surface_soup soup;
  std::map<std::array<int, 3>, std::size_t> points;
  const auto index = [&](const std::array<int, 3>& p) {
    const auto [place, is_new] = points.try_emplace(p, soup.points.size());
    if(is_new)
      soup.points.emplace_back(p[0], p[1], p[2]);
    return place->second;
  };
  for(const auto& [cube, is_there] : cubes)
    for(int side = 0; is_there && side < 6; ++side) {
      const auto axis = static_cast<std::size_t>(side / 2), u = (axis + 1) % 3, v = (axis + 2) % 3;
      std::array<int, 3> neighbor = cube, corner = cube;
      neighbor[axis] += side % 2 == 1 ? 1 : -1;
      if(const auto found = cubes.find(neighbor); found != cubes.end() && found->second)
        continue;
      corner[axis] += side % 2;
      std::vector<std::size_t> face;
      for(const auto& [du, dv] : std::array<std::pair<int, int>, 4>{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}}) {
        std::array<int, 3> p = corner;
        p[u] += du;
        p[v] += dv;
        face.push_back(index(p));
      }
      if(side % 2 == 0)
        std::reverse(face.begin(), face.end());
      soup.faces.push_back(std::move(face));
    }
  return soup;
}

/// a body and what it is called
struct Random_body
{
  const char* name;
  Surface_soup (*make)(Random_numbers& random, int faces);
};

inline const std::vector<Random_body>& random_bodies()
{
  static const std::vector<Random_body> bodies{
      {"sheet", random_sheet}, {"fins", random_fins}, {"spiral", random_spiral}, {"tube", random_tube},
      {"torus", random_torus}, {"fan", random_fan},   {"cubes", random_cubes}};
  return bodies;
}

#endif // CGAL_EXT_FUZZ_RANDOM_BODIES_H
