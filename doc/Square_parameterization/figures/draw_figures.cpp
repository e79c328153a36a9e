// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Draws the figures of the manual, from maps that it makes:
//
//     draw_figures FOLDER_OF_MESHES FOLDER_OF_FIGURES
//
// and prints the numbers that their captions name.

#include "draw_corner_figures.h"
#include "draw_cut_figures.h"
#include "draw_map_figures.h"

#include <cstdio>
#include <cstdlib>
#include <exception>

int main(int argc, char** argv)
{
  if(argc != 3) {
    std::fprintf(stderr, "usage: draw_figures FOLDER_OF_MESHES FOLDER_OF_FIGURES\n");
    return EXIT_FAILURE;
  }
  try {
    const figures::Folders folders{argv[1], argv[2]};
    figures::draw_corners(folders);
    figures::draw_corner_rules(folders);
    figures::draw_border_motion(folders);
    figures::draw_balances(folders);
    figures::draw_rectangle(folders);
    figures::draw_chord(folders);
    figures::draw_cut(folders);
    figures::draw_geometry_image(folders);
    figures::draw_strategies(folders);
  } catch(const std::exception& error) {
    std::fprintf(stderr, "draw_figures: %s\n", error.what());
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
