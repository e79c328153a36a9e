// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "test_command_line_pictures.h"
#include "test_command_line_closed.h"

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <tiny_gltf.h>

#include <memory>

// Textured files and pictures of the map, and what is refused of all pictures.

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

TEST_CASE("an SVG picture shows the rectangle of the map")
{
  const auto sizes_of = [](const std::string& text, const std::string& element) {
    const std::size_t begin = text.find(element);
    REQUIRE(begin != std::string::npos);
    const auto number_at = [&](const std::string& name) {
      return std::stod(text.substr(text.find(' ' + name + "='", begin) + name.size() + 3));
    };
    return std::array<double, 2>{number_at("width"), number_at("height")};
  };
  for(double aspect : {1., 2.5, 0.4}) {
    const auto [width, height] =
        sizes_of(Outputs(small, {"--aspect", number(aspect)}).text("a.svg"), "<rect fill='none'");
    CHECK(width / height == Approx(aspect).epsilon(1e-4));
    CHECK(std::max(width, height) == 540);
  }
  const Temporary_folder folder;
  const std::string input = folder.add("in.off", off(sheet(110, 110))); // so many faces are a picture
  REQUIRE(square_map({input, "--aspect", "3", "--strategy", "none", "--svg", folder / "a.svg"}).status == DONE);
  const auto [width, height] = sizes_of(read_file(folder / "a.svg"), "<image ");
  CHECK(width / height == Approx(3).epsilon(1e-4));
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
