// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "test_command_line_checks.h"

#include <cmath>
#include <numeric>
#include <sstream>

// Valid files of all kinds: each holds the sheet of the other tests.

namespace {

/// the file must hold the sheet
Mapped check_sheet(const std::string& name, const std::string& text)
{
  INFO(name << " of " << text.size() << " bytes, begins with " << text.substr(0, 200));
  const Temporary_folder folder;
  const Mapped mapped = check_map(folder.add(name, text));
  CHECK(mapped.map.points == small.points);
  CHECK(mapped.map.faces == small.faces);
  return mapped;
}

std::string replaced(std::string text, const std::string& before, const std::string& after)
{
  for(std::size_t place = text.find(before); place != std::string::npos;
      place = text.find(before, place + after.size()))
    text.replace(place, before.size(), after);
  return text;
}

/// how numbers of a PLY file are written
typedef std::string (*Write)(double x, bool is_big);

template <class Number>
std::string binary(double x, bool is_big)
{
  const Number number = static_cast<Number>(x);
  return is_big ? big_endian(number) : bytes(number);
}

const std::vector<std::pair<std::string, Write>> integer_types{
    {"char", binary<std::int8_t>},     {"uchar", binary<std::uint8_t>}, {"short", binary<std::int16_t>},
    {"ushort", binary<std::uint16_t>}, {"int", binary<std::int32_t>},   {"uint", binary<std::uint32_t>}};

std::string uppercase(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return char(std::toupper(c)); });
  return text;
}

} // namespace

TEST_CASE("PLY files are read with lists of any types of integers, in text and in both orders of bytes")
{
  for(const auto& [size_name, write_size] : integer_types)
    for(const auto& [index_name, write_index] : integer_types)
      for(const char* format : {"ascii", "binary_little_endian", "binary_big_endian"}) {
        const bool is_big = std::string(format) == "binary_big_endian", is_text = std::string(format) == "ascii";
        std::string text =
            replaced(ply_header(small, format), "list uchar int", "list " + size_name + ' ' + index_name);
        for(const Point& p : small.points)
          for(int i = 0; i < 3; ++i)
            text += is_text ? number(p[i]) + (i == 2 ? "\n" : " ") : binary<double>(p[i], is_big);
        for(const Face& face : small.faces) {
          text += is_text ? row(face, 0, "3 ") : write_size(3, is_big);
          for(std::size_t k = 0; !is_text && k < 3; ++k)
            text += write_index(double(face[k]), is_big);
        }
        check_sheet("in.ply", text);
      }
}

TEST_CASE("PLY files are read with the largest indices that unsigned types hold, in text and in both orders of bytes")
{
  const auto check_indices = [](const std::string& type, Write write, std::size_t largest) {
    const std::size_t isolated = largest + 1 - small.points.size(); // these come first
    Soup soup = small;
    soup.points.insert(soup.points.begin(), isolated, Point{9, 9, 9});
    for(Face& face : soup.faces)
      for(long& v : face)
        v += long(isolated);
    for(const bool is_big : {false, true}) {
      std::string text = replaced(ply_header(soup, is_big ? "binary_big_endian" : "binary_little_endian"),
                                  "list uchar int", "list uchar " + type);
      for(const Point& p : soup.points)
        for(double x : p)
          text += binary<double>(x, is_big);
      for(const Face& face : soup.faces) {
        text += '\3';
        for(long v : face)
          text += write(double(v), is_big);
      }
      check_sheet("in.ply", text);
    }
    check_sheet("in.ply", replaced(ply(soup), "list uchar int", "list uchar " + type));
  };
  check_indices("uchar", binary<std::uint8_t>, 255);
  check_indices("ushort", binary<std::uint16_t>, 65535);
}

TEST_CASE("PLY files are read with the other names of the types, and with a byte order mark")
{
  const std::string text = ply(small);
  for(const char* names : {"list uint8 int32", "list int8 uint32", "list uint16 int16", "list int16 uint16"})
    check_sheet("in.ply", replaced(text, "list uchar int", names));
  for(const char* name : {"float64", "float32", "float"})
    check_sheet("in.ply", replaced(text, "property double", std::string("property ") + name));
  for(const std::string& any : {text, binary_ply(small)})
    check_sheet("in.ply", "\xef\xbb\xbf" + any);
  // another property has the other name of the list
  const std::string faces = counted_rows(small.faces), points = text.substr(0, text.size() - faces.size());
  check_sheet("in.ply", replaced(points, "property list uchar int vertex_indices",
                                 "property int vertex_indices\nproperty list uchar int vertex_index") +
                            "7 " + replaced(faces.substr(0, faces.size() - 1), "\n", "\n7 ") + "\n");
}

