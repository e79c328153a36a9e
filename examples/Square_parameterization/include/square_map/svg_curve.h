// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_SVG_CURVE_H
#define SQUARE_MAP_SVG_CURVE_H

#include "Job.h"
#include "svg_faces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <ostream>
#include <string>
#include <vector>

namespace square_map {

/// how many significant digits two positive numbers need to differ in the last two
inline int digits_to_tell_apart(double low, double high)
{
  return (std::clamp)(static_cast<int>(std::ceil(std::log10(high / (high - low)))) + 2, 3, 9);
}

/// indicates whether several candidates were compared
inline bool has_curve(const CGAL_ext::Search_report& search)
{
  return (std::max)(search.curve.size(), search.sketched_curve.size()) > 1;
}

/// the curve of the objective over the candidates: those that were mapped, or sketched when these are more, joined by
/// lines, and the best of them
inline void write_curve(std::ostream& stream, const Job& job)
{
  constexpr double LEFT = 70, RIGHT = 740, TOP = 690, BOTTOM = 850;
  const CGAL_ext::Search_report& search = job.result.search;
  const bool is_sketched = search.sketched_curve.size() > search.curve.size();
  const std::vector<CGAL_ext::Search_report::Sample>& curve = is_sketched ? search.sketched_curve : search.curve;
  double low = std::numeric_limits<double>::infinity(), high = 0;
  for(const auto& sample : curve)
    if(std::isfinite(sample.objective)) {
      low = (std::min)(low, sample.objective);
      high = (std::max)(high, sample.objective);
    }
  if(!(high > low * (1 + 1e-9)))
    high = low * (1 + 1e-9) + 1e-9;
  const double span = (std::max)(search.candidates - 1, 1);
  const auto x = [&](double candidate) { return LEFT + candidate / span * (RIGHT - LEFT); };
  const auto y = [&](double objective) { return BOTTOM - (objective - low) / (high - low) * (BOTTOM - TOP); };

  stream << "<path d='M" << LEFT << ' ' << TOP - 8 << 'V' << BOTTOM + 6 << 'H' << RIGHT
         << "' fill='none' stroke='#222'/>\n<path fill='none' stroke='#8899aa' d='";
  char command = 'M';
  for(const auto& sample : curve) {
    if(std::isfinite(sample.objective))
      stream << command << x(sample.candidate) << ' ' << y(sample.objective);
    command = std::isfinite(sample.objective) ? 'L' : 'M'; // a candidate without a map parts the curve
  }
  stream << "'/>\n";
  const double radius = curve.size() > 200 ? 1.5 : 3;
  for(const auto& sample : curve)
    if(std::isfinite(sample.objective)) {
      const bool is_best = search.best_candidate && sample.candidate == *search.best_candidate;
      stream << "<circle cx='" << x(sample.candidate) << "' cy='" << y(sample.objective) << "' r='"
             << (is_best ? 6 : radius) << "' fill='" << (is_best ? "#d55e00" : "#0072b2") << "'/>\n";
    }
  for(double objective : {low, high})
    write_text(stream, LEFT - 6, y(objective) + 4, "end", rounded(objective, digits_to_tell_apart(low, high)));
  write_text(stream, LEFT, BOTTOM + 22, "middle", "0");
  write_text(stream, RIGHT, BOTTOM + 22, "middle", std::to_string(search.candidates - 1));
  write_text(stream, (LEFT + RIGHT) / 2, BOTTOM + 38, "middle",
             "candidate: " + std::to_string(curve.size()) + " of " + std::to_string(search.candidates) +
                 (is_sketched ? " sketched, the best is " : " mapped, the best is ") +
                 std::to_string(*search.best_candidate) + (search.has_moved_corners ? "; its corners then moved" : ""));
  write_text(stream, LEFT, TOP - 16, "start",
             is_sketched                       ? "balanced energy on a coarse mesh"
             : job.line.minimizer == "optimal" ? "balanced energy"
                                               : "L2 stretch");
}

} // namespace square_map

#endif // SQUARE_MAP_SVG_CURVE_H
