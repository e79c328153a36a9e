// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TEST_COMMAND_LINE_PICTURES_H
#define TEST_COMMAND_LINE_PICTURES_H

#include "test_command_line_checks.h"

#include <Eigen/Core>
#include <png.h>
#include <tinyexr.h>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <set>
#include <string>
#include <utility>
#include <vector>

// Pictures and samples, read back by the libraries that own their formats.

/// a PNG file as libpng reads it; rows from the top
template <class Channel>
struct Image
{
  int width = 0, height = 0;
  std::vector<std::array<Channel, 3>> pixels;

  const std::array<Channel, 3>& at(int x, int y) const { return pixels[static_cast<std::size_t>(y) * width + x]; }
};

template <class Channel>
Image<Channel> read_png(const std::string& bytes, png_uint_32 format)
{
  png_image image = {};
  image.version = PNG_IMAGE_VERSION;
  REQUIRE(png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()) != 0);
  image.format = format;
  Image<Channel> result{static_cast<int>(image.width), static_cast<int>(image.height), {}};
  result.pixels.resize(static_cast<std::size_t>(result.width) * result.height);
  REQUIRE(PNG_IMAGE_SIZE(image) == result.pixels.size() * sizeof(result.pixels[0]));
  REQUIRE(png_image_finish_read(&image, nullptr, result.pixels.data(), 0, nullptr) != 0);
  return result;
}

/// an EXR file as points, rows from the top
inline Image<float> read_exr(const std::string& bytes)
{
  float* values = nullptr;
  int width = 0, height = 0;
  const char* error = nullptr;
  REQUIRE(LoadEXRFromMemory(&values, &width, &height, reinterpret_cast<const unsigned char*>(bytes.data()),
                            bytes.size(), &error) == TINYEXR_SUCCESS);
  Image<float> image{width, height, {}};
  for(std::ptrdiff_t k = 0; k < std::ptrdiff_t(width) * height; ++k)
    image.pixels.push_back({values[4 * k], values[4 * k + 1], values[4 * k + 2]});
  std::free(values);
  return image;
}

/// what the command was asked for, all of it
struct Outputs
{
  explicit Outputs(const Soup& soup, const Arguments& options = {})
  {
    const std::string input = folder.add("in.off", off(soup));
    result = square_map(Arguments{input, "-o", folder / "map.obj", "--image", folder / "a.png", "--normal-map",
                                  folder / "n.png", "--grid-mesh", folder / "g.off", "--svg", folder / "a.svg",
                                  "--json", folder / "a.json"} +
                        options);
    INFO(result.err);
    REQUIRE(result.status == DONE);
    report = nlohmann::json::parse(read_file(folder / "a.json"));
  }

  std::string text(const std::string& name) const { return read_file(folder / name); }

  Temporary_folder folder;
  Finished_process result;
  nlohmann::json report;
};

inline Eigen::Vector3d vector_of(const nlohmann::json& numbers)
{
  return {numbers[0].get<double>(), numbers[1].get<double>(), numbers[2].get<double>()};
}

/// the points that a 16-bit picture stands for
inline std::vector<Eigen::Vector3d> points_in_box(const Image<std::uint16_t>& image, const nlohmann::json& box)
{
  const Eigen::Vector3d low = vector_of(box["min"]), high = vector_of(box["max"]);
  std::vector<Eigen::Vector3d> points;
  for(const auto& [x, y, z] : image.pixels)
    points.push_back(low + (high - low).cwiseProduct(Eigen::Vector3d(x, y, z)) / 65535);
  return points;
}

struct Plain_mesh
{
  std::vector<Point> points;
  std::vector<Face> faces;
};

inline Plain_mesh read_off_mesh(const std::string& text)
{
  std::istringstream stream(text);
  REQUIRE(next<std::string>(stream) == "OFF");
  Plain_mesh mesh;
  const std::size_t V = next<std::size_t>(stream), F = next<std::size_t>(stream);
  next<std::size_t>(stream);
  for(std::size_t v = 0; v < V; ++v)
    mesh.points.push_back(next_point(stream));
  Map faces;
  read_counted_faces(stream, F, faces);
  mesh.faces = faces.faces;
  return mesh;
}

/// number of sides of faces without a partner that runs the other way; every side must be there once
inline std::size_t open_sides(const std::vector<Face>& faces)
{
  std::set<std::pair<long, long>> sides;
  for(const Face& face : faces)
    for(std::size_t k = 0; k < face.size(); ++k)
      REQUIRE(sides.insert({face[k], face[(k + 1) % face.size()]}).second);
  std::size_t open = 0;
  for(const auto& [a, b] : sides)
    open += 1 - sides.count({b, a});
  return open;
}

#endif // TEST_COMMAND_LINE_PICTURES_H
