// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_REPORT_H
#define SQUARE_MAP_REPORT_H

#include "Job.h"
#include "name_of_start.h"
#include "surface_distances.h"

#include <CGAL_ext/Square_parameterization/internal/common/Thread_team.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace square_map {

/// a number for JSON, which has no infinity: null then
inline nlohmann::ordered_json number(double x)
{
  return std::isfinite(x) ? nlohmann::ordered_json(x) : nlohmann::ordered_json(nullptr);
}

/// corners as vertices of the file, as `--corners` takes them: copies count as their original; null for a vertex that
/// was added
inline nlohmann::ordered_json input_corners(const std::vector<Mesh::Vertex_index>& mesh_corners, const Job& job)
{
  nlohmann::ordered_json corners = nlohmann::ordered_json::array();
  for(Mesh::Vertex_index corner : mesh_corners) {
    const std::vector<std::size_t>& kept = job.conditioning.new_index;
    const std::vector<int>& originals = job.originals;
    const auto found = corner.idx() < originals.size()
                           ? std::find(kept.begin(), kept.end(), static_cast<std::size_t>(originals[corner.idx()]))
                           : kept.end();
    corners.push_back(found != kept.end() ? nlohmann::ordered_json(found - kept.begin())
                                          : nlohmann::ordered_json(nullptr));
  }
  return corners;
}

/// what was made of the file before it was mapped
inline nlohmann::ordered_json conditioning_report(const Job& job)
{
  const CGAL_ext::internal::Conditioning_report& conditioning = job.conditioning;
  const CGAL_ext::Square_map_result<Mesh>& result = job.result;
  return {{"vertices", job.mesh.number_of_vertices()},
          {"faces", job.mesh.number_of_faces()},
          {"border_edges", result.border_edges},
          {"seam_edges", result.cut.seam_edges},
          {"cut_length", result.cut.cut_length},
          {"border_edges_split", result.border_edges_split},
          {"chords_split", result.chords_split},
          {"degenerate_faces", result.degenerate_faces},
          {"components", conditioning.components},
          {"component", conditioning.component},
          {"vertices_dropped", conditioning.vertices_dropped},
          {"faces_dropped", conditioning.faces_dropped},
          {"polygons_triangulated", conditioning.polygons_triangulated},
          {"vertices_added", conditioning.vertices_added},
          {"faces_reoriented", conditioning.faces_reoriented}};
}

/// how the cut was chosen
inline nlohmann::ordered_json cut_report(const CGAL_ext::Cut_report& cut)
{
  static const char* const step_names[] = {"initial", "added", "dropped", "moved"};
  nlohmann::ordered_json json{{"decision_faces", cut.decision_faces},
                              {"score", number(cut.score)},
                              {"l2", number(cut.stretch)},
                              {"replaced", cut.is_replaced},
                              {"front", nlohmann::ordered_json::array()},
                              {"history", nlohmann::ordered_json::array()}};
  for(const CGAL_ext::Cut_choice& choice : cut.front)
    json["front"].push_back({{"cut_length", choice.length}, {"l2", choice.stretch}});
  for(const CGAL_ext::Cut_step& step : cut.history)
    json["history"].push_back({{"step", step_names[step.kind]},
                               {"score", number(step.score)},
                               {"l2", number(step.stretch)},
                               {"cut_length", step.length}});
  return json;
}

/// the map that is delivered; null for candidates of which none has one
inline nlohmann::ordered_json best_map_report(const Job& job)
{
  const CGAL_ext::Square_map_result<Mesh>& result = job.result;
  if(!result.search.best_candidate)
    return nullptr;
  std::vector<std::size_t> corners;
  for(Mesh::Vertex_index v : result.corners)
    corners.push_back(v.idx());
  return {{"candidate", *result.search.best_candidate},
          {"corners", corners}, // of the cut mesh
          {"input_corners", input_corners(result.corners, job)},
          {"has_moved_corners", result.search.has_moved_corners},
          {"l2", result.measures.l2},
          {"linf", result.measures.linf},
          {"symmetric_dirichlet", result.measures.symmetric_dirichlet},
          {"energy", result.minimization.objective},
          {"aspect", result.aspect},
          {"flipped", result.measures.flipped_faces},
          {"iterations", result.minimization.iterations}};
}

/// seconds spent in each part of the run
inline nlohmann::ordered_json timing_report(const Timings& seconds)
{
  return {{"read", seconds.read},     {"condition", seconds.condition}, {"cut", seconds.cut},
          {"search", seconds.search}, {"final", seconds.final},         {"sample", seconds.sample},
          {"write", seconds.write},   {"total", seconds.total}};
}

