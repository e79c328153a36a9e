// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "test_command_line_checks.h"

#include <limits>

// Maps of all kinds of surfaces, by all methods.

TEST_CASE("strategies differ in the candidates they map")
{
  const std::vector<long> border = border_of(small.faces);
  const std::string minimizer = GENERATE("iterative", "optimal");
  const auto search = [&](const std::string& strategy) {
    std::vector<std::string> options{"--minimizer", minimizer, "--strategy", strategy};
    if(minimizer == "optimal" && strategy != "none") // corners that move afterwards end where they like
      options.push_back("--quarter-corners");
    return check_map(small, options);
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
      const std::size_t faces = mapped.report["conditioned"]["degenerate_faces"];
      const std::string words = faces == 1 ? " face without area was mapped" : " faces without area were mapped";
      CHECK(mapped.messages.find(std::to_string(faces) + words) != std::string::npos);
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
