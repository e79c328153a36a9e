// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COMMON_THREAD_TEAM_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COMMON_THREAD_TEAM_H

#include <algorithm>
#include <atomic>
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

/// the number of threads that is meant by \p given
inline unsigned int number_of_threads(unsigned int given)
{
  return given != 0 ? given : default_number_of_threads();
}

/// runs independent tasks on a given number of threads, or on those that can be made: where the process has no room for
/// more of them the tasks are done by fewer. TBB, which has the loops for this, ends the process then, and what it
/// includes is an eighth of the memory that it takes to compile a program with this package.
///
/// The calling thread is one of the team. The others are made by the first call that has work for them, and wait from
/// then on: what a thread has as its own it keeps from call to call.
///
/// A task may call the team that it is a task of, which `current()` tells. Who waits for work takes tasks of the call
/// that began first: so many maps are shared out, and when fewer maps than threads are left, what is idle helps in the
/// loops of these.
class Thread_team
{
public:
  static constexpr std::size_t ANY_NUMBER = static_cast<std::size_t>(-1);

  /// \param threads their number; 0 for all cores
  explicit Thread_team(unsigned int threads) : m_most_helpers(std::size_t(number_of_threads(threads)) - 1) {}

  Thread_team(const Thread_team&) = delete;
  Thread_team& operator=(const Thread_team&) = delete;

  ~Thread_team()
  {
    {
      const std::lock_guard<std::mutex> lock(m_mutex);
      m_is_over = true;
      m_may_have_work = true;
    }
    m_work_has_come.notify_all();
    for(std::thread& helper : m_helpers)
      helper.join();
  }

  /// the team of which the calling thread does a task, or that was made its team by a `Scope`; else one of the calling
  /// thread alone
  static Thread_team& current()
  {
    static Thread_team alone(1);
    return place().team != nullptr ? *place().team : alone;
  }

  /// makes a team the current one of this thread for a while
  class Scope
  {
  public:
    explicit Scope(Thread_team& team) : m_before(std::exchange(place(), Place{&team, 0})) {}
    ~Scope() { place() = m_before; }
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;

  private:
    friend class Thread_team;
    Scope(Thread_team& team, unsigned int depth) : m_before(std::exchange(place(), Place{&team, depth})) {}

    struct Place
    {
      Thread_team* team = nullptr;
      unsigned int depth = 0; // of calls of the team in each other
    };
    Place m_before;
    static Place& place()
    {
      static thread_local Place result;
      return result;
    }
  };

  /// calls `task(i)` for each i in [0, count[. Of the exceptions that tasks throw the first comes out, when all tasks
  /// under way have ended; the others are not begun.
  /// \param most_at_once threads that work on these tasks, for tasks that need much memory
  template <class Task>
  void operator()(std::size_t count, const Task& task, std::size_t most_at_once = ANY_NUMBER)
  {
    if(count > 1 && most_at_once > 1 && m_number_of_helpers < (std::min)(m_most_helpers.load(), count - 1))
      make_helpers(count - 1);
    const unsigned int depth = place().team == this ? place().depth + 1 : 1;
    const Scope scope(*this, depth);
    if(count <= 1 || most_at_once <= 1 || m_number_of_helpers == 0) {
      for(std::size_t i = 0; i < count; ++i)
        task(i);
      return;
    }
    Call call{[&task](std::size_t i) { task(i); }, count, most_at_once, depth};
    std::unique_lock<std::mutex> lock(m_mutex);
    m_calls.push_back(&call);
    announce();
    for(std::size_t i = (std::min)({count - 1, most_at_once - 1, m_number_of_helpers.load()}); i > 0; --i)
      m_work_has_come.notify_one(); // as many as there is work for
    if(depth > 1)
      m_call_has_ended.notify_all(); // who waits for the task that this is a call of may help
    work(call, lock);
    while(call.busy > 0)
      if(Call* other = call_with_work(depth + 1)) // of a task that this one waits for
        work(*other, lock);
      else
        wait_for_end(call, lock);
    m_calls.erase(std::find(m_calls.begin(), m_calls.end(), &call));
    if(call.exception)
      std::rethrow_exception(call.exception);
  }

private:
  typedef Scope::Place Place;
  static Place& place() { return Scope::place(); }

