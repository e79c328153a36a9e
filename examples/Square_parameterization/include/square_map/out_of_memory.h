// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_OUT_OF_MEMORY_H
#define SQUARE_MAP_OUT_OF_MEMORY_H

#include "Temporary_files.h"
#include "has_progress_line.h"

#include <signal.h>
#include <sys/mman.h>
#include <unistd.h>

#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>

namespace square_map {

/// what is told when there is no memory
constexpr char OUT_OF_MEMORY[] = "there is not enough memory for this surface";

/// Lack of memory is an exception like others, and ends in `main()`. Some lack cannot get there: there is no room for the
/// exception itself, or for the stack; GMP ends the process; and Eigen 3.4 frees an array twice when it cannot be made
/// longer. All this ends in one of these signals, whose handler calls only what a handler may call.
class Out_of_memory
{
public:
  /// lets such signals end the process with \p exit_status and the same words, without temporary files. Other crashes
  /// stay what they are, but leave no temporary files either.
  static void handle(int exit_status)
  {
    status = exit_status;
    std::set_new_handler([] {
      was_met = true;
      throw std::bad_alloc();
    });
    static const std::terminate_handler tell_and_abort = std::get_terminate();
    std::set_terminate([] {
      if(was_met)
        std::abort();
      tell_and_abort();
    });
    static char stack[1 << 16]; // for a handler that is called since the stack is full
    stack_t alternative = {};
    alternative.ss_sp = stack;
    alternative.ss_size = sizeof stack;
    sigaltstack(&alternative, nullptr);
    struct sigaction action = {};
    sigemptyset(&action.sa_mask);
    action.sa_flags = static_cast<int>(SA_ONSTACK | SA_RESETHAND);
    action.sa_handler = end;
    for(int signal : {SIGSEGV, SIGBUS, SIGABRT})
      sigaction(signal, &action, nullptr);
  }

private:
  /// a crash of a process that could not get this much more is taken for one for lack of memory
  static constexpr std::size_t LEAST_ROOM = 1 << 26; // bytes

  static void end(int signal)
  {
    temporary_files.remove_all();
    if(was_met || mmap(nullptr, LEAST_ROOM, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0) == MAP_FAILED) {
      for(const char* text : {has_progress_line ? "\n" : "", "square_map: ", OUT_OF_MEMORY, "\n"})
        [[maybe_unused]] const auto written = write(STDERR_FILENO, text, std::strlen(text));
      _exit(status);
    }
    raise(signal); // its handler is the default one by now
  }

  static inline std::atomic<bool> was_met{false};
  static inline std::atomic<int> status{0};
};

} // namespace square_map

#endif // SQUARE_MAP_OUT_OF_MEMORY_H
