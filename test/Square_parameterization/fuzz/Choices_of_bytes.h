// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_FUZZ_CHOICES_OF_BYTES_H
#define CGAL_EXT_FUZZ_CHOICES_OF_BYTES_H

#include "Soup_of_bytes.h"
#include "check_map.h"

#include <CGAL_ext/Square_parameterization/Bracketing_corner_search.h>
#include <CGAL_ext/Square_parameterization/Cut_options.h>
#include <CGAL_ext/Square_parameterization/Hybrid_corner_search.h>
#include <CGAL_ext/Square_parameterization/Particle_swarm_corner_search.h>
#include <CGAL_ext/Square_parameterization/Step_sampling_corner_search.h>
#include <CGAL_ext/Square_parameterization/circle_corner_searches.h>
#include <CGAL_ext/Square_parameterization/internal/soup/condition_soup.h>
#include <CGAL_ext/Square_parameterization/parameterize_onto_square.h>

#include <array>
#include <vector>

/// what bytes choose beside the surface. Zeros choose the iteration, bracketing, and the best cut.
struct Choices_of_bytes
{
  explicit Choices_of_bytes(Byte_source& bytes)
  {
    options.search_options.number_of_threads = 1;
    choose_minimizer(bytes.next());
    choose_search(bytes.next());
    choose_cut(bytes.next());
    for(auto& place : places)
      place = bytes.next();
  }

  CGAL_ext::Square_map_options<Fuzz_mesh> options;
  CGAL_ext::internal::Conditioning_options conditioning_options;
  bool has_seams = false, has_corners = false;
  std::array<int, 4> places; ///< bytes that say which edges are seams and which vertices are corners

private:
  void choose_minimizer(int byte)
  {
    using CGAL_ext::Border_motion;
    static const std::vector<std::function<CGAL_ext::internal::Edge_weights(const CGAL_ext::internal::Patch&)>> weights{
        CGAL_ext::Blended_weights(),    CGAL_ext::Shape_preserving_weights(),     CGAL_ext::Clamped_cotangent_weights(),
        CGAL_ext::Mean_value_weights(), CGAL_ext::Symmetric_mean_value_weights(), CGAL_ext::Uniform_weights()};
    if(byte % 2 == 1) {
      CGAL_ext::Balanced_minimization balanced;
      balanced.balance = (byte / 2 % 4) / 3.;
      balanced.border = byte / 8 % 2 == 1 ? Border_motion::SLIDING : Border_motion::FIXED;
      options.minimization = balanced;
    } else {
      CGAL_ext::Stretch_minimization iteration;
      iteration.weights = weights[byte / 16 % weights.size()];
      options.minimization = iteration;
    }
  }

  void choose_search(int byte)
  {
    static const std::vector<CGAL_ext::Corner_search> searches{
        CGAL_ext::Bracketing_corner_search(),     CGAL_ext::Hybrid_corner_search(),
        CGAL_ext::Brute_force_corner_search(),    CGAL_ext::Step_sampling_corner_search(),
        CGAL_ext::Better_of_two_corner_search(),  CGAL_ext::Particle_swarm_corner_search(),
        CGAL_ext::First_candidate_corner_search()};
    has_corners = byte % 8 == 7;
    if(!has_corners)
      options.search = searches[byte % 8];
    if(byte / 8 % 2 == 1)
      options.search_options.corner_rule = CGAL_ext::Corner_rule::AUTHOR;
    if(byte / 16 % 2 == 1)
      options.search_options.walk = CGAL_ext::Walk::CLOCKWISE;
  }

  void choose_cut(int byte)
  {
    using CGAL_ext::Cut_mode;
    using CGAL_ext::internal::Topology;
    options.cut.mode = byte % 4 == 0 ? Cut_mode::BEST : byte % 4 == 3 ? Cut_mode::NONE : Cut_mode::SHORTEST;
    options.cut.cuts_disk = byte / 4 % 4 >= 2;
    has_seams = byte / 4 % 4 == 3;
    if(byte / 16 % 4 == 3)
      options.cut.max_cut_length = 0.5;
    const bool is_cut = options.cut.mode != Cut_mode::NONE || has_seams;
    conditioning_options.topology = is_cut ? Topology::CONNECTED : Topology::DISK;
    conditioning_options.component = byte / 16 == 8 ? 1 : 0;
    conditioning_options.triangulate = byte / 64 > 0;
  }
};

#endif // CGAL_EXT_FUZZ_CHOICES_OF_BYTES_H
