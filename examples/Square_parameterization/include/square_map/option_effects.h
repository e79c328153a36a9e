// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_OPTION_EFFECTS_H
#define SQUARE_MAP_OPTION_EFFECTS_H

#include "option_list.h"

#include <filesystem>
#include <string>
#include <vector>

namespace square_map {

/// indicates whether anything is made of samples
inline bool makes_image(const Command_line& line)
{
  return !line.image.empty() || !line.normal_map.empty() || !line.attributes.empty() || !line.grid_mesh.empty();
}

/// the extension of the name of an output, in lower case; empty when it has none
inline std::string output_extension(const std::string& name)
{
  return std::filesystem::path(name).has_extension() ? extension_of(name) : "";
}

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
      {{"strategy", "candidates", "curve", "corner-rule", "walk", "step", "interval", "seed"},
       "has no effect beside --corners",
       [](const Command_line& line) { return !line.corners; }},
      {{"candidates", "curve"},
       "goes with --strategy brute-force or quarter-brute-force",
       [](const Command_line& line) {
         return line.strategy == "brute-force" || line.strategy == "quarter-brute-force";
       }},
      {{"candidates"}, "has no effect beside --curve", [](const Command_line& line) { return line.curves.empty(); }},
      {{"quarter-corners"},
       "goes with --minimizer optimal, and a search",
       [](const Command_line& line) {
         return std::holds_alternative<CGAL_ext::Balanced_minimization>(line.options.minimization) && !line.corners &&
                line.strategy != "none";
       }},
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
      {{"resolution"},
       "goes with --image, --normal-map, --attributes or --grid-mesh",
       [](const Command_line& line) { return makes_image(line); }},
      {{"texture"},
       "goes with an output .glb or .obj",
       [](const Command_line& line) {
         const std::string extension = output_extension(line.output);
         return extension == "glb" || extension == "obj";
       }},
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
