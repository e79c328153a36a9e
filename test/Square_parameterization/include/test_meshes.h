// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Disks for the tests, as flat arrays. All are deterministic and irregular where a regular mesh would hide a defect.

#ifndef CGAL_EXT_TEST_MESHES_H
#define CGAL_EXT_TEST_MESHES_H

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

constexpr double PI = 3.14159265358979323846;

/// a disk: points, triangles (counter-clockwise) and the border vertices, counter-clockwise from the one of lowest
/// index
struct Flat_mesh
{
  std::vector<Eigen::Vector3d> points;
  std::vector<std::array<int, 3>> triangles;
  std::vector<int> border;
};

/// numbers that are the same on every platform: the distributions of the standard library are not
class Random_numbers
{
public:
  explicit Random_numbers(unsigned int seed) : m_engine(seed) {}

  /// uniform in [low, high[
  double operator()(double low, double high) { return low + (high - low) * (double(m_engine()) / 4294967296.0); }

  int below(int n) { return static_cast<int>((*this)(0, n)); }

private:
  std::mt19937 m_engine;
};

/// a flat rectangle [0, width] x [0, height] of columns x rows cells. Points are moved by up to `jitter` cells, border
/// points along the border, corners not at all; the diagonals are random, but no corner is an ear.
/// \pre jitter < 0.25, for which no triangle can turn over
inline Flat_mesh rectangle(int columns, int rows, double width, double height, unsigned int seed, double jitter = 0.2)
{
  Flat_mesh mesh;
  Random_numbers random(seed);
  const auto index = [columns](int i, int j) { return j * (columns + 1) + i; };
  for(int j = 0; j <= rows; ++j)
    for(int i = 0; i <= columns; ++i) {
      const double dx = random(-jitter, jitter), dy = random(-jitter, jitter);
      mesh.points.emplace_back((i + (i % columns == 0 ? 0 : dx)) / columns * width,
                               (j + (j % rows == 0 ? 0 : dy)) / rows * height, 0);
    }
  for(int j = 0; j < rows; ++j)
    for(int i = 0; i < columns; ++i) {
      const int a = index(i, j), b = index(i + 1, j), c = index(i + 1, j + 1), d = index(i, j + 1);
      bool rising = random(0, 1) < 0.5;
      if((i == 0 && j == 0) || (i == columns - 1 && j == rows - 1))
        rising = true;
      else if((i == columns - 1 && j == 0) || (i == 0 && j == rows - 1))
        rising = false;
      if(rising) {
        mesh.triangles.push_back({a, b, c});
        mesh.triangles.push_back({a, c, d});
      } else {
        mesh.triangles.push_back({a, b, d});
        mesh.triangles.push_back({b, c, d});
      }
    }
  for(int i = 0; i < columns; ++i)
    mesh.border.push_back(index(i, 0));
  for(int j = 0; j < rows; ++j)
    mesh.border.push_back(index(columns, j));
  for(int i = columns; i > 0; --i)
    mesh.border.push_back(index(i, rows));
  for(int j = rows; j > 0; --j)
    mesh.border.push_back(index(0, j));
  return mesh;
}

/// the flat unit square, irregularly triangulated, corners kept
inline Flat_mesh unit_square(int n, unsigned int seed = 1)
{
  return rectangle(n, n, 1, 1, seed);
}

/// moves every point: `f` takes the old position
template <class Function>
Flat_mesh transformed(Flat_mesh mesh, Function f)
{
  for(Eigen::Vector3d& p : mesh.points)
    p = f(Eigen::Vector3d(p));
  return mesh;
}

inline Flat_mesh scaled(const Flat_mesh& mesh, double factor)
{
  return transformed(mesh, [factor](const Eigen::Vector3d& p) -> Eigen::Vector3d { return factor * p; });
}

inline Flat_mesh translated(const Flat_mesh& mesh, const Eigen::Vector3d& by)
{
  return transformed(mesh, [by](const Eigen::Vector3d& p) -> Eigen::Vector3d { return p + by; });
}

inline Flat_mesh saddle(int n, unsigned int seed = 2)
{
  return transformed(rectangle(n, n, 1, 1, seed), [](const Eigen::Vector3d& p) {
    const double x = 2 * p.x() - 1, y = 2 * p.y() - 1;
    return Eigen::Vector3d(x, y, x * x - y * y);
  });
}

/// a bumpy height field over the unit square: waves and noise
inline Flat_mesh noisy_height_field(int n, unsigned int seed = 3)
{
  Random_numbers random(seed + 1000);
  return transformed(rectangle(n, n, 1, 1, seed), [&random](const Eigen::Vector3d& p) {
    const double waves = 0.15 * std::sin(7 * p.x()) * std::cos(5 * p.y()) + 0.1 * p.x() * p.x();
    return Eigen::Vector3d(p.x(), p.y(), waves + random(-0.01, 0.01));
  });
}

/// a flat strip forty times as long as wide
inline Flat_mesh long_strip(int n = 60, unsigned int seed = 4)
{
  return rectangle(n, 3, 40, 1, seed);
}

