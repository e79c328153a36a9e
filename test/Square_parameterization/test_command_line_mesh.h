// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TEST_COMMAND_LINE_MESH_H
#define TEST_COMMAND_LINE_MESH_H

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

// Small meshes and the text of the files that hold them, written without CGAL.

typedef std::array<double, 3> Point;
typedef std::vector<long> Face;

struct Soup
{
  std::vector<Point> points;
  std::vector<Face> faces;
};

/// a hilly sheet of nx by ny cells with uneven spacing; with even numbers no edge joins two border vertices but along
/// the border. Vertices are numbered as faces first name them, as in STL, and coordinates are exact in float.
inline Soup sheet(int nx, int ny, double offset = 0)
{
  const auto uneven = [](int i) { return i + ((i * 7) % 5) / 16.; };
  Soup soup;
  std::map<std::pair<int, int>, long> index;
  const auto vertex = [&](int i, int j) {
    const auto [found, is_new] = index.emplace(std::make_pair(i, j), static_cast<long>(soup.points.size()));
    if(is_new)
      soup.points.push_back({offset + uneven(i) + (j % 3) / 32., 1.25 * uneven(j) - (i % 2) / 16.,
                             ((i * i + 3 * j * i + 2 * j) % 7) / 8.});
    return found->second;
  };
  for(int j = 0; j < ny; ++j)
    for(int i = 0; i < nx; ++i) {
      const bool is_even = (i + j) % 2 == 0;
      const long p = vertex(i, j), q = vertex(i + 1, j);
      const long r = vertex(is_even ? i + 1 : i, j + 1), s = vertex(is_even ? i : i + 1, j + 1);
      soup.faces.push_back({p, q, r});
      soup.faces.push_back(is_even ? Face{p, r, s} : Face{q, s, r});
    }
  return soup;
}

/// the same surface, larger
inline Soup scaled(Soup soup, double factor)
{
  for(Point& p : soup.points)
    for(double& x : p)
      x *= factor;
  return soup;
}

/// the border vertices of an oriented disk, counter-clockwise from the lowest
inline std::vector<long> border_of(const std::vector<Face>& faces)
{
  std::map<std::pair<long, long>, int> sides;
  for(const Face& face : faces)
    for(std::size_t k = 0; k < face.size(); ++k)
      ++sides[{face[k], face[(k + 1) % face.size()]}];
  std::map<long, long> next;
  for(const auto& [side, count] : sides)
    if(sides.count({side.second, side.first}) == 0)
      next[side.first] = side.second;
  std::vector<long> loop;
  if(!next.empty())
    for(long v = next.begin()->first; loop.empty() || (v != loop.front() && loop.size() <= next.size()); v = next[v])
      loop.push_back(v);
  return loop;
}

inline std::string number(double x)
{
  std::ostringstream stream;
  stream.precision(17);
  stream << x;
  return stream.str();
}

inline std::string row(const Point& p, const std::string& before = "")
{
  return before + number(p[0]) + ' ' + number(p[1]) + ' ' + number(p[2]) + '\n';
}

inline std::string row(const Face& face, long first_index = 0, const std::string& before = "")
{
  std::string text = before;
  for(std::size_t k = 0; k < face.size(); ++k)
    text += (k == 0 ? "" : " ") + std::to_string(face[k] + first_index);
  return text + '\n';
}

inline std::string counted_rows(const std::vector<Face>& faces)
{
  std::string text;
  for(const Face& face : faces)
    text += row(face, 0, std::to_string(face.size()) + ' ');
  return text;
}

inline std::string off(const Soup& soup)
{
  std::string text = "OFF\n" + std::to_string(soup.points.size()) + ' ' + std::to_string(soup.faces.size()) + " 0\n";
  for(const Point& p : soup.points)
    text += row(p);
  return text + counted_rows(soup.faces);
}

inline std::string obj(const Soup& soup)
{
  std::string text;
  for(const Point& p : soup.points)
    text += row(p, "v ");
  for(const Face& face : soup.faces)
    text += row(face, 1, "f ");
  return text;
}

inline std::string ply_header(const Soup& soup, const std::string& format)
{
  return "ply\nformat " + format + " 1.0\nelement vertex " + std::to_string(soup.points.size()) +
         "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
         std::to_string(soup.faces.size()) + "\nproperty list uchar int vertex_indices\nend_header\n";
}

inline std::string ply(const Soup& soup)
{
  std::string text = ply_header(soup, "ascii");
  for(const Point& p : soup.points)
    text += row(p);
  return text + counted_rows(soup.faces);
}

/// the bytes of a number on a little-endian machine
template <class Number>
std::string bytes(Number x)
{
  std::string text(sizeof x, '\0');
  std::memcpy(text.data(), &x, sizeof x);
  return text;
}

template <class Number>
std::string big_endian(Number x)
{
  const std::string little = bytes(x);
  return {little.rbegin(), little.rend()};
}

inline std::string binary_ply(const Soup& soup)
{
  std::string text = ply_header(soup, "binary_little_endian");
  for(const Point& p : soup.points)
    for(double x : p)
      text += bytes(x);
  for(const Face& face : soup.faces) {
    text += bytes(static_cast<std::uint8_t>(face.size()));
    for(long v : face)
      text += bytes(static_cast<std::int32_t>(v));
  }
  return text;
}

inline std::string stl(const Soup& soup)
{
  std::string text = "solid sheet\n";
  for(const Face& face : soup.faces) {
    text += "facet normal 0 0 0\nouter loop\n";
    for(long v : face)
      text += row(soup.points[v], "vertex ");
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid sheet\n";
}

inline std::string binary_stl(const Soup& soup)
{
  std::string text(80, ' ');
  text += bytes(static_cast<std::uint32_t>(soup.faces.size()));
  for(const Face& face : soup.faces) {
    text += std::string(12, '\0');
    for(long v : face)
      for(double x : soup.points[v])
        text += bytes(static_cast<float>(x));
    text += std::string(2, '\0');
  }
  return text;
}

#endif // TEST_COMMAND_LINE_MESH_H
