// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "test_command_line_checks.h"

// Files with one defect each: the message names the format, the place, what was found and what was expected.

namespace {

struct Defect
{
  const char* file;
  std::string text;
  const char* message; ///< what follows the name of the format
};

void check_refused(const std::vector<Defect>& defects)
{
  for(const auto& [file, text, message] : defects) {
    std::string format = std::string(file).substr(3);
    std::transform(format.begin(), format.end(), format.begin(), [](unsigned char c) { return char(std::toupper(c)); });
    check_refusal_of_text(file, text, BAD_FILE, "' as " + format + ": " + message);
  }
}

const std::string off_points = "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
const std::string obj_points = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\n";
const std::string facet =
    "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";

std::string ascii_ply(const std::string& properties, const std::string& indices, const std::string& data)
{
  return "ply\nformat ascii 1.0\nelement vertex 3\n" + properties + "element face 1\n" + indices + "end_header\n" +
         data;
}

const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
const std::string list = "property list uchar int vertex_indices\n";
const std::string ply_points = "0 0 0\n1 0 0\n0 1 0\n";

} // namespace

TEST_CASE("a defect of an OFF file is named with its line")
{
  check_refused({
      {"in.off", off_points + "3 0 1 2\n3 0 2 3.7\n", "line 8: in face 1 an index from 0 to 3 was expected, not '3.7'"},
      {"in.off", off_points + "3 0 1 2\n3 0 2 99999999999999999999\n",
       "line 8: in face 1 an index from 0 to 3 was expected, not '99999999999999999999'"},
      {"in.off", off_points + "3 0 1 2\n3 0 2 3x\n", "line 8: in face 1 an index from 0 to 3 was expected, not '3x'"},
      {"in.off", off_points + "3 0 1 2\n\n# four of them\n3 0 2 4\n", "line 10: in face 1 an index from 0 to 3"},
      {"in.off", off_points + "3 0 1 2\n3 0 2 -1\n", "line 8: in face 1 an index from 0 to 3 was expected, not '-1'"},
      {"in.off", off_points + "3 0 1 2\n3 0 2\n", "line 8: in face 1 an index from 0 to 3 was expected, not the end"},
      {"in.off", off_points + "3 0 1 2\n", "it is incomplete: it ends after 1 of 2 faces"},
      {"in.off", off_points, "it is incomplete: it ends after 0 of 2 faces"},
      {"in.off", off_points + "3 0 1 2\n3.5 0 2 3\n", "line 8: the number of vertices of face 1 was expected"},
      {"in.off", "OFF\n3 1 0\n0 0 0\n1x 0 0\n0 1 0\n3 0 1 2\n", "line 4: a coordinate was expected, not '1x'"},
      {"in.off", "OFF\n3 1 0\n0 0 0\n1 0\n0 1 0\n3 0 1 2\n", "line 4: a coordinate was expected, not the end of the"},
      {"in.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n", "it is incomplete: it ends after 2 of 3 vertices"},
      {"in.off", "OFF\n3 one 0\n", "line 2: the number of faces was expected, not 'one'"},
      {"in.off", "OFF\n3 1 none\n0 0 0\n", "line 2: the number of edges was expected, not 'none'"},
      {"in.off", "nOFF\n4\n3 1 0\n", "line 2: its vertices have dimension 4; 3 was expected"},
      {"in.off", "points\n3 1 0\n", "line 1: OFF was expected, not 'points'"},
      {"in.off", "OFF3x\n1 0\n", "line 1: OFF was expected, not 'OFF3x'"},
      {"in.off", "OFFOFF3\n1 0\n", "line 1: OFF was expected, not 'OFFOFF3'"},
  });
}

