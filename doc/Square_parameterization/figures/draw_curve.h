// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FIGURES_DRAW_CURVE_H
#define FIGURES_DRAW_CURVE_H

#include <CGAL_ext/Square_parameterization/Search_report.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

namespace figures {

/// what a strategy has evaluated
struct Strategy_samples
{
  std::string name;
  CGAL_ext::Search_report report;
};

/// the curve of all candidates, and below it one row of dots for each strategy: the candidates that it has mapped, and
/// the best of them as a larger dot
inline std::string curve_svg(const CGAL_ext::Search_report& all, const std::vector<Strategy_samples>& strategies)
{
  constexpr double LEFT = 130, RIGHT = 690, TOP = 20, BOTTOM = 220, ROW = 26;
  const auto [lowest, highest] = std::minmax_element(
      all.curve.begin(), all.curve.end(), [](const auto& a, const auto& b) { return a.objective < b.objective; });
  const double low = lowest->objective, high = highest->objective;
  const auto x = [&](int candidate) { return LEFT + (RIGHT - LEFT) * candidate / (all.candidates - 1); };
  const auto y = [&](double objective) { return BOTTOM - (objective - low) / (high - low) * (BOTTOM - TOP); };
  const double height = BOTTOM + 50 + ROW * double(strategies.size());
  std::ostringstream svg;
  svg.precision(5);
  svg << "<?xml version='1.0' encoding='UTF-8'?>\n<svg xmlns='http://www.w3.org/2000/svg' width='720' height='"
      << height << "' viewBox='0 0 720 " << height << "' font-family='sans-serif' font-size='13' fill='#222'>\n"
      << "<rect width='720' height='" << height << "' fill='white'/>\n<path fill='none' stroke='#0072b2' d='";
  for(std::size_t k = 0; k < all.curve.size(); ++k)
    svg << (k == 0 ? 'M' : 'L') << x(all.curve[k].candidate) << ' ' << y(all.curve[k].objective);
  svg << "'/>\n";
  for(double objective : {low, high})
    svg << "<text x='" << LEFT - 12 << "' y='" << y(objective) + 4 << "' text-anchor='end'>" << objective
        << "</text>\n";
  svg << "<text x='" << LEFT - 12 << "' y='" << (TOP + BOTTOM) / 2 << "' text-anchor='end'>L2 stretch</text>\n";
  for(int candidate : {0, all.candidates - 1})
    svg << "<text x='" << x(candidate) << "' y='" << BOTTOM + 24 << "' text-anchor='middle'>" << candidate
        << "</text>\n";
  svg << "<text x='" << (LEFT + RIGHT) / 2 << "' y='" << BOTTOM + 24 << "' text-anchor='middle'>candidate</text>\n";
  double row = BOTTOM + 52;
  for(const auto& [name, report] : strategies) {
    svg << "<path d='M" << LEFT << ' ' << row << 'H' << RIGHT << "' stroke='#ddd'/>\n<text x='" << LEFT - 12 << "' y='"
        << row + 4 << "' text-anchor='end'>" << name << "</text>\n";
    for(const auto& sample : report.curve) {
      const bool is_best = sample.candidate == *report.best_candidate;
      svg << "<circle cx='" << x(sample.candidate) << "' cy='" << row << "' r='" << (is_best ? 6 : 3) << "' fill='"
          << (is_best ? "#d55e00" : "#0072b2") << "'/>\n";
    }
    row += ROW;
  }
  svg << "</svg>\n";
  return svg.str();
}

} // namespace figures

#endif // FIGURES_DRAW_CURVE_H
