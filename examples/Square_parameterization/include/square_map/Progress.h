// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_PROGRESS_H
#define SQUARE_MAP_PROGRESS_H

#include "has_progress_line.h"
#include "option_list.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <limits>
#include <string>

namespace square_map {

/// one line on a terminal that tells what is being done, which share of it is done, and how long the rest may take. The
/// line is gone when the work is; without a terminal there is none.
class Progress : public CGAL_ext::Search_visitor
{
public:
  explicit Progress(const Command_line& line) : m_line(line), m_is_shown(!line.is_quiet && isatty(STDERR_FILENO) != 0)
  {}

  ~Progress() override { clear(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// begins a part of the work
  void start(const std::string& phase)
  {
    m_phase = phase;
    m_start = Clock::now();
    show("");
  }

  /// removes the line
  void clear()
  {
    if(m_is_shown && m_width > 0)
      std::cerr << '\r' << std::string(m_width, ' ') << '\r' << std::flush;
    m_width = 0;
    has_progress_line = false;
  }

  void cut_progress(double share) override
  {
    if(share <= 0)
      start("cutting");
    else if(share < 1)
      show(std::to_string(static_cast<int>(100 * share)) + " %" + time_left("about", share));
    else if(m_line.corners) // there is no search, which would tell
      start("mapping");
  }

  void start_search(std::size_t candidates) override
  {
    m_evaluations = m_sketches = m_corner_moves = 0;
    m_most_evaluations = most_evaluations(candidates);
    start("searching");
  }

  void after_evaluation(const CGAL_ext::Search_report::Sample& sample) override
  {
    continue_with("searching");
    m_best = (std::min)(m_best, sample.objective);
    ++m_evaluations;
    char best[32];
    std::snprintf(best, sizeof best, "%.6g", m_best);
    show(std::to_string(m_evaluations) + " of at most " + std::to_string(m_most_evaluations) + " candidates, least " +
         (m_line.minimizer == "optimal" ? "energy " : "stretch ") + best +
         time_left("at most about", double(m_evaluations) / double(m_most_evaluations)));
  }

  void after_sketch(const CGAL_ext::Search_report::Sample& /* sample */) override
  {
    continue_with("searching");
    show(counted(++m_sketches, "candidate sketched", "candidates sketched")); // how many will be is not known
    m_start = Clock::now();                                                   // of what time is estimated for
  }

  void after_corner_move() override
  {
    continue_with("moving corners");
    show(counted(++m_corner_moves, "choice compared", "choices compared"));
  }

  void start_minimization() override { start("mapping"); }

private:
  typedef std::chrono::steady_clock Clock;

  /// begins a part of the work, unless it is what was being done
  void continue_with(const std::string& phase)
  {
    if(m_phase != phase)
      start(phase);
  }

  /// how many of the candidates a strategy evaluates at most, where its page tells
  std::size_t most_evaluations(std::size_t candidates) const
  {
    std::size_t most = candidates;
    if(m_line.strategy == "none")
      most = 1;
    else if(m_line.candidates)
      most = static_cast<std::size_t>(m_line.candidates->size());
    else if(m_line.strategy == "bracketing")
      most = (std::max)(std::size_t(12), static_cast<std::size_t>(2 * std::log2(double(candidates))) + 4);
    return (std::min)(most, candidates);
  }

  /// the time that the rest of this part takes when it goes on as it has begun
  std::string time_left(const char* bound, double share) const
  {
    const double seconds = std::chrono::duration<double>(Clock::now() - m_start).count() * (1 - share) / share;
    if(share >= 1 || seconds < 0.5)
      return "";
    const long whole = std::lround(seconds);
    const std::string time = whole < 120 ? std::to_string(whole) + " s" : std::to_string((whole + 30) / 60) + " min";
    return std::string(", ") + bound + ' ' + time + " left";
  }

  /// shows the line, as much of it as the terminal has columns
  void show(const std::string& words)
  {
    if(!m_is_shown)
      return;
    std::string text = m_phase + (words.empty() ? "" : ": " + words);
    winsize terminal = {};
    if(ioctl(STDERR_FILENO, TIOCGWINSZ, &terminal) == 0 && terminal.ws_col > 1)
      text.resize((std::min)(text.size(), std::size_t(terminal.ws_col) - 1));
    const std::size_t width = text.size();
    text.resize((std::max)(text.size(), m_width), ' '); // over what is left of the line before
    has_progress_line = true;
    std::cerr << '\r' << text << std::flush;
    m_width = width;
  }

  const Command_line& m_line;
  const bool m_is_shown;
  std::string m_phase;
  Clock::time_point m_start;
  std::size_t m_width = 0; ///< of the line that is shown
  std::size_t m_evaluations = 0, m_most_evaluations = 0, m_sketches = 0, m_corner_moves = 0;
  double m_best = std::numeric_limits<double>::infinity();
};

} // namespace square_map

#endif // SQUARE_MAP_PROGRESS_H
