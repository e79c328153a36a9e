// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PAPER_TABLES_FIGURES_H
#define PAPER_TABLES_FIGURES_H

#include "experiment.h"

#include <cmath>
#include <ostream>

namespace paper_tables {

constexpr int WIDTH = 640, HEIGHT = 320, MARGIN = 75;

inline void begin_svg(std::ostream& svg, const std::string& title)
{
  svg << "<svg xmlns='http://www.w3.org/2000/svg' width='" << WIDTH << "' height='" << HEIGHT
      << "' font-family='sans-serif' font-size='12'>\n<rect width='100%' height='100%' fill='white'/>\n<text x='"
      << WIDTH / 2 << "' y='20' text-anchor='middle'>" << title << "</text>\n";
}

/// stretch over candidates, with the best (red circle), single highest (yellow triangle) and many high (green square):
/// figure 5 of the paper
inline void write_stretch_curve(std::ostream& svg, const Experiment& experiment)
{
  double least = experiment.runs.at("quarter-brute-force").l2, largest = least;
  for(const auto& sample : experiment.curve)
    if(std::isfinite(sample.objective))
      largest = (std::max)(largest, sample.objective);
  const double range = largest > least ? largest - least : 1;
  const auto x = [&](int candidate) {
    return MARGIN + (WIDTH - 2. * MARGIN) * candidate / (std::max)(1, experiment.candidates - 1);
  };
  const auto y = [&](double stretch) { return HEIGHT - MARGIN - (HEIGHT - 2. * MARGIN) * (stretch - least) / range; };

  begin_svg(svg, experiment.name + ": L2 stretch of the candidates of the quarter");
  svg << "<path fill='none' stroke='black' d='";
  bool is_drawing = false;
  for(const auto& sample : experiment.curve) { // a candidate without a map leaves a gap
    if(std::isfinite(sample.objective))
      svg << (is_drawing ? 'L' : 'M') << x(sample.candidate) << ' ' << y(sample.objective) << ' ';
    is_drawing = std::isfinite(sample.objective);
  }
  svg << "'/>\n";
  const auto place = [&](const char* strategy) {
    const Run& run = experiment.runs.at(strategy);
    return "transform='translate(" + std::to_string(x(run.candidate)) + "," + std::to_string(y(run.l2)) + ")'";
  };
  svg << "<rect x='-5' y='-5' width='10' height='10' fill='limegreen' stroke='black' " << place("many-high") << "/>\n"
      << "<path d='M0 -7L6 5L-6 5Z' fill='yellow' stroke='black' " << place("single-highest") << "/>\n"
      << "<circle r='4' fill='red' stroke='black' " << place("quarter-brute-force") << "/>\n"
      << "<text x='" << MARGIN - 5 << "' y='" << y(least) << "' text-anchor='end'>" << least << "</text>\n"
      << "<text x='" << MARGIN - 5 << "' y='" << y(largest) << "' text-anchor='end'>" << largest << "</text>\n"
      << "<text x='" << WIDTH / 2 << "' y='" << HEIGHT - 10 << "' text-anchor='middle'>candidate 0 to "
      << experiment.candidates - 1 << "</text>\n</svg>\n";
}

/// share of the time of the quarter brute force that a strategy saves, in per cent
inline double saving(const Experiment& experiment, const char* strategy)
{
  return 100 * (1 - experiment.runs.at(strategy).seconds / experiment.runs.at("quarter-brute-force").seconds);
}

/// reduction of time by step sampling (grey) and hybrid (blue) against the quarter brute force: figure 6 of the paper.
/// A strategy that takes longer has no bar.
inline void write_bar_chart(std::ostream& svg, const std::vector<Experiment>& experiments)
{
  begin_svg(svg, "reduction of time against the quarter brute force, per cent (grey: step sampling, blue: hybrid)");
  const double slot = (WIDTH - 2. * MARGIN) / double((std::max)(std::size_t(1), experiments.size()));
  const double scale = (HEIGHT - 2. * MARGIN) / 100;
  for(std::size_t i = 0; i < experiments.size(); ++i)
    for(int bar = 0; bar < 2; ++bar) {
      const double value = (std::max)(0., saving(experiments[i], bar == 0 ? "step-sampling" : "hybrid"));
      svg << "<rect x='" << MARGIN + slot * (double(i) + 0.1 + 0.4 * bar) << "' y='" << HEIGHT - MARGIN - scale * value
          << "' width='" << 0.4 * slot << "' height='" << scale * value << "' fill='"
          << (bar == 0 ? "grey" : "steelblue") << "'><title>" << experiments[i].name << ": " << value
          << "</title></rect>\n";
    }
  svg << "<path stroke='black' d='M" << MARGIN << ' ' << HEIGHT - MARGIN << "H" << WIDTH - MARGIN << "'/>\n";
  for(std::size_t i = 0; i < experiments.size(); ++i)
    svg << "<text font-size='9' text-anchor='end' transform='translate(" << MARGIN + slot * (double(i) + 0.6) << ','
        << HEIGHT - MARGIN + 10 << ") rotate(-30)'>" << experiments[i].name << "</text>\n";
  for(int percent = 0; percent <= 100; percent += 25)
    svg << "<text x='" << MARGIN - 5 << "' y='" << HEIGHT - MARGIN - scale * percent << "' text-anchor='end'>"
        << percent << "</text>\n";
  svg << "</svg>\n";
}

} // namespace paper_tables

#endif // PAPER_TABLES_FIGURES_H