TEST_CASE("a defect of a binary OFF file is named with its element")
{
  const auto binary = [](const std::string& keyword, const std::vector<std::int32_t>& counts,
                         const std::vector<std::int32_t>& face) {
    std::string text = keyword + " BINARY\n";
    for(std::int32_t count : counts)
      text += big_endian(count);
    for(float x : {0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F})
      text += big_endian(x);
    for(std::int32_t word : face)
      text += big_endian(word);
    return text;
  };
  const std::vector<std::int32_t> counts{3, 1, 0};
  check_refused({
      {"in.off", binary("OFF", {-3, 1, 0}, {3, 0, 1, 2, 0}), "header number 1 has a negative count, -3"},
      {"in.off", binary("OFF", {3, -1, 0}, {3, 0, 1, 2, 0}), "header number 2 has a negative count, -1"},
      {"in.off", binary("nOFF", {2, 3, 1, 0}, {3, 0, 1, 2, 0}), "its vertices have dimension 2; 3 was expected"},
      {"in.off", binary("OFF", counts, {3, 0, 1, 3, 0}),
       "face 0 names vertex 3; the file has 3 vertices, counted from 0"},
      {"in.off", binary("OFF", counts, {3, 0, -1, 2, 0}),
       "face 0 names vertex -1; the file has 3 vertices, counted from 0"},
      {"in.off", binary("OFF", counts, {3, 0, 1, 2, 9}), "face 0 has 9 color components; at most 4 were expected"},
      {"in.off", binary("OFF", counts, {-3, 0, 1, 2, 0}), "face 0 has a negative count, -3"},
      {"in.off", binary("OFF", counts, {3, 0, 1}), "it is incomplete: it ends in face 0"},
      {"in.off", binary("OFF", {4000, 1, 0}, {}), "it is incomplete: it ends in vertex 3"},
      {"in.off", "OFF BINARY\n", "it is incomplete: it ends in header number 1"},
  });
}

TEST_CASE("a defect of an OBJ file is named with its line")
{
  check_refused({
      {"in.obj", obj_points + "f 1 3 4x\n", "line 6: a corner of a face, such as 1, 1/2, 1//3 or 1/2/3, was expected"},
      {"in.obj", obj_points + "f 1 3 4 x\n", "line 6: a corner of a face, such as 1, 1/2, 1//3 or 1/2/3, was expected"},
      {"in.obj", obj_points + "f 1 3 4.5\n", "line 6: a corner"},
      {"in.obj", obj_points + "f1 3 4\n", "line 6: a blank after v or f was expected, not 'f1'"},
      {"in.obj", obj_points + "f 1 3 4/1x\n", "line 6: a corner"},
      {"in.obj", obj_points + "f 1 3 4/1/1/1\n", "line 6: a corner"},
      {"in.obj", obj_points + "f 1 3 4/0\n", "line 6: a corner"},
      {"in.obj", obj_points + "f 1 3 99999999999999999999\n",
       "line 6: a face names vertex '99999999999999999999', which no file has"},
      {"in.obj", obj_points + "f 1 2\n", "line 6: a face has 2 corners; at least three were expected"},
      {"in.obj", obj_points + "f 1 3 \\ 4\n", "line 6: a corner"}, // a backslash that ends no line
      {"in.obj", obj_points + "v 0 nan 0\nf 1 3 4\n",
       "line 6: vertex 5, counted from 1, has a coordinate that is not finite"},
      {"in.obj", "V 0 0 0\nV 1 0 0\n",
       "it has 0 vertices and no faces, but lines of unknown kinds, the first of them line 1"},
      {"in.obj", obj_points + "f 1 3 0\n", "line 6: a face names vertex 0; vertices are counted from 1"},
      {"in.obj", obj_points + "f 1 3 -5\n", "line 6: a face names vertex -5; there are 4 vertices before it"},
      {"in.obj", obj_points + "f 1 3 5\nf 1 2 3\n", "line 6: a face names vertex 5; the file has 4 vertices"},
      {"in.obj", obj_points + "f 1 3 \\\n 4 \\\n 5x\n", "line 8: a corner"}, // where the word stands
      {"in.obj", "v 0 0\n" + obj_points, "line 1: a coordinate was expected, not the end of the line"},
      {"in.obj", "v 0 0 1,5\n" + obj_points, "line 1: a coordinate was expected, not '1,5'"},
      {"in.obj", "v 0 0 0 red\n" + obj_points, "line 1: a weight or a color was expected, not 'red'"},
      {"in.obj", "v 0 0 0 1 1 1 1 1\n" + obj_points, "line 1: a vertex has 8 numbers; at most 7 were expected"},
      {"in.obj", "v 0 0 0\nv 1 0 0\nl 1 2\n", "it has 2 vertices and no faces"},
  });
}

