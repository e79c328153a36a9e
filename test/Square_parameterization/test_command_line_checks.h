// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TEST_COMMAND_LINE_CHECKS_H
#define TEST_COMMAND_LINE_CHECKS_H

#include "test_command_line_map.h"
#include "test_command_line_process.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <set>
#include <string>
#include <utility>
#include <vector>

// Runs the built command as users do: what it writes is read back and measured without the code under test.

typedef std::vector<std::string> Arguments;

enum Exit_status
{
  DONE = 0,
  BAD_COMMAND_LINE = 2,
  BAD_FILE = 3,
  UNMAPPABLE = 4,
  NO_ONE_TO_ONE_MAP = 5
};

inline Arguments operator+(Arguments arguments, const Arguments& more)
{
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

/// one line that begins with the name of the command and holds `words`
inline bool is_one_message(const std::string& text, const std::string& words)
{
  return text.rfind("square_map: ", 0) == 0 && std::count(text.begin(), text.end(), '\n') == 1 && text.back() == '\n' &&
         text.find(words) != std::string::npos;
}

/// the command must end with `status` and one message that holds `words`, write nothing, and leave no file behind
/// \param prepare see `Running_process`
inline void check_refusal(
    const Temporary_folder& folder, const Arguments& arguments, Exit_status status, const std::string& words = "",
    const std::function<void()>& prepare = [] {})
{
  for(const Arguments& quiet : {Arguments{}, Arguments{"--quiet"}}) {
    const std::set<std::string> files = folder.file_names();
    const Finished_process result = square_map(arguments + quiet, "", prepare);
    INFO(Catch::StringMaker<Arguments>::convert(arguments) << "\n" << result.err);
    CHECK(result.status == status);
    CHECK(result.out == "");
    CHECK(is_one_message(result.err, words));
    CHECK(folder.file_names() == files);
  }
}

/// an input must be refused whether or not the outputs exist, and existing ones must survive
inline void check_refusal_of_input(
    const std::string& input, Exit_status status, const std::string& words = "", const Arguments& options = {},
    const std::function<void()>& prepare = [] {})
{
  const Temporary_folder folder;
  const std::string map = folder / "map.obj", report = folder / "report.json";
  const Arguments arguments = Arguments{input, "-o", map, "--json", report} + options;
  check_refusal(folder, arguments, status, words, prepare);
  folder.add("map.obj", "my map");
  folder.add("report.json", "my report");
  check_refusal(folder, arguments, status, words, prepare);
  CHECK(read_file(map) == "my map");
  CHECK(read_file(report) == "my report");
}

inline void check_refusal_of_text(const std::string& name, const std::string& text, Exit_status status,
                                  const std::string& words = "", const Arguments& options = {})
{
  INFO(name << " of " << text.size() << " bytes");
  const Temporary_folder folder;
  check_refusal_of_input(folder.add(name, text), status, words, options);
}

inline void check_refusal_of_soup(const Soup& soup, Exit_status status, const std::string& words = "",
                                  const Arguments& options = {})
{
  for(const auto& [name, text] : {std::make_pair("in.off", off(soup)), std::make_pair("in.obj", obj(soup)),
                                  std::make_pair("in.ply", ply(soup)), std::make_pair("in.PLY", binary_ply(soup))})
    check_refusal_of_text(name, text, status, words, options);
}

/// a map that the command wrote, its report and the messages that came with it
struct Mapped
{
  Map map;
  nlohmann::json report;
  std::string text, messages;
};

/// maps a file, checks all that must hold of every map, and returns it
inline Mapped check_map(const std::string& input, const Arguments& options = {}, const std::string& extension = "obj")
{
  const Temporary_folder folder;
  const std::string output = folder / ("map." + extension), report = folder / "report.json";
  const Finished_process result = square_map(Arguments{input, "-o", output, "--json", report} + options);
  INFO(Catch::StringMaker<Arguments>::convert(options) << "\n" << result.err);
  REQUIRE(result.status == DONE);
  CHECK(result.out == "");
  CHECK(folder.file_names() == std::set<std::string>{"map." + extension, "report.json"});

  Mapped mapped{{}, nlohmann::json::parse(read_file(report)), read_file(output), result.err};
  mapped.map = extension == "obj"   ? read_obj_map(mapped.text)
               : extension == "off" ? read_off_map(mapped.text)
                                    : read_ply_map(mapped.text);
  const nlohmann::json& best = mapped.report["best"];
  REQUIRE(mapped.map.points.size() == mapped.report["conditioned"]["vertices"]);
  REQUIRE(mapped.map.uv.size() == mapped.map.points.size());
  REQUIRE(mapped.map.faces.size() == mapped.report["conditioned"]["faces"]);
  CHECK(border_of(mapped.map.faces).size() == mapped.report["conditioned"]["border_edges"]);
  CHECK(border_fault(mapped.map, best["corners"].get<std::vector<long>>()) == "");
  const Measures measures = measure(mapped.map);
  CHECK(measures.flipped == 0);
  CHECK(best["flipped"] == 0);
  CHECK(double(measures.uv_area) == Approx(1).epsilon(1e-12));
  CHECK(best["l2"].get<double>() == Approx(double(measures.l2)).epsilon(1e-9));
  // the largest singular value is a square root that vanishes where the map is an isometry: half the digits
  CHECK(best["linf"].get<double>() == Approx(double(measures.linf)).epsilon(1e-9));
  CHECK(best["symmetric_dirichlet"].get<double>() == Approx(double(measures.symmetric_dirichlet)).epsilon(1e-9));
  CHECK(best["l2"].get<double>() >= 1 - 1e-12);
  return mapped;
}

inline Mapped check_map(const Soup& soup, const Arguments& options = {}, const std::string& extension = "obj")
{
  const Temporary_folder folder;
  return check_map(folder.add("in.off", off(soup)), options, extension);
}

/// the report without what may differ from run to run
inline nlohmann::json without_times_and_names(nlohmann::json report)
{
  report.erase("seconds");
  report.erase("threads");
  report["input"].erase("file");
  return report;
}

inline const Soup small = sheet(6, 4);

/// the value of `--corners`
inline std::string corner_option(const std::vector<long>& corners)
{
  std::string text;
  for(long v : corners)
    text += (text.empty() ? "" : ",") + std::to_string(v);
  return text;
}

#endif // TEST_COMMAND_LINE_CHECKS_H
