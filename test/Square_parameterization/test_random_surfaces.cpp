// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "fuzz/Random_surface.h"
#include "fuzz/map_bytes.h"
#include "fuzz/random_choices.h"
#include "square_map/name_of_start.h"
#include "test_meshes.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

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

/// the surface of bytes given as pairs of hexadecimal digits
Outcome map_hexadecimal(const std::string& digits)
{
  std::vector<std::uint8_t> bytes;
  for(std::size_t i = 0; i + 1 < digits.size(); i += 2)
    bytes.push_back(static_cast<std::uint8_t>(std::stoi(digits.substr(i, 2), nullptr, 16)));
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
  CHECK(map_hexadecimal(
            "090001000000000000020000000694861c3341069334859f1203996806a5598282e00433890054230012640644eaecdc5801"
            "fbbf7500239e0680005fd30403be5a05389a016dcd550307aa07dc60ce00fefa00a698074a642904890b0350e8006bc007ea"
            "5bfb00fe7701628ae1078f294703d6dc0150a20806ab4205bc8e07890d9f00906d07f7011001a366d3018bc154013f21da00"
            "424c06f8e0000000") == Outcome::ONE_TO_ONE);
  CHECK(map_hexadecimal(
            "0100000000000002020200000004c6c206a281d0e226041d05065ed05ae9da06dffcdbdf9807158d2e06c7feb9188b00101b"
            "03c4ce048c5803215900c38307107f180557ea02b25300048ea90448050121f61402739b00050000") == Outcome::ONE_TO_ONE);
}

TEST_CASE("surfaces with nails, handles, spikes, snapped coordinates and the like are mapped one-to-one or refused")
{
  std::map<Outcome, unsigned int> outcomes;
  for(unsigned int seed = 0; seed < 80; ++seed) {
    const Random_surface surface(seed, 30);
    if(surface.soup().faces.size() > 100) // with all its nails and handles
      continue;
    INFO("seed " << seed << ": " << surface.name());
    Outcome outcome = Outcome::REFUSED;
    REQUIRE_NOTHROW(outcome = map_soup(surface.soup(), random_choices(seed, 1)).outcome);
    ++outcomes[outcome];
  }
  CHECK(outcomes[Outcome::ONE_TO_ONE] >= 30);
}

namespace {

/// the usual search, which notes the work for the first candidate each time it is asked
struct Noting_search
{
  CGAL_ext::Candidate_set candidate_set() const { return CGAL_ext::Bracketing_corner_search().candidate_set(); }

  void operator()(const CGAL_ext::Corner_search_problem& problem) const
  {
    problem.objective_of({0});
    works.push_back(problem.work());
    CGAL_ext::Bracketing_corner_search()(problem);
  }

  std::vector<double>& works;
};

/// the default settings, of the first component
Choices_of_bytes default_choices()
{
  const std::vector<std::uint8_t> bytes = bytes_of_defaults();
  Byte_source source(bytes.data(), bytes.size());
  Choices_of_bytes choices(source);
  choices.conditioning_options.component = 0;
  return choices;
}

/// maps a surface of up to 2000 faces with default settings
Mapped_soup map_with_default_minimization(unsigned int seed, bool tries_other_starts = true)
{
  Choices_of_bytes choices = default_choices();
  choices.options.minimization = CGAL_ext::Balanced_minimization();
  choices.options.tries_other_starts = tries_other_starts;
  return map_soup(Random_surface(seed, 2000).soup(), choices);
}

/// maps one of the surfaces of up to 2000 faces that took longest, with all but default settings
/// \return the work for the first candidate, in sweeps over the mesh, of each search
std::pair<std::vector<double>, Mapped_soup> map_costly_surface(unsigned int seed)
{
  Choices_of_bytes choices = default_choices();
  std::vector<double> works;
  choices.options.search = Noting_search{works};
  Mapped_soup mapped = map_soup(Random_surface(seed, 2000).soup(), choices);
  return {works, mapped};
}

} // namespace

