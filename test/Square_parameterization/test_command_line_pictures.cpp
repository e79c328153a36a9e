// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "test_command_line_checks.h"
#include "test_command_line_closed.h"

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <png.h>
#include <tiny_gltf.h>
#include <tinyexr.h>

#include <cstdlib>
#include <memory>

// Pictures, samples and textured files, read back by the libraries that own their formats.

namespace {

/// a PNG file as libpng reads it; rows from the top
template <class Channel>
struct Image
{
  int width = 0, height = 0;
  std::vector<std::array<Channel, 3>> pixels;

  const std::array<Channel, 3>& at(int x, int y) const { return pixels[static_cast<std::size_t>(y) * width + x]; }
};

template <class Channel>
Image<Channel> read_png(const std::string& bytes, png_uint_32 format)
{
  png_image image = {};
  image.version = PNG_IMAGE_VERSION;
  REQUIRE(png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()) != 0);
  image.format = format;
  Image<Channel> result{static_cast<int>(image.width), static_cast<int>(image.height), {}};
  result.pixels.resize(static_cast<std::size_t>(result.width) * result.height);
  REQUIRE(PNG_IMAGE_SIZE(image) == result.pixels.size() * sizeof(result.pixels[0]));
  REQUIRE(png_image_finish_read(&image, nullptr, result.pixels.data(), 0, nullptr) != 0);
  return result;
}

/// an EXR file as points, rows from the top
Image<float> read_exr(const std::string& bytes)
{
  float* values = nullptr;
  int width = 0, height = 0;
  const char* error = nullptr;
  REQUIRE(LoadEXRFromMemory(&values, &width, &height, reinterpret_cast<const unsigned char*>(bytes.data()),
                            bytes.size(), &error) == TINYEXR_SUCCESS);
  Image<float> image{width, height, {}};
  for(std::ptrdiff_t k = 0; k < std::ptrdiff_t(width) * height; ++k)
    image.pixels.push_back({values[4 * k], values[4 * k + 1], values[4 * k + 2]});
  std::free(values);
  return image;
}

/// what the command was asked for, all of it
struct Outputs
{
  explicit Outputs(const Soup& soup, const Arguments& options = {})
  {
    const std::string input = folder.add("in.off", off(soup));
    result = square_map(Arguments{input, "-o", folder / "map.obj", "--image", folder / "a.png", "--normal-map",
                                  folder / "n.png", "--grid-mesh", folder / "g.off", "--svg", folder / "a.svg",
                                  "--json", folder / "a.json"} +
                        options);
    INFO(result.err);
    REQUIRE(result.status == DONE);
    report = nlohmann::json::parse(read_file(folder / "a.json"));
  }

  std::string text(const std::string& name) const { return read_file(folder / name); }

  Temporary_folder folder;
  Finished_process result;
  nlohmann::json report;
};

Eigen::Vector3d vector_of(const nlohmann::json& numbers)
{
  return {numbers[0].get<double>(), numbers[1].get<double>(), numbers[2].get<double>()};
}

/// the points that a 16-bit picture stands for
std::vector<Eigen::Vector3d> points_in_box(const Image<std::uint16_t>& image, const nlohmann::json& box)
{
  const Eigen::Vector3d low = vector_of(box["min"]), high = vector_of(box["max"]);
  std::vector<Eigen::Vector3d> points;
  for(const auto& [x, y, z] : image.pixels)
    points.push_back(low + (high - low).cwiseProduct(Eigen::Vector3d(x, y, z)) / 65535);
  return points;
}

struct Plain_mesh
{
  std::vector<Point> points;
  std::vector<Face> faces;
};

Plain_mesh read_off_mesh(const std::string& text)
{
  std::istringstream stream(text);
  REQUIRE(next<std::string>(stream) == "OFF");
  Plain_mesh mesh;
  const std::size_t V = next<std::size_t>(stream), F = next<std::size_t>(stream);
  next<std::size_t>(stream);
  for(std::size_t v = 0; v < V; ++v)
    mesh.points.push_back(next_point(stream));
  Map faces;
  read_counted_faces(stream, F, faces);
  mesh.faces = faces.faces;
  return mesh;
}

