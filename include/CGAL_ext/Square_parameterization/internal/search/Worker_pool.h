// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SEARCH_WORKER_POOL_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SEARCH_WORKER_POOL_H

#include <functional>
#include <mutex>
#include <utility>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// workers, each with memory of its own, of which threads borrow one at a time; as many are made as are in use at once
template <typename Worker>
class Worker_pool
{
public:
  /// \param make_worker called by several threads at a time
  explicit Worker_pool(std::function<Worker()> make_worker) : m_make_worker(std::move(make_worker)) {}

  /// what \p work returns when it is given a worker that no other thread uses: the last one that was put back, whose
  /// memory is the likeliest to be at hand. A worker that throws is not used again.
  template <typename Work>
  auto lend(const Work& work)
  {
    Worker worker = take();
    auto result = work(worker);
    const std::lock_guard<std::mutex> lock(m_mutex);
    m_idle.push_back(std::move(worker));
    return result;
  }

  /// frees the memory of the workers. \pre none is in use
  void clear() { m_idle.clear(); }

private:
  Worker take()
  {
    {
      const std::lock_guard<std::mutex> lock(m_mutex);
      if(!m_idle.empty()) {
        Worker worker = std::move(m_idle.back());
        m_idle.pop_back();
        return worker;
      }
    }
    return m_make_worker();
  }

  std::function<Worker()> m_make_worker;
  std::mutex m_mutex;
  std::vector<Worker> m_idle;
};

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_SEARCH_WORKER_POOL_H
