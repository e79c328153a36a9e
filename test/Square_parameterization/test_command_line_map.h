// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TEST_COMMAND_LINE_MAP_H
#define TEST_COMMAND_LINE_MAP_H

#include "test_command_line_mesh.h"

#include <boost/multiprecision/cpp_int.hpp>

#include <cmath>
#include <stdexcept>

// Reads the maps that square_map writes and measures them anew, without CGAL and without the code under test.

typedef std::array<double, 2> Uv;

struct Map
{
  std::vector<Point> points;
  std::vector<Uv> uv;
  std::vector<Face> faces;
};

/// the next number of the stream, or an exception
template <class Number>
Number next(std::istream& stream)
{
  Number x{};
  if(!(stream >> x))
    throw std::runtime_error("the map that was written is incomplete");
  return x;
}

inline Point next_point(std::istream& stream)
{
  const double x = next<double>(stream), y = next<double>(stream);
  return {x, y, next<double>(stream)};
}

inline Uv next_uv(std::istream& stream)
{
  const double u = next<double>(stream);
  return {u, next<double>(stream)};
}

inline void read_counted_faces(std::istream& stream, std::size_t count, Map& map)
{
  for(std::size_t f = 0; f < count; ++f) {
    map.faces.emplace_back(next<std::size_t>(stream));
    for(long& v : map.faces.back())
      v = next<long>(stream);
  }
}

/// the map of a surface as it was cut: one point per texture vertex, all corners of which must name the same vertex
inline Map read_obj_map(const std::string& text)
{
  Map map;
  std::vector<Point> vertices;
  std::vector<long> vertex_of; // per texture vertex
  std::istringstream lines(text);
  for(std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    const std::string kind = next<std::string>(words);
    if(kind == "v")
      vertices.push_back(next_point(words));
    else if(kind == "vt") {
      map.uv.push_back(next_uv(words));
      vertex_of.push_back(-1);
    } else if(kind == "f") {
      map.faces.emplace_back();
      for(std::string corner; words >> corner;) {
        const long v = std::stol(corner) - 1, vt = std::stol(corner.substr(corner.find('/') + 1)) - 1;
        if(vertex_of.at(vt) >= 0 && vertex_of[vt] != v)
          throw std::runtime_error("unexpected corner " + corner);
        vertex_of[vt] = v;
        map.faces.back().push_back(vt);
      }
    } else
      throw std::runtime_error("unexpected line " + line);
  }
  for(long v : vertex_of)
    map.points.push_back(vertices.at(v));
  return map;
}

/// OFF with texture coordinates after each point
inline Map read_off_map(const std::string& text)
{
  Map map;
  std::istringstream stream(text);
  if(next<std::string>(stream) != "STOFF")
    throw std::runtime_error("the OFF file has no texture coordinates");
  const std::size_t V = next<std::size_t>(stream), F = next<std::size_t>(stream);
  next<std::size_t>(stream);
  for(std::size_t v = 0; v < V; ++v) {
    map.points.push_back(next_point(stream));
    map.uv.push_back(next_uv(stream));
  }
  read_counted_faces(stream, F, map);
  return map;
}

/// ASCII PLY with the vertex properties x, y, z, s, t in this order
inline Map read_ply_map(const std::string& text)
{
  Map map;
  std::istringstream stream(text);
  std::string line, properties;
  std::size_t V = 0, F = 0;
  while(std::getline(stream, line) && line != "end_header") {
    std::istringstream words(line);
    std::string first, second, third;
    words >> first >> second >> third;
    if(first == "format" && second != "ascii")
      throw std::runtime_error("the PLY file is not ASCII");
    if(first == "element")
      (second == "vertex" ? V : F) = std::stoul(third);
    if(first == "property" && second == "double")
      properties += third;
  }
  if(properties != "xyzst")
    throw std::runtime_error("the PLY file has the properties " + properties);
  for(std::size_t v = 0; v < V; ++v) {
    map.points.push_back(next_point(stream));
    map.uv.push_back(next_uv(stream));
  }
  read_counted_faces(stream, F, map);
  return map;
}

/// indicates whether the uv triangle is counter-clockwise, in whole numbers: no rounding
inline bool is_counterclockwise(const Uv& p, const Uv& q, const Uv& r)
{
  typedef boost::multiprecision::cpp_int Integer;
  const auto scaled = [](double x) { // by 2^1127, which leaves no fraction of any double
    int exponent = 0;
    const double mantissa = std::frexp(x, &exponent);
    return Integer(static_cast<std::int64_t>(std::ldexp(mantissa, 53))) * (Integer(1) << (exponent + 1074));
  };
  const auto difference = [&scaled](double a, double b) { return Integer(scaled(a) - scaled(b)); };
  return difference(q[0], p[0]) * difference(r[1], p[1]) > difference(r[0], p[0]) * difference(q[1], p[1]);
}

