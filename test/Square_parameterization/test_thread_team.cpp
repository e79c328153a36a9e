// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL_ext/Square_parameterization/internal/common/Thread_team.h>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>

#include <atomic>
#include <chrono>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

using CGAL_ext::internal::Thread_team;

TEST_CASE("a team does each task once, whatever the numbers of threads and tasks, and again")
{
  for(unsigned int threads : {0u, 1u, 2u, 7u}) {
    Thread_team team(threads);
    for(std::size_t count : {0u, 1u, 2u, 5u, 1000u, 3u}) {
      std::vector<int> calls(count, 0);
      team(count, [&](std::size_t i) { ++calls[i]; });
      CHECK(calls == std::vector<int>(count, 1));
    }
  }
}

TEST_CASE("a team has as many threads as asked for, and keeps them")
{
  std::mutex mutex;
  std::set<std::thread::id> threads;
  std::atomic<int> met{0};
  Thread_team team(4);
  for(int call = 0; call < 2; ++call) {
    met = 0;
    std::atomic<int> complete{0}; // Catch counts for one thread at a time
    team(4, [&](std::size_t) {    // ends when all four are under way
      {
        const std::lock_guard<std::mutex> lock(mutex);
        threads.insert(std::this_thread::get_id());
      }
      ++met;
      const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
      while(met < 4 && std::chrono::steady_clock::now() < end)
        std::this_thread::yield();
      complete += met == 4 ? 1 : 0;
    });
    CHECK(complete == 4);
  }
  CHECK(threads.size() == 4);
  CHECK(threads.count(std::this_thread::get_id()) == 1);
}

TEST_CASE("an exception of a task comes out, and the team is as good as before")
{
  for(unsigned int threads : {1u, 3u}) {
    Thread_team team(threads);
    for(int call = 0; call < 3; ++call) {
      std::atomic<int> begun{0};
      CHECK_THROWS_WITH(team(100000,
                             [&](std::size_t i) {
                               ++begun;
                               if(i == 5)
                                 throw std::runtime_error("task 5");
                               if(i > 5) // seconds of tasks, for a thread that is kept from telling of its exception
                                 std::this_thread::sleep_for(std::chrono::microseconds(100));
                             }),
                        "task 5");
      CHECK(begun >= 1);
      CHECK(begun < 100000);
    }
    int sum = 0;
    std::mutex mutex;
    team(10, [&](std::size_t i) {
      const std::lock_guard<std::mutex> lock(mutex);
      sum += static_cast<int>(i);
    });
    CHECK(sum == 45);
  }
}

TEST_CASE("tasks may call their team, and each task is done once")
{
  for(unsigned int threads : {1u, 2u, 5u}) {
    Thread_team team(threads);
    for(std::size_t count : {1u, 2u, 9u}) {
      std::vector<std::vector<int>> calls(count, std::vector<int>(300, 0));
      std::atomic<int> strangers{0};
      team(count, [&](std::size_t i) {
        for(int repetition = 0; repetition < 20; ++repetition)
          Thread_team::current()(calls[i].size(), [&](std::size_t k) {
            ++calls[i][k];
            strangers += &Thread_team::current() == &team ? 0 : 1;
          });
      });
      CHECK(calls == std::vector<std::vector<int>>(count, std::vector<int>(300, 20)));
      CHECK(strangers == 0);
    }
  }
}

TEST_CASE("the current team is that of the task or of the scope, and else the calling thread alone")
{
  Thread_team team(3), other(2);
  const auto threads_of_current = [] {
    std::mutex mutex;
    std::set<std::thread::id> threads;
    Thread_team::current()(50, [&](std::size_t) {
      const std::lock_guard<std::mutex> lock(mutex);
      threads.insert(std::this_thread::get_id());
    });
    return threads;
  };
  CHECK(threads_of_current() == std::set<std::thread::id>{std::this_thread::get_id()});
  {
    const Thread_team::Scope scope(team);
    CHECK(&Thread_team::current() == &team);
    {
      const Thread_team::Scope inner(other);
      CHECK(&Thread_team::current() == &other);
    }
    CHECK(&Thread_team::current() == &team);
    other(1, [&](std::size_t) { CHECK(&Thread_team::current() == &other); });
    CHECK(&Thread_team::current() == &team);
  }
  CHECK(threads_of_current() == std::set<std::thread::id>{std::this_thread::get_id()});
}

TEST_CASE("threads without a task of their own help with the calls of the tasks that are left")
{
  Thread_team team(3);
  std::atomic<int> met{0};
  std::atomic<bool> have_met{false};
  team(4, [&](std::size_t i) {
    if(i != 3)
      return;
    Thread_team::current()(3, [&](std::size_t) { // ends when all three are under way
      ++met;
      const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
      while(met < 3 && std::chrono::steady_clock::now() < end)
        std::this_thread::yield();
      have_met = met == 3;
    });
  });
  CHECK(have_met);
}

TEST_CASE("no more tasks are under way at a time than are allowed")
{
  Thread_team team(4);
  for(std::size_t most : {1u, 2u}) {
    std::atomic<std::size_t> under_way{0}, excess{0}, done{0};
    team(
        40,
        [&](std::size_t) {
          if(++under_way > most)
            ++excess;
          std::this_thread::sleep_for(std::chrono::milliseconds(1));
          Thread_team::current()(10, [&](std::size_t) { ++done; });
          --under_way;
        },
        most);
    CHECK(excess == 0);
    CHECK(done == 400);
  }
}

TEST_CASE("an exception of a call in a call comes out of both")
{
  Thread_team team(3);
  for(int repetition = 0; repetition < 50; ++repetition)
    CHECK_THROWS_WITH(team(8,
                           [](std::size_t i) {
                             Thread_team::current()(100, [i](std::size_t k) {
                               if(i == 2 && k == 7)
                                 throw std::runtime_error("task 7 of task 2");
                             });
                           }),
                      "task 7 of task 2");
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) // which need more address space than there is
TEST_CASE("where no thread can be made the tasks are done by those there are")
{
  const pid_t child = fork();
  if(child == 0) { // the limit would stay
    std::atomic<int> done{0};
    Thread_team team(8);
    rlimit limit{1 << 20, 1 << 20}; // of the address space: less than there is already, and no room for a stack
    if(setrlimit(RLIMIT_AS, &limit) != 0)
      _exit(2);
    team(100, [&done](std::size_t) { ++done; });
    _exit(done == 100 ? 0 : 1);
  }
  int status = -1;
  waitpid(child, &status, 0);
  CHECK(WIFEXITED(status));
  CHECK(WEXITSTATUS(status) == 0);
}
#endif
