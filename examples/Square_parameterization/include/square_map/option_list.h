// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_OPTION_LIST_H
#define SQUARE_MAP_OPTION_LIST_H

#include "Resolution.h"
#include "candidate_slice.h"
#include "number_options.h"
#include "option_values.h"
#include "read_surface.h"

#include <CGAL_ext/Square_parameterization/internal/soup/condition_soup.h>

#include <boost/program_options.hpp>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace square_map {

/// what the user asked for
struct Command_line
{
  bool wants_help = false, wants_version = false;
  std::string help;
  std::string input, input_format, output, json, seams, texture, svg, page, thumbnail, image, normal_map, attributes,
      grid_mesh;
  std::optional<CGAL_ext::Grid_size> resolution; // none: the default, which the surface tells
  std::string strategy, minimizer = "optimal";
  std::optional<std::array<std::size_t, 4>> corners; // vertices of the file
  std::optional<Candidate_slice> candidates;         // none: all that the strategy asks for
  std::vector<std::string> curves;                   // reports of slices
  bool is_quiet = false;
  CGAL_ext::Square_map_options<Mesh> options;
  CGAL_ext::internal::Conditioning_options conditioning_options;
};

/// the options as they are given: names and numbers that are still to be checked
struct Given_options
{
  std::string weights, corner_rule, walk, preset, corners, border, cut, component, resolution, candidates;
  std::string aspect;
  bool keeps_quarters = false;
  boost::program_options::variables_map all;

  /// indicates whether the user gave the option; a switch has a value in any case
  bool has(const char* option) const { return all.count(option) != 0 && !all[option].defaulted(); }

  /// the number that the user gave, or a usage error. \pre it was given
  double number(const char* option) const { return parse_number_option(option, all[option].as<std::string>()); }

  /// the same of an option that takes whole numbers; 0 when it was not given
  int whole_number(const char* option) const { return has(option) ? static_cast<int>(number(option)) : 0; }
};

