// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "test_command_line_closed.h"
#include "test_command_line_pictures.h"

// The colors of the vertices of a file, carried to the samples.

TEST_CASE("the colors of vertices are carried to the samples, in every format that has them")
{
  // red grows with u, and green with v, on a flat sheet that is its own map but for scale
  const int n = 8;
  Soup flat = sheet(n, n);
  std::ostringstream coff, coff_real, coff_of_meshlab, colored_obj, colored_ply;
  const std::string counts = std::to_string(flat.points.size()) + ' ' + std::to_string(flat.faces.size());
  coff << "COFF\n" << counts << " 0\n";
  coff_real << "CNOFF\n" << counts << " 0\n";
  coff_of_meshlab << "NCOFF\n" << counts << " 0\n";
  colored_ply << "ply\nformat ascii 1.0\nelement vertex " << flat.points.size()
              << "\nproperty uchar red\nproperty uchar green\nproperty uchar blue\nproperty double x\n"
                 "property double y\nproperty double z\nelement face "
              << flat.faces.size() << "\nproperty list uchar int vertex_indices\nend_header\n";
  for(const Point& p : flat.points) {
    const int red = static_cast<int>(20 * p[0]), green = static_cast<int>(20 * p[1]) + 10, blue = 7;
    const std::string place = number(p[0]) + ' ' + number(p[1]) + ' ' + number(p[2]), space = " ";
    coff << place << space << red << space << green << space << blue << " 255\n";
    coff_of_meshlab << place << space << red << space << green << space << blue << " 255 0 0 1\n";
    coff_real.precision(17);
    colored_obj.precision(17);
    coff_real << place << " 0 0 1 " << std::fixed << red / 255. << space << green / 255. << space << blue / 255.
              << '\n';
    colored_obj << "v " << place << space << red / 255. << space << green / 255. << space << blue / 255. << '\n';
    colored_ply << red << space << green << space << blue << space << place << '\n';
  }
  coff << counted_rows(flat.faces);
  coff_real << counted_rows(flat.faces);
  coff_of_meshlab << counted_rows(flat.faces);
  colored_ply << counted_rows(flat.faces);
  for(const Face& f : flat.faces)
    colored_obj << "f " << f[0] + 1 << ' ' << f[1] + 1 << ' ' << f[2] + 1 << '\n';
  std::string expected;
  for(const auto& [name, text] :
      {std::make_pair("a.off", coff.str()), std::make_pair("b.off", coff_real.str()),
       std::make_pair("c.off", coff_of_meshlab.str()), std::make_pair("a.obj", colored_obj.str()),
       std::make_pair("a.ply", colored_ply.str())}) {
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
