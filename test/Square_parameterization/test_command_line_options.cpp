// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "test_command_line_checks.h"

// Command lines that make no sense.

TEST_CASE("a command line without input is refused")
{
  const Temporary_folder folder;
  check_refusal(folder, {}, BAD_COMMAND_LINE, "no input");
  check_refusal(folder, {"-o", folder / "map.obj"}, BAD_COMMAND_LINE, "no input");
  check_refusal(folder, {folder / "a.off", folder / "b.off"}, BAD_COMMAND_LINE);
}

TEST_CASE("unknown options and names and numbers out of range are refused")
{
  const Temporary_folder folder;
  const std::string input = folder.add("in.off", off(small));
  const std::vector<Arguments> bad{{"--unknown"},
                                   {"-x"},
                                   {"--strateg", "none"}, // a name is not guessed
                                   {"--strategy", "x"},
                                   {"--strategy", ""},
                                   {"--strategy"},
                                   {"--weights", "x"},
                                   {"--weights", ""},
                                   {"--corner-rule", "x"},
                                   {"--corner-rule", ""},
                                   {"--walk", "x"},
                                   {"--walk", ""},
                                   {"--preset", "x"},
                                   {"--preset", ""},
                                   {"--minimizer", "x"},
                                   {"--minimizer", ""},
                                   {"--border", "x"},
                                   {"--border", ""},
                                   {"--eta", "0"},
                                   {"--eta", "2"},
                                   {"--eta", "-0.5"},
                                   {"--eta", "nan"},
                                   {"--eta", "text"},
                                   {"--eta", "0.5x"},
                                   {"--threads", "-1"},
                                   {"--threads", "x"},
                                   {"--threads", "-4294967295"},
                                   {"--patience", "-1"},
                                   {"--patience", "1.5"},
                                   {"--quiet", "--quiet"},
                                   {"--minimizer", "iterative", "--balance", "0.5"}, // of the other minimizer
                                   {"--minimizer", "iterative", "--border", "sliding"},
                                   {"--minimizer", "optimal", "--balance", "1.5"},
                                   {"--minimizer", "optimal", "--balance", "-0.1"},
                                   {"--minimizer", "optimal", "--balance", "nan"}};
  for(const Arguments& options : bad)
    check_refusal(folder, Arguments{input, "-o", folder / "map.obj", "--json", folder / "report.json"} + options,
                  BAD_COMMAND_LINE);
}

TEST_CASE("an output that cannot be written is refused")
{
  const Temporary_folder folder;
  const std::string input = folder.add("in.off", off(small));
  std::filesystem::create_directory(folder / "folder.obj");
  check_refusal(folder, {input, "-o", folder / "missing/map.obj"}, BAD_COMMAND_LINE);
  check_refusal(folder, {input, "-o", folder / "folder.obj"}, BAD_COMMAND_LINE, "directory");
  check_refusal(folder, {input, "-o", input + "/map.obj"}, BAD_COMMAND_LINE);
  check_refusal(folder, {input, "-o", ""}, BAD_COMMAND_LINE);
  check_refusal(folder, {input, "-o", folder / "map.obj", "--json", folder / "missing/report.json"}, BAD_COMMAND_LINE);
  check_refusal(folder, {input, "-o", folder / "map.obj", "--json", folder / "folder.obj"}, BAD_COMMAND_LINE);
  check_refusal(folder, {input, "-o", folder / "map.obj", "--json", ""}, BAD_COMMAND_LINE);
  if(std::filesystem::is_character_file("/dev/full")) {
    check_refusal(folder, {input, "-o", folder / "map.obj", "--json", "/dev/full"}, BAD_COMMAND_LINE);
    CHECK(std::filesystem::is_character_file("/dev/full"));
    const Finished_process result = square_map({input, "-o", folder / "map.obj", "--json", "-"}, "/dev/full");
    CHECK(result.status == BAD_COMMAND_LINE);
    CHECK(is_one_message(result.err, ""));
    CHECK(folder.file_names() == std::set<std::string>{"folder.obj", "in.off"});
  }
}

