// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_THREAD_WATCHER_H
#define CGAL_EXT_THREAD_WATCHER_H

#include <CGAL_ext/Square_parameterization/Search_visitor.h>

#include <chrono>
#include <set>
#include <thread>

/// sees which threads map candidates
struct Thread_watcher : CGAL_ext::Search_visitor
{
  void after_evaluation(const CGAL_ext::Search_report::Sample&) override
  {
    threads.insert(std::this_thread::get_id());
    std::this_thread::sleep_for(std::chrono::milliseconds(10)); // leaves a candidate to threads that are slow to wake
  }

  std::set<std::thread::id> threads;
};

#endif // CGAL_EXT_THREAD_WATCHER_H
