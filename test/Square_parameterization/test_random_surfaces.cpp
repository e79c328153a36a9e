// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "fuzz/map_bytes.h"
#include "test_meshes.h"

#include <catch2/catch.hpp>

#include <map>

// What the fuzzer of maps does, for a fixed sequence of random meshes, and for those that once found a bug.

namespace {

Outcome map_random_bytes(unsigned int seed)
{
  Random_numbers random(seed);
  std::vector<std::uint8_t> bytes(30 + random.below(300));
  for(std::uint8_t& byte : bytes)
    byte = static_cast<std::uint8_t>(random.below(256));
  return map_bytes(bytes.data(), bytes.size());
}

} // namespace

TEST_CASE("random surfaces with holes, handles, chords and faces without area are mapped one-to-one or refused")
{
  std::map<Outcome, int> outcomes;
  for(unsigned int seed = 0; seed < 300; ++seed) {
    INFO("seed " << seed);
    Outcome outcome = Outcome::REFUSED;
    REQUIRE_NOTHROW(outcome = map_random_bytes(seed));
    if(outcome == Outcome::UNMAPPED)
      UNSCOPED_INFO("seed " << seed << " has no map");
    ++outcomes[outcome];
  }
  CHECK(outcomes[Outcome::ONE_TO_ONE] >= 100);
  CHECK(outcomes[Outcome::UNMAPPED] == 0);
}