TEST_CASE("a defect of a PLY file is named with its line or its element")
{
  const std::string half_facet = "3 0 1";
  check_refused({
      {"in.ply", ascii_ply("property float y\nproperty float z\n", list, ""), "it has no coordinate x"},
      {"in.ply", ascii_ply("property float x\nproperty float z\n", list, ""), "it has no coordinate y"},
      {"in.ply", ascii_ply("property float x\nproperty float y\n", list, ""),
       "it has no coordinate z; x, y and z were expected"},
      {"in.ply", ascii_ply("property float X\nproperty float y\nproperty float z\n", list, ply_points + "3 0 1 2\n"),
       "it has no coordinate x"},
      {"in.ply", ascii_ply(xyz + "property float x\n", list, ""), "its header has two properties of the name 'x'"},
      {"in.ply", ascii_ply(xyz, "property list uchar int corners\n", ply_points), "its faces have no list"},
      {"in.ply", ascii_ply(xyz, "property int vertex_indices\n", ply_points + "1\n"), "its faces have no list"},
      {"in.ply", ascii_ply(xyz, list, "0 0 0\n1 0x 0\n"), "line 11: in vertex 1 a number was expected, not '0x'"},
      {"in.ply", ascii_ply(xyz, list, "0 0 0 7\n"), "line 10: the end of vertex 0 was expected, not '7'"},
      {"in.ply", ascii_ply(xyz, list, ply_points + "3 0 1 1.5\n"), "line 13: in face 0 a whole number was expected"},
      {"in.ply", ascii_ply(xyz, list, ply_points + "3 0 1 2x\n"), "line 13: in face 0 a whole number was expected"},
      {"in.ply", ascii_ply(xyz, list, ply_points + "3 0 1 99999999999999999999\n"),
       "line 13: in face 0 a number that its type can hold was expected, not '99999999999999999999'"},
      {"in.ply", ascii_ply(xyz, "property list uchar double vertex_indices\n", ply_points + "3 0 1 1e30\n"),
       "line 13: face 0 names vertex 1e+30; the file has 3 vertices, counted from 0"},
      {"in.ply", replaced(ascii_ply(xyz, list, ply_points + "3 0 1 2\n"), "element face", "element Face"),
       "it has no element face"},
      {"in.ply", ascii_ply(xyz, list + list, ply_points), "its header has two properties of the name 'vertex_indices'"},
      {"in.ply", ascii_ply(xyz, "property list uchar uint vertex_indices\n", ply_points + "3 0 1 -2\n"),
       "line 13: in face 0 a number that its type can hold was expected, not '-2'"},
      {"in.ply", ascii_ply(xyz, list, ply_points + "259 0 1 2\n"),
       "line 13: in face 0 a number that its type can hold was expected, not '259'"},
      {"in.ply", ascii_ply(xyz, list, ply_points + half_facet), "it is incomplete: it ends in face 0"},
      {"in.ply", ascii_ply(xyz, list, "0 0 0\n"), "it is incomplete: it ends in vertex 1"},
      {"in.ply", replaced(ascii_ply(xyz, list, ply_points + "3 0 1 2x\n"), "\n", "\r"), "line 13: in face 0 a whole"},
      {"in.ply", ascii_ply(xyz, "property list char int vertex_indices\n", ply_points + "-3 0 1 2\n"),
       "line 13: face 0 has a list 'vertex_indices' whose number"},
      {"in.ply", ascii_ply(xyz, "property list uchar float vertex_indices\n", ply_points + "3 0 1 1.5\n"),
       "line 13: face 0 has an index that is not a whole number"},
      {"in.ply", ascii_ply(xyz, list, ply_points + "3 0 1 3\n"),
       "line 13: face 0 names vertex 3; the file has 3 vertices, counted from 0"},
      {"in.ply", ascii_ply(xyz, list, ply_points + "3 0 -1 2\n"),
       "line 13: face 0 names vertex -1; the file has 3 vertices"},
      {"in.ply",
       "ply\nformat ascii 1.0\nelement face 1\n" + list + "element vertex 3\n" + xyz + "end_header\n3 0 1 7\n" +
           ply_points,
       "line 10: face 0 names vertex 7; the file has 3 vertices, counted from 0"},
      {"in.ply", binary_ply(small).substr(0, 900), "it is incomplete: it ends in vertex "},
      {"in.ply", binary_ply(small).substr(0, 1200), "it is incomplete: it ends in face "},
      {"in.ply", "ply\nformat utf8 1.0\n", "line 2: ascii, binary_little_endian or binary_big_endian was expected"},
      {"in.ply", "ply\nformat ascii 2.0\n", "line 2: version 1.0 was expected, not '2.0'"},
      {"in.ply", "ply\nelement vertex many\n", "line 2: the number of elements was expected, not 'many'"},
      {"in.ply", "ply\nelement vertex 3\n" + xyz + "end_header\n", "its header does not name a format"},
      {"in.ply", "ply\nformat ascii 1.0\nelement face 1\n" + list + "end_header\n3 0 1 2\n",
       "it has no element vertex"},
      {"in.ply",
       "ply\nformat ascii 1.0\nelement vertex 3\n" + xyz + "element tristrips 1\n" + list + "end_header\n" + ply_points,
       "it has triangle strips, which are not read; an element face was expected"},
      {"in.ply",
       "ply\nformat ascii 1.0\nelement vertex 3\n" + xyz + "element face 1\n" + list + "element tristrips 1\n" + list +
           "end_header\n" + ply_points + "3 0 1 2\n3 0 1 2\n",
       "it has triangle strips, which are not read; an element face was expected"},
      {"in.ply", off(small), "line 1: ply was expected, not 'OFF'"},
  });
}

