// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Bytes as a small triangulation: whatever is mapped must be mapped one-to-one.

#include "map_bytes.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  map_bytes(data, size);
  return 0;
}
