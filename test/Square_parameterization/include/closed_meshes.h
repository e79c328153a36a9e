// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Closed and holed surfaces for the tests, as flat arrays.

#ifndef CGAL_EXT_CLOSED_MESHES_H
#define CGAL_EXT_CLOSED_MESHES_H

#include "test_meshes.h"

#include <CGAL_ext/Square_parameterization/internal/surface/Surface_arrays.h>
#include <CGAL_ext/Square_parameterization/internal/surface/Triangle_surface.h>

#include <functional>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

/// points and oriented triangles of any topology; no vertex is without a triangle
struct Closed_mesh
{
  std::vector<Eigen::Vector3d> points;
  std::vector<std::array<int, 3>> triangles;
};

inline CGAL_ext::internal::Triangle_surface surface_of(const Closed_mesh& mesh)
{
  return CGAL_ext::internal::make_triangle_surface(mesh.points, mesh.triangles);
}

/// the same as a mesh is read
inline CGAL_ext::internal::Surface_arrays arrays_of(const Closed_mesh& mesh)
{
  CGAL_ext::internal::Surface_arrays arrays;
  arrays.points = mesh.points;
  arrays.triangles = mesh.triangles;
  for(const auto& loop : surface_of(mesh).border_loops)
    arrays.border_sides += loop.size();
  return arrays;
}

inline Closed_mesh tetrahedron()
{
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
}

/// two triangles back to back
inline Closed_mesh pillow()
{
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {2, 1, 0}}};
}

