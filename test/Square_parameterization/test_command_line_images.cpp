// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "test_command_line_closed.h"
#include "test_command_line_pictures.h"

// What is made of samples: geometry images, normal maps, and the surface that is rebuilt.

TEST_CASE("a geometry image holds the vertices at their places, the corners exactly")
{
  const Outputs outputs(small, {"--resolution", "65x41"});
  const auto image = read_png<std::uint16_t>(outputs.text("a.png"), PNG_FORMAT_LINEAR_RGB);
  REQUIRE(image.width == 65);
  REQUIRE(image.height == 41);
  CHECK(outputs.report["image"]["width"] == 65);
  CHECK(outputs.report["image"]["height"] == 41);
  const auto points = points_in_box(image, outputs.report["image"]["box"]);
  const Map map = read_obj_map(outputs.text("map.obj"));
  const Eigen::Vector3d extent =
      vector_of(outputs.report["image"]["box"]["max"]) - vector_of(outputs.report["image"]["box"]["min"]);
  double sum = 0;
  for(std::size_t v = 0; v < map.points.size(); ++v) {
    const Eigen::Vector3d vertex(map.points[v][0], map.points[v][1], map.points[v][2]);
    const double x = map.uv[v][0] * 64, y = 40 - map.uv[v][1] * 40;
    const int i = std::min(static_cast<int>(x), 63), j = std::min(static_cast<int>(y), 39);
    const double s = x - i, t = y - j;
    const auto at = [&](int di, int dj) { return points[static_cast<std::size_t>(j + dj) * 65 + i + di]; };
    const Eigen::Vector3d found =
        (1 - t) * ((1 - s) * at(0, 0) + s * at(1, 0)) + t * ((1 - s) * at(0, 1) + s * at(1, 1));
    sum += (found - vertex).squaredNorm();
    const bool is_corner = (s == 0 || s == 1) && (t == 0 || t == 1) && map.uv[v][0] * (1 - map.uv[v][0]) == 0 &&
                           map.uv[v][1] * (1 - map.uv[v][1]) == 0;
    if(is_corner)
      CHECK(((found - vertex).cwiseAbs() - extent / 65535).maxCoeff() <= 0);
  }
  const double rms = std::sqrt(sum / double(map.points.size())) / extent.norm();
  CHECK(rms == Approx(outputs.report["image"]["rms_error"].get<double>()).epsilon(1e-2));
  CHECK(rms < 0.02);
}

TEST_CASE("a floating-point image and the grid mesh hold the same points, and the error falls with the pixel")
{
  double last = 1;
  for(const char* resolution : {"17", "33", "65"}) {
    const Temporary_folder folder;
    const std::string input = folder.add("in.off", off(sheet(8, 8)));
    REQUIRE(square_map({input, "--image", folder / "a.exr", "--grid-mesh", folder / "g.off", "--resolution", resolution,
                        "--json", folder / "a.json"})
                .status == DONE);
    const Image<float> image = read_exr(read_file(folder / "a.exr"));
    const Plain_mesh mesh = read_off_mesh(read_file(folder / "g.off"));
    const int n = std::stoi(resolution);
    REQUIRE(image.width == n);
    REQUIRE(image.height == n);
    REQUIRE(mesh.points.size() == image.pixels.size());
    for(std::size_t s = 0; s < mesh.points.size(); ++s)
      for(int c = 0; c < 3; ++c)
        CHECK(image.at(static_cast<int>(s) % n, n - 1 - static_cast<int>(s) / n)[c] ==
              static_cast<float>(mesh.points[s][c]));
    CHECK(mesh.faces.size() == static_cast<std::size_t>(2 * (n - 1) * (n - 1)));
    CHECK(open_sides(mesh.faces) == static_cast<std::size_t>(4 * (n - 1)));
    const double error = nlohmann::json::parse(read_file(folder / "a.json"))["image"]["rms_error"];
    CHECK(error < 0.7 * last);
    last = error;
  }
}

TEST_CASE("the normals of a flat surface are one color")
{
  Soup flat = small;
  for(Point& p : flat.points)
    p[2] = 0;
  const Outputs outputs(flat, {"--resolution", "9"});
  for(const auto& pixel : read_png<std::uint8_t>(outputs.text("n.png"), PNG_FORMAT_RGB).pixels)
    CHECK(pixel == std::array<std::uint8_t, 3>{128, 128, 255});
  CHECK(outputs.report["image"]["hausdorff_error"] < 0.1);
}

