// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "test_command_line_checks.h"
#include "test_meshes.h"

#include <cmath>
#include <map>
#include <numeric>
#include <utility>

// Surfaces that cannot be mapped as they are: refused, or reduced to a component, or cut.

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
  check_refusal_of_soup(soup, UNMAPPABLE, "none of its faces has an area");
  // one face, whose sides and chord are split before it is measured
  check_refusal_of_soup({{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}}, UNMAPPABLE, "none of its faces has an area");
  // closed, to be cut
  check_refusal_of_soup({{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}},
                        UNMAPPABLE, "none of its faces has an area");
}

TEST_CASE("a message that names vertices says from where they are counted, and one that names none does not")
{
  const Soup bow{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}, {{0, 1, 2}, {0, 3, 4}}};
  for(const auto& [name, text] : {std::pair<std::string, std::string>{"in.off", off(bow)}, {"in.obj", obj(bow)}})
    check_refusal_of_text(name, text, UNMAPPABLE, "; vertices and faces are counted from 0");
  const Temporary_folder folder;
  const std::string without = folder.add("in.off", off({small.points, {}}));
  CHECK(square_map({without}).err.find("counted from 0") == std::string::npos);
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
    const auto report = nlohmann::json::parse(result.out), conditioned = report["conditioned"];
    const std::size_t seams = conditioned["seam_edges"], chords = conditioned["chords_split"];
    CHECK(seams >= 2);
    CHECK(conditioned["cut_length"] == Approx(double(seams) * std::sqrt(2.) / std::sqrt(4 * std::sqrt(3.))));
    CHECK(conditioned["border_edges"] == 2 * seams);

    std::istringstream lines(read_file(output));
    std::vector<Point> points;
    std::size_t texture_vertices = 0, faces = 0;
    std::map<long, long> vertex_of; // per texture vertex
    for(std::string line, key; std::getline(lines, line);) {
      std::istringstream words(line);
      words >> key;
      if(key == "v")
        points.push_back(next_point(words));
      texture_vertices += key == "vt" ? 1 : 0;
      faces += key == "f" ? 1 : 0;
      char slash = 0;
      for(long v = 0, vt = 0; key == "f" && words >> v >> slash >> vt;)
        vertex_of[vt - 1] = v - 1;
    }
    REQUIRE(points.size() == octahedron.points.size() + chords);
    CHECK(std::equal(octahedron.points.begin(), octahedron.points.end(), points.begin()));
    CHECK(texture_vertices == points.size() + seams - 1);
    CHECK(faces == octahedron.faces.size() + 2 * chords);

    // corners are vertices of the cut surface, and of the file, where one may be several
    const std::vector<long> corners = report["best"]["corners"], input_corners = report["best"]["input_corners"];
    REQUIRE(corners.size() == 4);
    REQUIRE(input_corners.size() == 4);
    for(int k = 0; k < 4; ++k)
      CHECK(vertex_of.at(corners[k]) == input_corners[k]);
    const Finished_process again = square_map(arguments + Arguments{"--corners", corner_option(input_corners)});
    REQUIRE(again.status == DONE);
    CHECK(nlohmann::json::parse(again.out)["best"]["input_corners"] == input_corners);
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
  Soup shifted = small; // an isolated vertex comes first, and is dropped
  shifted.points.insert(shifted.points.begin(), {9, 9, 9});
  for(Face& face : shifted.faces)
    for(auto& v : face)
      ++v;
  check_refusal_of_input(folder.add("shifted.off", off(shifted)), UNMAPPABLE,
                         "seams.txt', line 2: the seam from vertex 1 to vertex 35 is not an edge",
                         seams("1 2\n1 35\n"));
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

TEST_CASE("a flat square of 5000 strips is mapped all but without stretch, as it is flat")
{
  const int strips = 5000;
  Soup soup;
  for(int i = 0; i <= strips; ++i)
    for(double y : {0., 1.})
      soup.points.push_back({double(i) / strips, y, 0});
  for(int a = 0; a < 2 * strips; a += 2)
    soup.faces.insert(soup.faces.end(), {{a, a + 2, a + 3}, {a, a + 3, a + 1}});
  CHECK(check_map(soup).report["best"]["l2"] < 1.2);
}

/// a polygon whose corners are at the given distances from its center
Soup star(const std::vector<double>& radii)
{
  Soup soup;
  soup.faces.emplace_back();
  for(std::size_t i = 0; i < radii.size(); ++i) {
    const double angle = 2 * 3.14159265358979 * double(i) / double(radii.size());
    soup.points.push_back({radii[i] * std::cos(angle), radii[i] * std::sin(angle), 0});
    soup.faces[0].push_back(static_cast<long>(i));
  }
  return soup;
}

/// the polygon with two corners exchanged: it crosses itself there, so that it is split between its corners alone
Soup crossing_itself(Soup polygon)
{
  std::swap(polygon.faces[0][0], polygon.faces[0][2]);
  return polygon;
}

