// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_ADD_OUTPUTS_H
#define SQUARE_MAP_ADD_OUTPUTS_H

#include "Job.h"
#include "Output_set.h"
#include "draw_thumbnail.h"
#include "report.h"
#include "write_glb.h"
#include "write_grid_mesh.h"
#include "write_page.h"
#include "write_svg.h"

#include <CGAL_ext/Square_parameterization/internal/common/Thread_team.h>

#include <filesystem>
#include <ostream>
#include <string>

namespace square_map {

/// writes the map that `-o` names
inline void write_output(std::ostream& stream, Job& job)
{
  const Command_line& line = job.line;
  const std::string extension = output_extension(line.output);
  CGAL_ext::internal::Thread_team team(line.options.search_options.number_of_threads);
  const CGAL_ext::internal::Thread_team::Scope scope(team);
  if(extension == "glb")
    write_glb(stream, job.flat->points, job.flat->normals, job.flat->uv, job.flat->triangles, job.texture);
  else
    write_map(stream, job.mesh, job.uv, job.originals, extension, job.result.aspect,
              has_material(line) ? std::filesystem::path(beside(line.output, ".mtl")).filename().string() : "");
}

/// adds the material of an OBJ file and its picture; one that is there already stays
inline void add_material(const Job& job, Output_set& outputs)
{
  const std::string picture = beside(job.line.output, ".png");
  outputs.add(beside(job.line.output, ".mtl"), [picture](std::ostream& stream) { write_material(stream, picture); });
  if(!is_same_file(job.line.texture, picture))
    outputs.add(picture, [&job](std::ostream& stream) { stream << job.texture; });
}

/// adds what is made of samples
inline void add_image_outputs(const Job& job, Output_set& outputs)
{
  outputs.add(job.line.image, [&job](std::ostream& stream) {
    stream << (output_extension(job.line.image) == "exr" ? exr_file(point_picture(*job.image))
                                                         : png_file(point_picture_in_box(*job.image)));
  });
  outputs.add(job.line.normal_map, [&job](std::ostream& stream) { stream << png_file(normal_picture(*job.image)); });
  outputs.add(job.line.attributes, [&job](std::ostream& stream) { stream << png_file(color_picture(*job.image)); });
  outputs.add(job.line.grid_mesh, [&job](std::ostream& stream) {
    write_grid_mesh(stream, *job.image, output_extension(job.line.grid_mesh));
  });
}

/// adds the outputs that the command line names, the report last: it tells how long the others took to write
inline void add_outputs(Job& job, const Stopwatch& watch, Output_set& outputs)
{
  outputs.add(job.line.output, [&job](std::ostream& stream) { write_output(stream, job); });
  if(has_material(job.line))
    add_material(job, outputs);
  add_image_outputs(job, outputs);
  outputs.add(job.line.svg, [&job](std::ostream& stream) { write_svg(stream, *job.flat, job); });
  outputs.add(job.line.page, [&job](std::ostream& stream) { write_page(stream, *job.flat, job, *job.first); });
  outputs.add(job.line.thumbnail,
              [&job](std::ostream& stream) { stream << png_file(draw_thumbnail(*job.flat, job.result.aspect)); });
  outputs.add(job.line.json, [&job, &watch](std::ostream& stream) {
    nlohmann::ordered_json report = make_report(job); // measuring the image takes time, too
    job.seconds.write = watch.total() - job.seconds.total;
    job.seconds.total = watch.total();
    report["seconds"] = timing_report(job.seconds);
    // a file name need not be UTF-8
    stream << report.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << '\n';
  });
}

} // namespace square_map

#endif // SQUARE_MAP_ADD_OUTPUTS_H
