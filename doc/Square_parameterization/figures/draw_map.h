// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FIGURES_DRAW_MAP_H
#define FIGURES_DRAW_MAP_H

#include "compiled_reader.h"
#include "square_map/surface_view.h"

#include <CGAL_ext/Square_parameterization/internal/energy/rectangle.h>
#include <CGAL_ext/Square_parameterization/internal/patch/write_uv.h>
#include <CGAL_ext/Square_parameterization/internal/sampling/vertex_normals.h>
#include <CGAL_ext/Square_parameterization/internal/surface/Face_graph_arrays.h>
#include <CGAL_ext/Square_parameterization/parameterize_onto_square.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace figures {

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
using square_map::Canvas;
using square_map::checkerboard_at;
using square_map::Color;
using square_map::Place;
using square_map::Surface_view;
typedef square_map::Picture<std::uint8_t> Picture;

/// options of maps whose corners are those of a candidate, unless a figure is about corners that move
struct Options : CGAL_ext::Square_map_options<Mesh>
{
  Options() { search_options.moves_corners = false; }
};

/// a mapped surface, cut open, as arrays
struct Map
{
  std::vector<Eigen::Vector3d> points, normals;
  std::vector<std::array<int, 3>> triangles;
  CGAL_ext::internal::Uv_coordinates uv;
  std::vector<std::array<int, 2>> border; ///< edges of one face
  CGAL_ext::Square_map_result<Mesh> result;
};

inline Mesh read(const std::string& file)
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(file, mesh))
    throw std::runtime_error("cannot read " + file);
  return mesh;
}

/// the edges that only one of the triangles has
inline std::vector<std::array<int, 2>> border_edges(const std::vector<std::array<int, 3>>& triangles)
{
  std::map<std::pair<int, int>, int> faces;
  for(const auto& t : triangles)
    for(int k = 0; k < 3; ++k)
      ++faces[std::minmax(t[k], t[(k + 1) % 3])];
  std::vector<std::array<int, 2>> border;
  for(const auto& [edge, count] : faces)
    if(count == 1)
      border.push_back({edge.first, edge.second});
  return border;
}

inline Map make_map(Mesh mesh, const Options& options = {})
{
  using namespace CGAL_ext::internal;
  auto uvmap = mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:uv").first;
  Map map;
  map.result = CGAL_ext::parameterize_onto_square(mesh, uvmap, CGAL_ext::parameters::options<Mesh>(options));
  if(map.result.status != CGAL::Surface_mesh_parameterization::OK)
    throw std::runtime_error(map.result.message);
  auto [arrays, vertices] = read_faces(mesh, mesh.faces(), mesh.points());
  map.points = std::move(arrays.points);
  map.triangles = std::move(arrays.triangles);
  map.uv = read_uv(vertices, uvmap);
  std::map<std::array<double, 3>, int> first_of_place; // the copies of a vertex have one normal
  std::vector<int> originals;
  for(std::size_t v = 0; v < map.points.size(); ++v) {
    const Eigen::Vector3d& p = map.points[v];
    originals.push_back(
        first_of_place.emplace(std::array<double, 3>{p.x(), p.y(), p.z()}, static_cast<int>(v)).first->second);
  }
  map.normals = vertex_normals(map.points, map.triangles, originals);
  map.border = border_edges(map.triangles);
  return map;
}

/// the default minimization, with a border that moves or not
inline CGAL_ext::Balanced_minimization with_border(CGAL_ext::Border_motion motion)
{
  CGAL_ext::Balanced_minimization balanced;
  balanced.border = motion;
  return balanced;
}

/// evaluates one candidate alone
struct Only_candidate
{
  int candidate;
  bool is_valid() const { return candidate >= 0; }
  CGAL_ext::Candidate_set candidate_set() const { return CGAL_ext::Candidate_set::QUARTER; }
  void operator()(const CGAL_ext::Corner_search_problem& problem) const { problem.objective_of({candidate}); }
};

inline const std::array<Color, 4> CORNER_COLORS{Color{213, 94, 0}, {0, 158, 115}, {204, 121, 167}, {230, 159, 0}};

