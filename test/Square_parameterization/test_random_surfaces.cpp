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

/// maps random surfaces; all that are accepted must get a map
void check_seeds(unsigned int first, unsigned int count)
{
  std::map<Outcome, unsigned int> outcomes;
  for(unsigned int seed = first; seed < first + count; ++seed) {
    INFO("seed " << seed);
    Outcome outcome = Outcome::REFUSED;
    REQUIRE_NOTHROW(outcome = map_random_bytes(seed));
    CHECK(outcome != Outcome::UNMAPPED);
    ++outcomes[outcome];
  }
  CHECK(outcomes[Outcome::ONE_TO_ONE] >= count / 3);
}

} // namespace

TEST_CASE("random surfaces with holes, handles, chords and faces without area are mapped one-to-one or refused")
{
  check_seeds(0, 300);
}

TEST_CASE("surfaces with faces a rounding error high, of which maps were once lost or infinite, are mapped")
{
  for(unsigned int seed : {1434u, 1962u})
    CHECK(map_random_bytes(seed) == Outcome::ONE_TO_ONE);
}

TEST_CASE("many random surfaces are mapped one-to-one or refused", "[.long]")
{
  check_seeds(300, 20000);
}
