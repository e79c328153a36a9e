// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_SAMPLE_MAP_H
#define SQUARE_MAP_SAMPLE_MAP_H

#include "Job.h"
#include "Progress.h"
#include "map_first_candidate.h"

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace square_map {

/// the colors of the vertices of the cut mesh, made of those of the file
inline Vertex_colors flat_colors(const Job& job)
{
  std::vector<std::optional<Eigen::Vector3d>> conditioned(job.uncut_vertices), colors(job.flat->points.size());
  for(std::size_t v = 0; v < job.input_colors.size(); ++v)
    if(const std::size_t kept = conditioned_vertex(v, job.conditioning);
       kept != CGAL_ext::internal::Conditioning_report::DROPPED)
      conditioned[kept] = job.input_colors[v];
  for(std::size_t v = 0; v < job.originals.size(); ++v)
    colors[v] = conditioned[job.originals[v]];
  return completed_colors(std::move(colors), job.flat->points, job.flat->triangles);
}

/// the grid of the image: by default it has the proportions of the rectangle
inline CGAL_ext::Grid_size grid_of_samples(const Job& job)
{
  if(job.line.resolution)
    return *job.line.resolution;
  return job.result.seam_grid ? *job.result.seam_grid
                              : default_resolution(job.uncut_vertices).fitted_to(job.result.aspect);
}

/// makes what the outputs are made of: the map as arrays, the samples, and the map of the first candidate
inline void sample_map(Job& job, Progress& progress)
{
  const Command_line& line = job.line;
  if(makes_image(line) || !line.svg.empty() || !line.page.empty() || !line.thumbnail.empty() ||
     output_extension(line.output) == "glb")
    job.flat = flat_map(job.mesh, job.uv, job.originals);
  if(!line.attributes.empty())
    job.flat->colors = flat_colors(job);
  if(makes_image(line)) {
    progress.start("sampling");
    job.image = make_geometry_image(*job.flat, grid_of_samples(job), job.result.seam_samples);
  }
  if(!line.page.empty()) {
    progress.start("mapping the first candidate");
    job.first = map_first_candidate(job);
  }
}

} // namespace square_map

#endif // SQUARE_MAP_SAMPLE_MAP_H
