// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_MAP_FIRST_CANDIDATE_H
#define SQUARE_MAP_MAP_FIRST_CANDIDATE_H

#include "Job.h"

#include <CGAL_ext/Square_parameterization/internal/common/Deadline.h>

#include <utility>

namespace square_map {

/// maps the cut mesh once more, with the corners of the first candidate
inline First_candidate map_first_candidate(const Job& job)
{
  First_candidate first;
  if(job.line.corners)
    first.reason = "The corners were given: there is no first candidate.";
  else if(*job.result.search.best_candidate == 0 && !job.result.search.has_moved_corners)
    first.reason = "The first candidate is the best.";
  else if(CGAL_ext::internal::has_passed(job.line.options.search_options.deadline))
    first.reason = "The first candidate is not shown: the time limit was reached.";
  if(!first.reason.empty())
    return first;
  Mesh mesh = job.mesh; // a disk, with its chords split: it stays as it is
  UV_map uv = mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:first_uv").first;
  CGAL_ext::Square_map_options<Mesh> options = job.line.options;
  options.search = CGAL_ext::First_candidate_corner_search();
  options.search_options.moves_corners = false;
  options.cut.mode = CGAL_ext::Cut_mode::NONE;
  options.seams.clear();
  options.seam_grid.reset();
  auto result = CGAL_ext::parameterize_onto_square(mesh, uv, CGAL_ext::parameters::options(options));
  if(result.status != CGAL::Surface_mesh_parameterization::OK) {
    first.reason = "The first candidate is not shown: " + result.message + ".";
    return first;
  }
  first.uv.resize(static_cast<Eigen::Index>(mesh.number_of_vertices()), 2);
  for(Mesh::Vertex_index v : mesh.vertices())
    first.uv.row(static_cast<Eigen::Index>(v.idx())) << uv[v].x(), uv[v].y();
  first.aspect = result.aspect;
  first.corners = std::move(result.corners);
  first.measures = std::move(result.measures);
  return first;
}

} // namespace square_map

#endif // SQUARE_MAP_MAP_FIRST_CANDIDATE_H
