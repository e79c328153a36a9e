// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_CANVAS_H
#define SQUARE_MAP_CANVAS_H

#include "pictures.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace square_map {

/// a point of the picture: x and y in [0, 1], y upwards, and the depth, larger is nearer
typedef Eigen::Vector3d Place;

/// a picture that is drawn with depth, three times as large as it becomes
class Canvas
{
public:
  Canvas(int width, int height)
    : m_width(width),
      m_height(height),
      m_pixels(static_cast<std::size_t>(FACTOR * width) * static_cast<std::size_t>(FACTOR * height),
               Eigen::Vector3d::Constant(255)),
      m_depths(m_pixels.size(), -std::numeric_limits<double>::infinity())
  {}

  /// draws a triangle; `color_at(weights, distance)` gives the color at barycentric coordinates and at a distance from
  /// the nearest edge, in pixels
  template <class ColorAt>
  void draw_triangle(const std::array<Place, 3>& corners, const ColorAt& color_at)
  {
    std::array<Eigen::Vector2d, 3> p;
    for(int k = 0; k < 3; ++k)
      p[k] = pixel(corners[k]);
    const double area = cross(p[1] - p[0], p[2] - p[0]);
    if(area == 0)
      return;
    const Eigen::Vector2d low = p[0].cwiseMin(p[1]).cwiseMin(p[2]), high = p[0].cwiseMax(p[1]).cwiseMax(p[2]);
    for_each_pixel(low, high, [&](const Eigen::Vector2d& q, std::size_t index) {
      std::array<double, 3> weights{};
      double distance = std::numeric_limits<double>::infinity(), depth = 0;
      for(int k = 0; k < 3; ++k) {
        const Eigen::Vector2d &a = p[(k + 1) % 3], &b = p[(k + 2) % 3];
        weights[k] = cross(b - a, q - a) / area;
        if(weights[k] < 0)
          return;
        distance = (std::min)(distance, weights[k] * std::abs(area) / (b - a).norm() / FACTOR);
        depth += weights[k] * corners[k].z();
      }
      put(index, depth, color_at(weights, distance));
    });
  }

  /// draws a line with round ends; it is hidden by what lies before it by more than a little
  /// \param width in pixels
  void draw_line(const Place& from, const Place& to, double width, const Color& color)
  {
    const Eigen::Vector2d a = pixel(from), b = pixel(to), along = b - a;
    const double radius = width * FACTOR / 2;
    const Eigen::Vector2d margin = Eigen::Vector2d::Constant(radius);
    for_each_pixel(a.cwiseMin(b) - margin, a.cwiseMax(b) + margin, [&](const Eigen::Vector2d& q, std::size_t index) {
      const double share = along.isZero(0) ? 0 : (std::clamp)(along.dot(q - a) / along.squaredNorm(), 0., 1.);
      if((a + share * along - q).norm() <= radius)
        put(index, from.z() + share * (to.z() - from.z()) + 0.02, vector(color));
    });
  }

  void draw_disk(const Place& center, double radius, const Color& color)
  {
    const Place front = center + Place(0, 0, 0.05); // of a surface that turns away there
    draw_line(front, front, 2 * radius + 3, {255, 255, 255});
    draw_line(front, front, 2 * radius, color);
  }

  /// the picture in its size
  Picture<std::uint8_t> picture() const
  {
    Picture<std::uint8_t> result{m_width, m_height, {}};
    for(int y = 0; y < m_height; ++y)
      for(int x = 0; x < m_width; ++x) {
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        for(int j = 0; j < FACTOR; ++j)
          for(int i = 0; i < FACTOR; ++i)
            sum += m_pixels[static_cast<std::size_t>(FACTOR * y + j) * static_cast<std::size_t>(FACTOR * m_width) +
                            static_cast<std::size_t>(FACTOR * x + i)];
        std::array<std::uint8_t, 3> color{};
        for(int c = 0; c < 3; ++c)
          color[c] = static_cast<std::uint8_t>(std::lround(sum[c] / (FACTOR * FACTOR)));
        result.pixels.push_back(color);
      }
    return result;
  }

  static Eigen::Vector3d vector(const Color& color) { return {double(color[0]), double(color[1]), double(color[2])}; }

private:
  static constexpr int FACTOR = 3;

  static double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

  Eigen::Vector2d pixel(const Place& place) const
  {
    return {place.x() * FACTOR * m_width, (1 - place.y()) * FACTOR * m_height};
  }

  template <class Use>
  void for_each_pixel(const Eigen::Vector2d& low, const Eigen::Vector2d& high, const Use& use)
  {
    const int width = FACTOR * m_width, height = FACTOR * m_height;
    const int left = (std::max)(0, static_cast<int>(low.x())),
              right = (std::min)(width - 1, static_cast<int>(high.x()));
    const int top = (std::max)(0, static_cast<int>(low.y())),
              bottom = (std::min)(height - 1, static_cast<int>(high.y()));
    for(int y = top; y <= bottom; ++y)
      for(int x = left; x <= right; ++x)
        use(Eigen::Vector2d(x + 0.5, y + 0.5),
            static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x));
  }

  void put(std::size_t index, double depth, const Eigen::Vector3d& color)
  {
    if(depth < m_depths[index])
      return;
    m_depths[index] = depth;
    m_pixels[index] = color;
  }

  int m_width, m_height;
  std::vector<Eigen::Vector3d> m_pixels;
  std::vector<double> m_depths;
};

} // namespace square_map

#endif // SQUARE_MAP_CANVAS_H
