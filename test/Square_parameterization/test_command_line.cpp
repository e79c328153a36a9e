// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "test_command_line_map.h"
#include "test_command_line_process.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <functional>
#include <limits>
#include <random>
#include <utility>

// Runs the built command as users do: what it writes is read back and measured without the code under test.

namespace {

typedef std::vector<std::string> Arguments;

enum Exit_status
{
  DONE = 0,
  BAD_COMMAND_LINE = 2,
  BAD_FILE = 3,
  UNMAPPABLE = 4,
  NO_ONE_TO_ONE_MAP = 5
};

Arguments operator+(Arguments arguments, const Arguments& more)
{
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

/// one line that begins with the name of the command and holds `words`
bool is_one_message(const std::string& text, const std::string& words)
{
  return text.rfind("square_map: ", 0) == 0 && std::count(text.begin(), text.end(), '\n') == 1 && text.back() == '\n' &&
         text.find(words) != std::string::npos;
}

/// the command must end with `status` and one message that holds `words`, write nothing, and leave no file behind
void check_refusal(const Temporary_folder& folder, const Arguments& arguments, Exit_status status,
                   const std::string& words = "")
{
  for(const Arguments& quiet : {Arguments{}, Arguments{"--quiet"}}) {
    const std::set<std::string> files = folder.file_names();
    const Finished_process result = square_map(arguments + quiet);
    INFO(Catch::StringMaker<Arguments>::convert(arguments) << "\n" << result.err);
    CHECK(result.status == status);
    CHECK(result.out == "");
    CHECK(is_one_message(result.err, words));
    CHECK(folder.file_names() == files);
  }
}

/// an input must be refused whether or not the outputs exist, and existing ones must survive
void check_refusal_of_input(const std::string& input, Exit_status status, const std::string& words = "",
                            const Arguments& options = {})
{
  const Temporary_folder folder;
  const std::string map = folder / "map.obj", report = folder / "report.json";
  const Arguments arguments = Arguments{input, "-o", map, "--json", report} + options;
  check_refusal(folder, arguments, status, words);
  folder.add("map.obj", "my map");
  folder.add("report.json", "my report");
  check_refusal(folder, arguments, status, words);
  CHECK(read_file(map) == "my map");
  CHECK(read_file(report) == "my report");
}

void check_refusal_of_text(const std::string& name, const std::string& text, Exit_status status,
                           const std::string& words = "", const Arguments& options = {})
{
  INFO(name << " of " << text.size() << " bytes");
  const Temporary_folder folder;
  check_refusal_of_input(folder.add(name, text), status, words, options);
}

void check_refusal_of_soup(const Soup& soup, Exit_status status, const std::string& words = "",
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
Mapped check_map(const std::string& input, const Arguments& options = {}, const std::string& extension = "obj")
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

Mapped check_map(const Soup& soup, const Arguments& options = {}, const std::string& extension = "obj")
{
  const Temporary_folder folder;
  return check_map(folder.add("in.off", off(soup)), options, extension);
}

/// the report without what may differ from run to run
nlohmann::json without_times_and_names(nlohmann::json report)
{
  report.erase("seconds");
  report.erase("threads");
  report["input"].erase("file");
  return report;
}

std::string noise(std::size_t length, unsigned int seed)
{
  std::mt19937 random(seed);
  std::string text;
  while(text.size() < length)
    text += static_cast<char>(random() & 255);
  return text;
}

const Soup small = sheet(6, 4);

} // namespace

// ---------------------------------------------------------------------------------------------------------------------
// files that cannot be read

TEST_CASE("an input that is not a file is refused")
{
  const Temporary_folder folder;
  check_refusal_of_input(folder / "missing.off", BAD_FILE, "no such file");
  std::filesystem::create_directory(folder / "folder.off");
  check_refusal_of_input(folder / "folder.off", BAD_FILE, "not a regular file");
  check_refusal_of_input(folder.add("in", off(small)), BAD_FILE);
  check_refusal_of_input(folder.add("in.txt", off(small)), BAD_FILE);
}

TEST_CASE("an empty file is refused")
{
  for(const char* name : {"in.off", "in.obj", "in.ply", "in.stl"}) {
    check_refusal_of_text(name, "", BAD_FILE);
    check_refusal_of_text(name, "\n", BAD_FILE);
  }
}

TEST_CASE("a truncated file is refused")
{
  const std::string facets = stl(small);
  for(double share : {0.01, 0.1, 0.25, 0.5, 0.6, 0.75, 0.9, 0.97}) {
    const auto start_of = [share](const std::string& text) { return text.substr(0, std::size_t(share * text.size())); };
    check_refusal_of_text("in.off", start_of(off(small)), BAD_FILE);
    check_refusal_of_text("in.ply", start_of(ply(small)), BAD_FILE);
    check_refusal_of_text("in.ply", start_of(binary_ply(small)), BAD_FILE);
    check_refusal_of_text("in.stl", start_of(binary_stl(small)), BAD_FILE);
    if(share >= 0.1) // until a first facet is complete there is nothing to miss
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
                        "1 face has fewer than three vertices (face ");
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
  for(const char* keyword : {"STOFF", "COFF", "NOFF", "STCNOFF", "# comment\n\n #\n STOFF"})
    CHECK(check_map(folder.add("in.off", keyword + text)).map.points == small.points);
  std::istringstream lines(text);
  std::string colored = "COFF";
  std::size_t number = 0;
  for(std::string line; std::getline(lines, line); ++number) // a color for the second vertex alone
    colored += line + (number == 3 ? " 255 0\n" : "\n");
  CHECK(check_map(folder.add("in.off", colored)).map.points == small.points);
}

TEST_CASE("a PLY header that CGAL's reader cannot take is refused, its variants are read")
{
  const std::string text = ply(small);
  const auto replaced = [&text](const std::string& before, const std::string& after) {
    std::string result = text;
    return result.replace(result.find(before), before.size(), after);
  };
  check_refusal_of_text("in.ply", replaced("element", "elephant"), BAD_FILE, "belongs to no element");
  check_refusal_of_text("in.ply", replaced("element face", "element other 1000000000000000000\nelement face"), BAD_FILE,
                        "no properties");
  for(const char* unknown : {"property integer i", "property list float int i", "property list uchar index i"})
    check_refusal_of_text(
        "in.ply",
        replaced("element face", "element other 1000000000000000000\n" + std::string(unknown) + "\nelement face"),
        BAD_FILE, "property 'i' is of no type");
  check_refusal_of_text("in.ply", "ply\nformat ascii 1.0\nelement other 1000000000000000000\n", BAD_FILE,
                        "header has no end");
  for(const char* type : {"int", "uchar", "ushort", "list uchar double"})
    check_refusal_of_text("in.ply", replaced("double y", type + std::string(" y")), BAD_FILE, "coordinate y");
  const Temporary_folder folder;
  for(const std::string& variant :
      {replaced("double z", "float64 z"), replaced("uchar int", "int uint"), replaced("indices", "index"),
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
                        "1 vertex has a coordinate that is not finite (vertex 5)");
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
        "1 face names a vertex that does not exist (face 7 names vertex " + std::to_string(v) + " of ";
    check_refusal_of_text("in.ply", ply(soup), BAD_FILE, sentence);
    check_refusal_of_text("in.ply", binary_ply(soup), BAD_FILE, sentence);
    if(v > 0 || v == -100000) // small negative numbers of OBJ count from the last vertex
      check_refusal_of_text("in.obj", obj(soup), BAD_FILE);
  }
  check_refusal_of_text("in.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n", BAD_FILE);
}

// ---------------------------------------------------------------------------------------------------------------------
// surfaces that cannot be mapped

TEST_CASE("a surface without faces cannot be mapped")
{
  const Soup points{small.points, {}};
  check_refusal_of_text("in.off", off(points), UNMAPPABLE, "no faces");
  check_refusal_of_text("in.ply", ply(points), UNMAPPABLE, "no faces");
}

TEST_CASE("faces that are all without area cannot be mapped")
{
  Soup soup = small;
  for(Point& p : soup.points)
    p = {p[0], 2 * p[0], 0};
  check_refusal_of_soup(soup, UNMAPPABLE, "all of its 48 faces are without area");
  // closed, to be cut
  check_refusal_of_soup({{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}},
                        UNMAPPABLE, "all of its 4 faces are without area");
}

TEST_CASE("vertices that all coincide cannot be mapped")
{
  Soup soup = small;
  for(Point& p : soup.points)
    p = {1, 2, 3};
  check_refusal_of_soup(soup, UNMAPPABLE);
}

TEST_CASE("a face that repeats a vertex cannot be mapped")
{
  Soup soup = small;
  soup.faces[11][2] = soup.faces[11][0];
  check_refusal_of_soup(soup, UNMAPPABLE, "face 11");
}

TEST_CASE("faces that are not triangles cannot be mapped and are counted")
{
  Soup soup;
  soup.points = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}, {3, 0, 0}};
  soup.faces = {{0, 1, 4, 3}, {1, 2, 5, 4}, {2, 6, 5}};
  check_refusal_of_soup(soup, UNMAPPABLE, "2 non-triangular faces");
  const Mapped mapped = check_map(soup, {"--triangulate"});
  CHECK(mapped.report["conditioned"]["polygons_triangulated"] == 2);
  CHECK(mapped.report["input"]["faces"] == 3);
  CHECK(std::equal(soup.points.begin(), soup.points.end(), mapped.map.points.begin()));
}

