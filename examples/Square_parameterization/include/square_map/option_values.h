// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_OPTION_VALUES_H
#define SQUARE_MAP_OPTION_VALUES_H

#include <CGAL_ext/Square_parameterization/Bracketing_corner_search.h>
#include <CGAL_ext/Square_parameterization/Hybrid_corner_search.h>
#include <CGAL_ext/Square_parameterization/Particle_swarm_corner_search.h>
#include <CGAL_ext/Square_parameterization/Step_sampling_corner_search.h>
#include <CGAL_ext/Square_parameterization/circle_corner_searches.h>
#include <CGAL_ext/Square_parameterization/parameterize_onto_square.h>

#include "parse_number.h"

#include <array>
#include <cctype>
#include <cstdio>
#include <functional>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <variant>

namespace square_map {

/// a command line that makes no sense
struct Usage_error : std::runtime_error
{
  using std::runtime_error::runtime_error;
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

/// the iteration of Yoshizawa et al. in a minimization: all of it, or its start
inline CGAL_ext::Stretch_minimization& iteration_of(CGAL_ext::Minimization& minimization)
{
  if(auto* const balanced = std::get_if<CGAL_ext::Balanced_minimization>(&minimization))
    return balanced->start;
  return std::get<CGAL_ext::Stretch_minimization>(minimization);
}

/// the settings that reproduce the tables of the paper, for the minimization that is chosen
inline void apply_paper_preset(CGAL_ext::Square_map_settings& options)
{
  CGAL_ext::Stretch_minimization& iteration = iteration_of(options.minimization);
  iteration.weights = CGAL_ext::Shape_preserving_weights();
  iteration.eta = 1;
  iteration.patience = 0;
  options.search_options.corner_rule = CGAL_ext::Corner_rule::AUTHOR;
  options.chords = CGAL_ext::Chords::EARS;
}

/// four vertex numbers separated by commas, with or without blanks
inline std::array<std::size_t, 4> parse_corners(const std::string& text)
{
  const auto refuse = [&text] {
    throw Usage_error("--corners takes four vertex numbers a,b,c,d counted from 0; not '" + text + "'");
  };
  std::array<std::size_t, 4> corners{};
  std::istringstream stream(text);
  char comma = ',';
  for(int k = 0; k < 4; ++k) {
    if((k > 0 && !(stream >> comma)) || comma != ',' || !std::isdigit((stream >> std::ws).peek()))
      refuse();
    std::string digits;
    while(std::isdigit(stream.peek()))
      digits += static_cast<char>(stream.get());
    const auto number = parse_integer<std::size_t>(digits);
    if(!number)
      throw Usage_error("corner vertex " + digits + " does not exist");
    corners[k] = *number;
  }
  if(!(stream >> std::ws).eof())
    refuse();
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

} // namespace square_map

#endif // SQUARE_MAP_OPTION_VALUES_H