TEST_CASE("the data of a binary PLY file begin behind a carriage return, also with the byte of a line feed")
{
  Soup soup = small;
  const float x = 0.5f + 5 / 8388608.f; // 0a 00 00 3f
  soup.points[0][0] = double(x);
  std::string text = replaced(ply_header(soup, "binary_little_endian"), "property double", "property float");
  text = replaced(text, "\n", "\r");
  for(const Point& p : soup.points)
    for(double coordinate : p)
      text += bytes(float(coordinate));
  for(const Face& face : soup.faces) {
    text += '\3';
    for(long v : face)
      text += bytes(std::int32_t(v));
  }
  const Temporary_folder folder;
  const Mapped mapped = check_map(folder.add("in.ply", text));
  CHECK(mapped.map.points[0][0] == double(x));
  CHECK(mapped.map.faces == soup.faces);
}

TEST_CASE("PLY files are read with integer coordinates, and with elements and properties that are not needed")
{
  const std::string head = "ply\nformat ascii 1.0\nelement nothing 9000000000\nelement camera 1\nproperty list uchar "
                           "float view\nelement vertex 4\n";
  const std::string text =
      head + "property uchar red\nproperty short z\nproperty int y\nproperty list uchar int near\n"
             "property uchar x\nproperty list uchar int near\nelement face 2\nproperty list int float weights\n"
             "property list uint8 uint16 vertex_index\nproperty float quality\nelement edge 9\n"
             "property int a\nend_header\n2 1.5 2\n9 0 0 0 0 0\n9 0 0 2 7 7 3 0\n9 5 4 0 3 1 8\n9 0 4 0 0 0\n"
             "0 3 0 1 2 .5\n2 1e3 nan 3 0 2 3 .25\n";
  const Temporary_folder folder;
  const Map map = check_map(folder.add("in.ply", text), {"--cut", "none"}).map;
  REQUIRE(map.points.size() >= 4);
  CHECK(map.points[0] == Point{0, 0, 0});
  CHECK(map.points[1] == Point{3, 0, 0});
  CHECK(map.points[2] == Point{3, 4, 5});
  CHECK(map.points[3] == Point{0, 4, 0});
}

TEST_CASE(
    "binary PLY files are read with coordinates of any type, and with elements and properties that are not needed")
{
  const std::vector<Point> corners{{0, 0, 0}, {3, 0, 0}, {3, 4, 5}, {0, 4, 0}};
  std::vector<std::pair<std::string, Write>> types = integer_types;
  types.emplace_back("float", binary<float>);
  types.emplace_back("double", binary<double>);
  for(const auto& [type, write] : types)
    for(const bool is_big : {false, true}) {
      const auto list = [is_big = is_big](const std::vector<double>& values, Write size, Write value) {
        std::string text = size(double(values.size()), is_big);
        for(double x : values)
          text += value(x, is_big);
        return text;
      };
      std::string text = std::string("ply\nformat ") + (is_big ? "binary_big_endian" : "binary_little_endian") +
                         " 1.0\nelement camera 1\nproperty list uchar float view\nelement vertex 4\n"
                         "property uchar red\nproperty " +
                         type + " z\nproperty " + type + " y\nproperty list uchar int near\nproperty " + type +
                         " x\nelement face 2\nproperty list int float weights\n"
                         "property list uint8 uint16 vertex_index\nproperty float quality\nelement edge 1\n"
                         "property int a\nend_header\n";
      text += list({1.5, 2}, binary<std::uint8_t>, binary<float>);
      for(const Point& p : corners)
        text += '\7' + write(p[2], is_big) + write(p[1], is_big) +
                list({7, p[0]}, binary<std::uint8_t>, binary<std::int32_t>) + write(p[0], is_big);
      for(const std::vector<double>& face : {std::vector<double>{0, 1, 2}, {0, 2, 3}})
        text += list({0.5}, binary<std::int32_t>, binary<float>) +
                list(face, binary<std::uint8_t>, binary<std::uint16_t>) + binary<float>(0.25, is_big);
      text += binary<std::int32_t>(1, is_big);
      const Temporary_folder folder;
      CAPTURE(type, is_big);
      const Map map = check_map(folder.add("in.ply", text), {"--cut", "none"}).map;
      REQUIRE(map.points.size() >= corners.size());
      CHECK(std::equal(corners.begin(), corners.end(), map.points.begin()));
    }
}

