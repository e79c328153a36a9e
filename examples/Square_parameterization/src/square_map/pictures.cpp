// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../../include/square_map/pictures.h"
#include "../../include/square_map/Malformed_file.h"

#include <boost/algorithm/string/predicate.hpp>
#include <png.h>
#include <tinyexr.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <new>
#include <stdexcept>

namespace square_map {

namespace {

struct Close
{
  void operator()(std::FILE* file) const { std::fclose(file); }
};

struct Free
{
  void operator()(void* memory) const { std::free(memory); }
};

/// a file in memory, for libpng's simplified writer: its own for memory compresses twice
class Memory_file
{
public:
  Memory_file() : m_file(open_memstream(&m_bytes, &m_size))
  {
    if(!m_file)
      throw std::bad_alloc();
  }

  ~Memory_file()
  {
    m_file.reset();
    std::free(m_bytes);
  }

  Memory_file(const Memory_file&) = delete;
  Memory_file& operator=(const Memory_file&) = delete;

  std::FILE* file() const { return m_file.get(); }

  std::string bytes()
  {
    std::fflush(m_file.get());
    return {m_bytes, m_size};
  }

private:
  char* m_bytes = nullptr;
  std::size_t m_size = 0;
  std::unique_ptr<std::FILE, Close> m_file;
};

/// why libpng has failed. Throws `std::bad_alloc` where it was for want of memory.
std::string message_of(const png_image& image)
{
  const std::string message(image.message);
  if(boost::icontains(message, "insufficient memory") || boost::icontains(message, "out of memory"))
    throw std::bad_alloc();
  return message;
}

/// \param format of libpng: samples of 16 bits are linear, and written as they are
template <class Channel>
std::string png_of_format(const Picture<Channel>& picture, png_uint_32 format)
{
  png_image image = {};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(picture.width);
  image.height = static_cast<png_uint_32>(picture.height);
  image.format = format;
  Memory_file file;
  if(png_image_write_to_stdio(&image, file.file(), 0, picture.pixels.data(), 0, nullptr) == 0)
    throw std::runtime_error("libpng cannot write the picture: " + message_of(image));
  return file.bytes();
}

} // namespace

std::string png_file(const Picture<std::uint8_t>& picture)
{
  return png_of_format(picture, PNG_FORMAT_RGB);
}

std::string png_file(const Picture<std::uint16_t>& picture)
{
  return png_of_format(picture, PNG_FORMAT_LINEAR_RGB);
}

std::string exr_file(const Picture<float>& picture)
{
  constexpr int CHANNELS = 3;
  std::array<std::vector<float>, CHANNELS> values;
  std::array<unsigned char*, CHANNELS> planes{};
  std::array<EXRChannelInfo, CHANNELS> channels{};
  std::array<int, CHANNELS> types{};
  for(int c = 0; c < CHANNELS; ++c) {
    for(const auto& pixel : picture.pixels)
      values[c].push_back(pixel[CHANNELS - 1 - c]);
    planes[c] = reinterpret_cast<unsigned char*>(values[c].data());
    channels[c].name[0] = "BGR"[c]; // in the order of the alphabet, as EXR has them
    types[c] = TINYEXR_PIXELTYPE_FLOAT;
  }
  EXRHeader header;
  InitEXRHeader(&header);
  header.compression_type = TINYEXR_COMPRESSIONTYPE_ZIP;
  header.num_channels = CHANNELS;
  header.channels = channels.data();
  header.pixel_types = header.requested_pixel_types = types.data();
  EXRImage image;
  InitEXRImage(&image);
  image.num_channels = CHANNELS;
  image.images = planes.data();
  image.width = picture.width;
  image.height = picture.height;
  unsigned char* bytes = nullptr;
  const char* error = nullptr;
  const std::size_t size = SaveEXRImageToMemory(&image, &header, &bytes, &error);
  const std::unique_ptr<unsigned char, Free> owner(bytes);
  if(size == 0) {
    const std::string reason = error != nullptr ? error : "the reason is unknown";
    FreeEXRErrorMessage(error);
    throw std::runtime_error("tinyexr cannot write the picture: " + reason);
  }
  return {reinterpret_cast<const char*>(bytes), size};
}

Picture<std::uint8_t> read_png(const std::string& bytes)
{
  png_image image = {};
  image.version = PNG_IMAGE_VERSION;
  const std::unique_ptr<png_image, void (*)(png_image*)> owner(&image, png_image_free);
  if(png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()) == 0)
    throw Malformed_file("it is no PNG picture: " + message_of(image));
  constexpr png_uint_32 MOST_PIXELS = 1 << 28;
  if(image.height > MOST_PIXELS / image.width)
    throw Malformed_file("the picture has more than 268435456 pixels");
  image.format = PNG_FORMAT_RGB;
  const png_color background = {255, 255, 255}; // behind what is transparent
  Picture<std::uint8_t> picture{static_cast<int>(image.width), static_cast<int>(image.height), {}};
  picture.pixels.resize(static_cast<std::size_t>(image.width) * image.height);
  if(png_image_finish_read(&image, &background, picture.pixels.data(), 0, nullptr) == 0)
    throw Malformed_file("the PNG picture is damaged: " + message_of(image));
  return picture;
}

Picture<std::uint8_t> checkerboard(int squares, int pixels_of_square)
{
  const Color light{240, 240, 235}, dark{60, 90, 140};
  Picture<std::uint8_t> picture{squares * pixels_of_square, squares * pixels_of_square, {}};
  picture.pixels.resize(static_cast<std::size_t>(picture.width) * picture.height);
  for(int y = 0; y < picture.height; ++y)
    for(int x = 0; x < picture.width; ++x)
      picture.at(x, y) = (x / pixels_of_square + y / pixels_of_square) % 2 == 0 ? light : dark;
  return picture;
}

} // namespace square_map
