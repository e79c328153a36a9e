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

TEST_CASE("a number out of range is refused, and never moved into it")
{
  const Temporary_folder folder;
  const std::string input = folder.add("in.off", off(small));
  const std::vector<std::pair<Arguments, std::string>> bad{
      {{"--strategy", "step-sampling", "--step", "-1"}, "--step must be a whole number from 0"},
      {{"--strategy", "step-sampling", "--step", "1000001"}, "--step must be a whole number from 0 to 1000000"},
      {{"--strategy", "step-sampling", "--step", "2.5"}, "--step must be a whole number"},
      {{"--strategy", "hybrid", "--interval", "-1"}, "--interval must be a whole number from 0"},
      {{"--strategy", "hybrid", "--interval", "99999999999"}, "--interval must be a whole number"},
      {{"--strategy", "particle-swarm", "--seed", "-1"}, "--seed must be a whole number from 0"},
      {{"--strategy", "particle-swarm", "--seed", "1000001"}, "--seed must be a whole number from 0 to 1000000"},
      {{"--patience", "1000001"}, "--patience must be a whole number from 0 to 1000000"},
      {{"--threads", "1000001"}, "--threads must be a whole number from 0 to 1000000"},
      {{"--eta", "1.0000001"}, "--eta must be above 0 and at most 1"},
      {{"--balance", "1.0000001"}, "--balance must be from 0 to 1"},
      {{"--aspect", "0"}, "--aspect must be from 0.001 to 1000, or best; not '0'"},
      {{"--aspect", "-2"}, "--aspect must be from 0.001 to 1000, or best; not '-2'"},
      {{"--aspect", "nan"}, "--aspect must be from 0.001 to 1000, or best; not 'nan'"},
      {{"--aspect", "1e9"}, "--aspect must be from 0.001 to 1000, or best; not '1e9'"},
      {{"--minimizer", "iterative", "--aspect", "2"}, "--aspect goes with --minimizer optimal"},
      {{"--quarter-corners", "--minimizer", "iterative"},
       "--quarter-corners goes with --minimizer optimal, and a search"},
      {{"--cut-weight", "-0.001"}, "--cut-weight must be a finite number, 0 or more; not '-0.001'"},
      {{"--cut-weight", "nan"}, "--cut-weight must be a finite number, 0 or more; not 'nan'"},
      {{"--max-cut-length", "-1"}, "--max-cut-length must be a number, 0 or more; not '-1'"},
      {{"--max-cut-length", "nan"}, "--max-cut-length must be a number, 0 or more; not 'nan'"},
      {{"--cut-weight", "inf"}, "--cut-weight must be a finite number, 0 or more; not 'inf'"},
      {{"--threads", "x"}, "--threads must be a whole number from 0 to 1000000; not 'x'"},
      {{"--threads", "4294967297"}, "--threads must be a whole number from 0 to 1000000; not '4294967297'"},
      {{"--patience", "1e3"}, "--patience must be a whole number from 0 to 1000000; not '1e3'"},
      {{"--balance", "0,5"}, "--balance must be from 0 to 1; not '0,5'"},
      {{"--eta", "0.5x"}, "--eta must be above 0 and at most 1; not '0.5x'"},
      {{"--time-limit", "1e400"}, "--time-limit must be above 0 and at most 1e9 seconds; not '1e400'"},
      {{"--time-limit", "0"}, "--time-limit must be above 0 and at most 1e9 seconds; not '0'"},
      {{"--component", "-1"}, "--component"},
      {{"--component", "1"}, "no component 1"}};
  for(const auto& [options, words] : bad)
    check_refusal(folder, Arguments{input, "-o", folder / "map.obj"} + options, BAD_COMMAND_LINE, words);
}

