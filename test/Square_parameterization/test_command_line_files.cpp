// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "test_command_line_checks.h"

#include <limits>
#include <random>

// Files that cannot be read.

namespace {

std::string noise(std::size_t length, unsigned int seed)
{
  std::mt19937 random(seed);
  std::string text;
  while(text.size() < length)
    text += static_cast<char>(random() & 255);
  return text;
}

} // namespace

TEST_CASE("an input that is not a file is refused")
{
  const Temporary_folder folder;
  check_refusal_of_input(folder / "missing.off", BAD_FILE, "no such file");
  std::filesystem::create_directory(folder / "folder.off");
  check_refusal_of_input(folder / "folder.off", BAD_FILE, "it is a folder");
  check_refusal_of_input(folder / "missing.off" + "/in.off", BAD_FILE, "no such file");
  check_refusal_of_input(folder.add("in", off(small)), BAD_FILE, "it has no extension");
  check_refusal_of_input(folder.add("in.txt", off(small)), BAD_FILE, "its extension '.txt' is unknown");
  check_refusal_of_input("/dev/zero", BAD_FILE, "it is a device");
  const std::string closed = folder.add("closed.off", off(small));
  std::filesystem::permissions(closed, std::filesystem::perms::none);
  check_refusal_of_input(closed, BAD_FILE, "its permissions do not allow it", {}, heed_permissions);
}

TEST_CASE("an empty file is refused")
{
  for(const char* name : {"in.off", "in.obj", "in.ply", "in.stl"}) {
    check_refusal_of_text(name, "", BAD_FILE, "it is empty");
    check_refusal_of_text(name, "\n", BAD_FILE);
  }
}

TEST_CASE("a file of another kind is called so")
{
  const std::vector<std::pair<std::string, std::string>> kinds{{"\x1f\x8b\x08", "a file compressed by gzip"},
                                                               {"PK\x03\x04", "a zip archive"},
                                                               {"\xff\xfev ", "text in UTF-16"},
                                                               {"<!DOCTYPE html>", "XML or HTML"},
                                                               {"glTF", "binary glTF"}};
  for(const auto& [beginning, kind] : kinds)
    for(const char* name : {"in.off", "in.obj", "in.ply", "in.stl"})
      check_refusal_of_text(name, beginning + std::string(500, 'x'), BAD_FILE, "; it begins as " + kind);
}

TEST_CASE("a truncated file is refused")
{
  const std::string facets = stl(small);
  for(double share : {0.01, 0.1, 0.25, 0.5, 0.6, 0.75, 0.9, 0.97}) {
    const auto start_of = [share](const std::string& text) {
      return text.substr(0, std::size_t(share * double(text.size())));
    };
    check_refusal_of_text("in.off", start_of(off(small)), BAD_FILE);
    check_refusal_of_text("in.ply", start_of(ply(small)), BAD_FILE);
    check_refusal_of_text("in.ply", start_of(binary_ply(small)), BAD_FILE);
    check_refusal_of_text("in.stl", start_of(binary_stl(small)), BAD_FILE);
    check_refusal_of_text("in.stl", start_of(facets), BAD_FILE);
  }
}

TEST_CASE("an OBJ file, which does not say how much it should hold, is refused when it ends too early")
{
  const std::string text = obj(small);
  const std::size_t faces = text.find("f ");
  check_refusal_of_text("in.obj", text.substr(0, faces / 2), BAD_FILE);
  check_refusal_of_text("in.obj", text.substr(0, faces), BAD_FILE);
  check_refusal_of_text("in.obj", text.substr(0, text.rfind(' ')), BAD_FILE,
                        "in.obj' as OBJ: line 83: a face has ");
}

TEST_CASE("binary noise is refused")
{
  for(unsigned int seed = 0; seed < 8; ++seed)
    for(std::size_t length : {1, 84, 3000}) {
      for(const char* name : {"in.off", "in.obj", "in.ply", "in.stl"})
        check_refusal_of_text(name, noise(length, seed), BAD_FILE);
      check_refusal_of_text("in.off", "OFF\n" + noise(length, seed), BAD_FILE);
      check_refusal_of_text("in.ply", ply_header(small, "ascii") + noise(length, seed), BAD_FILE);
    }
}

TEST_CASE("a damaged file is mapped or refused, but never half")
{
  const std::vector<std::pair<std::string, std::string>> files{
      {"in.off", off(small)},        {"in.obj", obj(small)},        {"in.ply", ply(small)},
      {"in.ply", binary_ply(small)}, {"in.stl", binary_stl(small)}, {"in.stl", stl(small)}};
  for(unsigned int seed = 0; seed < 40; ++seed)
    for(auto [name, text] : files) {
      std::mt19937 random(seed);
      for(unsigned int damages = 1 + seed % 3; damages > 0; --damages)
        text[random() % text.size()] =
            seed % 2 == 0 ? static_cast<char>(random() & 255) : "0123456789 .-\n"[random() % 14];
      const Temporary_folder folder;
      const Finished_process result = square_map({folder.add(name, text), "-o", folder / "map.obj"});
      INFO("seed " << seed << ", " << name << " of " << text.size() << " bytes\n" << result.err);
      CHECK((result.status == DONE || result.status == BAD_FILE || result.status == UNMAPPABLE));
      if(result.status == DONE)
        CHECK(measure(read_obj_map(read_file(folder / "map.obj"))).flipped == 0);
      else {
        CHECK(is_one_message(result.err, ""));
        CHECK(folder.file_names() == std::set<std::string>{name});
      }
    }
}

