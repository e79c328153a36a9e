// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_GEOMETRY_IMAGE_H
#define SQUARE_MAP_GEOMETRY_IMAGE_H

#include "Flat_map.h"
#include "pictures.h"

#include <CGAL_ext/Square_parameterization/internal/sampling/Grid_mesh.h>
#include <CGAL_ext/Square_parameterization/internal/sampling/locate_samples.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace square_map {

/// points and normals of the surface on a regular grid of the square: row by row from (0, 0), the same on both sides of
/// a seam
struct Geometry_image
{
  CGAL_ext::Grid_size size;
  std::vector<Eigen::Vector3d> points, normals;
  Vertex_colors colors;               ///< empty when the map has none
  Eigen::AlignedBox3d box;            ///< of the surface
  CGAL_ext::internal::Grid_mesh mesh; ///< rebuilt from the points

  /// the point of a vertex of the rebuilt mesh
  const Eigen::Vector3d& mesh_point(int v) const { return points[mesh.samples[v]]; }
};

/// samples the map
inline Geometry_image make_geometry_image(const Flat_map& map, const CGAL_ext::Grid_size& size,
                                          const std::vector<std::array<int, 2>>& seam_samples)
{
  using namespace CGAL_ext::internal;
  Geometry_image image{size, {}, {}, {}, map.box(), {}};
  for(const auto& [f, weights] : locate_samples(map.triangles, map.uv, size)) {
    image.points.push_back(interpolated(map.points, map.triangles[f], weights));
    image.normals.push_back(sample_normal(map.normals, map.points, map.triangles[f], weights));
    if(!map.colors.empty())
      image.colors.push_back(interpolated(map.colors, map.triangles[f], weights));
  }
  const std::vector<std::size_t> welded = welded_samples(size, seam_samples);
  for(std::size_t s = 0; s < welded.size(); ++s) {
    image.points[s] = Eigen::Vector3d(image.points[welded[s]]);
    image.normals[s] = Eigen::Vector3d(image.normals[welded[s]]);
    if(!image.colors.empty())
      image.colors[s] = Eigen::Vector3d(image.colors[welded[s]]);
  }
  image.mesh = Grid_mesh_builder(size, image.points, welded)();
  return image;
}

/// the point of the image at a place of the square, interpolated bilinearly
inline Eigen::Vector3d interpolated_point(const Geometry_image& image, double u, double v)
{
  const auto place = [](double x, int n) { // the sample before, and how far beyond it
    const double scaled = (std::clamp)(x, 0., 1.) * (n - 1);
    const int i = (std::min)(static_cast<int>(scaled), n - 2);
    return std::make_pair(i, scaled - i);
  };
  const auto [i, s] = place(u, image.size.width);
  const auto [j, t] = place(v, image.size.height);
  const auto point = [&, i = i, j = j](int di, int dj) -> const Eigen::Vector3d& {
    return image.points[static_cast<std::size_t>(j + dj) * image.size.width + i + di];
  };
  return (1 - t) * ((1 - s) * point(0, 0) + s * point(1, 0)) + t * ((1 - s) * point(0, 1) + s * point(1, 1));
}

/// the root mean square of the distances between the vertices and the image at their places, in \p units
inline double rms_error_at_vertices(const Geometry_image& image, const Flat_map& map, double units)
{
  double sum = 0;
  for(std::size_t v = 0; v < map.points.size(); ++v)
    sum += ((interpolated_point(image, map.uv(v, 0), map.uv(v, 1)) - map.points[v]) / units).squaredNorm();
  return std::sqrt(sum / static_cast<double>(map.points.size()));
}

/// a picture of one color a sample; v grows upwards
template <class Channel, class Pixel_of>
Picture<Channel> picture_of_samples(const CGAL_ext::Grid_size& size, Pixel_of pixel_of)
{
  Picture<Channel> picture{size.width, size.height, {}};
  picture.pixels.resize(size.number_of_samples());
  for(std::size_t s = 0; s < picture.pixels.size(); ++s)
    picture.at(static_cast<int>(s % size.width), size.height - 1 - static_cast<int>(s / size.width)) = pixel_of(s);
  return picture;
}

/// coordinates as shares of the bounding box, in 16 bits: 0 and 65535 are its sides
inline Picture<std::uint16_t> point_picture_in_box(const Geometry_image& image)
{
  return picture_of_samples<std::uint16_t>(image.size, [&image](std::size_t s) {
    std::array<std::uint16_t, 3> pixel{};
    for(int c = 0; c < 3; ++c) {
      const double low = image.box.min()[c], half_extent = image.box.max()[c] / 2 - low / 2;
      const double share = half_extent > 0 ? (image.points[s][c] / 2 - low / 2) / half_extent : 0;
      pixel[c] = static_cast<std::uint16_t>(std::lround(65535 * (std::clamp)(share, 0., 1.)));
    }
    return pixel;
  });
}

/// the coordinates themselves
/// \throw Output_error for a coordinate that is too large for 32 bits
inline Picture<float> point_picture(const Geometry_image& image)
{
  const double largest = (std::max)(image.box.min().cwiseAbs().maxCoeff(), image.box.max().cwiseAbs().maxCoeff());
  if(!(largest <= static_cast<double>(std::numeric_limits<float>::max())))
    throw Output_error("EXR has no number as large as the coordinates of this surface");
  return picture_of_samples<float>(image.size, [&image](std::size_t s) {
    const Eigen::Vector3f p = image.points[s].cast<float>();
    return std::array<float, 3>{p.x(), p.y(), p.z()};
  });
}

/// three numbers from 0 to 1 in 8 bits each; others are moved there
inline Color color_of(const Eigen::Vector3d& x)
{
  Color pixel{};
  for(int c = 0; c < 3; ++c)
    pixel[c] = static_cast<std::uint8_t>(std::lround(255 * (x[c] > 0 ? (std::min)(x[c], 1.) : 0)));
  return pixel;
}

/// normals in the coordinates of the surface: -1 is 0, and 1 is 255
inline Picture<std::uint8_t> normal_picture(const Geometry_image& image)
{
  return picture_of_samples<std::uint8_t>(
      image.size, [&image](std::size_t s) { return color_of((image.normals[s] + Eigen::Vector3d::Ones()) / 2); });
}

inline Picture<std::uint8_t> color_picture(const Geometry_image& image)
{
  return picture_of_samples<std::uint8_t>(image.size, [&image](std::size_t s) { return color_of(image.colors[s]); });
}

} // namespace square_map

#endif // SQUARE_MAP_GEOMETRY_IMAGE_H