TEST_CASE("a half disk of 20000 corners is stretched as little as one of 1000, and no triangle of it is torn")
{
  const auto half_disk = [](int corners) {
    Soup soup;
    soup.faces.emplace_back();
    for(int i = 0; i < corners; ++i) {
      const double angle = 3.14159265358979 * i / (corners - 1);
      soup.points.push_back({std::cos(angle), std::sin(angle), 0});
      soup.faces[0].push_back(i);
    }
    return soup;
  };
  const Mapped coarse = check_map(half_disk(1000), {"--triangulate"});
  const Mapped coarse_between_corners = check_map(crossing_itself(half_disk(1000)), {"--triangulate"});
  const auto compare = [](const Mapped& fine, const Mapped& to) {
    CHECK(fine.report["best"]["energy"] < 1.02 * double(to.report["best"]["energy"]));
    CHECK(fine.report["best"]["linf"] < 1500); // 500 to 2200 by size, from 19000 to 21000 corners
  };
  compare(check_map(half_disk(20000), {"--triangulate"}), coarse);
  compare(check_map(crossing_itself(half_disk(20000)), {"--triangulate"}), coarse_between_corners);
}

TEST_CASE("of a star of 5000 corners, whose maps cost much, one is made, and its corners stay")
{
  std::vector<double> radii;
  for(int i = 0; i < 5000; ++i)
    radii.push_back(0.5 + 0.5 * ((i * 7919) % 5003) / 5003);
  const Mapped mapped = check_map(crossing_itself(star(radii)), {"--triangulate"});
  CHECK(mapped.report["evaluations"] == 1);
  CHECK(mapped.report["corner_moves"] == 1); // the one that tells what they cost
}

TEST_CASE("where the first sketch of a polygon is hopeless and has cost much, or its first map has, no other is made")
{
  std::vector<double> radii;
  for(int i = 0; i < 8000; ++i)
    radii.push_back(0.1 + 0.9 * ((i * 7919) % 10007) / 10007);
  CHECK(check_map(star(radii), {"--triangulate"}).report["sketches"] == 1);
  radii.clear();
  for(int i = 0; i < 6000; ++i)
    radii.push_back(i % 2 == 0 ? 0.1 : 1);
  const auto without_sketch = check_map(crossing_itself(star(radii)), {"--triangulate"}).report;
  CHECK(without_sketch["evaluations"] == 1);
  CHECK(without_sketch["start"] == "as chosen");
}

TEST_CASE("a polygon of many corners gets vertices inside, with which it is stretched less than between its corners")
{
  std::vector<double> radii;
  for(int i = 0; i < 2000; ++i)
    radii.push_back(i % 2 == 0 ? 0.9 : 1);
  const auto split_with_vertices = check_map(star(radii), {"--triangulate"}).report,
             split_between_corners = check_map(crossing_itself(star(radii)), {"--triangulate"}).report;
  CHECK(split_with_vertices["conditioned"]["vertices_added"] > 500);
  CHECK(split_between_corners["conditioned"]["vertices_added"] == 0);
  CHECK(split_with_vertices["best"]["l2"] < 8);
  CHECK(split_between_corners["best"]["l2"] > split_with_vertices["best"]["l2"]);
  const auto circle = check_map(star(std::vector<double>(1000, 1)), {"--triangulate"}).report;
  CHECK(circle["best"]["l2"] < 1.04); // 1.07 between the corners alone
}

/// a polygon with teeth of height 2 on a base of height 5
Soup comb(int teeth)
{
  Soup soup;
  soup.points = {{-1, -5, 0}, {2. * teeth, -5, 0}, {2. * teeth, 0, 0}};
  for(int i = teeth; i-- > 0;)
    for(const auto& [x, y] : {std::pair(1, 0), {1, 2}, {0, 2}, {0, 0}})
      soup.points.push_back({2. * i + x, double(y), 0});
  soup.points.push_back({-1, 0, 0});
  soup.faces.emplace_back(soup.points.size());
  std::iota(soup.faces[0].begin(), soup.faces[0].end(), 0);
  return soup;
}

TEST_CASE("of a comb of which few choices of corners have a map one is found")
{
  CHECK(check_map(comb(160), {"--triangulate"}).report["best"]["l2"] < 10);
  CHECK(check_map(crossing_itself(comb(160)), {"--triangulate"}).report["best"]["l2"] < 11); // its base is another
}

TEST_CASE("a comb of a thousand teeth, whose map was once lost in rounding in a fan of thousands of triangles, has one")
{
  for(const Soup& polygon : {comb(1000), crossing_itself(comb(1000))})
    CHECK(check_map(polygon, {"--triangulate"}).report["best"]["energy"] < 1e9);
}

TEST_CASE("a map that did not begin as usual says how it began")
{
  const Flat_mesh tube = crumpled_tube(150, 1);
  Soup soup;
  for(const Eigen::Vector3d& p : tube.points)
    soup.points.push_back({p.x(), p.y(), p.z()});
  for(const auto& [a, b, c] : tube.triangles)
    soup.faces.push_back({a, b, c});
  CHECK(check_map(soup).report["start"] == "gradual coarsening");
  const Temporary_folder folder;
  const Finished_process usual = square_map({folder.add("in.off", off(sheet(6, 6))), "-o", folder / "map.obj"}),
                         other = square_map({folder.add("tube.off", off(soup)), "-o", folder / "map.obj"});
  CHECK(usual.err.find("began with") == std::string::npos);
  CHECK(other.err.find("this one began with another: gradual coarsening") != std::string::npos);
}
