// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "test_command_line_checks.h"

#include <limits>

// What is written, in which format, and where.

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