TEST_CASE("an edge with three faces cannot be mapped")
{
  Soup soup = small;
  soup.points.push_back({0, 0, 9});
  soup.faces.push_back({soup.faces[0][0], soup.faces[0][1], static_cast<long>(soup.points.size()) - 1});
  soup.faces.push_back({soup.faces[0][0], soup.faces[0][2], static_cast<long>(soup.points.size()) - 1});
  check_refusal_of_soup(soup, UNMAPPABLE, "1 non-manifold edge");
}

TEST_CASE("a border vertex touched by two border loops cannot be mapped")
{
  Soup soup = sheet(6, 6);
  const std::vector<long> border = border_of(soup.faces);
  const auto border_vertices = [&border](const Face& face) {
    return std::count_if(face.begin(), face.end(),
                         [&border](long v) { return std::find(border.begin(), border.end(), v) != border.end(); });
  };
  const auto touching =
      std::find_if(soup.faces.begin(), soup.faces.end(), [&](const Face& face) { return border_vertices(face) == 1; });
  REQUIRE(touching != soup.faces.end());
  soup.faces.erase(touching);
  check_refusal_of_soup(soup, UNMAPPABLE, "1 non-manifold ver");

  const Soup bow_tie{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}, {{0, 1, 2}, {0, 3, 4}}};
  check_refusal_of_soup(bow_tie, UNMAPPABLE, "vertex 0");
}