/// what is right or wrong with a map onto the unit square
struct Measures
{
  long double l2 = 0, linf = 0, symmetric_dirichlet = 0, uv_area = 0;
  std::size_t flipped = 0;
};

/// area of a triangle in space; exactly zero for small whole coordinates on a line
inline long double area_of(const Point& p, const Point& q, const Point& r)
{
  typedef long double Real;
  Real squares = 0;
  for(int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const Real cross = (Real(q[i]) - p[i]) * (Real(r[j]) - p[j]) - (Real(q[j]) - p[j]) * (Real(r[i]) - p[i]);
    squares += cross * cross;
  }
  return std::sqrt(squares) / 2;
}

/// the formulas of Sander et al. 2001 as they stand in the paper
inline Measures measure(const Map& map)
{
  typedef long double Real;
  Measures result;
  Real surface_area = 0, energy = 0, inverse_energy = 0, largest = 0;
  for(const Face& face : map.faces) {
    const Uv &p1 = map.uv.at(face.at(0)), &p2 = map.uv.at(face.at(1)), &p3 = map.uv.at(face.at(2));
    const Point &q1 = map.points.at(face[0]), &q2 = map.points.at(face[1]), &q3 = map.points.at(face[2]);
    if(!is_counterclockwise(p1, p2, p3))
      ++result.flipped;
    const Real s1 = p1[0], s2 = p2[0], s3 = p3[0], t1 = p1[1], t2 = p2[1], t3 = p3[1];
    const Real uv_area = ((s2 - s1) * (t3 - t1) - (s3 - s1) * (t2 - t1)) / 2;
    Real a = 0, b = 0, c = 0; // Ss.Ss, Ss.St, St.St
    for(int i = 0; i < 3; ++i) {
      // differences first: the coefficients of q1, q2 and q3 sum to zero
      const Real e2 = Real(q2[i]) - q1[i], e3 = Real(q3[i]) - q1[i];
      const Real Ss = (e2 * (t3 - t1) + e3 * (t1 - t2)) / (2 * uv_area);
      const Real St = (e2 * (s1 - s3) + e3 * (s2 - s1)) / (2 * uv_area);
      a += Ss * Ss;
      b += Ss * St;
      c += St * St;
    }
    const Real area = area_of(q1, q2, q3); // it is |uv_area| sqrt(a c - b b), too
    result.uv_area += uv_area;
    surface_area += area;
    energy += (a + c) / 2 * area;
    if(area > 0)
      inverse_energy += (a + c) / 2 * uv_area * uv_area / area;
    largest = std::max(largest, std::sqrt((a + c + std::sqrt((a - c) * (a - c) + 4 * b * b)) / 2));
  }
  const Real scale = result.uv_area / surface_area;
  result.l2 = std::sqrt(energy / surface_area * scale);
  result.linf = largest * std::sqrt(scale);
  result.symmetric_dirichlet = (energy * scale + inverse_energy / scale) / (2 * surface_area);
  return result;
}

/// says what is wrong with the border of the map: it must run round the unit square once, counter-clockwise, with the
/// given vertices exactly on its corners. Empty when all is right.
inline std::string border_fault(const Map& map, const std::vector<long>& corners)
{
  static const Uv square[4] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  if(corners.size() != 4)
    return "there are not four corners";
  for(int k = 0; k < 4; ++k)
    if(map.uv.at(corners[k]) != square[k])
      return "corner vertex " + std::to_string(corners[k]) + " is not on its corner";
  std::vector<long> loop = border_of(map.faces);
  const auto start = std::find(loop.begin(), loop.end(), corners[0]);
  if(start == loop.end())
    return "the first corner is not on the border";
  std::rotate(loop.begin(), start, loop.end());
  double previous = -1;
  for(long v : loop) {
    const auto [x, y] = map.uv[v];
    const double along = y == 0 ? x : x == 1 ? 1 + y : y == 1 ? 3 - x : x == 0 ? 4 - y : -1;
    if(!(x >= 0 && x <= 1 && y >= 0 && y <= 1 && along > previous))
      return "border vertex " + std::to_string(v) + " at " + number(x) + ' ' + number(y) + " is not on its way round";
    previous = along;
  }
  return "";
}

#endif // TEST_COMMAND_LINE_MAP_H
