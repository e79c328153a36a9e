// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_WRITE_PAGE_H
#define SQUARE_MAP_WRITE_PAGE_H

#include "Job.h"
#include "Map_border.h"
#include "Packed_arrays.h"
#include "Stretch_colors.h"
#include "base64.h"
#include "page_template.h"
#include "report.h"
#include "svg_curve.h"

#include <CGAL_ext/Square_parameterization/internal/energy/rectangle.h>

#include <cmath>
#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

namespace square_map {

/// places of vertices on the rectangle that the unit square stands for, from its center
inline std::vector<float> places(const CGAL_ext::internal::Uv_coordinates& uv, double aspect)
{
  const CGAL_ext::internal::Uv_coordinates centered = CGAL_ext::internal::on_rectangle(uv.array() - 0.5, aspect);
  std::vector<float> result;
  for(Eigen::Index v = 0; v < centered.rows(); ++v)
    for(int c = 0; c < 2; ++c)
      result.push_back(static_cast<float>(centered(v, c)));
  return result;
}

/// \param scale of a vector of length 1
template <class Number>
std::vector<Number> packed(const std::vector<Eigen::Vector3d>& vectors, double scale)
{
  std::vector<Number> result;
  for(const Eigen::Vector3d& x : vectors)
    for(int c = 0; c < 3; ++c)
      result.push_back(static_cast<Number>(scale * x[c]));
  return result;
}

/// adds the edges of the border, and the number of the seam that each is a side of; -1 for none
inline void add_border(const Map_border& border, Packed_arrays& arrays)
{
  std::vector<std::uint32_t> ends;
  std::vector<std::int32_t> seams(border.number_of_edges(), -1);
  for(int k = 0; k < static_cast<int>(border.number_of_edges()); ++k)
    for(int end : {k, k + 1})
      ends.push_back(static_cast<std::uint32_t>(border.vertex(end)));
  for(const auto& [side, seam] : border.seam_sides())
    for(int k = 0; k < side.edges; ++k)
      seams[static_cast<std::size_t>(side.first + k) % seams.size()] = static_cast<std::int32_t>(seam);
  arrays.add("border", ends);
  arrays.add("seam", seams);
}

/// the arrays that the page draws, in 32 bits: points in diagonals of their box
inline Packed_arrays page_arrays(const Flat_map& map, const Job& job, const First_candidate& first)
{
  const auto stretch = [](const std::vector<double>& face_l2) {
    return std::vector<float>(face_l2.begin(), face_l2.end());
  };
  Packed_arrays arrays;
  arrays.add("points", packed<float>(in_box(map.points, map.box()), 1));
  arrays.add("normals", packed<std::int8_t>(map.normals, 127));
  std::vector<std::uint32_t> triangles;
  for(const auto& t : map.triangles)
    triangles.insert(triangles.end(), t.begin(), t.end());
  arrays.add("triangles", triangles);
  arrays.add("places", places(map.uv, job.result.aspect));
  arrays.add("stretch", stretch(job.result.measures.face_l2));
  if(first.reason.empty()) {
    arrays.add("places_first", places(first.uv, first.aspect));
    arrays.add("stretch_first", stretch(first.measures.face_l2));
  }
  add_border(Map_border(map, job), arrays);
  return arrays;
}

/// the scale of the colors, the same for both candidates
inline nlohmann::ordered_json scale_report(const Job& job, const First_candidate& first)
{
  std::vector<double> stretch = job.result.measures.face_l2;
  stretch.insert(stretch.end(), first.measures.face_l2.begin(), first.measures.face_l2.end());
  const Stretch_colors colors(std::move(stretch));
  nlohmann::ordered_json report{{"low", colors.stretch_at(0)}, {"high", colors.stretch_at(1)}};
  for(int level = 0; level < Stretch_colors::LEVELS; ++level)
    report["colors"].push_back(Stretch_colors::color(level));
  return report;
}

inline nlohmann::ordered_json first_candidate_report(const Job& job, const First_candidate& first)
{
  const CGAL_ext::Stretch_measures& measures = first.measures;
  return {{"candidate", 0},
          {"input_corners", input_corners(first.corners, job)},
          {"l2", number(measures.l2)},
          {"linf", number(measures.linf)},
          {"symmetric_dirichlet", number(measures.symmetric_dirichlet)},
          {"aspect", first.aspect},
          {"flipped", measures.flipped_faces}};
}

/// JSON inside a page: no text in it can end the script that it stands in
inline std::string json_in_page(const nlohmann::ordered_json& json)
{
  std::string text;
  for(char c : json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace))
    text += c == '<' ? std::string("\\u003c") : std::string(1, c);
  return text;
}

/// writes the page: the surface in space and on the square or the rectangle that it stands for, by one script that draws and one that holds the map, without
/// a request to anywhere. It does not depend on time and threads.
/// \param first the map of the first candidate; without one the page shows the best map alone
inline void write_page(std::ostream& stream, const Flat_map& map, const Job& job, const First_candidate& first)
{
  const Packed_arrays arrays = page_arrays(map, job, first);
  nlohmann::ordered_json page{{"report", map_report(job)},
                              {"first", nullptr},
                              {"no_first", first.reason},
                              {"scale", scale_report(job, first)},
                              {"arrays", arrays.layout()}};
  if(first.reason.empty())
    page["first"] = first_candidate_report(job, first);
  constexpr std::size_t SEAM_COLORS = 6;
  for(std::size_t k = 0; k < SEAM_COLORS; ++k)
    page["seam_colors"].push_back(seam_color(k));
  stream.precision(6);
  stream << page_before_data();
  if(has_curve(job.result.search)) {
    stream << "<template id='curve'><svg xmlns='http://www.w3.org/2000/svg' viewBox='0 660 800 240' "
              "font-family='sans-serif' font-size='18' fill='#222'>\n";
    write_curve(stream, job);
    stream << "</svg></template>\n";
  }
  stream << "<script type='application/json' id='page'>" << json_in_page(page) << "</script>\n"
         << "<script type='application/octet-stream' id='arrays'>" << base64(arrays.bytes()) << "</script>\n"
         << page_after_data();
}

} // namespace square_map

#endif // SQUARE_MAP_WRITE_PAGE_H
