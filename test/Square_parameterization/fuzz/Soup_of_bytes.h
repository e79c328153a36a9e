// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_FUZZ_SOUP_OF_BYTES_H
#define CGAL_EXT_FUZZ_SOUP_OF_BYTES_H

#include <CGAL_ext/Square_parameterization/internal/soup/Surface_soup.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

/// bytes one after the other; zeros when they are used up
class Byte_source
{
public:
  Byte_source(const std::uint8_t* data, std::size_t size) : m_data(data), m_size(size) {}

  bool is_empty() const { return m_next >= m_size; }
  int next() { return is_empty() ? 0 : m_data[m_next++]; }
  std::size_t below(std::size_t n) { return (static_cast<std::size_t>(next()) * 256 + next()) % n; }

private:
  const std::uint8_t* m_data;
  std::size_t m_size, m_next = 0;
};

/// a small surface that bytes describe: a tetrahedron, a sheet, a torus, or a sheet and a tetrahedron; then vertices
/// are put into faces, edges flipped, holes and handles made, faces turned round, vertices moved near or onto others;
/// then all is scaled, flattened or moved, and faces are joined to polygons
class Soup_of_bytes
{
public:
  explicit Soup_of_bytes(Byte_source& bytes) : m_bytes(bytes)
  {
    start();
    const int transformation = m_bytes.next(), exponent = m_bytes.next();
    const bool has_polygons = m_bytes.next() % 4 == 3;
    constexpr int MOST_STEPS = 120;
    for(int i = 0; i < MOST_STEPS && !m_bytes.is_empty() && !m_soup.faces.empty(); ++i)
      step();
    transform(transformation, exponent);
    if(has_polygons)
      for(const auto& [a, b] : m_joined_edges)
        join_faces(a, b);
  }

  const CGAL_ext::internal::Surface_soup& soup() const { return m_soup; }

private:
  typedef std::vector<std::size_t> Face;

  Eigen::Vector3d some_point()
  {
    const auto coordinate = [this] { return (m_bytes.next() - 128) / 32.; };
    const double x = coordinate(), y = coordinate();
    return {x, y, coordinate()};
  }

  void start()
  {
    const int kind = m_bytes.next() % 4;
    const std::size_t m = 3 + m_bytes.next() % 4, n = 3 + m_bytes.next() % 4;
    if(kind != 0)
      add_grid(m, n, kind == 2);
    if(kind == 0 || kind == 3)
      add_tetrahedron();
  }

