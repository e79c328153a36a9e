// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_COMMAND_LINE_H
#define SQUARE_MAP_COMMAND_LINE_H

#include <CGAL_ext/Square_parameterization/Bracketing_corner_search.h>
#include <CGAL_ext/Square_parameterization/Hybrid_corner_search.h>
#include <CGAL_ext/Square_parameterization/Particle_swarm_corner_search.h>
#include <CGAL_ext/Square_parameterization/Step_sampling_corner_search.h>
#include <CGAL_ext/Square_parameterization/circle_corner_searches.h>
#include <CGAL_ext/Square_parameterization/parameterize_onto_square.h>

#include "write_map.h"

#include <boost/program_options.hpp>

#include <algorithm>
#include <array>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace square_map {

/// a command line that makes no sense
struct Usage_error : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// what the user asked for
struct Command_line
{
  bool wants_help = false;
  std::string help;
  std::string input, output, json, seams;
  std::string strategy, minimizer = "optimal";
  std::optional<std::array<std::size_t, 4>> corners; // vertices of the file
  bool is_quiet = false;
  CGAL_ext::Square_map_options options;
  CGAL_ext::internal::Conditioning_options conditioning_options;
};

/// the value that a name stands for, or a usage error that lists the names
template <class Value>
const Value& named(const std::map<std::string, Value>& values, const std::string& option, const std::string& name)
{
  const auto found = values.find(name);
  if(found != values.end())
    return found->second;
  std::string names;
  for(const auto& value : values)
    names += (names.empty() ? "" : ", ") + value.first;
  throw Usage_error("--" + option + " is one of: " + names + "; not '" + name + "'");
}

/// the tuning numbers of the strategies; 0 stands for the formula of the paper
struct Tuning
{
  int step = 0, interval = 0, seed = 0;
};

inline std::map<std::string, CGAL_ext::Corner_search> strategies(const Tuning& tuning)
{
  return {{"none", CGAL_ext::First_candidate_corner_search()},
          {"brute-force", CGAL_ext::Brute_force_corner_search()},
          {"quarter-brute-force", CGAL_ext::Quarter_brute_force_corner_search()},
          {"particle-swarm", CGAL_ext::Particle_swarm_corner_search(0, 20, 3, static_cast<unsigned int>(tuning.seed))},
          {"step-sampling", CGAL_ext::Step_sampling_corner_search(tuning.step)},
          {"single-highest", CGAL_ext::Single_highest_corner_search()},
          {"many-high", CGAL_ext::Many_high_corner_search()},
          {"better-of-two", CGAL_ext::Better_of_two_corner_search()},
          {"bracketing", CGAL_ext::Bracketing_corner_search()},
          {"hybrid", CGAL_ext::Hybrid_corner_search(tuning.interval)}};
}

typedef std::function<CGAL_ext::internal::Edge_weights(const CGAL_ext::internal::Patch&)> Weights;

inline const std::map<std::string, Weights>& weights()
{
  using CGAL_ext::Shape_preserving_weights;
  static const std::map<std::string, Weights> result{
      {"blended", CGAL_ext::Blended_weights()},
      {"shape-preserving", Shape_preserving_weights()},
      {"shape-preserving-plain", Shape_preserving_weights(Shape_preserving_weights::Average::PLAIN)},
      {"mean-value", CGAL_ext::Mean_value_weights()},
      {"symmetric-mean-value", CGAL_ext::Symmetric_mean_value_weights()},
      {"uniform", CGAL_ext::Uniform_weights()},
      {"clamped-cotangent", CGAL_ext::Clamped_cotangent_weights()},
      {"harmonic", CGAL_ext::Harmonic_weights()}};
  return result;
}

/// the settings that reproduce the tables of the paper
inline void apply_paper_preset(CGAL_ext::Square_map_options& options)
{
  options.minimization.weights = CGAL_ext::Shape_preserving_weights();
  options.minimization.eta = 1;
  options.minimization.patience = 0;
  options.search_options.corner_rule = CGAL_ext::Corner_rule::AUTHOR;
  options.chords = CGAL_ext::Chords::EARS;
}

/// four vertex numbers separated by commas
inline std::array<std::size_t, 4> parse_corners(const std::string& text)
{
  std::array<std::size_t, 4> corners{};
  std::istringstream stream(text);
  char comma = ',';
  for(int k = 0; k < 4; ++k)
    if((k > 0 && !(stream >> comma)) || comma != ',' || !std::isdigit(stream.peek()) || !(stream >> corners[k]))
      throw Usage_error("--corners takes four vertex numbers a,b,c,d counted from 0; not '" + text + "'");
  if(!(stream >> std::ws).eof())
    throw Usage_error("--corners takes four vertex numbers a,b,c,d counted from 0; not '" + text + "'");
  return corners;
}

/// the number of a component, by size: a number from 0, or the word largest
inline std::size_t parse_component(const std::string& text)
{
  if(text == "largest")
    return 0;
  std::istringstream stream(text);
  std::size_t component = 0;
  if(!std::isdigit(stream.peek()) || !(stream >> component) || stream.peek() != EOF)
    throw Usage_error("--component is 'largest' or a number counted from 0; not '" + text + "'");
  return component;
}