/// number of sides of faces without a partner that runs the other way; every side must be there once
std::size_t open_sides(const std::vector<Face>& faces)
{
  std::set<std::pair<long, long>> sides;
  for(const Face& face : faces)
    for(std::size_t k = 0; k < face.size(); ++k)
      REQUIRE(sides.insert({face[k], face[(k + 1) % face.size()]}).second);
  std::size_t open = 0;
  for(const auto& [a, b] : sides)
    open += 1 - sides.count({b, a});
  return open;
}

} // namespace

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
  CHECK(outputs.result.err.find("do not close at the seams") != std::string::npos);
  const Outputs larger(soup_of(torus(16, 12)), {"--resolution", "33"});
  CHECK(larger.result.err.find("do not close") == std::string::npos);
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

TEST_CASE("a glTF file holds the cut surface with its texture")
{
  const Temporary_folder folder;
  const std::string input = folder.add("in.off", off(soup_of(torus(16, 12))));
  REQUIRE(square_map({input, "-o", folder / "map.obj"}).status == DONE);
  REQUIRE(square_map({input, "-o", folder / "map.glb"}).status == DONE);
  const Map map = read_obj_map(read_file(folder / "map.obj"));
  tinygltf::Model model;
  std::string error, warning;
  REQUIRE(tinygltf::TinyGLTF().LoadBinaryFromFile(&model, &error, &warning, folder / "map.glb"));
  CHECK(error == "");
  CHECK(warning == "");
  REQUIRE(model.meshes.size() == 1);
  const tinygltf::Primitive& primitive = model.meshes[0].primitives.at(0);
  const auto numbers = [&](const char* name, std::size_t k) {
    const tinygltf::Accessor& accessor = model.accessors[primitive.attributes.at(name)];
    REQUIRE(accessor.count == map.points.size());
    return reinterpret_cast<const float*>(model.buffers[0].data.data() +
                                          model.bufferViews[accessor.bufferView].byteOffset) +
           k;
  };
  const std::vector<double>& center = model.nodes.at(0).translation;
  for(std::size_t v = 0; v < map.points.size(); ++v) {
    for(std::size_t c = 0; c < 3; ++c)
      CHECK(*numbers("POSITION", 3 * v + c) + center[c] == Approx(map.points[v][c]).margin(1e-6));
    CHECK(*numbers("TEXCOORD_0", 2 * v) == static_cast<float>(map.uv[v][0]));
    CHECK(*numbers("TEXCOORD_0", 2 * v + 1) == static_cast<float>(1 - map.uv[v][1]));
  }
  const tinygltf::Accessor& indices = model.accessors[primitive.indices];
  REQUIRE(indices.count == 3 * map.faces.size());
  const auto* index = reinterpret_cast<const std::uint32_t*>(model.buffers[0].data.data() +
                                                             model.bufferViews[indices.bufferView].byteOffset);
  for(Face face : map.faces) { // they may begin at another corner
    Face found{index[0], index[1], index[2]};
    index += 3;
    std::rotate(found.begin(), std::min_element(found.begin(), found.end()), found.end());
    std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
    CHECK(found == face);
  }
  CHECK(model.images.at(0).width == 1024);
  CHECK(model.images[0].height == 1024);
}

