// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_JOB_H
#define SQUARE_MAP_JOB_H

#include "Command_line.h"
#include "First_candidate.h"
#include "Geometry_image.h"

#include <chrono>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace square_map {

/// seconds spent in each part of the run
struct Timings
{
  double read = 0, condition = 0, cut = 0, search = 0, final = 0, sample = 0, write = 0, total = 0;
};

/// measures the steps of a run
class Stopwatch
{
public:
  /// seconds since the last lap, or since the start
  double lap()
  {
    const Clock::time_point last = std::exchange(m_lap, Clock::now());
    return seconds(last, m_lap);
  }

  /// seconds since the start
  double total() const { return seconds(m_start, Clock::now()); }

private:
  typedef std::chrono::steady_clock Clock;

  static double seconds(Clock::time_point from, Clock::time_point to)
  {
    return std::chrono::duration<double>(to - from).count();
  }

  Clock::time_point m_start = Clock::now(), m_lap = m_start;
};

/// one run of the command: what was asked for, and what each step adds
struct Job
{
  explicit Job(Command_line command_line) : line(std::move(command_line)) {}
  Job(const Job&) = delete; // uv belongs to the mesh in this very place
  Job& operator=(const Job&) = delete;

  Command_line line;
  Passed_over passed_over; ///< of the file
  std::size_t input_vertices = 0, input_faces = 0;
  Vertex_colors input_colors; ///< of the vertices of the file; empty unless asked for
  CGAL_ext::internal::Conditioning_report conditioning;
  Mesh mesh;                                ///< conditioned, later cut and with split chords
  std::size_t uncut_vertices = 0;           ///< of the conditioned mesh
  UV_map uv;                                ///< of the mesh
  CGAL_ext::Square_map_result<Mesh> result; ///< of the map, made or not
  std::vector<int> originals;               ///< per vertex of the cut mesh, the vertex of the conditioned one;
                                            ///< vertices beyond were added
  std::string texture;                      ///< the bytes of a PNG file, for outputs that have one
  std::optional<Flat_map> flat;             ///< the map as arrays, for outputs that are made of it
  std::optional<Geometry_image> image;      ///< the samples, for outputs that are made of them
  std::optional<First_candidate> first;     ///< for the page
  Timings seconds;
};

/// indicates whether the map is the best so far, and not that of a whole run: nothing else stops a cut or a search
inline bool has_reached_time_limit(const Job& job)
{
  return job.result.search.is_cancelled || job.result.cut.is_cancelled;
}

} // namespace square_map

#endif // SQUARE_MAP_JOB_H
