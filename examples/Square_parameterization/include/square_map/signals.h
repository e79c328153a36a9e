// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_SIGNALS_H
#define SQUARE_MAP_SIGNALS_H

#include "Temporary_files.h"
#include "has_progress_line.h"

#include <poll.h>
#include <signal.h>
#include <unistd.h>

#include <atomic>
#include <cstring>

namespace square_map {

/// what a signal finds the process at
enum class Run_phase
{
  WORKING,    ///< no output has been touched: a signal ends the process
  COMMITTING, ///< the outputs take their places, in a moment that must not be torn: signals are passed over
  COMMITTED,  ///< the outputs have their places: the first signal is passed over, a second one ends the process
  ENDING      ///< by a signal
};

inline std::atomic<Run_phase> run_phase{Run_phase::WORKING};

/// The process ends in the handler, whatever it is at: cutting, mapping, or waiting for a reader. This leaves nothing
/// to undo, for outputs are written elsewhere until they take their places. It calls only what a handler may call, and waits
/// for nobody: where the pipe for messages is full the process ends without one.
extern "C" inline void square_map_end_by_signal(int signal)
{
  static std::atomic<bool> was_passed_over{false};
  Run_phase phase = Run_phase::WORKING;
  run_phase.compare_exchange_strong(phase, Run_phase::ENDING);
  if(phase == Run_phase::ENDING)
    return; // another thread is at it, and has its message still to write
  const bool is_first = !was_passed_over && phase != Run_phase::WORKING;
  if(is_first || phase == Run_phase::COMMITTING) {
    was_passed_over = true;
    return;
  }
  temporary_files.remove_all();
  const char* const message = signal == SIGINT    ? "square_map: interrupted by SIGINT; no file was replaced\n"
                              : signal == SIGTERM ? "square_map: ended by SIGTERM; no file was replaced\n"
                              : signal == SIGHUP  ? "square_map: ended by SIGHUP; no file was replaced\n"
                              : signal == SIGQUIT ? "square_map: ended by SIGQUIT; no file was replaced\n"
                                                  : "square_map: no processor time is left; no file was replaced\n";
  pollfd error{STDERR_FILENO, POLLOUT, 0};
  if(phase == Run_phase::WORKING && poll(&error, 1, 0) == 1)
    for(const char* text : {has_progress_line ? "\n" : "", message})
      [[maybe_unused]] const auto written = write(STDERR_FILENO, text, std::strlen(text));
  _exit(128 + signal);
}

/// lets signals end the process with status 128 + signal and without temporary files, and lets writing to a pipe without
/// reader, or beyond the limit of a file, fail. A signal that the caller has the process ignore, as nohup does, stays
/// ignored.
inline void handle_signals()
{
  struct sigaction action = {};
  sigemptyset(&action.sa_mask);
  action.sa_flags = SA_RESTART;
  for(int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGXCPU}) {
    struct sigaction former = {};
    action.sa_handler = square_map_end_by_signal;
    if(sigaction(signal, nullptr, &former) == 0 && former.sa_handler != SIG_IGN)
      sigaction(signal, &action, nullptr);
  }
  action.sa_handler = SIG_IGN;
  for(int signal : {SIGPIPE, SIGXFSZ})
    sigaction(signal, &action, nullptr);
}

/// from here on signals are passed over; does not return when one has already come
inline void begin_commit()
{
  Run_phase phase = Run_phase::WORKING;
  if(!run_phase.compare_exchange_strong(phase, Run_phase::COMMITTING) && phase == Run_phase::ENDING)
    for(;;)
      pause();
}

/// a second signal ends the process again
inline void end_commit()
{
  run_phase = Run_phase::COMMITTED;
}

} // namespace square_map

#endif // SQUARE_MAP_SIGNALS_H
