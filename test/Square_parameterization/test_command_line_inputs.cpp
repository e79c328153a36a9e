// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "test_command_line_checks.h"

#include <sys/stat.h>

#include <cstring>
#include <sstream>

// Where the surface and the seams come from, and the surface as STL.

namespace {

/// runs a command of the shell, in which square_map is a function
Finished_process by_shell(const std::string& command)
{
  const Temporary_folder folder;
  const std::string script =
      folder.add("script", "square_map() { '" + std::string(SQUARE_MAP) + "' \"$@\"; }\n" + command);
  const std::string line = "bash '" + script + "' > '" + (folder / "out") + "' 2> '" + (folder / "err") + "'";
  const int status = std::system(line.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_file(folder / "out"), read_file(folder / "err")};
}

const std::vector<std::pair<std::string, std::string>>& sheets()
{
  static const std::vector<std::pair<std::string, std::string>> result{{"off", off(small)},
                                                                       {"off", "# comment\n\n" + off(small)},
                                                                       {"off", "OFF" + off(small).substr(4)}, // glued
                                                                       {"obj", obj(small)},
                                                                       {"obj", "# comment\nmtllib x\n" + obj(small)},
                                                                       {"ply", ply(small)},
                                                                       {"ply", binary_ply(small)},
                                                                       {"stl", stl(small)},
                                                                       {"stl", binary_stl(small)},
                                                                       {"obj", "\xef\xbb\xbf" + obj(small)}};
  return result;
}

} // namespace

TEST_CASE("standard input, pipes and what the shell makes of a command are read by content")
{
  const Temporary_folder folder;
  const std::string expected = check_map(small).text, map = folder / "map.obj";
  for(const auto& [format, text] : sheets()) {
    const std::string file = "'" + folder.add("in", text) + "'";
    for(const std::string& command :
        {"square_map - -o " + map + " < " + file, "cat " + file + " | square_map - -o " + map,
         "square_map /dev/stdin -o " + map + " < " + file, "cat " + file + " | square_map /dev/stdin -o " + map,
         "square_map <(cat " + file + ") -o " + map,
         "mkfifo " + file + ".fifo; cat " + file + " > " + file + ".fifo & square_map " + file + ".fifo -o " + map}) {
      INFO(command << " of " << format);
      const Finished_process result = by_shell(command);
      INFO(result.err);
      CHECK(result.status == DONE);
      CHECK(read_file(map) == expected);
      std::filesystem::remove(map);
      std::filesystem::remove(folder / "in.fifo");
    }
  }
}

TEST_CASE("the report calls standard input -")
{
  const Temporary_folder folder;
  const Finished_process result = by_shell("square_map - --quiet --json - < '" + folder.add("in", off(small)) + "'");
  REQUIRE(result.status == DONE);
  CHECK(nlohmann::json::parse(result.out)["input"]["file"] == "-");
}

TEST_CASE("a stream that holds no surface is refused")
{
  const std::vector<std::pair<std::string, std::string>> commands{
      {"square_map - < /dev/null", "cannot read standard input: it is empty"},
      {"square_map - <&-", "cannot read standard input: it is closed"},
      {"echo nothing at all | square_map -", "it does not begin as an OFF, OBJ, PLY or STL file"},
      {"printf '\\037\\213' | square_map -",
       "it begins as a file compressed by gzip; OFF, OBJ, PLY or STL was expected"},
      {"echo fo 1 2 3 | square_map -", "standard input as OBJ: line 1: a face names vertex 3"},
      {"echo OFF 4000000000 4000000000 0 | square_map -", "standard input as OFF: it is incomplete"},
      {"printf 'ply\nformat ascii 1.0\nelement vertex 4000000000\nproperty float x\nproperty float y\n"
       "property float z\nelement face 1\nproperty list uchar int vertex_index\nend_header\n0 0 0\n' | square_map -",
       "standard input as PLY: it is incomplete: it ends in vertex 1"},
      {"square_map - --input-format off < .", "standard input: it is a folder"}};
  for(const auto& [command, words] : commands) {
    INFO(command);
    const Finished_process result = by_shell(command);
    CHECK(result.status == BAD_FILE);
    INFO(result.err);
    CHECK(is_one_message(result.err, words));
  }
}

TEST_CASE("the option --input-format takes the place of the extension")
{
  const Temporary_folder folder;
  for(const auto& [format, text] : sheets())
    for(const char* name : {"in", "in.txt", "in.off", "in.stl"})
      CHECK(check_map(folder.add(name, text), {"--input-format", format}).map.points == small.points);
  check_refusal_of_text("in.off", off(small), BAD_FILE, "as PLY: line 1: ply was expected", {"--input-format", "ply"});
  for(const char* wrong : {"OFF", "glb", ""})
    check_refusal_of_text("in.off", off(small), BAD_COMMAND_LINE, "--input-format is one of: obj, off, ply, stl",
                          {"--input-format", wrong});
}

