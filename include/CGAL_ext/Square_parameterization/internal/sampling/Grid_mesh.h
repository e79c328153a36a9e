// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SAMPLING_GRID_MESH_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SAMPLING_GRID_MESH_H

#include <CGAL_ext/Square_parameterization/Grid_size.h>
#include <CGAL_ext/Square_parameterization/internal/common/Disjoint_sets.h>
#include <CGAL_ext/Square_parameterization/internal/cut/cut_open.h>
#include <CGAL_ext/Square_parameterization/internal/sampling/grid_border.h>
#include <CGAL_ext/Square_parameterization/internal/surface/Triangle_surface.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <set>
#include <utility>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// per sample of a grid, row by row, the first of those that are the same point of the surface
/// \param seam_samples pairs of samples of the border that are the same point, counted counter-clockwise from (0, 0)
inline std::vector<std::size_t> welded_samples(const Grid_size& grid,
                                               const std::vector<std::array<int, 2>>& seam_samples)
{
  const int border_samples = number_of_border_samples(grid);
  Disjoint_sets points(border_samples);
  for(const auto& [a, b] : seam_samples)
    points.union_set(a, b);
  std::vector<std::size_t> first(border_samples, grid.number_of_samples()); // of each point
  for(int k = 0; k < border_samples; ++k) {
    std::size_t& sample = first[points.find_set(k)];
    sample = (std::min)(sample, grid_sample(k, grid));
  }
  std::vector<std::size_t> result(grid.number_of_samples());
  for(std::size_t s = 0; s < result.size(); ++s)
    result[s] = s;
  for(int k = 0; k < border_samples; ++k)
    result[grid_sample(k, grid)] = first[points.find_set(k)];
  return result;
}

/// a surface rebuilt from samples of a grid
struct Grid_mesh
{
  std::vector<std::size_t> samples;          ///< #V, the sample of each vertex, row by row
  std::vector<std::array<int, 3>> triangles; ///< #F, two for each square of the grid, oriented as the grid is
};

/// rebuilds a surface from samples: splits each square of the grid by its shorter diagonal, or by the other one where
/// the shorter joins two vertices that an edge joins already, as beside the end of a seam. Where a seam ends at a corner
/// of the grid the square there is folded to nothing, and left out with the sample at the corner.
/// \param points one per sample
/// \param welded as `welded_samples()` gives them
class Grid_mesh_builder
{
public:
  Grid_mesh_builder(const Grid_size& grid, const std::vector<Eigen::Vector3d>& points,
                    const std::vector<std::size_t>& welded)
    : m_grid(grid), m_points(points), m_vertices(welded.size(), -1)
  {
    double extent = 0;
    for(const Eigen::Vector3d& p : points)
      extent = (std::max)(extent, p.cwiseAbs().maxCoeff());
    if(extent > 0)
      m_scale = 1 / extent;
    for(int j : {0, grid.height - 1})
      for(int i : {0, grid.width - 1}) {
        const std::size_t beside = sample(i == 0 ? 1 : i - 1, j), above = sample(i, j == 0 ? 1 : j - 1);
        if(welded[beside] == welded[above])
          m_folded.insert(sample(i, j));
      }
    for(std::size_t s = 0; s < welded.size(); ++s) {
      if(m_folded.count(s) != 0)
        continue;
      int& vertex = m_vertices[welded[s]];
      if(vertex < 0) {
        vertex = static_cast<int>(m_mesh.samples.size());
        m_mesh.samples.push_back(welded[s]);
      }
      m_vertices[s] = vertex;
    }
  }

  Grid_mesh operator()()
  {
    add_border_edges();
    m_mesh.triangles.reserve(2 * m_grid.number_of_samples());
    for(int j = 0; j + 1 < m_grid.height; ++j)
      for(int i = 0; i + 1 < m_grid.width; ++i)
        add_square(i, j);
    return std::move(m_mesh);
  }

private:
  typedef std::pair<int, int> Edge;

  std::size_t sample(int i, int j) const { return static_cast<std::size_t>(j) * m_grid.width + i; }

  bool is_beside_border(int i, int j) const
  {
    return i == 0 || j == 0 || i + 2 == m_grid.width || j + 2 == m_grid.height;
  }

  double squared_length(std::size_t a, std::size_t b) const
  {
    return ((m_points[a] - m_points[b]) * m_scale).squaredNorm();
  }

