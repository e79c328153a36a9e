// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COMMON_THREAD_TEAM_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COMMON_THREAD_TEAM_H

#include <algorithm>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <new>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// the number of threads that 0 stands for
inline unsigned int default_number_of_threads()
{
  return (std::max)(1u, std::thread::hardware_concurrency());
}

/// runs independent tasks on a given number of threads, or on those that can be made: where the process has no room for
/// more of them the tasks are done by fewer. TBB, which has the loops for this, ends the process then, and what it
/// includes is an eighth of the memory that it takes to compile a program with this package.
///
/// The calling thread is one of the team. The others are made by the first call that has work for them, and wait from
/// then on: what a thread has as its own it keeps from call to call.
class Thread_team
{
public:
  /// \param number_of_threads 0 for all cores
  /// \param most_tasks at a time: more threads would have nothing to do
  Thread_team(unsigned int number_of_threads, int most_tasks)
    : m_most_helpers((std::min)(number_of_threads != 0 ? number_of_threads : default_number_of_threads(),
                                static_cast<unsigned int>((std::max)(most_tasks, 1))) -
                     1)
  {}

  Thread_team(const Thread_team&) = delete;
  Thread_team& operator=(const Thread_team&) = delete;

  ~Thread_team()
  {
    {
      const std::lock_guard<std::mutex> lock(m_mutex);
      m_is_over = true;
    }
    m_work_has_come.notify_all();
    for(std::thread& helper : m_helpers)
      helper.join();
  }

  /// calls `task(i)` for each i in [0, count[. Of the exceptions that tasks throw the first comes out, when all tasks
  /// under way have ended; the others are not begun. Called by one thread at a time, and not by a task of this team.
  template <class Task>
  void operator()(std::size_t count, const Task& task)
  {
    if(count > 1 && m_helpers.size() < m_most_helpers)
      make_helpers((std::min)(m_most_helpers, count - 1));
    if(count <= 1 || m_helpers.empty()) {
      for(std::size_t i = 0; i < count; ++i)
        task(i);
      return;
    }
    std::unique_lock<std::mutex> lock(m_mutex);
    m_task = [&task](std::size_t i) { task(i); };
    m_next = 0;
    m_count = count;
    m_work_has_come.notify_all();
    work(lock);
    m_work_is_done.wait(lock, [this] { return m_busy == 0; });
    m_task = nullptr;
    if(m_exception)
      std::rethrow_exception(std::exchange(m_exception, nullptr));
  }

private:
  /// makes threads until there are as many as asked for, or no more can be had
  void make_helpers(std::size_t number)
  {
    try {
      m_helpers.reserve(number);
      while(m_helpers.size() < number)
        m_helpers.emplace_back([this] { help(); });
    } catch(const std::system_error&) { // a limit of threads, or no room for a stack
      m_most_helpers = m_helpers.size();
    } catch(const std::bad_alloc&) {
      m_most_helpers = m_helpers.size();
    }
  }

  /// what a thread of the team does
  void help()
  {
    std::unique_lock<std::mutex> lock(m_mutex);
    for(;;) {
      m_work_has_come.wait(lock, [this] { return m_is_over || m_next < m_count; });
      if(m_is_over)
        return;
      work(lock);
      if(m_busy == 0)
        m_work_is_done.notify_one();
    }
  }

  /// does tasks until none is left to begin
  void work(std::unique_lock<std::mutex>& lock)
  {
    ++m_busy;
    while(m_next < m_count) {
      const std::size_t i = m_next++;
      lock.unlock();
      std::exception_ptr exception;
      try {
        m_task(i);
      } catch(...) {
        exception = std::current_exception();
      }
      lock.lock();
      if(!exception)
        continue;
      m_next = m_count; // what has not begun is left
      if(!m_exception)
        m_exception = exception;
    }
    --m_busy;
  }

  std::size_t m_most_helpers;
  std::vector<std::thread> m_helpers; // beside the calling thread

  std::mutex m_mutex; // guards what follows
  std::condition_variable m_work_has_come, m_work_is_done;
  std::function<void(std::size_t)> m_task;
  std::size_t m_next = 0, m_count = 0; // the tasks to begin
  std::size_t m_busy = 0;              // threads that work
  std::exception_ptr m_exception;
  bool m_is_over = false;
};

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COMMON_THREAD_TEAM_H