/// the options; what is given goes to \p given, or straight to \p line
inline boost::program_options::options_description option_list(Given_options& given, Command_line& line)
{
  namespace po = boost::program_options;
  po::options_description options("options");
  auto add = options.add_options();
  const auto text = [] { return po::value<std::string>(); }; // a number, see `Given_options::number()`
  add("help,h", "show this text");
  add("version", "show the versions of this program and of CGAL");
  add("output,o", po::value(&line.output)->value_name("FILE"),
      "the map: .obj, .off or .ply by extension; .glb for the textured surface; .stl for the surface that is mapped, "
      "without its map");
  add("texture", po::value(&line.texture)->value_name("checker|FILE"),
      "for .glb, and for .obj with a .mtl and a .png file beside it: a checkerboard (default of .glb), or a PNG file");
  add("image", po::value(&line.image)->value_name("FILE"),
      "the geometry image: .png, 16 bits in the bounding box, or .exr, 32-bit floating-point");
  add("normal-map", po::value(&line.normal_map)->value_name("FILE"), "the normals of the samples: .png");
  add("attributes", po::value(&line.attributes)->value_name("FILE"),
      "the colors of the vertices of the file at the samples: .png");
  add("grid-mesh", po::value(&line.grid_mesh)->value_name("FILE"),
      "the surface rebuilt from the samples: .obj, .off, .ply or .stl");
  add("resolution", po::value(&given.resolution)->value_name("N|WxH"),
      "samples of the image, the normal map, the attributes and the grid mesh; by default four a vertex");
  add("svg", po::value(&line.svg)->value_name("FILE"),
      "picture of the map: faces in the colors of their stretch, corners, seams and the curve of the candidates");
  add("report", po::value(&line.page)->value_name("FILE"),
      "a page that shows the map beside the surface, in any browser: .html; the first candidate is mapped once more");
  add("thumbnail", po::value(&line.thumbnail)->value_name("FILE"),
      "a small picture of the surface in a checkerboard of its map: .png");
  add("input-format", po::value(&line.input_format)->value_name("NAME"),
      "off, obj, ply or stl; by default the extension of INPUT tells, or the content of a pipe");
  add("strategy", po::value(&line.strategy)->value_name("NAME"),
      "how corners are searched: bracketing (default for optimal), hybrid (default for iterative), brute-force, "
      "quarter-brute-force, particle-swarm, step-sampling, single-highest, many-high, better-of-two, none");
  add("candidates", po::value(&given.candidates)->value_name("FIRST:LAST"),
      "brute-force, quarter-brute-force: map these candidates alone, FIRST and LAST among them, counted from 0; no "
      "corner moves on its own. Where none has a map, a report alone is written all the same");
  add("curve", po::value(&line.curves)->value_name("FILE"),
      "brute-force, quarter-brute-force: a report of such a slice; may be given several times, until all candidates "
      "are "
      "known: the best is mapped, with the outputs of a search of all");
  add("minimizer", po::value(&line.minimizer)->value_name("NAME"),
      "optimal (default): least balanced energy; iterative: Yoshizawa et al.");
  add("balance", text()->value_name("X"),
      "optimal: 0 (least L2 stretch, tears) to 1 (symmetric Dirichlet); default 0.3");
  add("aspect", po::value(&given.aspect)->value_name("R"),
      "optimal: width over height of the rectangle, or best; default 1, the square. uv stay in [0, 1]");
  add("quarter-corners", po::bool_switch(&given.keeps_quarters),
      "optimal: leave the corners where the quarters of the border put them, as they are in a slice anyway; without it "
      "they move on their own");
  add("border", po::value(&given.border)->value_name("NAME"),
      "optimal: fixed or sliding (default); the border of iterative is fixed");
  add("component", po::value(&given.component)->value_name("K"),
      "map one connected component: largest, or a number; 0 has most faces, ties go to the first face");
  add("triangulate", po::bool_switch(&line.conditioning_options.triangulate), "split faces that are no triangles");
  add("cut", po::value(&given.cut)->value_name("NAME"),
      "how a surface that is not a disk is cut: best (default): for little stretch; shortest; none: it is refused");
  add("cut-weight", text()->value_name("X"),
      "best: stretch that a cut of the length sqrt(area) must save; default 0.05");
  add("max-cut-length", text()->value_name("X"),
      "best: length, in units of sqrt(area), beyond which a cut is not extended");
  add("cut-disk", po::bool_switch(&line.options.cut.cuts_disk),
      "best: cut a disk, too, where L2 falls by more than --cut-weight times the length of the cut");
  add("seams", po::value(&line.seams)->value_name("FILE"),
      "edges to cut along, two vertex numbers a line, counted from 0; what they lack is added");
  add("weights", po::value(&given.weights)->value_name("NAME"),
      "of the iteration, which is the start of optimal: blended (default), shape-preserving, shape-preserving-plain, "
      "mean-value, symmetric-mean-value, uniform, clamped-cotangent, harmonic");
  add("corner-rule", po::value(&given.corner_rule)->value_name("NAME"), "where sides end: nearest (default), author");
  add("walk", po::value(&given.walk)->value_name("NAME"),
      "direction in which candidates are counted: counter-clockwise (default), clockwise");
  add("preset", po::value(&given.preset)->value_name("NAME"), "paper: the settings of the published tables");
  add("step", text()->value_name("N"), "step-sampling: distance between samples; 0 (default): sqrt(V m / F)");
  add("interval", text()->value_name("N"), "hybrid: stride; 0 (default): the step less one");
  add("seed", text()->value_name("N"), "particle-swarm: seed; default 0");
  add("eta", text()->value_name("X"), "exponent of the stretch, in ]0, 1]; default 0.3");
  add("patience", text()->value_name("N"), "iterates that may fail to be lower; default 1");
  add("threads", text()->value_name("N"), "threads; 0 (default) for all cores, fewer on large surfaces");
  add("time-limit", text()->value_name("SECONDS"),
      "then no cut and no candidate is begun any more, and a map in work is left: the best map so far, or exit status "
      "5 when there is none");
  add("corners", po::value(&given.corners)->value_name("a,b,c,d"),
      "four border vertices, counter-clockwise, counted from 0: no search; one that is cut stands for its copies");
  add("json", po::value(&line.json)->value_name("FILE"), "report; - for standard output");
  add("quiet,q", po::bool_switch(&line.is_quiet), "no progress on the terminal");
  return options;
}

} // namespace square_map

#endif // SQUARE_MAP_OPTION_LIST_H