TEST_CASE("an option without an effect beside the others is refused, with its default value, too")
{
  const Temporary_folder folder;
  const std::string input = folder.add("in.off", off(small)), seams = folder.add("seams.txt", "8 9\n");
  const std::vector<long> b = border_of(small.faces);
  const Arguments corners{"--corners", corner_option({b[0], b[3], b[6], b[9]})}, cut{"--seams", seams};
  const std::vector<std::pair<Arguments, std::string>> bad{
      // numbers of a strategy that is not used: another is given, or is the default
      {{"--step", "2"}, "--step goes with --strategy step-sampling"},
      {{"--step", "0"}, "--step goes with --strategy step-sampling"},
      {{"--step", "2", "--strategy", "hybrid"}, "--step goes with --strategy step-sampling"},
      {{"--step", "2", "--preset", "paper"}, "--step goes with --strategy step-sampling"},
      {{"--interval", "2"}, "--interval goes with --strategy hybrid"},
      {{"--interval", "0"}, "--interval goes with --strategy hybrid"},
      {{"--interval", "2", "--minimizer", "iterative", "--strategy", "bracketing"},
       "--interval goes with --strategy hybrid"},
      {{"--seed", "1"}, "--seed goes with --strategy particle-swarm"},
      {{"--seed", "0"}, "--seed goes with --strategy particle-swarm"},
      {{"--seed", "1", "--strategy", "step-sampling"}, "--seed goes with --strategy particle-swarm"},
      // what searches corners, beside corners
      {corners + Arguments{"--strategy", "hybrid"}, "--strategy has no effect beside --corners"},
      {corners + Arguments{"--strategy", "none"}, "--strategy has no effect beside --corners"},
      {corners + Arguments{"--corner-rule", "author"}, "--corner-rule has no effect beside --corners"},
      {corners + Arguments{"--corner-rule", "nearest"}, "--corner-rule has no effect beside --corners"},
      {corners + Arguments{"--walk", "clockwise"}, "--walk has no effect beside --corners"},
      {corners + Arguments{"--walk", "counter-clockwise"}, "--walk has no effect beside --corners"},
      {corners + Arguments{"--step", "2"}, "--step has no effect beside --corners"},
      {corners + Arguments{"--interval", "2"}, "--interval has no effect beside --corners"},
      {corners + Arguments{"--seed", "2"}, "--seed has no effect beside --corners"},
      // what chooses a cut, where it is given, short, or none
      {cut + Arguments{"--cut", "best"}, "--cut has no effect beside --seams"},
      {cut + Arguments{"--cut", "none"}, "--cut has no effect beside --seams"},
      {cut + Arguments{"--cut-weight", "0.05"}, "--cut-weight has no effect beside --seams"},
      {cut + Arguments{"--max-cut-length", "2"}, "--max-cut-length has no effect beside --seams"},
      {cut + Arguments{"--cut-disk"}, "--cut-disk has no effect beside --seams"},
      {{"--cut", "none", "--cut-weight", "0.05"}, "--cut-weight goes with --cut best"},
      {{"--cut", "shortest", "--cut-weight", "0.1"}, "--cut-weight goes with --cut best"},
      {{"--cut", "none", "--max-cut-length", "2"}, "--max-cut-length goes with --cut best"},
      {{"--cut", "shortest", "--max-cut-length", "2"}, "--max-cut-length goes with --cut best"},
      {{"--cut", "none", "--cut-disk"}, "--cut-disk goes with --cut best"},
      {{"--cut", "shortest", "--cut-disk"}, "--cut-disk goes with --cut best"},
      // what only the optimal minimizer has
      {{"--minimizer", "iterative", "--balance", "0.3"}, "--balance goes with --minimizer optimal"},
      {{"--minimizer", "iterative", "--border", "sliding"}, "--border sliding goes with --minimizer optimal"},
      {{"--preset", "paper", "--balance", "0.3"}, "--balance goes with --minimizer optimal"}};
  for(const auto& [options, words] : bad)
    check_refusal(folder, Arguments{input, "-o", folder / "map.obj"} + options, BAD_COMMAND_LINE, words);
}