  bool is_folded(int i, int j) const
  {
    return !m_folded.empty() && (m_folded.count(sample(i, j)) != 0 || m_folded.count(sample(i + 1, j)) != 0 ||
                                 m_folded.count(sample(i, j + 1)) != 0 || m_folded.count(sample(i + 1, j + 1)) != 0);
  }

  Edge edge(std::size_t a, std::size_t b) const { return std::minmax(m_vertices[a], m_vertices[b]); }

  /// remembers the sides of the squares along the border: no other edges can be met a second time
  void add_border_edges()
  {
    for(int j = 0; j + 1 < m_grid.height; ++j)
      for(int i = 0; i + 1 < m_grid.width; ++i)
        if(is_beside_border(i, j) && !is_folded(i, j))
          for(std::size_t corner : {sample(i, j), sample(i + 1, j + 1)})
            for(std::size_t next : {sample(i + 1, j), sample(i, j + 1)})
              m_edges.insert(edge(corner, next));
  }

  void add_square(int i, int j)
  {
    const std::size_t a = sample(i, j), b = sample(i + 1, j), c = sample(i + 1, j + 1), d = sample(i, j + 1);
    if(is_folded(i, j))
      return;
    bool is_ac = squared_length(a, c) <= squared_length(b, d);
    if(is_beside_border(i, j)) {
      const auto is_possible = [this](const Edge& diagonal) {
        return diagonal.first != diagonal.second && m_edges.count(diagonal) == 0;
      };
      if(is_possible(edge(a, c)) != is_possible(edge(b, d)))
        is_ac = is_possible(edge(a, c));
      m_edges.insert(is_ac ? edge(a, c) : edge(b, d));
    }
    if(is_ac) {
      add_triangle(a, b, c);
      add_triangle(a, c, d);
    } else {
      add_triangle(a, b, d);
      add_triangle(b, c, d);
    }
  }

  void add_triangle(std::size_t a, std::size_t b, std::size_t c)
  {
    m_mesh.triangles.push_back({m_vertices[a], m_vertices[b], m_vertices[c]});
  }

  const Grid_size m_grid;
  const std::vector<Eigen::Vector3d>& m_points;
  double m_scale = 1;             // the square of no length times it overflows or vanishes
  std::vector<int> m_vertices;    // per sample
  std::set<std::size_t> m_folded; // corners of the grid at which seams end
  std::set<Edge> m_edges;         // that are at the border, or beside it
  Grid_mesh m_mesh;
};

/// what a set of triangles is made of
struct Surface_topology
{
  bool is_closed = false;   ///< every edge belongs to two triangles
  bool is_manifold = false; ///< every edge belongs to at most two, oriented alike; those of every vertex form one fan
  int genus = 0;            ///< of a connected surface that is manifold
};

/// \param triangles such that every vertex belongs to one
inline Surface_topology topology_of(std::size_t number_of_vertices, const std::vector<std::array<int, 3>>& triangles)
{
  Surface_topology topology;
  Edge_numbering numbering = number_edges(number_of_vertices, triangles);
  const auto& uses = numbering.number_of_triangles;
  topology.is_closed = std::all_of(uses.begin(), uses.end(), [](int n) { return n == 2; });
  std::vector<int> balance(numbering.edges.size(), 0); // triangles that go along the edge, less those against it
  bool is_manifold = std::all_of(uses.begin(), uses.end(), [](int n) { return n <= 2; });
  for(std::size_t f = 0; f < triangles.size(); ++f)
    for(int k = 0; k < 3; ++k) {
      const int a = triangles[f][(k + 1) % 3], b = triangles[f][(k + 2) % 3];
      balance[numbering.triangle_edges[f][k]] += a < b ? 1 : -1;
      is_manifold = is_manifold && a != b;
    }
  for(std::size_t e = 0; e < uses.size() && is_manifold; ++e)
    is_manifold = uses[e] == 1 || balance[e] == 0;
  if(!is_manifold)
    return topology;
  const Triangle_surface surface = make_triangle_surface(
      std::vector<Eigen::Vector3d>(number_of_vertices, Eigen::Vector3d(0, 0, 0)), triangles, std::move(numbering));
  const auto no_seam = [](int) { return false; };
  topology.is_manifold = cut_open(surface, no_seam).originals.size() == number_of_vertices; // no fan is copied
  topology.genus = surface.genus();
  return topology;
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SAMPLING_GRID_MESH_H