inline void check_outputs(const Command_line& line)
{
  namespace fs = std::filesystem;
  if(!line.output.empty()) {
    const std::string extension = fs::path(line.output).has_extension() ? extension_of(line.output) : "";
    if(extension != "obj" && extension != "off" && extension != "ply")
      throw Usage_error("the output '" + line.output + "' must end in .obj, .off or .ply");
  }
  std::vector<std::string> files{line.input, line.seams, line.output, line.json == "-" ? "" : line.json};
  for(std::size_t i = 0; i < files.size(); ++i)
    for(std::size_t j = i + 1; j < files.size(); ++j) {
      std::error_code error;
      if(files[i].empty() || files[j].empty())
        continue;
      if(fs::weakly_canonical(files[i], error) == fs::weakly_canonical(files[j], error) ||
         fs::equivalent(files[i], files[j], error))
        throw Usage_error("'" + files[i] + "' and '" + files[j] + "' are the same file");
    }
}

/// reads the command line; throws `Usage_error`
inline Command_line parse_command_line(int argc, char** argv)
{
  namespace po = boost::program_options;
  Command_line line;
  std::string weights_name, rule, walk, preset, corners, border, cut, component;
  double eta = 0, balance = 0;
  int patience = 0, threads = 0;
  Tuning tuning;
  po::options_description visible("options");
  auto add = visible.add_options();
  add("help,h", "show this text");
  add("output,o", po::value(&line.output)->value_name("FILE"), "the map: .obj, .off or .ply by extension");
  add("strategy", po::value(&line.strategy)->value_name("NAME"),
      "how corners are searched: bracketing (default for optimal), hybrid (default for iterative), brute-force, "
      "quarter-brute-force, particle-swarm, step-sampling, single-highest, many-high, better-of-two, none");
  add("minimizer", po::value(&line.minimizer)->value_name("NAME"),
      "optimal (default): least balanced energy; iterative: Yoshizawa et al.");
  add("balance", po::value(&balance)->value_name("X"),
      "optimal: 0 (least L2 stretch, tears) to 1 (symmetric Dirichlet); default 0.3");
  add("border", po::value(&border)->value_name("NAME"),
      "fixed or sliding; default fixed for iterative, sliding for optimal");
  add("component", po::value(&component)->value_name("K"),
      "map one connected component: largest, or a number; 0 has most faces, ties go to the first face");
  add("triangulate", po::bool_switch(&line.conditioning_options.triangulate), "split faces that are no triangles");
  add("cut", po::value(&cut)->value_name("NAME"),
      "how a surface that is not a disk is cut: best (default): for little stretch; shortest; none: it is refused");
  add("cut-weight", po::value(&line.options.cut.cut_weight)->value_name("X"),
      "best: stretch that a cut of the length sqrt(area) must save; default 0.05");
  add("max-cut-length", po::value(&line.options.cut.max_cut_length)->value_name("X"),
      "best: length, in units of sqrt(area), beyond which a cut is not extended");
  add("cut-disk", po::bool_switch(&line.options.cut.cuts_disk),
      "best: cut a disk, too, where L2 falls by more than --cut-weight times the length of the cut");
  add("seams", po::value(&line.seams)->value_name("FILE"),
      "edges to cut along, two vertex numbers a line, counted from 0; what they lack is added");
  add("weights", po::value(&weights_name)->value_name("NAME"),
      "of the iteration, which is the start of optimal: blended (default), shape-preserving, shape-preserving-plain, "
      "mean-value, symmetric-mean-value, uniform, "
      "clamped-cotangent, harmonic");
  add("corner-rule", po::value(&rule)->value_name("NAME"), "where sides end: nearest (default), author");
  add("walk", po::value(&walk)->value_name("NAME"),
      "direction in which candidates are counted: counter-clockwise (default), clockwise");
  add("preset", po::value(&preset)->value_name("NAME"), "paper: the settings of the published tables");
  add("step", po::value(&tuning.step)->value_name("N"),
      "step-sampling: distance between samples; 0 (default): sqrt(V m / F)");
  add("interval", po::value(&tuning.interval)->value_name("N"), "hybrid: stride; 0 (default): the step less one");
  add("seed", po::value(&tuning.seed)->value_name("N"), "particle-swarm: seed; default 0");
  add("eta", po::value(&eta)->value_name("X"), "exponent of the stretch, in ]0, 1]; default 0.3");
  add("patience", po::value(&patience)->value_name("N"), "iterates that may fail to be lower; default 1");
  add("threads", po::value(&threads)->value_name("N"), "threads; 0 (default) for all cores, fewer on large surfaces");
  add("corners", po::value(&corners)->value_name("a,b,c,d"),
      "four border vertices, counter-clockwise, counted from 0: no search");
  add("json", po::value(&line.json)->value_name("FILE"), "report; - for standard output");
  add("quiet", po::bool_switch(&line.is_quiet), "no progress on the terminal");
  po::options_description all;
  all.add(visible).add_options()("input", po::value(&line.input));
  std::ostringstream help;
  help << "usage: square_map INPUT [options]\n"
          "maps a triangle mesh (OFF, OBJ, PLY, STL), cut where it must be, onto the unit square with little stretch\n"
       << visible
       << "exit status: 0 done; 2 bad command line; 3 unreadable or malformed file; 4 the surface cannot be mapped;\n"
          "5 no one-to-one map was found\n";
  line.help = help.str();

  po::variables_map given;
  try {
    po::store(po::command_line_parser(argc, argv)
                  .options(all)
                  .positional(po::positional_options_description().add("input", 1))
                  .style(po::command_line_style::unix_style & ~po::command_line_style::allow_guessing)
                  .run(),
              given);
    po::notify(given);
  } catch(const po::error& error) {
    throw Usage_error(error.what());
  }
  line.wants_help = given.count("help") != 0;
  if(line.wants_help)
    return line;
  if(line.input.empty())
    throw Usage_error("no input file is given");
  const auto is_given = [&given](const char* option) { return given.count(option) != 0; };
  for(const char* number : {"threads", "patience", "step", "interval", "seed"})
    if(is_given(number) && (given[number].as<int>() < 0 || given[number].as<int>() > 1000000))
      throw Usage_error(std::string("--") + number + " must be a number from 0 to 1000000");
  for(const char* file : {"output", "json", "seams"})
    if(is_given(file) && given[file].as<std::string>().empty())
      throw Usage_error(std::string("--") + file + " needs the name of a file");

  CGAL_ext::Square_map_options& options = line.options;
  if(is_given("preset")) {
    named<bool>({{"paper", true}}, "preset", preset);
    apply_paper_preset(options);
    if(!is_given("minimizer"))
      line.minimizer = "iterative";
  }
  using CGAL_ext::Border_motion;
  if(!named<bool>({{"iterative", false}, {"optimal", true}}, "minimizer", line.minimizer))
    options.balanced.reset();
  if(!is_given("strategy"))
    line.strategy = options.balanced ? "bracketing" : "hybrid";
  if(is_given("balance")) {
    if(!options.balanced)
      throw Usage_error("--balance goes with --minimizer optimal");
    if(!(balance >= 0 && balance <= 1))
      throw Usage_error("--balance must be from 0 to 1");
    options.balanced->balance = balance;
  }
  if(is_given("border")) {
    const Border_motion motion =
        named<Border_motion>({{"fixed", Border_motion::FIXED}, {"sliding", Border_motion::SLIDING}}, "border", border);
    if(options.balanced)
      options.balanced->border = motion;
    else if(motion == Border_motion::SLIDING)
      throw Usage_error("--border sliding goes with --minimizer optimal");
  }
  if(is_given("component"))
    line.conditioning_options.component = parse_component(component);
  if(is_given("cut")) {
    using CGAL_ext::Cut_mode;
    line.options.cut.mode = named<Cut_mode>(
        {{"none", Cut_mode::NONE}, {"shortest", Cut_mode::SHORTEST}, {"best", Cut_mode::BEST}}, "cut", cut);
  }
  if(line.options.cut.mode != CGAL_ext::Cut_mode::NONE || !line.seams.empty())
    line.conditioning_options.topology = CGAL_ext::internal::Topology::CONNECTED;
  if(!line.options.cut.is_valid())
    throw Usage_error("--cut-weight and --max-cut-length must not be negative");
  if(line.options.cut.cuts_disk && (!line.options.cut.may_cut_disk() || !line.seams.empty()))
    throw Usage_error("--cut-disk goes with --cut best, and without --seams");
  options.search = named(strategies(tuning), "strategy", line.strategy);
  if(is_given("weights"))
    options.minimization.weights = named(weights(), "weights", weights_name);
  using CGAL_ext::Corner_rule;
  using CGAL_ext::Walk;
  if(is_given("corner-rule"))
    options.search_options.corner_rule =
        named<Corner_rule>({{"author", Corner_rule::AUTHOR}, {"nearest", Corner_rule::NEAREST}}, "corner-rule", rule);
  if(is_given("walk"))
    options.search_options.walk =
        named<Walk>({{"counter-clockwise", Walk::COUNTER_CLOCKWISE}, {"clockwise", Walk::CLOCKWISE}}, "walk", walk);
  if(is_given("eta")) {
    if(!(eta > 0 && eta <= 1))
      throw Usage_error("--eta must be above 0 and at most 1");
    options.minimization.eta = eta;
  }
  if(is_given("patience"))
    options.minimization.patience = patience;
  if(options.balanced) { // the number of iterations of its start is its own
    options.balanced->start.weights = options.minimization.weights;
    options.balanced->start.eta = options.minimization.eta;
    options.balanced->start.patience = options.minimization.patience;
  }
  options.search_options.number_of_threads = threads;
  if(is_given("corners")) {
    line.corners = options.corners = parse_corners(corners);
    line.strategy = "none";
  }
  check_outputs(line);
  return line;
}

} // namespace square_map

#endif // SQUARE_MAP_COMMAND_LINE_H