TEST_CASE("a closed surface cannot be mapped uncut")
{
  const Soup tetrahedron{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
  check_refusal_of_soup(tetrahedron, UNMAPPABLE, "closed", {"--cut", "none"});
}

namespace {

/// both surfaces in one file
Soup united(const Soup& first, const Soup& second)
{
  Soup soup = first;
  for(Face face : second.faces) {
    for(long& v : face)
      v += static_cast<long>(first.points.size());
    soup.faces.push_back(face);
  }
  soup.points.insert(soup.points.end(), second.points.begin(), second.points.end());
  return soup;
}

} // namespace

TEST_CASE("of several components one must be chosen")
{
  const Soup other = sheet(2, 4, 100), soup = united(other, small);
  check_refusal_of_soup(soup, UNMAPPABLE, "2 connected components");
  check_refusal_of_soup(soup, UNMAPPABLE, "0 has 48 faces, 1 has 16 faces");
  for(const char* number : {"2", "99999999999"})
    check_refusal_of_soup(soup, BAD_COMMAND_LINE, "the surface has 2", {"--component", number});
  for(const char* name : {"", "-1", "x", "0x", "1.5", "Largest", "99999999999999999999999"})
    check_refusal_of_soup(soup, BAD_COMMAND_LINE, "--component is", {"--component", name});

  const Mapped expected = check_map(small);
  for(const char* name : {"largest", "0"}) {
    const Mapped mapped = check_map(soup, {"--component", name});
    CHECK(mapped.text == expected.text);
    CHECK(mapped.messages.find("component 0 of 2") != std::string::npos);
    const nlohmann::json& conditioned = mapped.report["conditioned"];
    CHECK(conditioned["components"] == 2);
    CHECK(conditioned["component"] == 0);
    CHECK(conditioned["faces_dropped"] == other.faces.size());
    CHECK(conditioned["vertices_dropped"] == other.points.size());
  }
  CHECK(check_map(soup, {"--component", "1"}).map.points == other.points);
  CHECK(check_map(small, {"--component", "largest"}).report["conditioned"]["components"] == 1);
}

namespace {

/// a band of `length` quadrilaterals of two triangles, closed to a ring, twisted or not
Soup ring(int length, bool is_twisted)
{
  Soup soup;
  for(int i = 0; i < length; ++i) {
    const double angle = 6.25 * i / length, twist = is_twisted ? angle / 2 : 0.5;
    for(int side : {-1, 1})
      soup.points.push_back({(3 + side * std::cos(twist)) * std::cos(angle),
                             (3 + side * std::cos(twist)) * std::sin(angle), side * std::sin(twist)});
    const long a = 2 * i, b = a + 1;
    long c = (a + 2) % (2 * length), d = c + 1;
    if(is_twisted && i == length - 1)
      std::swap(c, d);
    soup.faces.insert(soup.faces.end(), {{a, b, d}, {a, d, c}});
  }
  return soup;
}

} // namespace

TEST_CASE("a disk is cut on demand alone")
{
  const Temporary_folder folder;
  const std::string input =
      folder.add("in.off", off({{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -5}},
                                {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}}));
  const auto map = [&](const Arguments& options) {
    const Finished_process result =
        square_map(Arguments{input, "-o", folder / "map.obj", "--json", "-", "--quiet"} + options);
    REQUIRE(result.status == DONE);
    return nlohmann::json::parse(result.out);
  };
  const auto whole = map({}), cut = map({"--cut-disk"});
  CHECK(whole["conditioned"]["seam_edges"] == 0);
  CHECK(cut["conditioned"]["seam_edges"] > 0);
  CHECK(cut["best"]["l2"] < whole["best"]["l2"]);
  CHECK(square_map({input, "--cut-disk", "--cut", "shortest"}).status == BAD_COMMAND_LINE);
  CHECK(square_map({input, "--cut-disk", "--seams", folder.add("seams.txt", "0 4\n")}).status == BAD_COMMAND_LINE);
}