  /// one use of the operator
  struct Call
  {
    std::function<void(std::size_t)> task;
    std::size_t count, most_at_once;
    unsigned int depth;
    std::size_t next = 0;             // task to begin
    std::atomic<std::size_t> busy{0}; // threads that work on it
    std::exception_ptr exception = nullptr;

    Call(std::function<void(std::size_t)> task_of, std::size_t count_of, std::size_t most, unsigned int depth_of)
      : task(std::move(task_of)), count(count_of), most_at_once(most), depth(depth_of)
    {}

    bool has_work() const { return next < count && busy < most_at_once; }
  };

  /// looks that a thread takes for work before it sleeps: to wake it takes as long as a short loop
  static constexpr int LOOKS = 20000;

  /// makes threads until there are as many as have work, or no more can be had
  void make_helpers(std::size_t number)
  {
    const std::lock_guard<std::mutex> lock(m_making);
    try {
      while(m_helpers.size() < (std::min)(number, m_most_helpers.load())) {
        m_helpers.emplace_back([this] { help(); });
        m_number_of_helpers = m_helpers.size();
      }
    } catch(const std::system_error&) { // a limit of threads, or no room for a stack
      m_most_helpers = m_helpers.size();
    } catch(const std::bad_alloc&) {
      m_most_helpers = m_helpers.size();
    }
  }

  /// the call that began first of those that a thread can take tasks of; null when there is none
  Call* call_with_work(unsigned int least_depth) const
  {
    for(Call* call : m_calls)
      if(call->depth >= least_depth && call->has_work())
        return call;
    return nullptr;
  }

  /// lets those see it that look for work
  void announce() { m_may_have_work = m_is_over || call_with_work(0) != nullptr; }

  /// what a thread of the team does
  void help()
  {
    std::unique_lock<std::mutex> lock(m_mutex);
    while(!m_is_over)
      if(Call* call = call_with_work(0)) {
        work(*call, lock);
      } else {
        lock.unlock();
        for(int i = 0; i < LOOKS && !m_may_have_work; ++i)
          pause(i);
        lock.lock();
        m_work_has_come.wait(lock, [this] { return m_is_over || call_with_work(0) != nullptr; });
      }
  }

  /// does tasks of a call until none is left to begin
  void work(Call& call, std::unique_lock<std::mutex>& lock)
  {
    const Scope scope(*this, call.depth);
    ++call.busy;
    while(call.next < call.count) {
      const std::size_t i = call.next++;
      if(call.next == call.count)
        announce();
      lock.unlock();
      std::exception_ptr exception;
      try {
        call.task(i);
      } catch(...) {
        exception = std::current_exception();
      }
      lock.lock();
      if(!exception)
        continue;
      call.next = call.count; // what has not begun is left
      announce();
      if(!call.exception)
        call.exception = exception;
    }
    if(--call.busy == 0)
      m_call_has_ended.notify_all();
  }

  /// waits until a call has ended, or there may be work
  void wait_for_end(const Call& call, std::unique_lock<std::mutex>& lock)
  {
    lock.unlock();
    for(int i = 0; i < LOOKS && call.busy > 0 && !m_may_have_work; ++i)
      pause(i);
    lock.lock();
    m_call_has_ended.wait(lock, [&] { return call.busy == 0 || call_with_work(call.depth + 1) != nullptr; });
  }

  /// the other threads of a machine that has no core to spare go first
  static void pause(int look)
  {
    if(look % 64 == 63)
      std::this_thread::yield();
  }

  std::atomic<std::size_t> m_most_helpers, m_number_of_helpers{0};
  std::mutex m_making;                // guards what follows
  std::vector<std::thread> m_helpers; // beside the calling thread

  std::mutex m_mutex; // guards what follows
  std::condition_variable m_work_has_come, m_call_has_ended;
  std::vector<Call*> m_calls; // under way, in the order in which they began
  bool m_is_over = false;

  std::atomic<bool> m_may_have_work{false};
};

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COMMON_THREAD_TEAM_H
