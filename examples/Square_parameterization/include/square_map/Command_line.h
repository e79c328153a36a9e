// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_COMMAND_LINE_H
#define SQUARE_MAP_COMMAND_LINE_H

#include "check_files.h"
#include "option_effects.h"
#include "parse_number.h"

#include <chrono>
#include <optional>
#include <sstream>
#include <string>
#include <variant>

namespace square_map {

/// indicates whether a word of the command line is the name of an option that takes a value
inline bool takes_value(const boost::program_options::options_description& options, const std::string& word)
{
  const bool is_long = word.rfind("--", 0) == 0, is_short = !is_long && word.size() == 2 && word[0] == '-';
  if(!is_short && !(is_long && word.size() > 2))
    return false;
  const auto* const option = options.find_nothrow(is_long ? word.substr(2) : word, false);
  return option != nullptr && option->semantic()->max_tokens() > 0;
}

/// reads the options, with the input file; the help text, too
inline void read_options(int argc, char** argv, Given_options& given, Command_line& line)
{
  namespace po = boost::program_options;
  const po::options_description visible = option_list(given, line);
  std::ostringstream help;
  help << "usage: square_map INPUT [options]; INPUT - is standard input\n"
          "maps a triangle mesh (OFF, OBJ, PLY, STL), cut where it must be, onto the unit square with little stretch\n"
       << visible
       << "exit status: 0 done; 2 bad command line; 3 unreadable or malformed file; 4 the surface cannot be mapped;\n"
          "5 no one-to-one map was found; 128 + S ended by signal S\n";
  line.help = help.str();

  po::options_description all;
  all.add(visible).add_options()("input", po::value(&line.input));
  try {
    po::store(po::command_line_parser(argc, argv)
                  .options(all)
                  .positional(po::positional_options_description().add("input", 1))
                  .style(po::command_line_style::unix_style & ~po::command_line_style::allow_guessing)
                  .run(),
              given.all);
    po::notify(given.all);
  } catch(const po::too_many_positional_options_error& error) {
    for(int i = 1; i + 1 < argc; ++i)
      if(takes_value(visible, argv[i]) && takes_value(visible, argv[i + 1])) // which was read as the value
        throw Usage_error(std::string(argv[i]) + " needs a value, not the option " + argv[i + 1]);
    throw Usage_error(error.what());
  } catch(const po::error& error) {
    throw Usage_error(error.what());
  }
  line.wants_help = given.has("help");
  line.wants_version = given.has("version");
}

inline void check_options(const Given_options& given, const Command_line& line)
{
  if(line.input.empty())
    throw Usage_error("no input file is given");
  if(given.has("input-format"))
    named(file_formats(), "input-format", line.input_format);
  for(const char* option :
      {"output", "json", "svg", "report", "thumbnail", "image", "normal-map", "attributes", "grid-mesh"})
    if(given.has(option))
      check_file_name(option, given.all[option].as<std::string>());
  for(const char* option : {"seams", "texture"})
    if(given.has(option))
      check_input_name(option, given.all[option].as<std::string>());
  for(const std::string& curve : line.curves)
    check_input_name("curve", curve);
}

/// a ratio, or none for the best
inline std::optional<double> parse_aspect(const std::string& text)
{
  if(text == "best")
    return {};
  const std::optional<double> aspect = parse_real(text);
  if(!aspect || !(*aspect >= 1e-3 && *aspect <= 1e3))
    throw Usage_error("--aspect must be from 0.001 to 1000, or best; not '" + text + "'");
  return aspect;
}

/// how a map is minimised: the preset, and what is given beside it
inline void set_minimizer(const Given_options& given, Command_line& line)
{
  CGAL_ext::Square_map_settings& options = line.options;
  if(given.has("preset")) {
    named<bool>({{"paper", true}}, "preset", given.preset);
    if(!given.has("minimizer"))
      line.minimizer = "iterative";
  }
  options.minimization = named<CGAL_ext::Minimization>(
      {{"iterative", CGAL_ext::Stretch_minimization()}, {"optimal", CGAL_ext::Balanced_minimization()}}, "minimizer",
      line.minimizer);
  if(given.has("preset"))
    apply_paper_preset(options);
  auto* const balanced = std::get_if<CGAL_ext::Balanced_minimization>(&options.minimization);
  if(given.has("balance")) {
    if(balanced == nullptr)
      throw Usage_error("--balance goes with --minimizer optimal");
    balanced->balance = given.number("balance");
  }
  if(given.has("aspect")) {
    if(balanced == nullptr)
      throw Usage_error("--aspect goes with --minimizer optimal");
    balanced->aspect = parse_aspect(given.aspect);
  }
  if(given.has("border")) {
    using CGAL_ext::Border_motion;
    const Border_motion motion = named<Border_motion>(
        {{"fixed", Border_motion::FIXED}, {"sliding", Border_motion::SLIDING}}, "border", given.border);
    if(balanced != nullptr)
      balanced->border = motion;
    else if(motion == Border_motion::SLIDING)
      throw Usage_error("--border sliding goes with --minimizer optimal");
  }
}

/// the iteration, which is the start of the other minimizer, too; the number of iterations of a start is its own
inline void set_iteration(const Given_options& given, CGAL_ext::Square_map_settings& options)
{
  CGAL_ext::Stretch_minimization& iteration = iteration_of(options.minimization);
  if(given.has("weights"))
    iteration.weights = named(weights(), "weights", given.weights);
  if(given.has("eta"))
    iteration.eta = given.number("eta");
  if(given.has("patience"))
    iteration.patience = static_cast<unsigned int>(given.whole_number("patience"));
}

/// what is mapped, and how it is cut
inline void set_surface(const Given_options& given, Command_line& line)
{
  using CGAL_ext::Cut_mode;
  CGAL_ext::Cut_options& cut = line.options.cut;
  if(given.has("component"))
    line.conditioning_options.component = parse_component(given.component);
  if(given.has("cut"))
    cut.mode = named<Cut_mode>({{"none", Cut_mode::NONE}, {"shortest", Cut_mode::SHORTEST}, {"best", Cut_mode::BEST}},
                               "cut", given.cut);
  if(cut.mode != Cut_mode::NONE || !line.seams.empty())
    line.conditioning_options.topology = CGAL_ext::internal::Topology::CONNECTED;
  if(given.has("cut-weight"))
    cut.cut_weight = given.number("cut-weight");
  if(given.has("max-cut-length"))
    cut.max_cut_length = given.number("max-cut-length");
}

/// how corners are searched
inline void set_search(const Given_options& given, Command_line& line)
{
  using CGAL_ext::Corner_rule;
  using CGAL_ext::Walk;
  CGAL_ext::Square_map_settings& options = line.options;
  if(!given.has("strategy"))
    line.strategy =
        std::holds_alternative<CGAL_ext::Balanced_minimization>(options.minimization) ? "bracketing" : "hybrid";
  const Tuning tuning{given.whole_number("step"), given.whole_number("interval"), given.whole_number("seed")};
  options.search = named(strategies(tuning), "strategy", line.strategy);
  if(given.has("candidates")) {
    line.candidates = parse_candidates(given.candidates);
    options.search = Slice_corner_search{options.search.candidate_set(), *line.candidates};
    options.tries_other_starts = false; // the curves of all slices come from one start
  }
  options.search_options.moves_corners = line.strategy != "none" && !line.candidates && !given.keeps_quarters;
  if(given.has("corner-rule"))
    options.search_options.corner_rule = named<Corner_rule>(
        {{"author", Corner_rule::AUTHOR}, {"nearest", Corner_rule::NEAREST}}, "corner-rule", given.corner_rule);
  if(given.has("walk"))
    options.search_options.walk = named<Walk>(
        {{"counter-clockwise", Walk::COUNTER_CLOCKWISE}, {"clockwise", Walk::CLOCKWISE}}, "walk", given.walk);
  options.search_options.number_of_threads = static_cast<unsigned int>(given.whole_number("threads"));
  if(given.has("time-limit"))
    options.search_options.deadline =
        std::chrono::steady_clock::now() + std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                                               std::chrono::duration<double>(given.number("time-limit")));
  if(given.has("corners")) {
    line.corners = parse_corners(given.corners);
    line.strategy = "none";
  }
}

/// reads the command line; throws `Usage_error`
inline Command_line parse_command_line(int argc, char** argv)
{
  Command_line line;
  Given_options given;
  read_options(argc, argv, given, line);
  if(line.wants_help || line.wants_version)
    return line;
  check_options(given, line);
  set_minimizer(given, line);
  set_iteration(given, line.options);
  set_surface(given, line);
  set_search(given, line);
  if(given.has("resolution"))
    line.resolution = parse_resolution(given.resolution);
  check_effects(given, line);
  check_files(line);
  return line;
}

} // namespace square_map

#endif // SQUARE_MAP_COMMAND_LINE_H