TEST_CASE("a closed surface is cut: its vertices stay, seams part the texture alone")
{
  const Soup octahedron{{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
                        {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
  for(const Arguments& options : {Arguments{}, Arguments{"--cut", "shortest"}, Arguments{"--seams"}}) {
    const Temporary_folder folder;
    const std::string input = folder.add("in.off", off(octahedron)), output = folder / "map.obj";
    Arguments arguments = Arguments{input, "-o", output, "--json", "-", "--quiet"} + options;
    if(!options.empty() && options[0] == "--seams")
      arguments.push_back(folder.add("seams.txt", "0 4\n\n4 1\n"));
    const Finished_process result = square_map(arguments);
    REQUIRE(result.status == DONE);
    const auto conditioned = nlohmann::json::parse(result.out)["conditioned"];
    const std::size_t seams = conditioned["seam_edges"], chords = conditioned["chords_split"];
    CHECK(seams >= 2);
    CHECK(conditioned["cut_length"] == Approx(seams * std::sqrt(2.) / std::sqrt(4 * std::sqrt(3.))));
    CHECK(conditioned["border_edges"] == 2 * seams);

    std::istringstream lines(read_file(output));
    std::vector<Point> points;
    std::size_t texture_vertices = 0, faces = 0;
    for(std::string line, key; std::getline(lines, line);) {
      std::istringstream words(line);
      words >> key;
      if(key == "v")
        points.push_back(next_point(words));
      texture_vertices += key == "vt" ? 1 : 0;
      faces += key == "f" ? 1 : 0;
    }
    REQUIRE(points.size() == octahedron.points.size() + chords);
    CHECK(std::equal(octahedron.points.begin(), octahedron.points.end(), points.begin()));
    CHECK(texture_vertices == points.size() + seams - 1);
    CHECK(faces == octahedron.faces.size() + 2 * chords);
  }
}

TEST_CASE("seams that make no sense are refused")
{
  const Temporary_folder folder;
  const std::string input = folder.add("in.off", off(small));
  const auto seams = [&](const std::string& text) { return Arguments{"--seams", folder.add("seams.txt", text)}; };
  check_refusal_of_input(input, BAD_FILE, "line 2", seams("0 1\n1 x\n"));
  check_refusal_of_input(input, BAD_FILE, "vertex 35", seams("0 35\n"));
  check_refusal_of_input(input, BAD_FILE, "line 1", seams("0 1 2\n"));
  check_refusal_of_input(input, UNMAPPABLE, "not an edge", seams("0 34\n"));
  check_refusal_of_input(input, BAD_FILE, "cannot read", {"--seams", folder / "missing.txt"});
}

TEST_CASE("an annulus cannot be mapped uncut")
{
  check_refusal_of_soup(ring(12, false), UNMAPPABLE, "2 border loops", {"--cut", "none"});
}

TEST_CASE("a Moebius strip cannot be mapped")
{
  check_refusal_of_soup(ring(12, true), UNMAPPABLE, "not orientable");
}

TEST_CASE("a torus with a hole cannot be mapped uncut")
{
  Soup soup;
  for(int i = 0; i < 25; ++i) {
    const double a = 6.25 * (i % 5) / 5, b = 6.25 * (i / 5) / 5;
    soup.points.push_back({(3 + std::cos(a)) * std::cos(b), (3 + std::cos(a)) * std::sin(b), std::sin(a)});
    const auto vertex = [i](int across, int along) {
      return static_cast<long>((i % 5 + across) % 5 + 5 * ((i / 5 + along) % 5));
    };
    soup.faces.insert(soup.faces.end(),
                      {{vertex(0, 0), vertex(1, 0), vertex(1, 1)}, {vertex(0, 0), vertex(1, 1), vertex(0, 1)}});
  }
  soup.faces.erase(soup.faces.begin(), soup.faces.begin() + 2);
  check_refusal_of_soup(soup, UNMAPPABLE, "genus", {"--cut", "none"});
}

// ---------------------------------------------------------------------------------------------------------------------
// command lines that make no sense

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

std::string corner_option(const std::vector<long>& corners)
{
  std::string text;
  for(long v : corners)
    text += (text.empty() ? "" : ",") + std::to_string(v);
  return text;
}

} // namespace

TEST_CASE("corners that are not four border vertices in order are refused")
{
  const Temporary_folder folder;
  const std::string input = folder.add("in.off", off(small));
  const std::vector<long> b = border_of(small.faces);
  long inner = 0;
  while(std::find(b.begin(), b.end(), inner) != b.end())
    ++inner;
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
  long inner = 2;
  while(std::find(b.begin(), b.end(), inner) != b.end())
    ++inner;
  check_refusal(folder, {input, "--corners", corner_option({b[0], b[3], inner, b[9]})}, BAD_COMMAND_LINE,
                "vertex " + std::to_string(inner) + " is not on the border");
  check_refusal(folder, {input, "--corners", corner_option({b[0], b[3], 1, b[9]})}, BAD_COMMAND_LINE,
                "vertex 1 is not on the border");
}

// ---------------------------------------------------------------------------------------------------------------------
// maps

TEST_CASE("every format holds the same mesh and gives the same map")
{
  const Temporary_folder folder;
  const Mapped expected = check_map(small, {"--strategy", "brute-force"});
  CHECK(expected.map.points == small.points);
  CHECK(expected.map.faces == small.faces);
  const std::vector<std::pair<std::string, std::string>> files{{"in.obj", obj(small)},
                                                               {"in.ply", ply(small)},
                                                               {"binary.ply", binary_ply(small)},
                                                               {"in.stl", stl(small)},
                                                               {"binary.stl", binary_stl(small)},
                                                               {"IN.OFF", off(small)}};
  for(const auto& [name, text] : files) {
    INFO(name);
    const Mapped mapped = check_map(folder.add(name, text), {"--strategy", "brute-force"});
    CHECK(mapped.text == expected.text);
    CHECK(without_times_and_names(mapped.report) == without_times_and_names(expected.report));
  }
}

TEST_CASE("every output format holds the same map")
{
  const Mapped expected = check_map(small);
  for(const char* extension : {"off", "ply"}) {
    INFO(extension);
    const Mapped mapped = check_map(small, {}, extension);
    CHECK(mapped.map.points == expected.map.points);
    CHECK(mapped.map.uv == expected.map.uv);
    CHECK(mapped.map.faces == expected.map.faces);
  }
}

TEST_CASE("no other file is touched")
{
  const Temporary_folder folder;
  const std::set<std::string> others{"map", "map.obj.part", "map.obj~", "map.obj.tmp", "map.mtl", "part"};
  const std::string input = folder.add("in.off", off(small));
  for(const std::string& name : others)
    folder.add(name, name);
  CHECK(square_map({input, "-o", folder / "map.obj"}).status == DONE);
  for(const std::string& name : others)
    CHECK(read_file(folder / name) == name);
  CHECK(folder.file_names().size() == others.size() + 2);
}

TEST_CASE("an existing output is replaced, a link to it stays a link")
{
  const Temporary_folder folder;
  const std::string input = folder.add("in.off", off(small)), target = folder.add("map.obj", "my map");
  std::filesystem::create_symlink(target, folder / "link.obj");
  CHECK(square_map({input, "-o", folder / "link.obj"}).status == DONE);
  CHECK(std::filesystem::is_symlink(folder / "link.obj"));
  CHECK(read_obj_map(read_file(target)).uv.size() == small.points.size());
  CHECK(folder.file_names() == std::set<std::string>{"in.off", "link.obj", "map.obj"});
}

TEST_CASE("the report holds what it promises")
{
  const Temporary_folder folder;
  const std::string input = folder.add("in.off", off(small));
  const nlohmann::json report = check_map(input, {"--strategy", "quarter-brute-force"}).report;
  CHECK(report["input"] == nlohmann::json{{"file", input}, {"vertices", 35}, {"faces", 48}});
  for(const char* key : {"vertices", "faces", "border_edges", "seam_edges", "cut_length", "border_edges_split",
                         "chords_split", "vertices_dropped", "faces_reoriented", "components", "component",
                         "faces_dropped", "degenerate_faces", "polygons_triangulated"})
    CHECK(report["conditioned"][key].is_number());
  CHECK(report["strategy"] == "quarter-brute-force");
  CHECK(report["minimizer"] == "optimal");
  CHECK(report["evaluations"] == report["candidates"]);
  for(const char* key : {"candidate", "l2", "linf", "symmetric_dirichlet", "energy", "flipped"})
    CHECK(report["best"][key].is_number());
  CHECK(report["best"]["corners"].size() == 4);
  CHECK(report["threads"] >= 1);
  double sum = 0;
  for(const char* key : {"read", "condition", "cut", "search", "final", "write"}) {
    CHECK(report["seconds"][key] >= 0);
    sum += report["seconds"][key].get<double>();
  }
  CHECK(report["seconds"]["total"] >= 0.999 * sum);

  REQUIRE(report["curve"].size() == report["evaluations"]);
  double least = std::numeric_limits<double>::infinity();
  for(std::size_t j = 0; j < report["curve"].size(); ++j) {
    CHECK(report["curve"][j]["candidate"] == j);
    least = std::min(least, report["curve"][j]["l2"].get<double>());
  }
  // the delivered map is the best candidate's, finished to a tighter tolerance
  CHECK(report["curve"][report["best"]["candidate"].get<int>()]["l2"] == Approx(least).epsilon(1e-3));
  CHECK(report["best"]["l2"] == Approx(least).epsilon(1e-3));
  const auto iterative = check_map(small, {"--minimizer", "iterative", "--strategy", "quarter-brute-force"}).report;
  const auto& best = iterative["best"];
  CHECK(best["l2"] == Approx(best["energy"].get<double>()).epsilon(1e-12));
  CHECK(iterative["curve"][best["candidate"].get<int>()]["l2"] == Approx(best["l2"].get<double>()).epsilon(1e-12));
}

TEST_CASE("strategies differ in the candidates they map")
{
  const std::vector<long> border = border_of(small.faces);
  const std::string minimizer = GENERATE("iterative", "optimal");
  const auto search = [&](const std::string& strategy) {
    return check_map(small, {"--minimizer", minimizer, "--strategy", strategy});
  };
  const auto l2 = [](const Mapped& mapped) { return mapped.report["best"]["l2"].get<double>(); };
  const auto evaluations = [](const Mapped& mapped) { return mapped.report["evaluations"].get<std::size_t>(); };
  const Mapped none = search("none"), quarter = search("quarter-brute-force"), full = search("brute-force");
  CHECK(evaluations(none) == 1);
  CHECK(none.report["best"]["candidate"] == 0);
  CHECK(none.report["best"]["corners"][0] == border[0]);
  CHECK(none.report["curve"][0] == full.report["curve"][0]);
  CHECK(evaluations(quarter) > 1);
  CHECK(evaluations(quarter) < border.size() / 2);
  CHECK(evaluations(full) == border.size());
  CHECK(l2(quarter) <= l2(none));
  CHECK(l2(full) <= l2(quarter));
  for(const std::string strategy :
      {"particle-swarm", "step-sampling", "single-highest", "many-high", "better-of-two", "hybrid", "bracketing"}) {
    const Mapped mapped = search(strategy);
    INFO(strategy);
    CHECK(mapped.report["strategy"] == strategy);
    CHECK(evaluations(mapped) <= border.size());
    CHECK(mapped.report["curve"].size() == evaluations(mapped));
    CHECK(l2(full) <= l2(mapped));
    CHECK(search(strategy).text == mapped.text);
  }
}

TEST_CASE("the optimal minimizer lowers L2, Linf and symmetric Dirichlet at once, at every balance, with either border")
{
  const auto best = [](const Mapped& mapped, const char* key) { return mapped.report["best"][key].get<double>(); };
  const Soup soup = sheet(12, 9);
  const Mapped iterative = check_map(soup, {"--minimizer", "iterative", "--strategy", "brute-force"});
  const Mapped optimal = check_map(soup);
  for(const char* key : {"l2", "linf", "symmetric_dirichlet"})
    CHECK(best(optimal, key) < best(iterative, key));
  CHECK(optimal.report["minimizer"] == "optimal");
  const std::vector<std::string> defaults{"--minimizer", "optimal", "--balance",  "0.3",
                                          "--border",    "sliding", "--strategy", "bracketing"};
  CHECK(check_map(soup, defaults).text == optimal.text);
  const Mapped fixed = check_map(soup, {"--minimizer", "optimal", "--border", "fixed", "--strategy", "brute-force"});
  const Mapped sliding =
      check_map(soup, {"--minimizer", "optimal", "--border", "sliding", "--strategy", "brute-force"});
  CHECK(best(sliding, "energy") < best(fixed, "energy"));
  for(const std::string balance : {"0", "0.1", "1"}) {
    const Mapped mapped = check_map(soup, {"--minimizer", "optimal", "--balance", balance, "--strategy", "none"});
    // E = 2 L2^2 + b times its counterpart, and 4 SD = 2 L2^2 + the counterpart
    const double twice_l2 = 2 * best(mapped, "l2") * best(mapped, "l2");
    CHECK(best(mapped, "energy") ==
          Approx(twice_l2 + std::stod(balance) * (4 * best(mapped, "symmetric_dirichlet") - twice_l2)).epsilon(1e-9));
  }
}

TEST_CASE("the corners of the user are taken as they are")
{
  const std::vector<long> b = border_of(small.faces);
  for(const std::vector<long>& corners : {std::vector<long>{b[2], b[5], b[11], b[15]}, {b[15], b[2], b[5], b[11]}}) {
    const Mapped mapped = check_map(small, {"--corners", corner_option(corners)});
    CHECK(mapped.report["best"]["corners"] == corners);
    CHECK(mapped.report["evaluations"] == 1);
    CHECK(mapped.report["strategy"] == "none");
  }
}

TEST_CASE("all weights, rules and walks give maps that are one-to-one and not mirrored")
{
  const std::string minimizer = GENERATE("iterative", "optimal");
  for(const char* weights : {"blended", "shape-preserving", "shape-preserving-plain", "mean-value",
                             "symmetric-mean-value", "uniform", "clamped-cotangent"})
    for(const char* rule : {"author", "nearest"})
      for(const char* walk : {"counter-clockwise", "clockwise"}) {
        const Mapped mapped =
            check_map(small, {"--minimizer", minimizer, "--weights", weights, "--corner-rule", rule, "--walk", walk});
        CHECK(mapped.map.faces == small.faces);
      }
  // harmonic weights may be negative: a map, or an honest refusal
  const Temporary_folder folder;
  const Finished_process harmonic = square_map({folder.add("in.off", off(small)), "--weights", "harmonic"});
  CHECK((harmonic.status == DONE || harmonic.status == NO_ONE_TO_ONE_MAP));
}

TEST_CASE("harmonic weights of a mesh without obtuse angles give a one-to-one map")
{
  Soup soup = sheet(6, 6);
  for(Point& p : soup.points)
    p = {std::floor(p[0] + 0.5), std::floor(p[1] / 1.25 + 0.5), 0};
  check_map(soup, {"--minimizer", "iterative", "--weights", "harmonic"});
}

TEST_CASE("tuning numbers have an effect")
{
  const auto iterative = [](std::vector<std::string> options) {
    options.insert(options.end(), {"--minimizer", "iterative"});
    return check_map(small, options);
  };
  const Mapped paper = check_map(small, {"--preset", "paper"});
  CHECK(paper.report["minimizer"] == "iterative");
  CHECK(paper.report["strategy"] == "hybrid");
  const Mapped spelled_out =
      iterative({"--weights", "shape-preserving", "--corner-rule", "author", "--eta", "1", "--patience", "0"});
  CHECK(paper.text == spelled_out.text);
  CHECK(paper.text != iterative({}).text);
  CHECK(iterative({"--eta", "1"}).text != iterative({}).text);
  CHECK(iterative({"--patience", "20"}).report["best"]["iterations"] >
        iterative({"--patience", "0"}).report["best"]["iterations"]);
  CHECK(check_map(small, {"--preset", "paper", "--eta", "0.5"}).text != paper.text);
}

TEST_CASE("the number of threads does not change a byte")
{
  const Soup soup = sheet(20, 13);
  const Mapped expected = check_map(soup, {"--strategy", "brute-force", "--threads", "1"});
  CHECK(expected.report["threads"] == 1);
  for(const char* threads : {"2", "8", "0"}) {
    const Mapped mapped = check_map(soup, {"--strategy", "brute-force", "--threads", threads});
    CHECK(mapped.text == expected.text);
    CHECK(without_times_and_names(mapped.report) == without_times_and_names(expected.report));
    const Temporary_folder folder;
    const std::string input = folder.add("in.off", off(small));
    CHECK(square_map({input, "--quiet", "--threads", threads}).err == "");
  }
}

TEST_CASE("chords are split at their midpoint")
{
  const Soup soup = sheet(5, 5); // two ears
  const Mapped mapped = check_map(soup);
  CHECK(mapped.report["conditioned"]["chords_split"] == 2);
  CHECK(mapped.map.points.size() == soup.points.size() + 2);
  CHECK(mapped.map.faces.size() == soup.faces.size() + 4);
  CHECK(std::equal(soup.points.begin(), soup.points.end(), mapped.map.points.begin()));
  CHECK(mapped.messages.find("2 chords") != std::string::npos);

  const Soup fan{{{0, 0, 0}, {4, 0, 0}, {5, 3, 0}, {2, 6, 1}, {-1, 3, 0}, {-1, 2, 0}},
                 {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}}};
  CHECK(check_map(fan).report["conditioned"]["chords_split"] == 3);
  CHECK(check_map(fan, {"--preset", "paper", "--strategy", "brute-force"}).report["conditioned"]["chords_split"] == 2);
}

TEST_CASE("a border of three vertices gets a fourth, in the middle of its longest edge")
{
  const Soup triangle{{{0, 0, 0}, {1, 0, 0}, {0, 2, 0}}, {{0, 1, 2}}};
  const Soup fan{{{0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {1, 1, 1}}, {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
  for(const Soup& soup : {triangle, fan}) {
    const Mapped mapped = check_map(soup);
    CHECK(mapped.report["conditioned"]["border_edges"] == 4);
    CHECK(mapped.report["conditioned"]["border_edges_split"] == 1);
    REQUIRE(mapped.map.points.size() > soup.points.size());
    for(int k = 0; k < 3; ++k)
      CHECK(mapped.map.points[soup.points.size()][k] == (soup.points[1][k] + soup.points[2][k]) / 2);
    CHECK(mapped.messages.find("an edge of it was split") != std::string::npos);
  }
}

TEST_CASE("faces without area are mapped and counted, and the points stay where they are")
{
  const std::vector<long> border = border_of(small.faces);
  Soup flat_face = small, short_border = small, short_edge = small, cluster = small;
  const Face& face = small.faces[9];
  for(int i = 0; i < 3; ++i) // the third corner on the line through the two others
    flat_face.points[face[2]][i] = (small.points[face[0]][i] + small.points[face[1]][i]) / 2;
  short_border.points[border[3]] = small.points[border[4]];
  short_edge.points[face[0]] = small.points[face[1]];
  for(long v = 10; v < 24; ++v)
    cluster.points[v] = small.points[10];
  for(const Soup& soup : {flat_face, short_border, short_edge, cluster})
    for(const Arguments& options : {Arguments{}, Arguments{"--minimizer", "optimal"}}) {
      const Mapped mapped = check_map(soup, options);
      CHECK(std::equal(soup.points.begin(), soup.points.end(), mapped.map.points.begin()));
      CHECK(mapped.report["conditioned"]["degenerate_faces"] >= 1);
      CHECK(mapped.messages.find("faces without area") != std::string::npos);
    }
  CHECK(check_map(flat_face).report["conditioned"]["degenerate_faces"] == 1);
  CHECK(check_map(small).report["conditioned"]["degenerate_faces"] == 0);
}

TEST_CASE("mis-oriented faces are turned round and isolated vertices dropped")
{
  Soup soup = small;
  for(int f : {3, 17, 18, 40})
    std::reverse(soup.faces[f].begin(), soup.faces[f].end());
  soup.points.insert(soup.points.end(), 3, {9, 9, 9});
  const Mapped expected = check_map(small), mapped = check_map(soup);
  CHECK(mapped.report["conditioned"]["faces_reoriented"] == 4);
  CHECK(mapped.report["conditioned"]["vertices_dropped"] == 3);
  CHECK(mapped.report["input"]["vertices"] == soup.points.size());
  CHECK(mapped.messages.find("4 faces") != std::string::npos);
  CHECK(mapped.messages.find("3 isolated vertices") != std::string::npos);
  CHECK(mapped.map.points == expected.map.points);
  CHECK(mapped.report["best"]["l2"].get<double>() ==
        Approx(expected.report["best"]["l2"].get<double>()).epsilon(1e-12));
}

TEST_CASE("the map does not depend on the unit of length")
{
  const double expected = check_map(small).report["best"]["l2"];
  for(int exponent : {-400, -100, 100, 400}) {
    Soup soup = small;
    for(Point& p : soup.points)
      for(double& x : p)
        x = std::ldexp(x, exponent);
    INFO("2^" << exponent);
    const Temporary_folder folder;
    const Finished_process result = square_map({folder.add("in.off", off(soup)), "--json", "-", "--quiet"});
    REQUIRE(result.status == DONE);
    CHECK(nlohmann::json::parse(result.out)["best"]["l2"].get<double>() == Approx(expected).epsilon(1e-12));
  }
}

TEST_CASE("a flat square is mapped by an isometry")
{
  Soup soup;
  for(int i = 0; i < 9; ++i)
    soup.points.push_back({3. * (i % 3), 3. * (i / 3), 5});
  soup.points[4] = {2, 4, 5};
  const std::vector<long> border{0, 1, 2, 5, 8, 7, 6, 3};
  for(std::size_t k = 0; k < border.size(); ++k)
    soup.faces.push_back({border[k], border[(k + 1) % border.size()], 4});
  const Mapped mapped = check_map(soup, {"--corners", "0,2,8,6"});
  CHECK(mapped.report["best"]["l2"].get<double>() == Approx(1).epsilon(0.002)); // the iteration stops near the minimum
}

TEST_CASE("the report on standard output is alone there, and a quiet run says nothing")
{
  const Temporary_folder folder;
  const std::string input = folder.add("in.off", off(small));
  const Finished_process loud = square_map({input, "--json", "-"});
  CHECK(loud.status == DONE);
  CHECK(nlohmann::json::parse(loud.out).is_object());
  CHECK(loud.err.find("L2 stretch") != std::string::npos);
  const Finished_process quiet = square_map({input, "--quiet", "--json", "-"});
  CHECK(nlohmann::json::parse(quiet.out).is_object());
  CHECK(quiet.err == "");
  const Finished_process silent = square_map({input, "--quiet", "-o", folder / "map.obj"});
  CHECK(silent.status == DONE);
  CHECK(silent.out == "");
  CHECK(silent.err == "");
  CHECK(std::filesystem::exists(folder / "map.obj"));
}

TEST_CASE("a file name may hold any bytes")
{
  const Temporary_folder folder;
  for(const char* name : {"with space.off", "\xc3\xa9t\xc3\xa9.off", "not utf-8 \xff\xfe.off", "a=b.off", "--o.off"})
    check_map(folder.add(name, off(small)));
}

TEST_CASE("the help is printed, whatever else is asked")
{
  for(const Arguments& arguments : {Arguments{"--help"}, {"-h"}, {"--help", "missing.off"}}) {
    const Finished_process result = square_map(arguments);
    CHECK(result.status == DONE);
    CHECK(result.err == "");
    for(const char* words : {"usage: square_map", "--strategy", "--corners", "--json", "exit status"})
      CHECK(result.out.find(words) != std::string::npos);
  }
}

// ---------------------------------------------------------------------------------------------------------------------
// real meshes, of Debian's package libcgal-demo

TEST_CASE("real meshes are mapped one-to-one", "[real]")
{
  // the largest L2 that is accepted; infinite where nothing is known
  const double any = std::numeric_limits<double>::infinity();
  const std::vector<std::pair<std::string, double>> meshes{{"lion-head", 1.56},
                                                           {"mannequin-devil", 1.43},
                                                           {"three_peaks", 1.31},
                                                           {"mushroom", 1.20},
                                                           {"nefertiti", 1.056},
                                                           {"mesh_with_border", 1.003},
                                                           {"cylinder", 1.003},
                                                           {"cylinder_locally_refined", any},
                                                           {"patch-01", any},
                                                           {"patch-13", any},
                                                           {"patch-20", any},
                                                           {"patch-21", any},
                                                           {"patch-23", any},
                                                           {"patch-30", any},
                                                           {"plane", any},
                                                           {"poly2x^2+y^2-0.062500", any},
                                                           {"oblong-shuffled", any},
                                                           {"blob", any},
                                                           {"fold", any},
                                                           {"open_cube", any},
                                                           {"hedra_open", any}};
  if(!std::filesystem::exists(REAL_MESHES)) {
    WARN("no real meshes: Debian's package libcgal-demo is not installed");
    return;
  }
  for(const auto& [name, largest_l2] : meshes)
    DYNAMIC_SECTION(name)
    {
      const Mapped mapped = check_map(REAL_MESHES "/" + name + ".off");
      CHECK(mapped.report["best"]["l2"].get<double>() <= largest_l2);
    }
}
