// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Draws the figures of the manual, from maps that it makes:
//
//     draw_figures FOLDER_OF_MESHES FOLDER_OF_FIGURES
//
// and prints the numbers that their captions name.

#include "draw_curve.h"
#include "draw_map.h"

#include <CGAL_ext/Square_parameterization/Hybrid_corner_search.h>
#include <CGAL_ext/Square_parameterization/Step_sampling_corner_search.h>
#include <CGAL_ext/Square_parameterization/circle_corner_searches.h>
#include <CGAL_ext/Square_parameterization/internal/sampling/locate_samples.h>

#include <cstdio>
#include <exception>
#include <fstream>
#include <numeric>
#include <string>
#include <vector>

namespace {

using namespace figures;

const char* const SADDLE = "poly2x^2+y^2-0.062500.off";

struct Folders
{
  std::string meshes, figures;

  Mesh mesh(const std::string& name) const { return read(meshes + '/' + name); }

  void write(const std::string& name, const std::string& bytes) const
  {
    std::ofstream file(figures + '/' + name, std::ios::binary);
    if(!(file << bytes).flush())
      throw std::runtime_error("cannot write " + figures + '/' + name);
  }

  void write(const std::string& name, const std::vector<Picture>& pictures) const
  {
    write(name, png_file(side_by_side(pictures)));
  }
};

/// all candidates of the quarter
Map map_all_candidates(const Mesh& mesh, Options options = {})
{
  options.search = CGAL_ext::Quarter_brute_force_corner_search();
  return make_map(mesh, options);
}

Map map_candidate(const Mesh& mesh, int candidate)
{
  Options options;
  options.search = Only_candidate{candidate};
  return make_map(mesh, options);
}

/// the worst and the best choice of corners: the reason why they are searched
void draw_corners(const Folders& folders)
{
  const Mesh mesh = folders.mesh(SADDLE);
  const Map best = map_all_candidates(mesh);
  const auto& curve = best.result.search.curve;
  const auto worst_sample = std::max_element(curve.begin(), curve.end(),
                                             [](const auto& a, const auto& b) { return a.objective < b.objective; });
  const Map worst = map_candidate(mesh, worst_sample->candidate);
  Style style;
  style.front = {0.4, -0.6, 1.3};
  style.up = {0, 0, 1};
  folders.write("corners.png", {draw_surface(worst, style), draw_surface(best, style)});
  std::printf("corners: L2 %.3f and %.3f\n", worst.result.measures.l2, best.result.measures.l2);
}

/// where the sides of the square end, with few border vertices
void draw_corner_rules(const Folders& folders)
{
  std::vector<Picture> pictures;
  Style style;
  style.has_edges = true;
  style.has_checkerboard = false;
  style.size = 230;
  for(const auto rule : {CGAL_ext::Corner_rule::NEAREST, CGAL_ext::Corner_rule::AUTHOR}) {
    Options options;
    options.search = CGAL_ext::First_candidate_corner_search();
    options.search_options.corner_rule = rule;
    CGAL_ext::Balanced_minimization balanced;
    balanced.border = CGAL_ext::Border_motion::FIXED;
    options.minimization = balanced;
    const Map map = make_map(folders.mesh("nefertiti.off"), options);
    pictures.push_back(draw_surface(map, style));
    pictures.push_back(draw_square(map, style));
    std::printf("corner rules: L2 %.4f\n", map.result.measures.l2);
  }
  folders.write("corner_rules.png", pictures);
}

void draw_border_motion(const Folders& folders)
{
  std::vector<Picture> pictures;
  Style style;
  style.has_edges = true;
  style.has_checkerboard = false;
  for(const auto motion : {CGAL_ext::Border_motion::FIXED, CGAL_ext::Border_motion::SLIDING}) {
    Options options;
    CGAL_ext::Balanced_minimization balanced;
    balanced.border = motion;
    options.minimization = balanced;
    const Map map = make_map(folders.mesh("nefertiti.off"), options);
    pictures.push_back(draw_square(map, style));
    std::printf("border: L2 %.4f\n", map.result.measures.l2);
  }
  folders.write("border_motion.png", pictures);
}

void draw_balances(const Folders& folders)
{
  std::vector<Picture> pictures;
  Style style;
  style.has_edges = true;
  style.has_checkerboard = style.has_corners = false;
  for(const double balance : {0., 0.3, 1.}) {
    Options options;
    CGAL_ext::Balanced_minimization balanced;
    balanced.balance = balance;
    options.minimization = balanced;
    const Map map = make_map(folders.mesh("lion-head.off"), options);
    pictures.push_back(draw_square(map, style));
    std::printf("balance %g: L2 %.3f, Linf %.1f\n", balance, map.result.measures.l2, map.result.measures.linf);
  }
  folders.write("balances.png", pictures);
}

/// a corner of the surface that a chord cuts off, before and after the chord is split
void draw_chord(const Folders& folders)
{
  Mesh mesh;
  std::vector<Mesh::Vertex_index> v;
  for(int j = 0; j <= 3; ++j)
    for(int i = 0; i <= 3; ++i)
      v.push_back(mesh.add_vertex(Kernel::Point_3(i, j, 0)));
  for(int j = 0; j < 3; ++j)
    for(int i = 0; i < 3; ++i) {
      const auto a = v[4 * j + i], b = v[4 * j + i + 1], c = v[4 * j + i + 5], d = v[4 * j + i + 4];
      // only the diagonal of the first cell joins two border vertices that are not neighbors along the border
      const bool falls = (i == 0 && j == 0) || (i == 0 && j == 2) || (i == 2 && j == 0);
      mesh.add_face(a, b, falls ? d : c);
      falls ? mesh.add_face(b, c, d) : mesh.add_face(a, c, d);
    }
  Style style;
  style.has_edges = true;
  style.has_checkerboard = style.has_corners = false;
  style.size = 240;
  const Map after = make_map(mesh);
  Map before = after;
  auto [arrays, vertices] = CGAL_ext::internal::read_faces(mesh, mesh.faces(), mesh.points());
  before.points = std::move(arrays.points);
  before.triangles = std::move(arrays.triangles);
  before.uv.setZero(static_cast<Eigen::Index>(before.points.size()), 2);
  before.normals.assign(before.points.size(), Eigen::Vector3d::UnitZ());
  before.border = border_edges(before.triangles);
  folders.write("chord.png", {draw_surface(before, style), draw_surface(after, style)});
  std::printf("chords: %zu split\n", after.result.chords_split);
}

Style hand_style()
{
  Style style;
  style.front = {0.3, -1, 0.2};
  style.up = {0, 0, 1};
  return style;
}

void draw_cut(const Folders& folders)
{
  const Map map = make_map(folders.mesh("hand.off"));
  const Style style = hand_style();
  Style edges;
  edges.has_edges = true;
  edges.has_checkerboard = false;
  folders.write("cut.png", {draw_surface(map, style), draw_square(map, edges)});
  std::printf("cut: length %.3f, L2 %.3f\n", map.result.cut.cut_length, map.result.measures.l2);
}

/// samples as a picture, and the surface rebuilt from them
void draw_geometry_image(const Folders& folders)
{
  constexpr int SAMPLES = 65;
  Options options;
  options.seam_grid = CGAL_ext::Grid_size{SAMPLES, SAMPLES};
  const Map map = make_map(folders.mesh("hand.off"), options);
  Map rebuilt;
  rebuilt.uv.resize(SAMPLES * SAMPLES, 2);
  Eigen::AlignedBox3d box;
  for(const auto& [f, weights] : CGAL_ext::internal::locate_samples(map.triangles, map.uv, *options.seam_grid)) {
    const int s = static_cast<int>(rebuilt.points.size()), i = s % SAMPLES, j = s / SAMPLES;
    rebuilt.points.push_back(CGAL_ext::internal::interpolated(map.points, map.triangles[f], weights));
    box.extend(rebuilt.points.back());
    rebuilt.uv.row(s) << i / (SAMPLES - 1.), j / (SAMPLES - 1.);
    if(i > 0 && j > 0) {
      rebuilt.triangles.push_back({s - SAMPLES - 1, s - SAMPLES, s});
      rebuilt.triangles.push_back({s - SAMPLES - 1, s, s - 1});
    }
  }
  std::vector<int> itself(rebuilt.points.size());
  std::iota(itself.begin(), itself.end(), 0);
  rebuilt.normals = CGAL_ext::internal::vertex_normals(rebuilt.points, rebuilt.triangles, itself);
  Style style = hand_style();
  Picture image{style.size, style.size, {}};
  for(int y = 0; y < style.size; ++y)
    for(int x = 0; x < style.size; ++x) {
      const int i = x * SAMPLES / style.size, j = (style.size - 1 - y) * SAMPLES / style.size;
      const Eigen::Vector3d share =
          (rebuilt.points[static_cast<std::size_t>(j * SAMPLES + i)] - box.min()).cwiseQuotient(box.sizes());
      Color color{};
      for(int c = 0; c < 3; ++c)
        color[c] = static_cast<std::uint8_t>(std::lround(255 * share[c]));
      image.pixels.push_back(color);
    }
  style.has_corners = style.has_checkerboard = false;
  style.has_edges = true;
  folders.write("geometry_image.png", {image, draw_surface(rebuilt, style)});
  std::printf("geometry image: %zu pairs of samples along the seams\n", map.result.seam_samples.size());
}

/// the curve of the objective, and where strategies look at it
void draw_strategies(const Folders& folders)
{
  const Mesh mesh = folders.mesh(SADDLE);
  Options options;
  options.minimization = CGAL_ext::Stretch_minimization();
  const CGAL_ext::Search_report all = map_all_candidates(mesh, options).result.search;
  std::vector<Strategy_samples> strategies;
  for(const auto& [name, search] : std::vector<std::pair<std::string, CGAL_ext::Corner_search>>{
          {"bracketing", CGAL_ext::Bracketing_corner_search()},
          {"hybrid", CGAL_ext::Hybrid_corner_search()},
          {"step sampling", CGAL_ext::Step_sampling_corner_search()},
          {"better of two", CGAL_ext::Better_of_two_corner_search()}}) {
    options.search = search;
    strategies.push_back({name, make_map(mesh, options).result.search});
    std::printf("%s: %zu of %d candidates, best %d\n", name.c_str(), strategies.back().report.evaluations,
                all.candidates, *strategies.back().report.best_candidate);
  }
  folders.write("strategies.svg", curve_svg(all, strategies));
}

} // namespace

int main(int argc, char** argv)
{
  if(argc != 3) {
    std::fprintf(stderr, "usage: draw_figures FOLDER_OF_MESHES FOLDER_OF_FIGURES\n");
    return EXIT_FAILURE;
  }
  try {
    const Folders folders{argv[1], argv[2]};
    draw_corners(folders);
    draw_corner_rules(folders);
    draw_border_motion(folders);
    draw_balances(folders);
    draw_chord(folders);
    draw_cut(folders);
    draw_geometry_image(folders);
    draw_strategies(folders);
  } catch(const std::exception& error) {
    std::fprintf(stderr, "draw_figures: %s\n", error.what());
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