TEST_CASE("each of these options is taken where it has an effect, also with its default value")
{
  const std::vector<long> b = border_of(small.faces);
  const Arguments corners{"--corners", corner_option({b[0], b[3], b[6], b[9]})};
  const std::vector<Arguments> good{
      {"--strategy", "step-sampling", "--step", "0"},
      {"--strategy", "hybrid", "--interval", "0"},
      {"--minimizer", "iterative", "--interval", "2"}, // hybrid is its default
      {"--preset", "paper", "--interval", "2"},
      {"--strategy", "particle-swarm", "--seed", "0"},
      {"--strategy", "none", "--walk", "clockwise", "--corner-rule", "author"},
      {"--preset", "paper", "--minimizer", "optimal", "--balance", "0.3", "--border", "fixed"},
      {"--minimizer", "iterative", "--border", "fixed"}, // as it is
      {"--cut", "best", "--cut-weight", "0.05", "--max-cut-length", "2", "--cut-disk"},
      {"--cut-weight", "0", "--max-cut-length", "inf"},
      {"--preset", "paper", "--walk", "clockwise", "--eta", "0.5", "--patience", "1", "--weights", "uniform"},
      corners + Arguments{"--minimizer", "iterative", "--eta", "1", "--patience", "0", "--weights", "mean-value"},
      corners + Arguments{"--preset", "paper", "--minimizer", "optimal", "--eta", "0.5"}};
  for(const Arguments& options : good)
    check_map(small, options);
}

TEST_CASE("an output that cannot be written is refused")
{
  const Temporary_folder folder;
  const std::string input = folder.add("in.off", off(small));
  std::filesystem::create_directory(folder / "folder.obj");
  check_refusal(folder, {input, "-o", folder / "missing/map.obj"}, BAD_COMMAND_LINE);
  check_refusal(folder, {input, "-o", folder / "folder.obj"}, BAD_COMMAND_LINE, "it is a folder");
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
  const std::string too_long(256, 'x'); // of such names nothing is known, but two of them differ
  check_refusal(folder, {input, "-o", folder / (too_long + ".obj"), "--json", folder / (too_long + ".json")},
                BAD_COMMAND_LINE, "the name is too long");
  const auto from_input = [&] { REQUIRE(freopen(input.c_str(), "r", stdin) != nullptr); };
  const Finished_process from_stream = square_map({"-", "-o", input}, "", from_input);
  CHECK(from_stream.status == BAD_COMMAND_LINE);
  CHECK(is_one_message(from_stream.err, "same file"));
  CHECK(read_file(input) == off(small));
}

TEST_CASE("an output with another extension than .obj, .off, .ply, .stl or .glb is refused")
{
  const Temporary_folder folder;
  const std::string input = folder.add("in.off", off(small));
  for(const char* name : {"map", "map.gltf", "map.txt", "obj", "map.", "map.obj.gz"})
    check_refusal(folder, {input, "-o", folder / name}, BAD_COMMAND_LINE, ".obj, .off, .ply, .stl or .glb");
  check_refusal(folder, {input, "-o", folder / ".obj"}, BAD_COMMAND_LINE, ".obj' has no name before its extension");
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
  check(corner_option({b[0], b[3], beyond, b[9]}),
        "corner vertex " + std::to_string(beyond) + " does not exist: the file has 35 vertices");
  check(corner_option({b[0], b[3], b[3], b[9]}),
        "not distinct border vertices: vertex " + std::to_string(b[3]) + " is named more than once");
  // the order that would be right begins with the same corner
  check(corner_option({b[9], b[6], b[3], b[0]}),
        "not in counter-clockwise order; this would be: " + corner_option({b[9], b[0], b[3], b[6]}));
  check(corner_option({b[0], b[6], b[3], b[9]}),
        "not in counter-clockwise order; this would be: " + corner_option({b[0], b[3], b[6], b[9]}));
  for(const char* malformed : {"", "1", "0,1,2", "0 1 2 3", "0, 1, 2, ", "0, 1, 2, 3 4", "0,1,2,3,4", "0,1,2,",
                               "0,,1,2", "a,b,c,d", "0;1;2;3", "-1,1,2,3", "0,1,2,3x", "0.5,1,2,3", "+0,1,2,3"})
    check(malformed, "--corners");
  check("0,1,2,99999999999999999999999", "corner vertex 99999999999999999999999 does not exist");
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