TEST_CASE("a header that promises more than the file holds is refused")
{
#ifdef __SANITIZE_ADDRESS__
  WARN("skipped: the address sanitizer ends the program where memory is refused");
  return;
#endif
  check_refusal_of_text("in.off", "OFF\n4000000000 8000000000 0\n0 0 0\n", BAD_FILE);
  check_refusal_of_text("in.off", "OFF\n3 4000000000 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", BAD_FILE);
  check_refusal_of_text("in.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n2000000000 0 1 2\n", BAD_FILE);
  check_refusal_of_text("in.off", "OFF\n-3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", BAD_FILE);
  for(const char* format : {"ascii", "binary_little_endian"}) {
    std::string header = ply_header(small, format);
    header.replace(header.find("vertex ") + 7, 2, "4000000000");
    check_refusal_of_text("in.ply", header + "0 0 0\n", BAD_FILE);
  }
  std::string faces = binary_ply({small.points, {{0, 1, 2}}});
  faces.replace(faces.find("list uchar"), 10, "list uint");
  check_refusal_of_text("in.ply", faces.replace(faces.size() - 13, 1, bytes(std::uint32_t(4000000000))), BAD_FILE);
  std::string facets = binary_stl(small);
  facets.replace(80, 4, "\xff\xff\xff\xff");
  check_refusal_of_text("in.stl", facets, BAD_FILE);
}

TEST_CASE("what OFF files say beside coordinates is ignored, also where it is incomplete")
{
  const std::string text = off(small).substr(3); // without the keyword
  const Temporary_folder folder;
  for(const char* keyword :
      {"STOFF", "COFF", "NOFF", "STCNOFF", "NCOFF", "CSTOFF", "NCSTOFF", "# comment\n\n #\n STOFF"})
    CHECK(check_map(folder.add("in.off", keyword + text)).map.points == small.points);
  std::istringstream lines(text);
  std::string colored = "COFF";
  std::size_t number = 0;
  for(std::string line; std::getline(lines, line); ++number) // a color for the second vertex alone
    colored += line + (number == 3 ? " 255 0\n" : "\n");
  CHECK(check_map(folder.add("in.off", colored)).map.points == small.points);
}

TEST_CASE("a PLY header that makes no sense is refused, its variants are read")
{
  const std::string text = ply(small);
  const auto replaced = [&text](const std::string& before, const std::string& after) {
    std::string result = text;
    return result.replace(result.find(before), before.size(), after);
  };
  check_refusal_of_text("in.ply", replaced("element", "elephant"), BAD_FILE, "not 'elephant'");
  check_refusal_of_text("in.ply", replaced("element vertex", "property int i\nelement vertex"), BAD_FILE,
                        "belongs to no element");
  for(const char* unknown : {"property integer i", "property list float int i", "property list uchar index i"})
    check_refusal_of_text(
        "in.ply",
        replaced("element face", "element other 1000000000000000000\n" + std::string(unknown) + "\nelement face"),
        BAD_FILE, "property 'i' is of no type");
  check_refusal_of_text("in.ply", "ply\nformat ascii 1.0\nelement other 1000000000000000000\n", BAD_FILE,
                        "header has no end");
  check_refusal_of_text("in.ply", replaced("double y", "list uchar double y"), BAD_FILE, "coordinate y is a list");
  const Temporary_folder folder;
  for(const std::string& variant :
      {replaced("double z", "float64 z"), replaced("uchar int", "int uint"), replaced("indices", "index"),
       replaced("element face", "element other 1000000000000000000\nelement face"),
       replaced("element vertex", "comment element\nobj_info property x\nelement vertex")})
    CHECK(check_map(folder.add("in.ply", variant)).map.points == small.points);
}

TEST_CASE("a coordinate that is not finite is refused")
{
  for(double x : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                  -std::numeric_limits<double>::infinity()})
    for(int i = 0; i < 3; ++i) {
      Soup soup = small;
      soup.points[5][i] = x;
      check_refusal_of_soup(soup, BAD_FILE);
      check_refusal_of_text("in.stl", binary_stl(soup), BAD_FILE);
    }
  Soup soup = small;
  soup.points[5][2] = std::numeric_limits<double>::infinity();
  check_refusal_of_text("in.ply", binary_ply(soup), BAD_FILE,
                        "in.ply' as PLY: 1 vertex has a coordinate that is not finite (vertex 5)");
  for(int v : {2, 3, 7})
    soup.points[v][1] = std::numeric_limits<double>::quiet_NaN();
  check_refusal_of_text("in.ply", binary_ply(soup), BAD_FILE,
                        "4 vertices have a coordinate that is not finite (vertex 2, vertex 3, vertex 5, ...)");
  check_refusal_of_text("in.off", "OFF\n3 1 0\n0 0 0\n1e999 0 0\n0 1 0\n3 0 1 2\n", BAD_FILE);
}

TEST_CASE("a face that names no vertex of the file is refused")
{
  for(long v : {static_cast<long>(small.points.size()), 2147483647L, -1L, -100000L}) {
    Soup soup = small;
    soup.faces[7][1] = v;
    check_refusal_of_text("in.off", off(soup), BAD_FILE);
    const std::string sentence =
        "face 7 names vertex " + std::to_string(v) + "; the file has " + std::to_string(small.points.size());
    check_refusal_of_text("in.ply", ply(soup), BAD_FILE, sentence);
    check_refusal_of_text("in.ply", binary_ply(soup), BAD_FILE, sentence);
    if(v > 0 || v == -100000) // small negative numbers of OBJ count from the last vertex
      check_refusal_of_text("in.obj", obj(soup), BAD_FILE);
  }
  check_refusal_of_text("in.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n", BAD_FILE);
}