TEST_CASE("the option --input-format takes the place of what the content of a stream says")
{
  const Temporary_folder folder;
  const std::string text = folder.add("in", "banana 1 2 3\n" + obj(small)), map = folder / "map.obj";
  const auto from_stream = [&](const std::string& options) {
    return by_shell("cat '" + text + "' | square_map - -q -o '" + map + "' " + options);
  };
  CHECK(from_stream("").status == BAD_FILE); // it may be anything
  CHECK(from_stream("--input-format obj").status == DONE);
  CHECK(read_obj_map(read_file(map)).points == small.points);
  const Finished_process wrong = from_stream("--input-format ply");
  CHECK(wrong.status == BAD_FILE);
  CHECK(is_one_message(wrong.err, "standard input as PLY: line 1: ply was expected"));
}

TEST_CASE("a file beyond an eighth of the memory is refused at once")
{
  const Temporary_folder folder;
  const std::string input = folder.add("in.off", off(small));
  std::filesystem::resize_file(input, std::uintmax_t(1) << 42); // 4 terabytes, of which the disk holds a block
  check_refusal(folder, {input}, BAD_FILE, "an eighth of the memory of this machine");
}

TEST_CASE("seams are read with comments, and refused with their line")
{
  const Temporary_folder folder;
  const std::string input = folder.add("in.off", off(small));
  const long a = small.faces[10][0], b = small.faces[10][1];
  const std::string seam = std::to_string(a) + ' ' + std::to_string(b);
  // one inner edge need not cut a disk open, but it must be read in each of these forms, with the same outcome
  const auto outcome = [&](const std::string& text) {
    return square_map({input, "--seams", folder.add("seams", text), "--quiet"});
  };
  const Finished_process plain = outcome(seam + "\n");
  for(const std::string& text :
      {"# comment\n\n" + seam + " # comment\n#", "\xef\xbb\xbf" + seam + "\r\n", "\t" + seam}) {
    CHECK(outcome(text).status == plain.status);
    CHECK(outcome(text).err == plain.err);
  }
  for(const std::string wrong : {"0 4x", "0x 4", "0 1.5", "0", "0 1 2", "0 1 x", "zero one"})
    check_refusal(folder, {input, "--seams", folder.add("seams", "# comment\n" + wrong + "\n")}, BAD_FILE,
                  "line 2 is not two vertex numbers");
  for(const std::string missing : {"0 35", "0 -1", "0 99999999999999999999"})
    check_refusal(folder, {input, "--seams", folder.add("seams", missing)}, BAD_FILE, "which no mapped face has");
}

TEST_CASE("seams with comments cut as they do without")
{
  const Soup tetrahedron{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
  const Temporary_folder folder;
  const std::string input = folder.add("in.off", off(tetrahedron)), map = folder / "map.obj";
  const auto map_with = [&](const std::string& seams) {
    CHECK(square_map({input, "-q", "--seams", folder.add("seams", seams), "-o", map}).status == DONE);
    return read_file(map);
  };
  const std::string plain = map_with("0 1\n1 2\n");
  CHECK(map_with("# two edges\n0 1 # the first\n\n1 2# the last\n") == plain);
  CHECK(map_with("0 1\n") != plain);
}

TEST_CASE("seams that are not a file are refused")
{
  const Temporary_folder folder;
  const std::string input = folder.add("in.off", off(small));
  std::filesystem::create_directory(folder / "folder");
  REQUIRE(mkfifo((folder / "pipe").c_str(), 0600) == 0);
  check_refusal(folder, {input, "--seams", folder / "folder"}, BAD_FILE, "it is a folder");
  check_refusal(folder, {input, "--seams", folder / "pipe"}, BAD_FILE, "it is a pipe; a file was expected");
  check_refusal(folder, {input, "--seams", folder / "missing"}, BAD_FILE, "there is no such file");
  check_refusal(folder, {input, "--seams", "-"}, BAD_COMMAND_LINE, "- is standard input for the surface alone");
}

TEST_CASE("the surface that is mapped is written as binary STL")
{
  const Temporary_folder folder;
  const std::string output = folder / "map.stl";
  const Finished_process result = square_map({folder.add("in.off", off(small)), "-o", output});
  REQUIRE(result.status == DONE);
  const std::string text = read_file(output), expected = binary_stl(small);
  REQUIRE(text.size() == expected.size());
  CHECK(text.substr(80, 4) == expected.substr(80, 4));
  for(std::size_t f = 0; f < small.faces.size(); ++f) {
    CHECK(text.substr(84 + 50 * f + 12, 38) == expected.substr(84 + 50 * f + 12, 38));
    float normal[3], product[3];
    std::memcpy(normal, text.data() + 84 + 50 * f, sizeof normal);
    const Point &p = small.points[small.faces[f][0]], &q = small.points[small.faces[f][1]],
                &r = small.points[small.faces[f][2]];
    double squares = 0, along = 0;
    for(int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      product[i] = float((q[j] - p[j]) * (r[k] - p[k]) - (q[k] - p[k]) * (r[j] - p[j]));
      squares += double(product[i]) * product[i];
      along += double(product[i]) * normal[i];
    }
    CHECK(along == Approx(std::sqrt(squares)).epsilon(1e-5)); // of length 1, and in the direction of the product
  }
  CHECK(check_map(output).map.points == small.points);
}

TEST_CASE("a surface with numbers that STL does not have is not written as STL")
{
  const Temporary_folder folder;
  check_refusal(folder, {folder.add("in.off", off(scaled(small, 1e39))), "-o", folder / "map.stl"}, BAD_COMMAND_LINE,
                "STL has no number");
}
