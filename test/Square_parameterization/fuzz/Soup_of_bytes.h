// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_FUZZ_SOUP_OF_BYTES_H
#define CGAL_EXT_FUZZ_SOUP_OF_BYTES_H

#include <CGAL_ext/Square_parameterization/internal/Surface_soup.h>

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

/// a small triangulation that bytes describe: a tetrahedron, a sheet or a torus; then vertices are put into faces, edges
/// flipped, holes made, faces turned round, vertices moved near or onto others
class Soup_of_bytes
{
public:
  explicit Soup_of_bytes(Byte_source& bytes) : m_bytes(bytes)
  {
    start();
    constexpr int MOST_STEPS = 120;
    for(int i = 0; i < MOST_STEPS && !m_bytes.is_empty() && !m_soup.faces.empty(); ++i)
      step();
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
    const int kind = m_bytes.next() % 3;
    const std::size_t m = 3 + m_bytes.next() % 3, n = 3 + m_bytes.next() % 3;
    if(kind == 0) {
      m_soup = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
      return;
    }
    const bool is_torus = kind == 2;
    for(std::size_t i = 0; i < m; ++i)
      for(std::size_t j = 0; j < n; ++j) {
        const double u = 6.283185307 * i / m, v = 6.283185307 * j / n, radius = 2 + std::cos(v);
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
    const int kind = m_bytes.next() % 8;
    const std::size_t f = m_bytes.below(m_soup.faces.size());
    switch(kind) {
    case 0:
      split_face(f);
      break;
    case 1:
      flip_edge(f, m_bytes.next() % 3);
      break;
    case 2:
      remove_face(f);
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
    default:
      move_near_neighbor(f);
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
    const auto has = [](const Face& face, std::size_t v) {
      return std::find(face.begin(), face.end(), v) != face.end();
    };
    for(const Face& face : m_soup.faces)
      if(has(face, c) && has(face, d))
        return;
    m_soup.faces[f] = {a, d, c};
    m_soup.faces[other] = {d, b, c};
  }

  void remove_face(std::size_t f)
  {
    if(m_soup.faces.size() > 2)
      m_soup.faces.erase(m_soup.faces.begin() + static_cast<std::ptrdiff_t>(f));
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

  Eigen::Vector3d point(std::size_t f, std::size_t k) const { return m_soup.points[m_soup.faces[f][k]]; }

  Byte_source& m_bytes;
  CGAL_ext::internal::Surface_soup m_soup;
};

#endif // CGAL_EXT_FUZZ_SOUP_OF_BYTES_H