TEST_CASE("OBJ files are read with all that the format has")
{
  const std::string text = obj(small);
  for(const std::string& variant :
      {replaced(text, " ", "\t"), replaced(text, "\n", "\r\n"), replaced(text, "\n", "\r"), "\xef\xbb\xbf" + text,
       replaced(text, " ", " \\\n  "), replaced(text, " ", " \\\r\n"), replaced(text, "\n", " # comment\n"),
       replaced(text, " ", " \\ \t\n"), replaced(text, "f ", "fo "), text + "\\", text + "g x \\ "})
    check_sheet("in.obj", variant);
  Soup relative = small;
  for(Face& face : relative.faces)
    for(long& v : face)
      v -= long(small.points.size()) + 1; // the text adds 1
  check_sheet("in.obj", obj(relative));
  const std::size_t faces = text.find("f ");
  check_sheet("in.obj", text.substr(faces) + text.substr(0, faces)); // faces before vertices
}

TEST_CASE("what an OBJ file has beside points and faces is passed over and said")
{
  std::string points, faces;
  for(const Point& p : small.points)
    points += replaced(row(p, "v "), "\n", " 0.5 0.25 1\n");
  for(const Face& face : small.faces)
    faces += "f " + std::to_string(face[0] + 1) + "/1/1 " + std::to_string(face[1] + 1) + "//1 " +
             std::to_string(face[2] + 1) + "/1\n";
  const Mapped mapped = check_sheet(
      "in.obj", "mtllib a b.mtl\no sheet\nmg 1 0.5\nmaplib m\nusemap off\n" + points +
                    "vt 0 0\nvn 0 0 1\nvp 0 0\ncall other.obj 1\ng a b\ns off\nusemtl red\n" + faces +
                    "l 1 2 3\np 1\ncstype bspline\ndeg 3\ncurv 0 1 1 2 \\\n 3 4\nparm u 0 1\nend\nbanana 1\n");
  const nlohmann::json expected{{"colors", 35},
                                {"display and command lines", 1},
                                {"free-form lines", 6},
                                {"groups", 3},
                                {"lines of unknown kinds, the first of them line 104", 1},
                                {"materials", 4},
                                {"normals", 1},
                                {"objects", 1},
                                {"points", 1},
                                {"polylines", 1},
                                {"texture coordinates", 1}};
  CHECK(mapped.report["input"]["passed_over"] == expected);
  CHECK(mapped.messages.find("passed over in the file: colors (35), ") != std::string::npos);
  for(const char* weight : {" 1", " 0.5 0.25 1 1"})
    check_sheet("in.obj", replaced(points, " 0.5 0.25 1", weight) + faces);
  const Temporary_folder folder;
  const Finished_process quiet = square_map({folder.add("in.obj", obj(small) + "l 1 2\n"), "--quiet"});
  CHECK(quiet.status == DONE);
  CHECK(quiet.err == "");
}

TEST_CASE("lines of all kinds that OBJ files have are passed over by their kind")
{
  const std::vector<std::pair<std::string, std::vector<std::string>>> kinds{
      {"free-form lines", {"vp",   "cstype", "deg", "bmat", "step", "curv", "curv2", "surf", "parm", "trim",  "hole",
                           "scrv", "sp",     "end", "con",  "bzp",  "bsp",  "cdc",   "cdp",  "res",  "ctech", "stech"}},
      {"display and command lines",
       {"bevel", "c_interp", "d_interp", "lod", "shadow_obj", "trace_obj", "call", "csh", "unset"}},
      {"materials", {"mtllib", "usemtl", "maplib", "usemap"}},
      {"groups", {"g", "s", "mg"}}};
  for(const auto& [kind, keywords] : kinds) {
    std::string text = obj(small);
    for(const std::string& keyword : keywords)
      text += keyword + " 1 2 3\n";
    CHECK(check_sheet("in.obj", text).report["input"]["passed_over"] == nlohmann::json{{kind, keywords.size()}});
  }
}