/// three numbers
inline nlohmann::ordered_json numbers(const Eigen::Vector3d& x)
{
  return {x.x(), x.y(), x.z()};
}

inline nlohmann::ordered_json distance_report(const Surface_distance& distance)
{
  return {{"rms", distance.rms}, {"hausdorff", distance.hausdorff}, {"triangles_asked", distance.triangles_asked}};
}

/// points in diagonals of a box, from its center
inline std::vector<Eigen::Vector3d> in_box(std::vector<Eigen::Vector3d> points, const Eigen::AlignedBox3d& box)
{
  const Eigen::Vector3d center = box.min() / 2 + box.max() / 2;
  const double diagonal = box.diagonal().stableNorm();
  for(Eigen::Vector3d& p : points)
    p = (p - center) / diagonal;
  return points;
}

/// how well the samples stand for the surface, in diagonals of its box, and what the mesh rebuilt from them is
/// \param seam_message why the samples on the two sides of the seams differ; empty when they do not
inline nlohmann::ordered_json image_report(const Geometry_image& image, const Flat_map& map,
                                           const std::string& seam_message, unsigned int number_of_threads)
{
  std::vector<Eigen::Vector3d> samples;
  for(std::size_t sample : image.mesh.samples)
    samples.push_back(image.points[sample]);
  const auto points = in_box(map.points, image.box), image_points = in_box(std::move(samples), image.box);
  const Triangles surface{points, map.triangles}, rebuilt{image_points, image.mesh.triangles};
  const Surface_distance to_image = distance_to(rebuilt, surface, number_of_threads);
  const Surface_distance from_image = distance_to(surface, rebuilt, number_of_threads);
  const auto topology = CGAL_ext::internal::topology_of(image_points.size(), image.mesh.triangles);
  return {{"width", image.size.width},
          {"height", image.size.height},
          {"box", {{"min", numbers(image.box.min())}, {"max", numbers(image.box.max())}}},
          {"rms_error", rms_error_at_vertices(image, map, image.box.diagonal().stableNorm())},
          {"hausdorff_error", (std::max)(to_image.hausdorff, from_image.hausdorff)},
          {"surface_to_image", distance_report(to_image)},
          {"image_to_surface", distance_report(from_image)},
          {"seam_message", seam_message},
          {"is_closed", topology.is_closed},
          {"is_manifold", topology.is_manifold},
          {"genus", topology.is_manifold ? nlohmann::ordered_json(topology.genus) : nlohmann::ordered_json(nullptr)}};
}

inline nlohmann::ordered_json curve_report(const std::vector<CGAL_ext::Search_report::Sample>& curve)
{
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for(const auto& sample : curve)
    json.push_back({{"candidate", sample.candidate}, {"l2", number(sample.l2)}, {"energy", number(sample.objective)}});
  return json;
}

/// what the run found out, but for what depends on the machine: time and threads
inline nlohmann::ordered_json map_report(const Job& job)
{
  const CGAL_ext::Search_report& search = job.result.search;
  nlohmann::ordered_json json;
  json["input"] = {{"file", job.line.input}, {"vertices", job.input_vertices}, {"faces", job.input_faces}};
  if(!job.passed_over.empty())
    json["input"]["passed_over"] = job.passed_over;
  json["conditioned"] = conditioning_report(job);
  json["cut"] = cut_report(job.result.cut);
  json["strategy"] = job.line.strategy;
  json["minimizer"] = job.line.minimizer;
  json["start"] = name_of(job.result.start);
  json["time_limit_reached"] = has_reached_time_limit(job);
  json["candidates"] = search.candidates;
  json["evaluations"] = search.evaluations;
  json["sketches"] = search.sketches;
  json["corner_maps"] = search.corner_maps;
  json["corner_moves"] = search.corner_moves;
  json["best"] = best_map_report(job);
  json["curve"] = curve_report(search.curve);
  json["sketched_curve"] = curve_report(search.sketched_curve); // of a coarse mesh
  return json;
}

/// the report of a run that made a map
inline nlohmann::ordered_json make_report(const Job& job)
{
  nlohmann::ordered_json json = map_report(job);
  if(job.image)
    json["image"] = image_report(*job.image, *job.flat, job.result.seam_message,
                                 static_cast<unsigned int>(job.line.options.search_options.number_of_threads));
  json["threads"] = CGAL_ext::internal::number_of_threads(job.line.options.search_options.number_of_threads);
  json["seconds"] = timing_report(job.seconds);
  return json;
}

} // namespace square_map

#endif // SQUARE_MAP_REPORT_H
