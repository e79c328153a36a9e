// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_FUZZ_MAP_BYTES_H
#define CGAL_EXT_FUZZ_MAP_BYTES_H

#include "map_soup.h"

/// builds a surface from bytes and maps it. Throws when a map, or the surface that is mapped, is not what it should be.
inline Outcome map_bytes(const std::uint8_t* data, std::size_t size)
{
  Byte_source bytes(data, size);
  const Choices_of_bytes choices(bytes);
  return map_soup(Soup_of_bytes(bytes).soup(), choices).outcome;
}

#endif // CGAL_EXT_FUZZ_MAP_BYTES_H