TEST_CASE("a surface whose usual start leads to no map, or to a poor one, is mapped from another start")
{
  using CGAL_ext::Map_start;
  const auto [seed, start] = GENERATE(table<unsigned int, Map_start>(
      {{10201052, Map_start::UNIFORM_WEIGHTS},                       // a fan, crumpled
       {10201177, Map_start::UNIFORM_WEIGHTS},                       // a tube with nails, snapped
       {16000112, Map_start::UNIFORM_WEIGHTS},                       // a spiral with handles, snapped
       {31000647, Map_start::UNIFORM_WEIGHTS},                       // fins with handles and holes, of polygons
       {32000217, Map_start::UNIFORM_WEIGHTS},                       // a torus with nails, flattened
       {31000529, Map_start::MEAN_VALUE_WEIGHTS},                    // a fan with nails
       {31000268, Map_start::GRADUAL_COARSENING},                    // a fan with nails, holes and spikes
       {12000058, Map_start::GRADUAL_COARSENING_UNIFORM_WEIGHTS},    // fins with nails and spikes
       {12000199, Map_start::GRADUAL_COARSENING_MEAN_VALUE_WEIGHTS}, // a sheet with nails, ears and spikes
       {16000010, Map_start::FIXED_BORDER_FIRST_UNIFORM_WEIGHTS},    // a torn fan, snapped
       {12000110, Map_start::FIXED_BORDER_FIRST_UNIFORM_WEIGHTS}})); // a sheet with spikes
  CAPTURE(seed);
  const auto soup = Random_surface(seed, 2000).soup();
  Choices_of_bytes choices = default_choices();
  const auto map_from = [&](bool tries_other_starts, const CGAL_ext::Balanced_minimization& minimization) {
    choices.options.tries_other_starts = tries_other_starts;
    choices.options.minimization = minimization;
    return map_soup(soup, choices);
  };
  CGAL_ext::Balanced_minimization minimization;
  const Mapped_soup mapped = map_from(true, minimization), usual = map_from(false, minimization);
  REQUIRE(mapped.outcome == Outcome::ONE_TO_ONE);
  CHECK(mapped.start == start);
  // not far above the maps from the weights, or the border, of other starts
  minimization.start.weights = CGAL_ext::Uniform_weights();
  const Mapped_soup uniform = map_from(false, minimization);
  minimization.border = CGAL_ext::Border_motion::FIXED;
  const Mapped_soup fixed = map_from(false, minimization);
  for(const Mapped_soup& other : {usual, uniform, fixed})
    if(other.outcome == Outcome::ONE_TO_ONE)
      CHECK(mapped.measures.l2 < 1.3 * other.measures.l2);
}

TEST_CASE("a surface of which the cut that was decided on leaves no map is mapped along the shortest cut")
{
  const auto soup = Random_surface(96401433, 9000).soup();
  Choices_of_bytes choices = default_choices();
  const Mapped_soup mapped = map_soup(soup, choices);
  REQUIRE(mapped.outcome == Outcome::ONE_TO_ONE);
  CHECK(mapped.has_shortest_cut);
  choices.options.tries_other_starts = false; // nor other cuts
  CHECK(map_soup(soup, choices).outcome == Outcome::UNMAPPED);
  choices.options.tries_other_starts = true;
  choices.options.cut.mode = CGAL_ext::Cut_mode::SHORTEST;
  const Mapped_soup shortest = map_soup(soup, choices);
  CHECK_FALSE(shortest.has_shortest_cut); // instead of another one
  CHECK(shortest.measures.l2 == mapped.measures.l2);
}

TEST_CASE("a spiral with ears and spikes that small steps of coarsening lose is mapped by halves, with its border "
          "fixed first")
{
  const Mapped_soup mapped = map_with_default_minimization(97000350);
  REQUIRE(mapped.outcome == Outcome::ONE_TO_ONE);
  CHECK(mapped.start == CGAL_ext::Map_start::FIXED_BORDER_FIRST_MEAN_VALUE_WEIGHTS);
  CHECK(mapped.measures.l2 < 76.43); // of the border that is fixed to the end
}