  void add_tetrahedron()
  {
    const std::size_t v = m_soup.points.size();
    for(const Eigen::Vector3d& p :
        {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0, 1, 0), Eigen::Vector3d(0, 0, 1)})
      m_soup.points.push_back(p);
    for(const Face& face :
        {Face{v, v + 2, v + 1}, Face{v, v + 1, v + 3}, Face{v + 1, v + 2, v + 3}, Face{v + 2, v, v + 3}})
      m_soup.faces.push_back(face);
  }

  /// a sheet, or a torus, of m times n points
  void add_grid(std::size_t m, std::size_t n, bool is_torus)
  {
    for(std::size_t i = 0; i < m; ++i)
      for(std::size_t j = 0; j < n; ++j) {
        const double u = 6.283185307 * double(i) / double(m), v = 6.283185307 * double(j) / double(n),
                     radius = 2 + std::cos(v);
        m_soup.points.push_back(is_torus ? Eigen::Vector3d(radius * std::cos(u), radius * std::sin(u), std::sin(v))
                                         : Eigen::Vector3d(double(i), double(j), 0));
      }
    const auto index = [m, n](std::size_t i, std::size_t j) { return (i % m) * n + j % n; };
    for(std::size_t i = 0; i + (is_torus ? 0 : 1) < m; ++i)
      for(std::size_t j = 0; j + (is_torus ? 0 : 1) < n; ++j) {
        m_soup.faces.push_back({index(i, j), index(i + 1, j), index(i + 1, j + 1)});
        m_soup.faces.push_back({index(i, j), index(i + 1, j + 1), index(i, j + 1)});
      }
  }

  void step()
  {
    const int kind = m_bytes.next() % 12;
    const std::size_t f = m_bytes.below(m_soup.faces.size());
    switch(kind) {
    case 1:
      flip_edge(f, m_bytes.next() % 3);
      break;
    case 2:
      remove_face(f, m_bytes.next() % 16 == 0);
      break;
    case 3:
      turn_face(f);
      break;
    case 4:
      move_onto_neighbor(f);
      break;
    case 5:
      move_onto_edge(f);
      break;
    case 6:
      m_soup.points[m_soup.faces[f][0]] = some_point();
      break;
    case 7:
      move_near_neighbor(f);
      break;
    case 8:
      add_tube(f, m_bytes.below(m_soup.faces.size()));
      break;
    case 9:
      m_joined_edges.emplace_back(m_soup.faces[f][0], m_soup.faces[f][1]);
      break;
    default:
      split_face(f);
    }
  }

  void split_face(std::size_t f)
  {
    const Face face = m_soup.faces[f];
    const std::size_t v = m_soup.points.size();
    m_soup.points.push_back((m_soup.points[face[0]] + m_soup.points[face[1]] + m_soup.points[face[2]]) / 3);
    m_soup.faces[f] = {face[0], face[1], v};
    m_soup.faces.push_back({face[1], face[2], v});
    m_soup.faces.push_back({face[2], face[0], v});
  }

  /// flips an edge of two faces that agree, unless the other diagonal is an edge
  void flip_edge(std::size_t f, std::size_t k)
  {
    const std::size_t a = m_soup.faces[f][k], b = m_soup.faces[f][(k + 1) % 3], c = m_soup.faces[f][(k + 2) % 3];
    std::size_t other = m_soup.faces.size(), d = 0;
    for(std::size_t g = 0; g < m_soup.faces.size(); ++g)
      for(std::size_t i = 0; i < 3; ++i)
        if(m_soup.faces[g][i] == b && m_soup.faces[g][(i + 1) % 3] == a) {
          other = g;
          d = m_soup.faces[g][(i + 2) % 3];
        }
    if(other == m_soup.faces.size() || d == c)
      return;
    for(const Face& face : m_soup.faces)
      if(has(face, c) && has(face, d))
        return;
    m_soup.faces[f] = {a, d, c};
    m_soup.faces[other] = {d, b, c};
  }

  /// removes a face, seldom where that leaves a vertex with two fans
  void remove_face(std::size_t f, bool may_pinch)
  {
    if(m_soup.faces.size() > 2 && (may_pinch || !is_pinched_without(f)))
      m_soup.faces.erase(m_soup.faces.begin() + static_cast<std::ptrdiff_t>(f));
  }

  /// indicates whether a corner of the face is on the border, but none of its two sides
  bool is_pinched_without(std::size_t f) const
  {
    const auto is_border_edge = [this](std::size_t a, std::size_t b) {
      return std::count_if(m_soup.faces.begin(), m_soup.faces.end(),
                           [a, b](const Face& face) { return has(face, a) && has(face, b); }) == 1;
    };
    const Face& corners = m_soup.faces[f];
    for(std::size_t k = 0; k < 3; ++k) {
      const std::size_t v = corners[k];
      bool is_on_border = false;
      for(const Face& face : m_soup.faces)
        for(std::size_t w : face)
          is_on_border = is_on_border || (w != v && has(face, v) && is_border_edge(v, w));
      if(is_on_border && !is_border_edge(v, corners[(k + 1) % 3]) && !is_border_edge(v, corners[(k + 2) % 3]))
        return true;
    }
    return false;
  }

  void turn_face(std::size_t f) { std::swap(m_soup.faces[f][0], m_soup.faces[f][1]); }

  void move_onto_neighbor(std::size_t f) { m_soup.points[m_soup.faces[f][0]] = point(f, 1); }

  void move_onto_edge(std::size_t f) { m_soup.points[m_soup.faces[f][0]] = (point(f, 1) + point(f, 2)) / 2; }

  void move_near_neighbor(std::size_t f)
  {
    const double share = std::ldexp(1., -(m_bytes.next() % 64));
    const Eigen::Vector3d moved = point(f, 1) + share * (point(f, 0) - point(f, 1));
    m_soup.points[m_soup.faces[f][0]] = moved;
  }

  /// puts a tube between two faces that are far enough apart: a handle, or a bridge to another component
  void add_tube(std::size_t f, std::size_t g)
  {
    const Face a = m_soup.faces[f], b{m_soup.faces[g][0], m_soup.faces[g][2], m_soup.faces[g][1]};
    for(const Face& face : m_soup.faces)
      if(std::any_of(a.begin(), a.end(), [&face](std::size_t v) { return has(face, v); }) &&
         std::any_of(b.begin(), b.end(), [&face](std::size_t v) { return has(face, v); }))
        return;
    m_soup.faces[f] = {a[0], a[1], b[0]};
    m_soup.faces[g] = {a[1], b[1], b[0]};
    for(std::size_t k : {1, 2}) {
      const std::size_t next = (k + 1) % 3;
      m_soup.faces.push_back({a[k], a[next], b[k]});
      m_soup.faces.push_back({a[next], b[next], b[k]});
    }
  }

  /// makes one polygon of the two faces at an edge, if there are such
  void join_faces(std::size_t from, std::size_t to)
  {
    const auto begins_with = [this](std::size_t a, std::size_t b) {
      return std::find_if(m_soup.faces.begin(), m_soup.faces.end(), [a, b](Face& face) {
        for(std::size_t k = 0; k < face.size(); ++k)
          if(face[k] == a && face[(k + 1) % face.size()] == b) {
            std::rotate(face.begin(), face.begin() + static_cast<std::ptrdiff_t>(k), face.end());
            return true;
          }
        return false;
      });
    };
    const auto first = begins_with(from, to), second = begins_with(to, from);
    if(first == m_soup.faces.end() || second == m_soup.faces.end() || first == second)
      return;
    first->insert(first->begin() + 1, second->begin() + 2, second->end());
    m_soup.faces.erase(second);
  }

  /// leaves the points alone, scales them by up to 2^500, flattens or moves them
  void transform(int kind, int exponent)
  {
    Eigen::Vector3d scale(1, 1, 1), offset(0, 0, 0);
    switch(kind % 8) {
    case 5:
      scale.setConstant(std::ldexp(1., 4 * (exponent - 128)));
      break;
    case 6:
      scale.z() = std::ldexp(1., -exponent);
      break;
    case 7:
      offset = std::ldexp(1., exponent % 64) * Eigen::Vector3d(1, -0.3, 0.7);
      break;
    default:
      return;
    }
    for(Eigen::Vector3d& p : m_soup.points)
      p = p.cwiseProduct(scale) + offset;
  }

  static bool has(const Face& face, std::size_t v) { return std::find(face.begin(), face.end(), v) != face.end(); }

  Eigen::Vector3d point(std::size_t f, std::size_t k) const { return m_soup.points[m_soup.faces[f][k]]; }

  Byte_source& m_bytes;
  CGAL_ext::internal::Surface_soup m_soup;
  std::vector<std::pair<std::size_t, std::size_t>> m_joined_edges; // whose faces become one at the end
};

#endif // CGAL_EXT_FUZZ_SOUP_OF_BYTES_H
