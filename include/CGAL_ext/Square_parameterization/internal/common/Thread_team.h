// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COMMON_THREAD_TEAM_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COMMON_THREAD_TEAM_H

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cstddef>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// runs a task that may be parallel itself, so that its thread takes up no other tasks while it waits: what a thread
/// does with a mutex locked
template <class Task>
auto run_isolated(const Task& task)
{
  return tbb::this_task_arena::isolate(task);
}

/// runs independent tasks on a given number of threads
class Thread_team
{
public:
  /// \param number_of_threads 0 for all cores
  /// \param most_tasks at a time: more threads would have nothing to do
  Thread_team(unsigned int number_of_threads, int most_tasks)
    : m_limit(tbb::global_control::max_allowed_parallelism,
              thread_limit(useful_threads(number_of_threads, most_tasks))),
      m_arena(number_of_threads == 0 ? static_cast<int>(tbb::task_arena::automatic)
                                     : useful_threads(number_of_threads, most_tasks))
  {}

  /// calls `task(i)` for each i in [0, count[; an exception that a task throws comes out
  template <class Task>
  void operator()(std::size_t count, const Task& task)
  {
    m_arena.execute([&] {
      tbb::parallel_for(
          tbb::blocked_range<std::size_t>(0, count, 1),
          [&](const auto& range) {
            for(std::size_t i = range.begin(); i != range.end(); ++i)
              task(i);
          },
          tbb::simple_partitioner());
    });
  }

private:
  static int useful_threads(unsigned int number_of_threads, int most_tasks)
  {
    return static_cast<int>((std::min)(number_of_threads, static_cast<unsigned int>(most_tasks)));
  }

  /// TBB has as many threads as cores unless it is allowed more
  static std::size_t thread_limit(int number_of_threads)
  {
    return (std::max)(static_cast<std::size_t>(number_of_threads),
                      tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
  }

  tbb::global_control m_limit;
  tbb::task_arena m_arena;
};

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COMMON_THREAD_TEAM_H
