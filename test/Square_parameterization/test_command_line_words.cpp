// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "test_command_line_checks.h"
#include "test_command_line_closed.h"

#include <CGAL/version_macros.h>

// What is asked for and told, in words.

TEST_CASE("the version is printed, whatever else is asked")
{
  for(const Arguments& arguments : {Arguments{"--version"}, {"--version", "missing.off"}}) {
    const Finished_process result = square_map(arguments);
    CHECK(result.status == DONE);
    CHECK(result.out == "square_map " SQUARE_MAP_VERSION " (CGAL " CGAL_VERSION_STR ")\n");
    CHECK(result.err == "");
  }
  for(const char* option : {"--version", "--help"}) {
    const Finished_process result = square_map({option}, "/dev/full");
    CHECK(result.status == BAD_COMMAND_LINE);
    CHECK(is_one_message(result.err, "cannot write to standard output"));
  }
}

TEST_CASE("a quiet run has a short name")
{
  const Temporary_folder folder;
  const Finished_process result = square_map({folder.add("in.off", off(small)), "-q", "-o", folder / "map.obj"});
  CHECK(result.status == DONE);
  CHECK(result.out + result.err == "");
}

TEST_CASE("an option is no name of a file")
{
  const Temporary_folder folder;
  const std::string input = folder.add("in.off", off(small));
  for(const Arguments& options : {
          Arguments{"--json=--quiet"},
          {"-o", "--json"},
          {"-o", "--map.obj"},
      })
    check_refusal(folder, Arguments{input} + options, BAD_COMMAND_LINE, "needs the name of a file, not the option");
  for(const char* option : {"--json", "--seams", "--texture", "--svg", "--report", "--thumbnail", "--image",
                            "--normal-map", "--attributes", "--grid-mesh", "--curve"})
    check_refusal(folder, {input, option, "--quiet"}, BAD_COMMAND_LINE, "needs the name of a file, not the option");
  check_refusal(folder, {input, "--json", "-q"}, BAD_COMMAND_LINE, "--json");
  for(const char* output : {"-o", "--output"}) // the next value is left over
    check_refusal(folder, {input, output, "--json", "-"}, BAD_COMMAND_LINE,
                  std::string(output) + " needs a value, not the option --json");
  for(const Arguments& rest : {Arguments{"--", "b.off"}, {"-o", "--", "m.obj"}, {"b.off", "c.off"}})
    check_refusal(folder, Arguments{input} + rest, BAD_COMMAND_LINE, "too many positional options");
  for(const char* option : {"--seams", "--texture", "--curve"})
    check_refusal(folder, {input, "-o", folder / "map.obj", "--strategy", "brute-force", option, "-"}, BAD_COMMAND_LINE,
                  "- is standard input for the surface alone");
  const auto in_folder = [&] { CHECK(chdir((folder / "").c_str()) == 0); };
  CHECK(square_map({input, "-q", "-o", "./--map.obj"}, "", in_folder).status == DONE);
  CHECK(folder.file_names() == std::set<std::string>{"--map.obj", "in.off"});
}

TEST_CASE("a message is one line, also where the name of a file has several")
{
  const Temporary_folder folder;
  check_refusal(folder, {folder / "a\nb.off"}, BAD_FILE, "a?b.off': there is no such file");
  const std::string input = folder.add("in.off", off(small));
  check_refusal(folder, {input, "-o", folder / "a\nf 1 1 1.obj", "--texture", "checker"}, BAD_COMMAND_LINE,
                "the name of the output has a line break");
  CHECK(square_map({input, "-q", "-o", folder / "a\nb.obj"}).status == DONE);
}

TEST_CASE("a list of corners may have blanks")
{
  const std::vector<long> b = border_of(small.faces);
  const auto with = [&](const std::string& comma) {
    std::string list = std::to_string(b[0]);
    for(int k : {3, 6, 9})
      list += comma + std::to_string(b[static_cast<std::size_t>(k)]);
    return list;
  };
  const std::string expected = check_map(small, {"--corners", with(",")}).text;
  for(const std::string& list : {with(", "), with(" , "), " " + with(",") + " ", with(",\t")})
    CHECK(check_map(small, {"--corners", list}).text == expected);
}

/// tries all orders of four corners: of those that are refused the order that is told has to be right, and to begin as they do
/// \return how many are refused
int check_orders_told(const std::array<long, 4>& corners, const Arguments& arguments)
{
  int refused = 0;
  std::array<std::size_t, 4> order{0, 1, 2, 3};
  do {
    const std::string list =
        corner_option({corners[order[0]], corners[order[1]], corners[order[2]], corners[order[3]]});
    const Finished_process result = square_map(arguments + Arguments{"--corners", list});
    const std::string words = "this would be: ";
    const std::size_t told = result.err.find(words);
    INFO(list << ": " << result.err);
    CHECK((result.status == DONE) == (told == std::string::npos));
    if(told == std::string::npos)
      continue;
    ++refused;
    const std::string right = result.err.substr(told + words.size(), result.err.size() - told - words.size() - 1);
    CHECK(right.rfind(std::to_string(corners[order[0]]) + ",", 0) == 0);
    CHECK(square_map(arguments + Arguments{"--corners", right}).status == DONE);
  } while(std::next_permutation(order.begin(), order.end()));
  return refused;
}

TEST_CASE("the order of corners that is said to be right is right")
{
  const Temporary_folder folder;
  const std::vector<long> b = border_of(small.faces);
  CHECK(check_orders_told({b[0], b[3], b[6], b[9]}, {folder.add("in.off", off(small))}) == 20);
}

TEST_CASE("the order of corners that is said to be right is right where a seam makes two of one vertex, too")
{
  const Temporary_folder folder;
  const std::string input = folder.add("in.off", off(soup_of(ellipsoid(0))));
  CHECK(check_orders_told({0, 1, 2, 3}, {input, "--seams", folder.add("seams", "0 2\n2 1\n1 3\n")}) > 0);
}

TEST_CASE("one thing is counted in the singular")
{
  // two triangles with a third on an edge of theirs: the ear of the strip has one chord
  const Soup fan{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}}, {{0, 1, 4}, {1, 3, 4}, {1, 2, 3}}};
  const Mapped mapped = check_map(fan);
  const std::size_t chords = mapped.report["conditioned"]["chords_split"];
  CHECK(mapped.messages.find(chords == 1 ? "1 chord was split\n" : "2 chords were split\n") != std::string::npos);
  Soup square{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2, 3}}};
  const Mapped polygon = check_map(square, {"--triangulate"});
  CHECK(polygon.messages.find("1 polygon was split into triangles\n") != std::string::npos);
  CHECK(polygon.messages.find("1 chord was split\n") != std::string::npos);
  Soup turned = small;
  turned.points.push_back({9, 9, 9});
  std::swap(turned.faces[5][0], turned.faces[5][1]);
  const Mapped one = check_map(turned);
  CHECK(one.messages.find("1 face was turned round to agree with the neighbors\n") != std::string::npos);
  CHECK(one.messages.find("1 isolated vertex was dropped\n") != std::string::npos);
}
