// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_OPTION_EFFECTS_H
#define SQUARE_MAP_OPTION_EFFECTS_H

#include "option_list.h"

#include <string>
#include <vector>

namespace square_map {

/// a condition without which some options have no effect
struct Effect
{
  std::vector<const char*> options;
  const char* need; ///< the rest of the sentence that refuses an option: it names the other option
  bool (*is_met)(const Command_line&);
};

/// which options have an effect under which condition; all others always have one. Where several rows refuse an option
/// the first is told.
inline std::vector<Effect> effects()
{
  using CGAL_ext::Cut_mode;
  return {
      {{"strategy", "corner-rule", "walk", "step", "interval", "seed"},
       "has no effect beside --corners",
       [](const Command_line& line) { return !line.corners; }},
      {{"step"},
       "goes with --strategy step-sampling",
       [](const Command_line& line) { return line.strategy == "step-sampling"; }},
      {{"interval"}, "goes with --strategy hybrid", [](const Command_line& line) { return line.strategy == "hybrid"; }},
      {{"seed"},
       "goes with --strategy particle-swarm",
       [](const Command_line& line) { return line.strategy == "particle-swarm"; }},
      {{"cut", "cut-weight", "max-cut-length", "cut-disk"},
       "has no effect beside --seams",
       [](const Command_line& line) { return line.seams.empty(); }},
      {{"cut-weight", "max-cut-length", "cut-disk"}, "goes with --cut best", [](const Command_line& line) {
         return line.options.cut.mode == Cut_mode::BEST;
       }}};
}

/// refuses options that are given and have no effect beside the others, also with the value that they have by default:
/// who gives them expects one
/// \param line what was made of all options
inline void check_effects(const Given_options& given, const Command_line& line)
{
  for(const Effect& effect : effects())
    for(const char* option : effect.options)
      if(given.has(option) && !effect.is_met(line))
        throw Usage_error("--" + std::string(option) + " " + effect.need);
}

} // namespace square_map

#endif // SQUARE_MAP_OPTION_EFFECTS_H
