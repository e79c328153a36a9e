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
    Thread_team team(threads, 100);
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
  Thread_team team(4, 100);
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
    Thread_team team(threads, 100);
    for(int call = 0; call < 3; ++call) {
      std::atomic<int> begun{0};
      CHECK_THROWS_WITH(team(100000,
                             [&](std::size_t i) {
                               ++begun;
                               if(i == 5)
                                 throw std::runtime_error("task 5");
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

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) // which need more address space than there is
TEST_CASE("where no thread can be made the tasks are done by those there are")
{
  const pid_t child = fork();
  if(child == 0) { // the limit would stay
    std::atomic<int> done{0};
    Thread_team team(8, 8);
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