TEST_CASE("an OBJ file with a texture names its material and picture, which lie beside it")
{
  const Temporary_folder folder;
  const std::string input = folder.add("in.off", off(small));
  REQUIRE(square_map({input, "-o", folder / "map.obj", "--texture", "checker"}).status == DONE);
  CHECK(folder.file_names() == std::set<std::string>{"in.off", "map.mtl", "map.obj", "map.png"});
  const std::string text = read_file(folder / "map.obj"), head = "mtllib map.mtl\nusemtl square\n";
  REQUIRE(text.rfind(head, 0) == 0);
  CHECK(read_obj_map(text.substr(head.size())).uv.size() == small.points.size());
  CHECK(read_file(folder / "map.mtl").find("newmtl square\n") == 0);
  CHECK(read_file(folder / "map.mtl").find("\nmap_Kd map.png\n") != std::string::npos);
  const auto picture = read_png<std::uint8_t>(read_file(folder / "map.png"), PNG_FORMAT_RGB);
  CHECK(picture.at(0, 0) != picture.at(32, 0));
  CHECK(picture.at(0, 0) == picture.at(32, 32));

  // a picture of one's own is copied, and stays where it is beside the map already
  const std::string own = read_file(folder / "map.png");
  const Temporary_folder other;
  REQUIRE(square_map({input, "-o", other / "x.obj", "--texture", folder / "map.png"}).status == DONE);
  CHECK(read_file(other / "x.png") == own);
  REQUIRE(square_map({input, "-o", folder / "map.obj", "--texture", folder / "map.png"}).status == DONE);
  CHECK(read_file(folder / "map.png") == own);
  CHECK(folder.file_names() == std::set<std::string>{"in.off", "map.mtl", "map.obj", "map.png"});
}

TEST_CASE("an SVG picture shows every face, the corners, the seams and the curve")
{
  const auto parse = [](const std::string& text) {
    std::istringstream stream(text);
    boost::property_tree::ptree tree;
    boost::property_tree::read_xml(stream, tree); // throws for what is not well-formed
    CHECK(tree.get<std::string>("svg.<xmlattr>.width") == "800");
  };
  const auto count = [](const std::string& text, const std::string& piece) {
    std::size_t n = 0;
    for(std::size_t k = text.find(piece); k != std::string::npos; k = text.find(piece, k + 1))
      ++n;
    return n;
  };
  const Outputs outputs(soup_of(ellipsoid(2)));
  const std::string svg = outputs.text("a.svg");
  parse(svg);
  CHECK(count(svg, "z") >= 128); // one closed path for each face
  for(const auto& corner : outputs.report["best"]["input_corners"])
    CHECK(svg.find('>' + std::to_string(corner.get<int>()) + '<') != std::string::npos);
  CHECK(svg.find(">A<") != std::string::npos);
  CHECK(svg.find("balanced energy") != std::string::npos);

  // a large surface is a picture in the picture
  const Temporary_folder folder;
  const std::string input = folder.add("in.off", off(sheet(110, 110)));
  REQUIRE(square_map({input, "--strategy", "none", "--svg", folder / "a.svg", "--minimizer", "iterative"}).status ==
          DONE);
  const std::string large = read_file(folder / "a.svg");
  parse(large);
  CHECK(large.find("data:image/png;base64,") != std::string::npos);
  CHECK(large.size() < 5000000);
}