TEST_CASE("the grid mesh of a closed surface is closed, with both sides of the seams in the image")
{
  for(const auto& [mesh, genus] : {std::make_pair(ellipsoid(3, 2), 0), std::make_pair(torus(16, 12), 1)}) {
    CAPTURE(genus);
    const Outputs outputs(soup_of(mesh), {"--resolution", "65"});
    const nlohmann::json& image = outputs.report["image"];
    CHECK(image["is_closed"] == true);
    CHECK(image["is_manifold"] == true);
    CHECK(image["genus"] == genus);
    const Plain_mesh rebuilt = read_off_mesh(outputs.text("g.off"));
    CHECK(open_sides(rebuilt.faces) == 0);
    CHECK(long(rebuilt.points.size()) - long(rebuilt.faces.size() / 2) == 2 - 2 * genus); // 3 F = 2 E
    CHECK(image["rms_error"] < 0.01);
    CHECK(image["hausdorff_error"] < 0.05);
    CHECK(image["surface_to_image"]["rms"] <= image["surface_to_image"]["hausdorff"]);
    // each point of the border of the picture is there twice, or more often
    const auto picture = read_png<std::uint16_t>(outputs.text("a.png"), PNG_FORMAT_LINEAR_RGB);
    std::map<std::array<std::uint16_t, 3>, int> met;
    for(int x = 0; x < 65; ++x)
      for(int y = 0; y < 65; ++y)
        if(x == 0 || y == 0 || x == 64 || y == 64)
          ++met[picture.at(x, y)];
    int once = 0;
    for(const auto& entry : met)
      once += entry.second == 1 ? 1 : 0;
    CHECK(once <= 4); // the ends of seams
    const Measures measures = measure(read_obj_map(outputs.text("map.obj")));
    CHECK(measures.flipped == 0);
    CHECK(outputs.report["best"]["l2"].get<double>() == Approx(double(measures.l2)).epsilon(1e-9));
    CHECK(border_fault(read_obj_map(outputs.text("map.obj")),
                       outputs.report["best"]["corners"].get<std::vector<long>>()) == "");
  }
}

TEST_CASE("a grid with too few samples for the seams is said to stay open")
{
  const Outputs outputs(soup_of(torus(16, 12)), {"--resolution", "2"});
  CHECK(outputs.report["image"]["is_closed"] == false);
  CHECK(outputs.report["image"]["seam_message"].get<std::string>().find("the border of the grid has 4") !=
        std::string::npos);
  CHECK(outputs.result.err.find("do not close at the seams") != std::string::npos);
  const Outputs larger(soup_of(torus(16, 12)), {"--resolution", "33"});
  CHECK(larger.report["image"]["seam_message"] == "");
  CHECK(larger.result.err.find("do not close") == std::string::npos);
}

TEST_CASE("the default grid has the proportions of the rectangle, also where seams share its samples")
{
  const nlohmann::json sheet_report = Outputs(small, {"--aspect", "4"}).report;
  CHECK(sheet_report["image"]["width"] == 129); // 4096 squares, as 64 by 64
  CHECK(sheet_report["image"]["height"] == 33);
  const nlohmann::json report = Outputs(soup_of(ellipsoid(3, 4)), {"--aspect", "best"}).report;
  const double aspect = report["best"]["aspect"];
  CHECK(std::abs(std::log(aspect)) > 0.1);
  const double width = report["image"]["width"], height = report["image"]["height"];
  CHECK((width - 1) / (height - 1) == Approx(aspect).epsilon(0.1)); // the last minimization changes the aspect a little
  CHECK((width - 1) * (height - 1) == Approx(64 * 64).epsilon(0.02));
  CHECK(report["image"]["is_closed"] == true);
  CHECK(Outputs(small, {"--aspect", "4", "--resolution", "33"}).report["image"]["width"] == 33);
}

TEST_CASE("the report says how many triangles the distances of the surfaces were asked at")
{
  const nlohmann::json few = Outputs(small, {"--resolution", "17"}).report;
  CHECK(few["image"]["surface_to_image"]["triangles_asked"] == few["conditioned"]["faces"]);
  CHECK(few["image"]["image_to_surface"]["triangles_asked"] == 2 * 16 * 16);
  const nlohmann::json many = Outputs(small, {"--resolution", "257"}).report;
  CHECK(many["image"]["image_to_surface"]["triangles_asked"] == (2 * 256 * 256 + 2) / 3); // every third
}

TEST_CASE("without a resolution there are four samples for each vertex")
{
  CHECK(Outputs(small).report["image"]["width"] == 65);
  const nlohmann::json image = Outputs(sheet(40, 40)).report["image"];
  CHECK(image["width"] == 129); // of 1681 vertices
  CHECK(image["height"] == 129);
}

TEST_CASE("all that is written is the same for any number of threads")
{
  const Soup soup = soup_of(ellipsoid(3, 2));
  const Outputs one(soup, {"--threads", "1"}), three(soup, {"--threads", "3"});
  for(const char* name : {"map.obj", "a.png", "n.png", "g.off", "a.svg"})
    CHECK(one.text(name) == three.text(name));
  CHECK(one.report["image"] == three.report["image"]);
}

TEST_CASE("coordinates that formats of 32 bits do not have are refused, and nothing is written")
{
  const Temporary_folder folder;
  const std::string input = folder.add("in.off", off(scaled(small, 1e300)));
  check_refusal(folder, {input, "-o", folder / "map.glb"}, BAD_COMMAND_LINE, "as large as the coordinates");
  check_refusal(folder, {input, "--image", folder / "a.exr", "--svg", folder / "a.svg"}, BAD_COMMAND_LINE,
                "as large as the coordinates");
  CHECK(square_map({input, "--image", folder / "a.png", "--grid-mesh", folder / "g.off", "--json", folder / "a.json"})
            .status == DONE);
  const nlohmann::json report = nlohmann::json::parse(read_file(folder / "a.json"));
  CHECK(report["image"]["rms_error"].is_number());
  CHECK(report["image"]["rms_error"] < 0.02);
}
