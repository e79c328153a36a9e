// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "test_command_line_checks.h"

#include <cmath>
#include <functional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

// Slices of the candidates, and the search that is made of their reports.

namespace {

struct Slices
{
  explicit Slices(std::string name_of_strategy, Soup soup = small, Arguments given = {})
    : strategy(std::move(name_of_strategy)), options(std::move(given)), input(folder.add("in.off", off(soup)))
  {}

  /// the report of a slice, also as a file
  nlohmann::json map_slice(int first, int last)
  {
    const std::string slice = std::to_string(first) + ':' + std::to_string(last);
    const std::string report = folder / ("slice" + std::to_string(reports.size()) + ".json");
    const Finished_process result =
        square_map(Arguments{input, "--strategy", strategy, "--candidates", slice, "--json", report} + options);
    INFO(slice << ": " << result.err);
    REQUIRE(result.status == DONE);
    reports.push_back(report);
    return nlohmann::json::parse(read_file(report));
  }

  Arguments curves() const
  {
    Arguments arguments;
    for(const std::string& report : reports)
      arguments = arguments + Arguments{"--curve", report};
    return arguments;
  }

  /// the bytes of all outputs of the search but the report, and the report without times
  std::pair<std::vector<std::string>, nlohmann::json> search(const Arguments& more)
  {
    const Arguments names{"m.obj", "m.svg", "m.html", "m.png", "g.off"};
    const Arguments outputs{"-o",          folder / names[0], "--svg",       folder / names[1],
                            "--report",    folder / names[2], "--thumbnail", folder / names[3],
                            "--grid-mesh", folder / names[4], "--json",      folder / "m.json"};
    const Finished_process result = square_map(Arguments{input, "--strategy", strategy} + options + outputs + more);
    INFO(result.err);
    REQUIRE(result.status == DONE);
    std::vector<std::string> bytes;
    for(const std::string& name : names)
      bytes.push_back(read_file(folder / name));
    nlohmann::json report = nlohmann::json::parse(read_file(folder / "m.json"));
    report.erase("seconds");
    return {bytes, report};
  }

  Temporary_folder folder;
  std::string strategy;
  Arguments options;
  std::string input;
  std::vector<std::string> reports;
};

/// a round tube, open at both ends, or closed at the upper one by a last vertex: symmetric, so that candidates are alike
Soup tube(long sectors, long rings, bool is_finger)
{
  Soup soup;
  for(long j = 0; j <= rings; ++j)
    for(long i = 0; i < sectors; ++i) {
      const double angle = 2 * 3.14159265358979 * double(i) / double(sectors);
      soup.points.push_back({std::cos(angle), std::sin(angle), double(j)});
    }
  for(long j = 0; j < rings; ++j)
    for(long i = 0; i < sectors; ++i) {
      const long p = j * sectors + i, q = j * sectors + (i + 1) % sectors;
      soup.faces.push_back({p, q, p + sectors});
      soup.faces.push_back({q, q + sectors, p + sectors});
    }
  if(is_finger) {
    for(long i = 0; i < sectors; ++i)
      soup.faces.push_back({rings * sectors + i, rings * sectors + (i + 1) % sectors, (rings + 1) * sectors});
    soup.points.push_back({0, 0, double(rings + 1)});
  }
  return soup;
}

} // namespace

TEST_CASE("a slice of the candidates has the curve of brute force there, both ends included")
{
  Slices slices("brute-force");
  const nlohmann::json full = slices.search({}).second;
  const std::size_t n = full["candidates"].get<std::size_t>();
  REQUIRE(full["curve"].size() == n);
  const std::vector<std::pair<std::size_t, std::size_t>> cases{{0, 0}, {3, 7}, {n - 1, n - 1}, {0, n - 1}};
  for(const auto& [first, last] : cases) {
    const nlohmann::json slice = slices.map_slice(static_cast<int>(first), static_cast<int>(last));
    CHECK(slice["candidates"] == n);
    CHECK(slice["evaluations"] == last - first + 1);
    REQUIRE(slice["curve"].size() == last - first + 1);
    std::size_t best = first;
    for(std::size_t k = first; k <= last; ++k) {
      CHECK(slice["curve"][k - first] == full["curve"][k]);
      if(full["curve"][k]["energy"] < full["curve"][best]["energy"])
        best = k;
    }
    CHECK(slice["best"]["candidate"] == best);
  }
}

TEST_CASE("the reports of all slices make the outputs of brute force, byte for byte")
{
  const auto [strategy, soup, options] = GENERATE(
      std::make_tuple("brute-force", small, Arguments{}),
      std::make_tuple("quarter-brute-force", sheet(12, 8), Arguments{"--aspect", "best", "--threads", "1"}),
      std::make_tuple("brute-force", tube(8, 3, false), Arguments{"--minimizer", "iterative", "--threads", "2"}));
  Slices slices(strategy, soup, options);
  const auto full = slices.search({});
  const int n = full.second["candidates"];
  REQUIRE(n > 4);
  const int middle = n / 2;
  slices.map_slice(middle, n - 2); // in any order, and some twice
  slices.map_slice(n - 1, n - 1);
  slices.map_slice(0, middle);
  CHECK(slices.search(slices.curves()) == full);
}