TEST_CASE("the colors of vertices are carried to the samples, in every format that has them")
{
  // red grows with u, and green with v, on a flat sheet that is its own map but for scale
  const int n = 8;
  Soup flat = sheet(n, n);
  std::ostringstream coff, coff_real, colored_obj, colored_ply;
  const std::string counts = std::to_string(flat.points.size()) + ' ' + std::to_string(flat.faces.size());
  coff << "COFF\n" << counts << " 0\n";
  coff_real << "CNOFF\n" << counts << " 0\n";
  colored_ply << "ply\nformat ascii 1.0\nelement vertex " << flat.points.size()
              << "\nproperty uchar red\nproperty uchar green\nproperty uchar blue\nproperty double x\n"
                 "property double y\nproperty double z\nelement face "
              << flat.faces.size() << "\nproperty list uchar int vertex_indices\nend_header\n";
  for(const Point& p : flat.points) {
    const int red = static_cast<int>(20 * p[0]), green = static_cast<int>(20 * p[1]) + 10, blue = 7;
    const std::string place = number(p[0]) + ' ' + number(p[1]) + ' ' + number(p[2]), space = " ";
    coff << place << space << red << space << green << space << blue << " 255\n";
    coff_real.precision(17);
    colored_obj.precision(17);
    coff_real << place << " 0 0 1 " << std::fixed << red / 255. << space << green / 255. << space << blue / 255.
              << '\n';
    colored_obj << "v " << place << space << red / 255. << space << green / 255. << space << blue / 255. << '\n';
    colored_ply << red << space << green << space << blue << space << place << '\n';
  }
  coff << counted_rows(flat.faces);
  coff_real << counted_rows(flat.faces);
  colored_ply << counted_rows(flat.faces);
  for(const Face& f : flat.faces)
    colored_obj << "f " << f[0] + 1 << ' ' << f[1] + 1 << ' ' << f[2] + 1 << '\n';
  std::string expected;
  for(const auto& [name, text] :
      {std::make_pair("a.off", coff.str()), std::make_pair("b.off", coff_real.str()),
       std::make_pair("a.obj", colored_obj.str()), std::make_pair("a.ply", colored_ply.str())}) {
    INFO(name);
    const Temporary_folder folder;
    const std::string input = folder.add(name, text);
    const Finished_process result =
        square_map({input, "--attributes", folder / "c.png", "--image", folder / "p.exr", "--resolution", "33"});
    INFO(result.err);
    REQUIRE(result.status == DONE);
    const auto colors = read_png<std::uint8_t>(read_file(folder / "c.png"), PNG_FORMAT_RGB);
    const Image<float> points = read_exr(read_file(folder / "p.exr"));
    for(std::size_t s = 0; s < colors.pixels.size(); ++s) { // linear but for the whole numbers of the vertices
      CHECK(std::abs(colors.pixels[s][0] - 20 * points.pixels[s][0]) < 2);
      CHECK(std::abs(colors.pixels[s][1] - (20 * points.pixels[s][1] + 10)) < 2);
      CHECK(int(colors.pixels[s][2]) == 7);
    }
    if(expected.empty())
      expected = read_file(folder / "c.png");
    CHECK(read_file(folder / "c.png") == expected);
  }
  // vertices that a cut copies and a chord adds have colors, too
  const Closed_mesh closed = tetrahedron();
  std::string text = "COFF\n4 4 6\n";
  for(std::size_t v = 0; v < 4; ++v)
    text += number(closed.points[v].x()) + ' ' + number(closed.points[v].y()) + ' ' + number(closed.points[v].z()) +
            " 100 100 " + std::to_string(50 * v) + '\n';
  const Temporary_folder folder;
  const std::string input = folder.add("in.off", text + counted_rows(soup_of(closed).faces));
  REQUIRE(square_map({input, "--attributes", folder / "c.png"}).status == DONE);
  for(const auto& pixel : read_png<std::uint8_t>(read_file(folder / "c.png"), PNG_FORMAT_RGB).pixels) {
    CHECK(int(pixel[0]) == 100);
    CHECK(int(pixel[2]) <= 150);
  }
  const std::string colorless = folder.add("colorless.off", off(small));
  check_refusal(folder, {colorless, "--attributes", folder / "d.png"}, BAD_FILE, "has no colors of its vertices");
  const std::string incomplete =
      folder.add("incomplete.off", "COFF\n3 1 3\n0 0 0 1 1\n1 0 0 1 1 1\n0 1 0 1 1 1\n3 0 1 2\n");
  check_refusal(folder, {incomplete, "--attributes", folder / "d.png"}, BAD_FILE,
                "line 3: a component of a color was expected");
}