TEST_CASE("an output that is the input or another output is refused")
{
  const Temporary_folder folder;
  const std::string input = folder.add("in.off", off(small));
  std::filesystem::create_symlink(input, folder / "link.off");
  std::filesystem::create_hard_link(input, folder / "hard.off");
  for(const char* name : {"in.off", "./in.off", "../" /* and back */, "link.off", "hard.off"}) {
    std::string same = folder / name;
    if(same.back() == '/')
      same += std::filesystem::path(folder / "").parent_path().filename().string() + "/in.off";
    check_refusal(folder, {input, "-o", same}, BAD_COMMAND_LINE, "same file");
    check_refusal(folder, {input, "--json", same}, BAD_COMMAND_LINE, "same file");
  }
  check_refusal(folder, {folder / "link.off", "-o", input}, BAD_COMMAND_LINE, "same file");
  check_refusal(folder, {input, "-o", folder / "map.obj", "--json", folder / "./map.obj"}, BAD_COMMAND_LINE,
                "same file");
  CHECK(read_file(input) == off(small));
}

TEST_CASE("an output with another extension than .obj, .off or .ply is refused")
{
  const Temporary_folder folder;
  const std::string input = folder.add("in.off", off(small));
  for(const char* name : {"map", "map.stl", "map.txt", "obj", ".obj", "map.", "map.obj.gz"})
    check_refusal(folder, {input, "-o", folder / name}, BAD_COMMAND_LINE, ".obj, .off or .ply");
}

namespace {

/// the first vertex from `first` on that is not on the border
long inner_vertex(const std::vector<long>& border, long first)
{
  while(std::find(border.begin(), border.end(), first) != border.end())
    ++first;
  return first;
}

} // namespace

TEST_CASE("corners that are not four border vertices in order are refused")
{
  const Temporary_folder folder;
  const std::string input = folder.add("in.off", off(small));
  const std::vector<long> b = border_of(small.faces);
  const long inner = inner_vertex(b, 0);
  const long beyond = static_cast<long>(small.points.size());
  const auto check = [&](const std::string& corners, const std::string& words) {
    check_refusal(folder, {input, "-o", folder / "map.obj", "--corners", corners}, BAD_COMMAND_LINE, words);
  };
  check(corner_option({b[0], b[3], inner, b[9]}), "vertex " + std::to_string(inner) + " is not on the border");
  check(corner_option({b[0], b[3], beyond, b[9]}), "vertex " + std::to_string(beyond) + " is not on the border");
  check(corner_option({b[0], b[3], b[3], b[9]}), "distinct");
  check(corner_option({b[9], b[6], b[3], b[0]}), "counter-clockwise");
  check(corner_option({b[0], b[6], b[3], b[9]}), "counter-clockwise");
  for(const char* malformed : {"", "1", "0,1,2", "0,1,2,3,4", "0,1,2,", "0,,1,2", "a,b,c,d", "0;1;2;3", "-1,1,2,3",
                               "0,1,2,3x", "0,1,2,99999999999999999999999", "0.5,1,2,3", "+0,1,2,3"})
    check(malformed, "--corners");
}

TEST_CASE("a corner is named by its number in the file when isolated vertices are dropped")
{
  Soup soup = small;
  soup.points.insert(soup.points.begin(), {{7, 7, 7}, {8, 8, 8}});
  for(Face& face : soup.faces)
    for(long& v : face)
      v += 2;
  const Temporary_folder folder;
  const std::string input = folder.add("in.off", off(soup));
  const std::vector<long> b = border_of(soup.faces);
  const long inner = inner_vertex(b, 2);
  check_refusal(folder, {input, "--corners", corner_option({b[0], b[3], inner, b[9]})}, BAD_COMMAND_LINE,
                "vertex " + std::to_string(inner) + " is not on the border");
  check_refusal(folder, {input, "--corners", corner_option({b[0], b[3], 1, b[9]})}, BAD_COMMAND_LINE,
                "vertex 1 is not on the border");
}
