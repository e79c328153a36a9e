// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_MESSAGES_H
#define SQUARE_MAP_MESSAGES_H

#include "Job.h"
#include "Malformed_file.h"
#include "name_of_start.h"

#include <iostream>
#include <string>

namespace square_map {

/// tells what of the file was not used
inline void tell_passed_over(const Passed_over& passed_over)
{
  if(!passed_over.empty())
    std::cerr << "passed over in the file: " << listed(passed_over) << '\n';
}

/// tells what was done to the polygons of the file
inline void tell_conditioning(const CGAL_ext::internal::Conditioning_report& conditioning)
{
  const auto tell = [](std::size_t count, const char* singular, const char* plural, const char* rest) {
    if(count > 0)
      std::cerr << counted(count, singular, plural) << rest << '\n';
  };
  if(conditioning.components > 1)
    std::cerr << "component " << conditioning.component << " of " << conditioning.components << " was kept, "
              << counted(conditioning.faces_dropped, "face", "faces")
              << (conditioning.components == 2 ? " of the other" : " of the others")
              << (conditioning.faces_dropped == 1 ? " was dropped\n" : " were dropped\n");
  tell(conditioning.polygons_triangulated, "polygon was", "polygons were", " split into triangles");
  tell(conditioning.vertices_added, "vertex was", "vertices were", " added inside polygons");
  tell(conditioning.faces_reoriented, "face was", "faces were", " turned round to agree with the neighbors");
  if(conditioning.components > 1)
    tell(conditioning.vertices_dropped, "vertex without a kept face was", "vertices without a kept face were",
         " dropped");
  else
    tell(conditioning.vertices_dropped, "isolated vertex was", "isolated vertices were", " dropped");
}

/// tells what was done to the mesh, and how good its map is
inline void tell_map(const CGAL_ext::Square_map_result<Mesh>& result, double total_seconds)
{
  if(result.cut.seam_edges > 0)
    std::cerr << "cut along " << counted(result.cut.seam_edges, "edge", "edges") << ", " << result.cut.cut_length
              << " sqrt(area) long"
              << (result.cut.is_replaced ? ": the shortest cut, for the best one led to no map, or to a bad one\n"
                                         : "\n");
  if(result.degenerate_faces > 0)
    std::cerr << counted(result.degenerate_faces, "face without area was mapped as if it were a little wide\n",
                         "faces without area were mapped as if they were a little wide\n");
  if(result.border_edges_split > 0)
    std::cerr << "the border was too short for four corners: an edge of it was split\n";
  if(result.chords_split > 0)
    std::cerr << counted(result.chords_split, "chord was split\n", "chords were split\n");
  if(result.start != CGAL_ext::Map_start::AS_CHOSEN)
    std::cerr << "the usual start led to no map, or to a bad one; this one began with another: "
              << name_of(result.start) << '\n';
  std::cerr << "L2 stretch " << result.measures.l2
            << (result.search.has_moved_corners ? " with corners moved from candidate " : " at candidate ")
            << *result.search.best_candidate << ", "
            << counted(result.search.evaluations + result.search.corner_maps, "map", "maps") << ", " << total_seconds
            << " s\n";
}

/// tells why the samples of seams differ
inline void tell_open_seams(const CGAL_ext::Square_map_result<Mesh>& result)
{
  if(!result.seam_message.empty())
    std::cerr << "the samples do not close at the seams: " << result.seam_message << '\n';
}

} // namespace square_map

#endif // SQUARE_MAP_MESSAGES_H