TEST_CASE("a slice of which no candidate has a map is a result for a report alone, and an error beside another output")
{
  // towards the tip of a long finger the triangles of a convex combination map are too tiny for rounding
  Slices slices("brute-force", tube(8, 200, true), {"--minimizer", "iterative"});
  const nlohmann::json report = slices.map_slice(0, 3);
  CHECK(report["best"].is_null());
  REQUIRE(report["curve"].size() == 4);
  for(const nlohmann::json& sample : report["curve"])
    CHECK(sample["energy"].is_null());
  slices.map_slice(4, 7);
  const Arguments brute_force = Arguments{slices.input, "--strategy", "brute-force"} + slices.options;
  check_refusal(slices.folder, brute_force + Arguments{"--candidates", "0:3", "-o", slices.folder / "map.obj"},
                NO_ONE_TO_ONE_MAP, "none of 4 evaluated candidates");
  // all of them together are refused as brute force is, in the same words
  const Arguments output{"-o", slices.folder / "map.obj"};
  check_refusal(slices.folder, brute_force + output, NO_ONE_TO_ONE_MAP, "none of 8 evaluated candidates");
  check_refusal(slices.folder, brute_force + slices.curves() + output, NO_ONE_TO_ONE_MAP,
                "none of 8 evaluated candidates");
}

TEST_CASE("slices that make no sense are refused")
{
  Slices slices("brute-force");
  const int n = slices.map_slice(0, 0)["candidates"];
  const Arguments brute_force{slices.input, "--strategy", "brute-force", "--json", slices.folder / "report.json"};
  for(const char* text : {"", ":", "1", "1:", ":1", "2:1", "-1:2", "1:2:3", "a:b", "1:2x", "1.5:2", "0:99999999999"})
    check_refusal(slices.folder, brute_force + Arguments{"--candidates", text}, BAD_COMMAND_LINE, "--candidates");
  check_refusal(slices.folder, brute_force + Arguments{"--candidates", "0:" + std::to_string(n)}, BAD_COMMAND_LINE,
                "--candidates 0:" + std::to_string(n) + ": the candidates of this surface are 0 to " +
                    std::to_string(n - 1));
  for(const Arguments& option : {Arguments{"--candidates", "0:1"}, {"--curve", slices.reports[0]}}) {
    check_refusal(slices.folder, Arguments{slices.input} + option, BAD_COMMAND_LINE,
                  option[0] + " goes with --strategy brute-force or quarter-brute-force");
    check_refusal(slices.folder, Arguments{slices.input, "--strategy", "hybrid"} + option, BAD_COMMAND_LINE,
                  option[0] + " goes with --strategy brute-force or quarter-brute-force");
    check_refusal(slices.folder, Arguments{slices.input, "--corners", "0,1,2,3"} + option, BAD_COMMAND_LINE,
                  option[0] + " has no effect beside --corners");
  }
  check_refusal(slices.folder, brute_force + Arguments{"--candidates", "0:1", "--curve", slices.reports[0]},
                BAD_COMMAND_LINE, "--candidates has no effect beside --curve");
}

TEST_CASE("reports that do not make a curve are refused")
{
  Slices slices("brute-force");
  const int n = slices.map_slice(0, 3)["candidates"];
  const Arguments brute_force{slices.input, "--strategy", "brute-force", "-o", slices.folder / "map.obj"};
  const auto check = [&](const Arguments& curves, const std::string& words) {
    check_refusal(slices.folder, brute_force + curves, BAD_FILE, words);
  };
  check(slices.curves(), "lack candidate 4 of " + std::to_string(n));
  slices.map_slice(4, n - 1);
  check({"--curve", slices.folder / "missing.json"}, "there is no such file");
  for(const char* text : {"", "{", "[]", "7", "{\"candidates\": 3}", "{\"candidates\": \"x\", \"curve\": []}",
                          "{\"candidates\": 20, \"curve\": [{\"candidate\": 0}]}"})
    check({"--curve", slices.folder.add("bad.json", text)}, "it is not one of square_map");
  const auto changed = [&](const std::function<void(nlohmann::json&)>& change) {
    nlohmann::json report = nlohmann::json::parse(read_file(slices.reports[0]));
    change(report);
    return Arguments{"--curve", slices.folder.add("bad.json", report.dump())};
  };
  check(slices.curves() + changed([](nlohmann::json& report) { report["candidates"] = 3; }), "it counts 3 candidates");
  check(changed([](nlohmann::json& report) { report["candidates"] = 0; }), "it has no candidates");
  check(slices.curves() + changed([](nlohmann::json& report) { report["curve"][1]["energy"] = 1.5; }),
        "candidate 1 has another value in another report");
  check(changed([&](nlohmann::json& report) { report["curve"][1]["candidate"] = n; }), "is not one of");
  // of other options: the value is not found again
  check(changed([](nlohmann::json& report) { report["curve"][1]["energy"] = 0.001; }) +
            Arguments{"--curve", slices.reports[1]},
        "of another surface or of other options: candidate 1");
  // of another surface
  Slices others("brute-force", sheet(8, 4));
  others.map_slice(0, others.map_slice(0, 0)["candidates"].get<int>() - 1);
  check(others.curves(), "of another surface or strategy");
}
