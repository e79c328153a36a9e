// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_PICTURES_H
#define SQUARE_MAP_PICTURES_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

// Pictures as the bytes of files: PNG by libpng, EXR by tinyexr.

namespace square_map {

typedef std::array<std::uint8_t, 3> Color; ///< red, green and blue

/// pixels in rows, the first row at the top
template <class Channel>
struct Picture
{
  int width = 0, height = 0;
  std::vector<std::array<Channel, 3>> pixels;

  std::array<Channel, 3>& at(int x, int y) { return pixels[static_cast<std::size_t>(y) * width + x]; }
};

/// a PNG file with 8 bits a channel
std::string png_file(const Picture<std::uint8_t>& picture);

/// a PNG file with 16 bits a channel
std::string png_file(const Picture<std::uint16_t>& picture);

/// an EXR file with 32-bit floating-point numbers
std::string exr_file(const Picture<float>& picture);

/// decodes a PNG file
/// \throw Malformed_file with the reason alone for bytes that are none
Picture<std::uint8_t> read_png(const std::string& bytes);

/// a picture of squares in two colors, \p squares along each side
Picture<std::uint8_t> checkerboard(int squares, int pixels_of_square);

} // namespace square_map

#endif // SQUARE_MAP_PICTURES_H
