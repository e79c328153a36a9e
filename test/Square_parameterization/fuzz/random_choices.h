// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_FUZZ_RANDOM_CHOICES_H
#define CGAL_EXT_FUZZ_RANDOM_CHOICES_H

#include "Choices_of_bytes.h"
#include "test_meshes.h"

#include <cstdint>
#include <vector>

/// the bytes of the default settings but for the component: the balanced energy with a sliding border, bracketing, the
/// best cut, and polygons split
inline std::vector<std::uint8_t> bytes_of_defaults()
{
  return {11, 0, 64};
}

/// the default settings, or others at random
inline Choices_of_bytes random_choices(unsigned int seed, unsigned int threads)
{
  std::vector<std::uint8_t> bytes = bytes_of_defaults();
  Random_numbers random(seed + 1000000000u); // apart from the numbers of the surface
  if(random(0, 1) < 0.5) {
    bytes.resize(7);
    for(std::uint8_t& byte : bytes)
      byte = static_cast<std::uint8_t>(random.below(256));
  }
  Byte_source source(bytes.data(), bytes.size());
  Choices_of_bytes choices(source);
  choices.options.search_options.number_of_threads = threads;
  return choices;
}

#endif // CGAL_EXT_FUZZ_RANDOM_CHOICES_H
