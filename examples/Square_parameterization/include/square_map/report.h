// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_REPORT_H
#define SQUARE_MAP_REPORT_H

#include "Command_line.h"

#include <CGAL_ext/Square_parameterization/internal/search/Candidate_evaluation.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace square_map {

/// seconds spent in each part of the run
struct Timings
{
  double read = 0, condition = 0, cut = 0, search = 0, final = 0, write = 0, total = 0;
};

/// a number for JSON, which has no infinity: null then
inline nlohmann::ordered_json number(double x)
{
  return std::isfinite(x) ? nlohmann::ordered_json(x) : nlohmann::ordered_json(nullptr);
}

/// the corners as vertices of the file, as `--corners` takes them: copies count as their original; null for a vertex
/// that was added
/// \param originals per vertex of the cut mesh, the vertex of the conditioned one; vertices beyond were added
inline nlohmann::ordered_json input_corners(const CGAL_ext::Square_map_result<Mesh>& result,
                                            const std::vector<int>& originals,
                                            const CGAL_ext::internal::Conditioning_report& conditioning)
{
  nlohmann::ordered_json corners = nlohmann::ordered_json::array();
  for(Mesh::Vertex_index corner : result.corners) {
    const auto& kept = conditioning.new_index;
    const auto found = corner.idx() < originals.size()
                           ? std::find(kept.begin(), kept.end(), static_cast<std::size_t>(originals[corner.idx()]))
                           : kept.end();
    corners.push_back(found != kept.end() ? nlohmann::ordered_json(found - kept.begin())
                                          : nlohmann::ordered_json(nullptr));
  }
  return corners;
}

/// the report of a run that made a map
/// \param originals see `input_corners()`
inline nlohmann::ordered_json make_report(const Command_line& line, std::size_t input_vertices, std::size_t input_faces,
                                          const CGAL_ext::internal::Conditioning_report& conditioning, const Mesh& mesh,
                                          const CGAL_ext::Square_map_result<Mesh>& result,
                                          const std::vector<int>& originals, const Timings& seconds)
{
  const CGAL_ext::Cut_report& cut = result.cut;
  nlohmann::ordered_json json;
  json["input"] = {{"file", line.input}, {"vertices", input_vertices}, {"faces", input_faces}};
  json["conditioned"] = {{"vertices", mesh.number_of_vertices()},
                         {"faces", mesh.number_of_faces()},
                         {"border_edges", result.border_edges},
                         {"seam_edges", cut.seam_edges},
                         {"cut_length", cut.cut_length},
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
  static const char* const step_names[] = {"initial", "added", "dropped", "moved", "judged"};
  json["cut"] = {{"decision_faces", cut.decision_faces},
                 {"score", number(cut.score)},
                 {"l2", number(cut.stretch)},
                 {"history", nlohmann::ordered_json::array()}};
  for(const CGAL_ext::Cut_step& step : cut.history)
    json["cut"]["history"].push_back({{"step", step_names[step.kind]},
                                      {"score", number(step.score)},
                                      {"l2", number(step.stretch)},
                                      {"cut_length", step.length}});
  json["strategy"] = line.strategy;
  json["minimizer"] = line.minimizer;
  json["candidates"] = result.search.candidates;
  json["evaluations"] = result.search.evaluations;
  json["sketches"] = result.search.sketches;
  std::vector<std::size_t> corners;
  for(Mesh::Vertex_index v : result.corners)
    corners.push_back(v.idx());
  json["best"] = {{"candidate", result.search.best_candidate},
                  {"corners", corners}, // of the cut mesh
                  {"input_corners", input_corners(result, originals, conditioning)},
                  {"l2", result.measures.l2},
                  {"linf", result.measures.linf},
                  {"symmetric_dirichlet", result.measures.symmetric_dirichlet},
                  {"energy", result.search.best_objective},
                  {"flipped", result.measures.flipped_faces},
                  {"iterations", result.minimization.iterations}};
  json["curve"] = nlohmann::ordered_json::array();
  for(const auto& sample : result.search.curve)
    json["curve"].push_back(
        {{"candidate", sample.candidate}, {"l2", number(sample.l2)}, {"energy", number(sample.objective)}});
  json["threads"] = CGAL_ext::internal::number_of_search_threads(line.options.search_options.number_of_threads,
                                                                 static_cast<int>(mesh.number_of_vertices()));
  json["seconds"] = {{"read", seconds.read},     {"condition", seconds.condition}, {"cut", seconds.cut},
                     {"search", seconds.search}, {"final", seconds.final},         {"write", seconds.write},
                     {"total", seconds.total}};
  return json;
}

} // namespace square_map

#endif // SQUARE_MAP_REPORT_H