TEST_CASE("a surface that is stretched thousands of times along the best cut is mapped along the shortest")
{
  const Mapped_soup mapped = map_with_default_minimization(17000356);
  REQUIRE(mapped.outcome == Outcome::ONE_TO_ONE);
  CHECK(mapped.has_shortest_cut);
  const Mapped_soup along_best = map_with_default_minimization(17000356, false); // nor other cuts
  REQUIRE(along_best.outcome == Outcome::ONE_TO_ONE);
  CHECK_FALSE(along_best.has_shortest_cut);
  CHECK(mapped.measures.l2 < 0.7 * along_best.measures.l2);
}

namespace {

/// counts the scores of cuts, which are told in groups
struct Progress_counter : CGAL_ext::Search_visitor
{
  void cut_progress(double) override { ++calls; }
  int calls = 0;
};

} // namespace

TEST_CASE("a surface of some hundred faces of which no cut has a map is not searched for one for long")
{
  Progress_counter counter;
  Choices_of_bytes choices = default_choices();
  choices.options.search_options.visitor = &counter;
  const Mapped_soup mapped = map_soup(Random_surface(95000952, 2000).soup(), choices); // a fan, crumpled, snapped
  CHECK(mapped.outcome == Outcome::UNMAPPED);
  CHECK(counter.calls > 5);
  CHECK(counter.calls < 20); // 28 where it is searched as long as a large one
}

TEST_CASE("each start has a name of its own")
{
  std::set<std::string> names;
  for(int start = 0; start <= static_cast<int>(CGAL_ext::Map_start::FIXED_BORDER_FIRST_MEAN_VALUE_WEIGHTS); ++start)
    names.insert(square_map::name_of(static_cast<CGAL_ext::Map_start>(start)));
  CHECK(names.size() == 12);
  CHECK(square_map::name_of(CGAL_ext::Map_start::UNIFORM_WEIGHTS) == "uniform weights");
  CHECK(square_map::name_of(CGAL_ext::Map_start::GRADUAL_COARSENING_UNIFORM_WEIGHTS) ==
        "gradual coarsening, uniform weights");
}

TEST_CASE("a spiral with ears, whose rims of large fans were once lost in rounding, is mapped")
{
  const auto [works, mapped] = map_costly_surface(7000152);
  CHECK(mapped.outcome == Outcome::ONE_TO_ONE);
  CHECK(works.size() == 2); // from the chosen start and by small steps
}

TEST_CASE(
    "a surface with ears is refused after one candidate from each start, where a longer search would get no further")
{
  const auto [works, mapped] = map_costly_surface(10200962);
  CHECK(mapped.outcome == Outcome::UNMAPPED);
  CHECK(works.size() == 6); // all that there are for a border of four vertices, which cannot slide
  CHECK(mapped.message == "none of 1 evaluated candidate has a one-to-one map");
  CHECK(*std::max_element(works.begin(), works.end()) < 2500); // once 3400 to 6000, by small steps of coarsening
}

TEST_CASE("where maps cost much, and are stretched thousands of times, not all starts are tried")
{
  const auto [works, mapped] = map_costly_surface(7000476);
  CHECK(mapped.outcome == Outcome::ONE_TO_ONE);
  CHECK(works.size() == 3); // there are more
}

TEST_CASE(
    "where mean value coordinates lead to a map that is lost in rounding, the middle of the rings is tried at once")
{
  const auto [works, mapped] = map_costly_surface(7000312);
  CHECK(mapped.outcome == Outcome::ONE_TO_ONE);
  REQUIRE(!works.empty());
  CHECK(works.front() < 420); // 697 by a slower start
}

TEST_CASE("many random surfaces are mapped one-to-one or refused", "[.long]")
{
  check_seeds(300, 20000);
}