TEST_CASE("what follows the last element that a header gives is passed over and said")
{
  const auto check_passed_over = [](const std::string& name, const std::string& text, const std::string& things,
                                    int count) {
    const Mapped mapped = check_sheet(name, text);
    CHECK(mapped.report["input"]["passed_over"] == nlohmann::json{{things + ", the last by its header", count}});
    CHECK(mapped.messages.find(things) != std::string::npos);
  };
  check_passed_over("in.off", off(small) + "\n# one more, and words\n3 0 1 2\nand words\n", "lines after face 47", 2);
  check_passed_over("in.ply", ply(small) + "3 0 1 2\n", "lines after face 47", 1);
  check_passed_over("in.ply", binary_ply(small) + "12345", "bytes after face 47", 5);
  check_passed_over("in.stl", binary_stl(small) + std::string(100, ' '), "bytes after facet 47", 100);
}

TEST_CASE("OFF files are read in text and binary, with and without what they say beside the surface")
{
  const std::string text = off(small);
  const std::string counts = "35 48 0\n", points_and_faces = text.substr(text.find(counts) + counts.size());
  std::string colored = "OFF # keyword\n\n# comment\n 35\n48 0 # counts\n";
  for(const Point& p : small.points)
    colored += replaced(row(p, "  "), "\n", " 255 0 0\n");
  for(const Face& face : small.faces)
    colored += "# a face\n" + replaced(row(face, 0, "3\t"), "\n", " 0.5 0.5 0.5 # red\n");
  for(const std::string& variant :
      {"\xef\xbb\xbf" + text, replaced(text, "\n", "\r\n"), colored, "OFF\n35 48\n" + points_and_faces,
       "nOFF 3\n" + counts + points_and_faces, "OFF " + counts + points_and_faces, text + "trailing words",
       "OFF" + counts + points_and_faces, counts + points_and_faces}) // as in collections of meshes, and without
    check_sheet("in.off", variant);
  std::string homogeneous = "4OFF\n" + counts;
  for(const Point& p : small.points)
    homogeneous += replaced(row(Point{2 * p[0], 2 * p[1], 2 * p[2]}), "\n", " 2\n");
  check_sheet("in.off", homogeneous + counted_rows(small.faces));
}

TEST_CASE("binary OFF files are read with normals, colors and texture coordinates, and with any number of face colors")
{
  for(const std::string keyword : {"OFF", "NOFF", "COFF", "STOFF", "STCNOFF"})
    for(int components : {-1, 0, 1, 3, 4}) { // after each face; -1: without their number
      std::string binary = keyword + " BINARY\n" + big_endian(std::int32_t(35)) + big_endian(std::int32_t(48)) +
                           big_endian(std::int32_t(0));
      const bool has_normals = keyword.find('N') != std::string::npos,
                 has_colors = keyword.find('C') != std::string::npos;
      const int attributes = (has_normals ? 3 : 0) + (has_colors ? 4 : 0) + (keyword[0] == 'S' ? 2 : 0);
      for(const Point& p : small.points) {
        for(double x : p)
          binary += big_endian(float(x));
        for(int i = 0; i < attributes; ++i)
          binary += big_endian(0.5f);
      }
      for(const Face& face : small.faces) {
        binary += big_endian(std::int32_t(3));
        for(long v : face)
          binary += big_endian(std::int32_t(v));
        binary += components < 0 ? "" : big_endian(std::int32_t(components));
        for(int i = 0; i < components; ++i)
          binary += big_endian(0.25f);
      }
      check_sheet("in.off", binary);
    }
}