/// an octahedron split `levels` times at the midpoints of its edges, stretched to an ellipsoid of radii 1, 1, `height`
inline Closed_mesh ellipsoid(int levels, double height = 1)
{
  Closed_mesh mesh{{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
                   {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
  for(int level = 0; level < levels; ++level) {
    std::map<std::pair<int, int>, int> middle;
    const auto middle_of = [&](int a, int b) {
      const auto [entry, is_new] = middle.emplace(std::minmax(a, b), static_cast<int>(mesh.points.size()));
      if(is_new) {
        const Eigen::Vector3d p = mesh.points[a] + mesh.points[b];
        mesh.points.push_back(p.normalized());
      }
      return entry->second;
    };
    std::vector<std::array<int, 3>> finer;
    for(const auto& [a, b, c] : mesh.triangles) {
      const int ab = middle_of(a, b), bc = middle_of(b, c), ca = middle_of(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    mesh.triangles = std::move(finer);
  }
  for(Eigen::Vector3d& p : mesh.points)
    p.z() *= height;
  return mesh;
}

/// two lids of n triangles each on one regular polygon of radius 1, at heights +1 and -1: closed; or only the upper one
inline Closed_mesh lids(int n, bool is_closed = true)
{
  Closed_mesh mesh;
  for(int i = 0; i < n; ++i)
    mesh.points.emplace_back(std::cos(2 * PI * i / n), std::sin(2 * PI * i / n), 0);
  mesh.points.emplace_back(0, 0, 1);
  if(is_closed)
    mesh.points.emplace_back(0, 0, -1);
  for(int i = 0; i < n; ++i) {
    mesh.triangles.push_back({i, (i + 1) % n, n});
    if(is_closed)
      mesh.triangles.push_back({(i + 1) % n, i, n + 1});
  }
  return mesh;
}

/// a disk of a given height and radius 1 on a regular polygon of n corners, whose lids are split into strips, without
/// vertices inside
inline Closed_mesh coin(int n, double height)
{
  Closed_mesh mesh;
  for(double z : {0., height})
    for(int i = 0; i < n; ++i)
      mesh.points.emplace_back(std::cos(2 * PI * i / n), std::sin(2 * PI * i / n), z);
  for(int i = 0; i < n; ++i) {
    const int next = (i + 1) % n;
    mesh.triangles.push_back({i, next, n + next});
    mesh.triangles.push_back({i, n + next, n + i});
  }
  for(int low = 0, high = n - 1; high - low > 1;) {
    const bool is_low = low + high < n;
    const int third = is_low ? low + 1 : high - 1;
    mesh.triangles.push_back({n + low, n + third, n + high});
    mesh.triangles.push_back({low, high, third});
    (is_low ? low : high) = third;
  }
  return mesh;
}

/// a torus of m x n quadrilaterals, each cut in two, with radii 2 and 1
inline Closed_mesh torus(int m, int n)
{
  Closed_mesh mesh;
  for(int i = 0; i < m; ++i)
    for(int j = 0; j < n; ++j) {
      const double u = 2 * PI * i / m, v = 2 * PI * j / n;
      mesh.points.emplace_back((2 + std::cos(v)) * std::cos(u), (2 + std::cos(v)) * std::sin(u), std::sin(v));
    }
  const auto index = [m, n](int i, int j) { return (i % m) * n + j % n; };
  for(int i = 0; i < m; ++i)
    for(int j = 0; j < n; ++j) {
      mesh.triangles.push_back({index(i, j), index(i + 1, j), index(i + 1, j + 1)});
      mesh.triangles.push_back({index(i, j), index(i + 1, j + 1), index(i, j + 1)});
    }
  return mesh;
}

/// the outside of the unit cubes for which `is_filled(x, y, z)`, each face cut in two.
/// \pre no two cubes touch along an edge or in a corner alone
inline Closed_mesh voxels(int nx, int ny, int nz, const std::function<bool(int, int, int)>& is_filled)
{
  Closed_mesh mesh;
  std::map<std::array<int, 3>, int> numbers;
  const auto filled = [&](const std::array<int, 3>& c) {
    return c[0] >= 0 && c[1] >= 0 && c[2] >= 0 && c[0] < nx && c[1] < ny && c[2] < nz && is_filled(c[0], c[1], c[2]);
  };
  const auto vertex = [&](const std::array<int, 3>& c) {
    const auto [entry, is_new] = numbers.emplace(c, static_cast<int>(mesh.points.size()));
    if(is_new)
      mesh.points.emplace_back(c[0], c[1], c[2]);
    return entry->second;
  };
  for(int x = 0; x < nx; ++x)
    for(int y = 0; y < ny; ++y)
      for(int z = 0; z < nz; ++z)
        for(int axis = 0; axis < 3 && filled({x, y, z}); ++axis)
          for(const int side : {0, 1}) {
            std::array<int, 3> neighbor{x, y, z}, a{x, y, z};
            neighbor[axis] += side == 1 ? 1 : -1;
            if(filled(neighbor))
              continue;
            a[axis] += side;
            std::array<int, 3> b = a, c = a, d = a;
            const int first = (axis + (side == 1 ? 1 : 2)) % 3, second = 3 - axis - first;
            ++b[first], ++c[first], ++c[second], ++d[second];
            mesh.triangles.push_back({vertex(a), vertex(b), vertex(c)});
            mesh.triangles.push_back({vertex(a), vertex(c), vertex(d)});
          }
  return mesh;
}

/// a plate of (2 columns + 1) x (2 rows + 1) cubes with columns x rows holes through it: a closed surface of that genus
inline Closed_mesh plate_with_handles(int columns, int rows)
{
  return voxels(2 * columns + 1, 2 * rows + 1, 1, [](int x, int y, int) { return x % 2 == 0 || y % 2 == 0; });
}

/// the mesh without some triangles, and without the vertices that no triangle is left for
inline Closed_mesh without_triangles(const Closed_mesh& mesh, const std::set<int>& removed)
{
  Closed_mesh result;
  std::vector<int> numbers(mesh.points.size(), -1);
  for(std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    if(removed.count(static_cast<int>(f)) != 0)
      continue;
    std::array<int, 3> triangle = mesh.triangles[f];
    for(int& v : triangle) {
      if(numbers[v] < 0) {
        numbers[v] = static_cast<int>(result.points.size());
        result.points.push_back(mesh.points[v]);
      }
      v = numbers[v];
    }
    result.triangles.push_back(triangle);
  }
  return result;
}

/// the mesh without `count` random triangles, no two of which have a vertex in common
inline Closed_mesh with_holes(const Closed_mesh& mesh, int count, unsigned int seed)
{
  Random_numbers random(seed);
  std::set<int> removed, taken;
  for(int attempt = 0; attempt < 1000 && static_cast<int>(removed.size()) < count; ++attempt) {
    const int f = random.below(static_cast<int>(mesh.triangles.size()));
    const auto& t = mesh.triangles[f];
    if(taken.count(t[0]) + taken.count(t[1]) + taken.count(t[2]) > 0)
      continue;
    removed.insert(f);
    taken.insert(t.begin(), t.end());
  }
  return without_triangles(mesh, removed);
}

/// a rectangle with irregular points
inline Closed_mesh plane(int n, unsigned int seed)
{
  const Flat_mesh flat = rectangle(n, n, 1, 1, seed);
  return {flat.points, flat.triangles};
}

/// a plane with the cells removed for which `is_hole(i, j)`
inline Closed_mesh perforated_plane(int n, unsigned int seed, const std::function<bool(int, int)>& is_hole)
{
  std::set<int> removed;
  for(int j = 0; j < n; ++j)
    for(int i = 0; i < n; ++i)
      if(is_hole(i, j))
        removed.insert({2 * (j * n + i), 2 * (j * n + i) + 1});
  return without_triangles(plane(n, seed), removed);
}

/// a disk: a comb whose teeth are two cells wide and `n` - 2 cells long
inline Closed_mesh comb(int n, unsigned int seed)
{
  return perforated_plane(n, seed, [](int i, int j) { return j >= 2 && i % 4 >= 2; });
}

/// a plane with (n / 3)^2 holes, two cells apart
inline Closed_mesh sieve(int n, unsigned int seed)
{
  return perforated_plane(n, seed, [n](int i, int j) { return i % 3 == 1 && j % 3 == 1 && i < n - 1 && j < n - 1; });
}

struct Named_mesh
{
  std::string name;
  Closed_mesh mesh;
  int genus, loops;
};

/// surfaces of many topologies
inline std::vector<Named_mesh> many_surfaces()
{
  std::vector<Named_mesh> all{{"tetrahedron", tetrahedron(), 0, 0},
                              {"pillow", pillow(), 0, 0},
                              {"octahedron", ellipsoid(0), 0, 0},
                              {"sphere", ellipsoid(3), 0, 0},
                              {"cigar", ellipsoid(3, 5), 0, 0},
                              {"small torus", torus(3, 3), 1, 0},
                              {"torus", torus(16, 9), 1, 0},
                              {"genus 2", plate_with_handles(2, 1), 2, 0},
                              {"genus 3", plate_with_handles(3, 1), 3, 0},
                              {"genus 12", plate_with_handles(4, 3), 12, 0},
                              {"tetrahedron without a face", without_triangles(tetrahedron(), {1}), 0, 1}};
  for(unsigned int seed = 1; seed <= 5; ++seed) {
    const int holes = static_cast<int>(seed);
    const std::string name = " with " + std::to_string(holes) + " holes";
    all.push_back({"sphere" + name, with_holes(ellipsoid(3), holes, seed), 0, holes});
    all.push_back({"torus" + name, with_holes(torus(14, 11), holes, seed), 1, holes});
    all.push_back({"genus 4" + name, with_holes(plate_with_handles(2, 2), holes, seed), 4, holes});
  }
  return all;
}

#endif // CGAL_EXT_CLOSED_MESHES_H