/// a ribbon wound up in a plane to a spiral of two turns
inline Flat_mesh spiral(int n = 80, unsigned int seed = 5)
{
  return transformed(rectangle(n, 3, 1, 1, seed), [](const Eigen::Vector3d& p) {
    const double angle = 4 * PI * p.x(), radius = 1 + 0.2 * angle - 0.5 * p.y();
    return Eigen::Vector3d(radius * std::cos(angle), radius * std::sin(angle), 0);
  });
}

/// a disk of rings around a centre, vertex 0; `f` takes the distance from the centre, in [0, 1], and the angle. Both
/// are jittered, the distance of the border is not.
template <class Function>
Flat_mesh polar_disk(int rings, int sectors, unsigned int seed, Function f)
{
  Flat_mesh mesh;
  Random_numbers random(seed);
  mesh.points.push_back(f(0., 0.));
  for(int r = 1; r <= rings; ++r)
    for(int s = 0; s < sectors; ++s) {
      const double dr = r < rings ? random(-0.2, 0.2) : 0, ds = random(-0.2, 0.2);
      mesh.points.push_back(f((r + dr) / rings, 2 * PI * (s + ds) / sectors));
    }
  const auto index = [sectors](int r, int s) { return 1 + (r - 1) * sectors + s % sectors; };
  for(int s = 0; s < sectors; ++s) {
    mesh.triangles.push_back({0, index(1, s), index(1, s + 1)});
    for(int r = 1; r < rings; ++r) {
      mesh.triangles.push_back({index(r, s), index(r + 1, s), index(r + 1, s + 1)});
      mesh.triangles.push_back({index(r, s), index(r + 1, s + 1), index(r, s + 1)});
    }
    mesh.border.push_back(index(rings, s));
  }
  return mesh;
}

/// a flat disk of radius 1
inline Flat_mesh flat_disk(int rings = 5, int sectors = 17, unsigned int seed = 6)
{
  return polar_disk(rings, sectors, seed,
                    [](double r, double t) { return Eigen::Vector3d(r * std::cos(t), r * std::sin(t), 0); });
}

inline Flat_mesh cone(double height = 2, int rings = 5, int sectors = 17, unsigned int seed = 7)
{
  return polar_disk(rings, sectors, seed, [height](double r, double t) {
    return Eigen::Vector3d(r * std::cos(t), r * std::sin(t), height * (1 - r));
  });
}

inline Flat_mesh hemisphere(int rings = 6, int sectors = 21, unsigned int seed = 8)
{
  return polar_disk(rings, sectors, seed, [](double r, double t) {
    const double polar = r * PI / 2;
    return Eigen::Vector3d(std::sin(polar) * std::cos(t), std::sin(polar) * std::sin(t), std::cos(polar));
  });
}

/// a tube of four sides, closed at one end, with points moved by up to half its radius: a long way from the border of four
/// vertices to the other end
inline Flat_mesh crumpled_tube(int rings, unsigned int seed)
{
  Flat_mesh mesh;
  Random_numbers random(seed);
  const auto add_point = [&](double x, double y, double z) {
    mesh.points.emplace_back(x + random(-0.5, 0.5), y + random(-0.5, 0.5), z + random(-0.5, 0.5));
  };
  for(int i = 0; i < rings; ++i)
    for(int j = 0; j < 4; ++j)
      add_point(std::cos(j * PI / 2), std::sin(j * PI / 2), i * PI / 2);
  add_point(0, 0, (rings - 1) * PI / 2);
  for(int i = 0; i < rings; ++i)
    for(int j = 0; j < 4; ++j) {
      const int a = 4 * i + j, b = 4 * i + (j + 1) % 4;
      if(i + 1 < rings) {
        mesh.triangles.push_back({a, b, b + 4});
        mesh.triangles.push_back({a, b + 4, a + 4});
      } else
        mesh.triangles.push_back({a, b, 4 * rings});
    }
  mesh.border = {0, 1, 2, 3};
  return mesh;
}

/// a regular fan of `spokes` triangles around vertex 0; every `period`-th of its rim edges carries an ear, a triangle
/// with two border edges, so that the edge is a chord
inline Flat_mesh fan_with_ears(int spokes = 12, int period = 3)
{
  Flat_mesh mesh;
  const auto on_circle = [spokes](double s, double radius) {
    const double t = 2 * PI * s / spokes;
    return Eigen::Vector3d(radius * std::cos(t), radius * std::sin(t), 0);
  };
  mesh.points.emplace_back(0, 0, 0);
  for(int s = 0; s < spokes; ++s)
    mesh.points.push_back(on_circle(s, 1));
  for(int s = 0; s < spokes; ++s) {
    const int a = 1 + s, b = 1 + (s + 1) % spokes;
    mesh.triangles.push_back({0, a, b});
    mesh.border.push_back(a);
    if(s % period == 0) {
      const int apex = static_cast<int>(mesh.points.size());
      mesh.points.push_back(on_circle(s + 0.5, 1.3));
      mesh.triangles.push_back({a, apex, b});
      mesh.border.push_back(apex);
    }
  }
  return mesh;
}

/// the same disk with its border counted from another vertex
inline Flat_mesh with_border_from(Flat_mesh mesh, int first)
{
  std::rotate(mesh.border.begin(), mesh.border.begin() + first, mesh.border.end());
  return mesh;
}

#endif // CGAL_EXT_TEST_MESHES_H