TEST_CASE("STL files are read in any case and with any name, binary ones also when they begin with solid")
{
  const std::string text = stl(small);
  for(const std::string& variant :
      {uppercase(text), replaced(text, "sheet", "my facet"), replaced(text, "sheet", "facet normal x"),
       replaced(text, "solid sheet", "solid"), replaced(text, "\n", " "),
       replaced(text, "normal 0 0 0", "normal nan nan nan"), replaced(text, "normal 0 0 0", "normal -1.#IND 1.#QNAN 0"),
       replaced(text, "normal 0 0 0", "normal"), replaced(text, " normal 0 0 0", ""), "  " + text,
       text + text.substr(0, 12) + "endsolid\n", "\xef\xbb\xbf" + text})
    check_sheet("in.stl", variant);
  for(const char* name : {"facet normal 1 0 0 x", "facet outer", "a facet outer loop", "solid facet"})
    check_sheet("in.stl", replaced(text, "solid sheet\n", std::string("solid ") + name + "\n"));
  for(const char* name : {"facet", "a facet", "a facet facet"}) // before a facet on the same line
    check_sheet("in.stl",
                replaced(replaced(text, "\n", " "), "solid sheet facet", std::string("solid ") + name + " facet"));
  std::string binary = binary_stl(small);
  check_sheet("in.stl", binary.replace(0, 12, "solid facet "));
  check_sheet("in.stl", binary.replace(0, 3, "\xEF\xBB\xBF"));
  check_sheet("in.stl", binary_stl(small) + "after the last facet");
  check_sheet("in.stl", binary_stl(small).replace(0, 3, "\xEF\xBB\xBF") + "after the last facet");
}

TEST_CASE("STL files are read with several solids, whatever stands between them, and on one line")
{
  const std::string text = stl(small), end = "endfacet\n";
  const std::size_t middle = text.find(end, text.size() / 2) + end.size();
  const auto parted = [&](const std::string& between) {
    return text.substr(0, middle) + between + text.substr(middle);
  };
  for(const char* name : {"", " b", " solid b", " facet b"}) {
    const std::string end_and_begin = std::string("endsolid") + name + "\nsolid" + name + "\n";
    check_sheet("in.stl", parted(end_and_begin));
    check_sheet("in.stl", parted(uppercase(end_and_begin)));
    check_sheet("in.stl", replaced(parted(end_and_begin), "\n", " "));
  }
  const Mapped mapped = check_sheet("in.stl", parted("endsolid a\n; a note\n\n# and one more\nsolid b\n") + "the end");
  CHECK(mapped.report["input"]["passed_over"] == nlohmann::json{{"lines outside solids", 3}});
}

TEST_CASE("OFF files are read with the numbers of points and faces on any lines")
{
  const std::string text = off(small), faces = counted_rows(small.faces);
  const std::string on_one_line = replaced(text.substr(0, text.size() - faces.size()), "\n", " ");
  check_sheet("in.off", replaced(text, " ", "\n"));
  check_sheet("in.off", on_one_line + faces);
  check_sheet("in.off", replaced(text, "\n", " "));
  check_refusal_of_text("in.off", on_one_line + "0 " + faces, BAD_FILE); // a number too many
  check_refusal_of_text("in.off", on_one_line + faces + "0\n", BAD_FILE);
}

TEST_CASE("an OFF file of which a row or a number is missing or comes twice is not taken for numbers on any lines")
{
  Soup sheet = small;
  for(Point& p : sheet.points) // coordinates that may be indices, and sizes of faces
    p = {std::round(p[0]), std::round(p[1]), 3};
  std::istringstream stream(off(sheet));
  std::vector<std::string> rows;
  for(std::string row; std::getline(stream, row);)
    rows.push_back(row + '\n');
  const auto joined = [](const std::vector<std::string>& texts) {
    return std::accumulate(texts.begin(), texts.end(), std::string());
  };
  const std::size_t points = sheet.points.size();
  for(std::size_t k = 2; k < rows.size(); k += 5) { // all rows take seconds
    std::vector<std::string> fewer = rows, more = rows;
    fewer.erase(fewer.begin() + std::ptrdiff_t(k));
    more.insert(more.begin() + std::ptrdiff_t(k), rows[k]);
    check_refusal_of_text("in.off", joined(fewer), BAD_FILE);
    if(k < 2 + points) // a face more is passed over behind the last one
      check_refusal_of_text("in.off", joined(more), BAD_FILE);
    std::vector<std::string> moved = rows; // a number, to the next row
    const std::size_t last = moved[k].rfind(' ');
    if(k + 1 < rows.size())
      moved[k + 1] = moved[k].substr(last + 1, moved[k].size() - last - 2) + ' ' + moved[k + 1];
    moved[k] = moved[k].substr(0, last) + '\n';
    check_refusal_of_text("in.off", joined(moved), BAD_FILE);
  }
  // a number is missing, and the first of a face is one more size of a face
  check_refusal_of_text("in.off", "OFF\n4 2 0\n0 0 0\n1 0\n1 1 0\n0 1 0\n4 3 0 1 2\n3 0 2 3\n", BAD_FILE);
}