TEST_CASE("values of pictures that make no sense are refused, and nothing is written")
{
  const Temporary_folder folder;
  const std::string input = folder.add("in.off", off(small)), text = folder.add("text.png", "no picture");
  REQUIRE(square_map({input, "-o", folder / "good.obj", "--texture", "checker"}).status == DONE);
  const std::string cut_off = folder.add("half.png", read_file(folder / "good.png").substr(0, 2000));
  const std::string image = folder / "a.png", map = folder / "map.obj";
  for(const char* resolution : {"1", "0", "0x5", "5x0", "-3", "x", "5x", "x5", "5x5x5", "", "2.5", "5 x 5", "5X5",
                                "16386", "99999999999", "1e3"})
    check_refusal(folder, {input, "--image", image, "--resolution", resolution}, BAD_COMMAND_LINE, "--resolution is");
  const std::vector<std::pair<Arguments, std::string>> bad{
      {{"-o", map, "--resolution", "9"}, "--resolution goes with --image"},
      {{"--svg", folder / "a.svg", "--texture", "checker"}, "--texture goes with an output .glb or .obj"},
      {{"-o", folder / "map.ply", "--texture", "checker"}, "--texture goes with an output .glb or .obj"},
      {{"--image", folder / "a.jpg"}, "must end in .png or .exr"},
      {{"--image", folder / "png"}, "must end in .png or .exr"},
      {{"--image", "-"}, "must end in .png or .exr"},
      {{"--normal-map", folder / "a.exr"}, "must end in .png"},
      {{"--grid-mesh", folder / "a.glb"}, "must end in .obj, .off, .ply or .stl"},
      {{"-o", folder / "a.gltf"}, "must end in .obj, .off, .ply, .stl or .glb"},
      {{"--image", image, "--normal-map", image}, "are the same file"},
      {{"-o", folder / "a.obj", "--texture", "checker", "--image", image}, "are the same file"},
      {{"-o", folder / "a.obj", "--texture", "checker", "--json", folder / "a.mtl"}, "are the same file"},
      {{"--svg", input}, "are the same file"},
      {{"--svg", ""}, "--svg needs the name of a file"}};
  for(const auto& [options, words] : bad)
    check_refusal(folder, Arguments{input} + options, BAD_COMMAND_LINE, words);
  for(const std::string& texture : {text, cut_off, folder / "missing.png", folder / "."})
    for(const std::string& output : {map, folder / "map.glb"})
      check_refusal(folder, {input, "-o", output, "--texture", texture}, BAD_FILE, "cannot read the texture");
}

TEST_CASE("coordinates that formats of 32 bits do not have are refused, and nothing is written")
{
  Soup huge = small;
  for(Point& p : huge.points)
    for(double& x : p)
      x *= 1e300;
  const Temporary_folder folder;
  const std::string input = folder.add("in.off", off(huge));
  check_refusal(folder, {input, "-o", folder / "map.glb"}, BAD_COMMAND_LINE, "as large as the coordinates");
  check_refusal(folder, {input, "--image", folder / "a.exr", "--svg", folder / "a.svg"}, BAD_COMMAND_LINE,
                "as large as the coordinates");
  CHECK(square_map({input, "--image", folder / "a.png", "--grid-mesh", folder / "g.off", "--json", folder / "a.json"})
            .status == DONE);
  const nlohmann::json report = nlohmann::json::parse(read_file(folder / "a.json"));
  CHECK(report["image"]["rms_error"].is_number());
  CHECK(report["image"]["rms_error"] < 0.02);
}

TEST_CASE("a thumbnail shows the surface in a checkerboard, in white surroundings")
{
  const Temporary_folder folder;
  for(const Soup& soup : {sheet(8, 8), soup_of(ellipsoid(3))}) {
    const Finished_process result =
        square_map({folder.add("in.off", off(soup)), "--quiet", "--thumbnail", folder / "t.png"});
    INFO(result.err);
    REQUIRE(result.status == DONE);
    const auto image = read_png<std::uint8_t>(read_file(folder / "t.png"), PNG_FORMAT_RGB);
    CHECK(image.width == 160);
    CHECK(image.height == 160);
    std::size_t white = 0, light = 0, dark = 0;
    for(const auto& pixel : image.pixels) {
      const bool is_blue = pixel[2] > pixel[0] + 20;
      ++(pixel == std::array<std::uint8_t, 3>{255, 255, 255} ? white : is_blue ? dark : light);
    }
    // both colors of the board are there alike, and the surface fills the picture in one direction
    CHECK(white > image.pixels.size() / 20);
    CHECK(light > image.pixels.size() / 10);
    CHECK(dark > image.pixels.size() / 10);
    CHECK(double(light) / double(dark) == Approx(1).margin(0.5));
  }
}