/// how a picture is drawn
struct Style
{
  bool has_edges = false, has_checkerboard = true, has_corners = true;
  Eigen::Vector3d front = {0, 0, 0}; ///< towards the one who looks; zero: as the mean normal
  Eigen::Vector3d up = {0, 1, 0};
  int size = 330;
};

/// of a picture that shows the faces, and no checkerboard
inline Style faces_style()
{
  Style style;
  style.has_edges = true;
  style.has_checkerboard = false;
  return style;
}

/// draws triangles at their places, in the checkerboard of their map or one color, with or without their edges
/// \param width of the picture; its height is the size of the style
inline Picture draw(const Map& map, const std::vector<Place>& places, const std::vector<double>& light,
                    const Style& style, int width)
{
  Canvas canvas(width, style.size);
  const Eigen::RowVector2d scale = CGAL_ext::internal::scale_to_rectangle(map.result.aspect);
  for(const auto& t : map.triangles)
    canvas.draw_triangle({places[t[0]], places[t[1]], places[t[2]]}, [&](const auto& w, double distance) {
      double u = 0, v = 0, brightness = 0;
      for(int k = 0; k < 3; ++k) {
        u += w[k] * map.uv(t[k], 0);
        v += w[k] * map.uv(t[k], 1);
        brightness += w[k] * light[t[k]];
      }
      const Eigen::Vector3d color =
          style.has_checkerboard ? checkerboard_at(u * scale.x(), v * scale.y(), 24) : Eigen::Vector3d(205, 215, 228);
      return Eigen::Vector3d(brightness * (style.has_edges && distance < 0.45 ? 0.35 : 1.) * color);
    });
  for(const auto& [a, b] : map.border)
    canvas.draw_line(places[a], places[b], 2.5, {30, 30, 30});
  if(style.has_corners)
    for(int k = 0; k < 4; ++k)
      canvas.draw_disk(places[map.result.corners[k].idx()], 5, CORNER_COLORS[k]);
  return canvas.picture();
}

/// the surface from the front
inline Picture draw_surface(const Map& map, const Style& style = {})
{
  Eigen::Vector3d front = style.front;
  if(front.isZero(0))
    for(const Eigen::Vector3d& n : map.normals)
      front += n;
  const Surface_view view(map.points, front, style.up);
  std::vector<Place> places;
  std::vector<double> light;
  for(std::size_t v = 0; v < map.points.size(); ++v) {
    places.push_back(view.place(map.points[v]));
    light.push_back(view.light(map.normals[v]));
  }
  return draw(map, places, light, style, style.size);
}

/// the map on the square, or on its rectangle, which has the same area unless it is upright
inline Picture draw_domain(const Map& map, const Style& style)
{
  const Eigen::RowVector2d sides =
      0.92 * (std::min)(1., std::sqrt(map.result.aspect)) * CGAL_ext::internal::scale_to_rectangle(map.result.aspect);
  const double width = sides.x() + 0.08; // in heights of the picture
  std::vector<Place> places;
  for(Eigen::Index v = 0; v < map.uv.rows(); ++v)
    places.emplace_back((0.04 + sides.x() * map.uv(v, 0)) / width, 0.5 + sides.y() * (map.uv(v, 1) - 0.5), 0.5);
  return draw(map, places, std::vector<double>(map.points.size(), 1.), style,
              static_cast<int>(std::lround(width * style.size)));
}

/// pictures of one height side by side
inline Picture side_by_side(const std::vector<Picture>& pictures)
{
  constexpr int GAP = 24;
  Picture result{-GAP, pictures.front().height, {}};
  for(const auto& picture : pictures)
    result.width += picture.width + GAP;
  result.pixels.assign(static_cast<std::size_t>(result.width) * static_cast<std::size_t>(result.height),
                       {255, 255, 255});
  int left = 0;
  for(auto picture : pictures) {
    for(int y = 0; y < picture.height; ++y)
      for(int x = 0; x < picture.width; ++x)
        result.at(left + x, y) = picture.at(x, y);
    left += picture.width + GAP;
  }
  return result;
}

} // namespace figures

#endif // FIGURES_DRAW_MAP_H