TEST_CASE("a defect of an STL file is named with its line or its facet")
{
  const std::string solid = "solid x\n" + facet;
  check_refused({
      {"in.stl", "solid x\n" + facet.substr(0, 45), "it is incomplete: it ends in facet 0"},
      {"in.stl", solid + facet.substr(0, 45), "it is incomplete: it ends in facet 1"},
      {"in.stl", solid, "it is incomplete: it ends without endsolid after 1 facet"},
      {"in.stl", solid + "endsolid x\nsol", "it is incomplete: it ends in the word solid"},
      {"in.stl", solid + "endsolid x\n" + facet, "line 10: solid was expected, not 'facet'"},
      {"in.stl", replaced(solid + "endsolid x solix y " + facet + "endsolid y", "\n", " "),
       "line 1: solid was expected, not 'facet'"},
      {"in.stl", "solid x\nfacet abnormal 0 0 1\n", "line 2: normal or outer loop was expected, not 'abnormal'"},
      {"in.stl", "solid x\nfacet normal 0 0 1 2\n", "line 2: normal or outer loop was expected, not '2'"},
      {"in.stl", solid + "vertex 0 0 0\n", "line 9: facet or endsolid was expected, not 'vertex'"},
      {"in.stl", "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0x 0\n",
       "line 5: a coordinate was expected, not '0x'"},
      {"in.stl", "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nendloop\nendfacet\n",
       "line 6: vertex was expected, not 'endloop'"},
      {"in.stl",
       "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nvertex 0 1 0\nendloop\n",
       "line 7: endloop was expected, not 'vertex'"},
      {"in.stl", replaced(solid, "vertex 1 0 0", "vertex 1 inf 0") + "endsolid\n",
       "facet 0 has a coordinate that is not finite"},
      {"in.stl", binary_stl(small).substr(0, 84 + 50 * 3 + 20), "it is incomplete: it ends in facet 3 of 48"},
      {"in.stl", std::string(50, 'x'), "it neither begins with the word solid nor has the 84 bytes of a binary header"},
  });
}
